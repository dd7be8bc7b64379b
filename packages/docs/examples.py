# SPDX-License-Identifier: GPL-3.0-or-later
"""What the pages of the functions show: numbers for the calls, the command of the tool that answers the same, a figure."""
from __future__ import annotations

import math

from header import Function, Parameter

# Of an argument, by its name.
NUMBERS = {
    "alpha": 0.25, "f": 0.1, "nu": 0.3, "c": 0.5, "x": -0.9, "y": 0.2, "n": 3,
    "Q_over_fP": 0.5, "AP_over_theta_a": 7.5,
    "E1": 200e3, "nu1": 0.3, "E2": 70e3, "nu2": 0.33,
    "theta": 0.01, "a": 2, "A": 1.82e-5, "R": 200, "P": 2000, "Q": 300, "b": 2.2, "k": 300, "M": 500, "sigma": 10,
    "beta": 0.1, "k_over_E": 0.0015, "safety": 0.9, "terms": 4, "doubt": 4, "status": 1,
    "sxx": 120, "syy": -64, "txy": 55, "E": 200e3, "k_over_sy": 0.0025, "strain_per_tension": 4.55e-6, "measure": 1,
    "plane_stress": 0, "repeats": 0, "angle": 0, "length": 0.1, "line": 1, "tolerance": 1e-3,
    "criterion": 1, "j": 0, "parameter": 4.05, "dK_th": 5, "ds0": 400,
    "P1": 2000, "M1": 0, "Q1": 300, "sigma1": 10, "P2": 2000, "M2": 0, "Q2": -300, "sigma2": -10,
}
# Of an array.
LISTS = {
    "x": [-0.9, 0, 0.9], "y": [0.2, 0.2, 0.2], "alpha": [0.1, 0.25, 1], "f": [0, 0.1, 0.3], "p": [-0.6, -1, -0.6],
    "sxx": [120, -80, 45], "syy": [-64, 31, 15], "txy": [55, -14, 26],
    "slope": [-0.01, 0, 0.02], "value": [0.1, 0.05, 0.02], "state": "state",
    "P": [2000, 2000], "M": [0, 0], "Q": [-300, 300], "sigma": [0, 0], "tilt": [0, 0], "displacement": [1e-3, -1e-3],
}
ROUND = [-4, -3, -2, -1, 0, 1, 2, 3, 4], [0.0803, 0.0449, 0.0201, 0.0049, 0.0001, 0.0051, 0.0198, 0.0452, 0.0799]
LOOP = {"P": [2000] * 11, "M": [0] * 11, "sigma": [0] * 11,
        "displacement": [0.001, 0.002, 0.0032, 0.001, -0.001, -0.003, -0.001, 0.001, 0.003, 0.002, -0.002],
        "Q": [453, 676, 863, -97, -526, -836, 70, 516, 835, 257, -687]}
SWT = [200e3]
SWT_LIFE = [*SWT, 475.4, -0.078, 0.612, -0.62, 0]
OWN = {**{(name, "constants"): SWT for name in ("criterion", "criterion_field", "cycle_worst")},
       **{(name, "constants"): SWT_LIFE for name in ("life", "damage", "damage_field")},
       **{("contact_loop_fit", argument): rows for argument, rows in LOOP.items()},
       ("profile_fit", "x"): ROUND[0], ("profile_fit", "height"): ROUND[1],
       **{(name, argument): number for name in ("cycle_growth", "cycle_closing_growth")
          for argument, number in {"x": -2.25, "law": [5, 400, 1e-13, 3, 1500], "initial": 0.05, "final": 5}.items()},
       ("contact_set_thickness", "t"): 40, ("cycle_create_driven", "compliance"): 1e-6,
       ("contact_create", "f"): 0.3, ("series_fit", "terms"): 2, ("validity", "beta"): 0, ("series_coefficient", "k"): 2,
       ("contact_set_bodies", "E2"): 200e3, ("contact_set_bodies", "nu2"): 0.3,
       ("yield_load", "f"): 0.3, ("contact_create_flat", "f"): 0.3,
       ("contact_create_profile", "f"): 0.3, ("cycle_worst", "y"): 0, ("contact_apply", "M"): 0,
       ("contact_apply", "Q"): 500, ("contact_guide", "tilt"): 0, ("contact_guide", "Q"): 500,
       ("contact_drive", "M"): 0, ("contact_drive", "sigma"): 0, ("contact_drive", "displacement"): 1e-3, ("contact_drive", "compliance"): 1e-6}
UNLOADED = {"contact_set_strain", "contact_set_beta", "contact_set_bodies", "contact_set_thickness"}  # refused once the bodies touch
HELD = {"contact_guide", "cycle_create_guided"}  # of a contact that is held
SLIDING = {"contact_shakedown_factor"}  # of one in full sliding
# The tool's command with the same numbers.
COMMANDS = {
    "load": "table contact-law --a-over-b 0.25",
    "peak_pressure": "table contact-law --a-over-b 0.25",
    "transition_pressure": "table contact-law --a-over-b 0.25",
    "pressure": "profile --a-over-b 0.25 --x -0.9",
    "stick_width": "table stick-zone --a-over-b 0.25 --q-over-fp 0.5",
    "shear": "profile --a-over-b 0.25 --f 0.1 --c-over-b 0.5 --x -0.9",
    "stress": "field --a-over-b 0.25 --f 0.1 --c-over-b 0.5 --x -0.9 --y 0.2",
    "stresses": "field --a-over-b 0.25 --f 0.1 --c-over-b 0.5 --x -0.9,0,0.9 --y 0.2",
    "max_tension": "table max-tension --a-over-b 0.25 --friction 0.1",
    "elastic_limit": "table elastic-limit --a-over-b 0.25 --friction 0.1 --nu 0.3",
    "elastic_limits": "table elastic-limit --a-over-b 0.1,0.25,1 --friction 0,0.1,0.3 --nu 0.3",
    "yield_point": "table elastic-limit --a-over-b 0.25 --friction 0.1 --nu 0.3",
    "subsurface_yield": "table elastic-limit --a-over-b 0.25 --friction 0.1 --nu 0.3",
    "surface_yield": "table elastic-limit --a-over-b 0.25 --friction 0.1 --nu 0.3",
    "critical_friction": "table critical-friction --a-over-b 0.25 --nu 0.3",
    "half_width": "solve --E1 200e3 --nu1 0.3 --theta 0.01 --a 2 --P 2000",
    "yield_load": "solve --E1 200e3 --nu1 0.3 --theta 0.01 --a 2 --P 2000 --f 0.3 --k 300",
    "contact_tractions": "profile --E1 200e3 --nu1 0.3 --theta 0.01 --a 2 --P 2000 --Q 300 --f 0.3 --x -0.9,0,0.9",
    "contact_slip": "profile --E1 200e3 --nu1 0.3 --theta 0.01 --a 2 --P 2000 --Q 300 --f 0.3 --x -0.9,0,0.9",
    "contact_stresses": "field --E1 200e3 --nu1 0.3 --theta 0.01 --a 2 --P 2000 --Q 300 --f 0.3 --x -0.9,0,0.9 --y 0.2",
    "contact_load": "solve --E1 200e3 --nu1 0.3 --theta 0.01 --a 2 --P 2000 --Q 300 --f 0.3",
}


def of_domain(p: Parameter):
    """For an argument of a name that is not above: the middle of its domain, or 1 beyond its lower end."""
    low, high = (max(p.domain.low, 0), p.domain.high) if p.domain else (0, math.inf)
    return int(low) + 1 if p.kind == "int32_t" else (low + high) / 2 if high - low < 10 else low + 1


def value_of(f: Function, p: Parameter):
    """A number, a list of them, or a list of lists."""
    number = OWN.get((f.name, p.name), NUMBERS.get(p.name))
    if not p.size:
        return of_domain(p) if number is None else number
    of = number if isinstance(number, list) else LISTS.get(p.name) or [of_domain(p)] * 3
    return [of, [-v for v in of]] if len(p.size) == 2 else of
