# SPDX-License-Identifier: GPL-3.0-or-later
"""From a rig to the verdict: a loop gives the friction, sixteen thresholds give the critical distance of a steel, and with both a log
is judged. Prints what the loop says, the scatter of the thresholds, and the verdict on a log with noise beside that on the loads it
was meant to have.                                                                                                    rig.py PICTURE

The thresholds of the nucleation of cracks, with and without a bulk stress, are of paper 952 of the 13th International Conference on
Fracture (2013), Table 2. Crossland's share of the hydrostatic stress is 3 (386/575 - 1/sqrt(3)), of fatigue limits in torsion and
tension of 386 and 575 MPa, which are assumed. Loop and log are made here, as a rig with 0.5 % of noise writes them. Units are N and mm.
"""
import tempfile
import warnings
from pathlib import Path

import numpy as np
import shown

import rwedge

STEEL = {"E": 210e3, "nu": 0.3, "crossland_alpha": 3 * (386 / 575 - 3**-0.5)}
F = 0.8
RADIUS = [20, 20, 40, 40, 40, 80, 80, 80, 80, 80, 80, 40, 40, 40, 80, 80]
P = [353, 552, 398, 707, 1100, 795, 1414, 2209, 795, 795, 795, 398, 398, 398, 795, 795]
Q = [186, 218, 271, 287, 310, 305, 399, 470, 273, 261, 137, 210, 192, 100, 300, 280]
SIGMA = np.array([0] * 8 + [100, 200, 400, 100, 200, 400, 200, 400])
LEAST = np.array([0] * 8 + [10, 20, 40, 10, 20, 40, 200, 400])
THRESHOLDS = {"radius": RADIUS, "P": P, "Q_max": Q, "sigma_max": SIGMA, "sigma_min": LEAST, "sigma_before": (SIGMA + LEAST) / 2}
WIDTH = 8  # of the specimen of the log


def thresholds(**words):
    return rwedge.series(THRESHOLDS, f=F, material=STEEL, criteria="crossland", **words)


def scatter(numbers):
    return 100 * np.std(numbers, ddof=1) / np.mean(numbers)


def loop_in_gross_slip(P=795, way=0.03, compliance=1e-5, noise=0.005):
    """Two cycles of a rig that prescribes the displacement, and gives way itself."""
    contact = rwedge.Contact.cylinder(80, rwedge.compliance(STEEL["E"], 0.3, STEEL["E"], 0.3), F)
    contact.load(P)
    displacement = way * np.sin(2 * np.pi * np.arange(201) / 100)
    shear = np.array([contact.drive(P, 0, 0, to, compliance) for to in displacement])
    return {"P": np.full(201, P), "displacement": displacement, "Q": shear + np.random.default_rng(1).normal(0, noise * F * P, 201)}


def write_log(path, noise=0.005, cycles=20, samples=100):
    """P constant, Q and the bulk stress in phase, in kN and MPa, below a preamble and a row of units."""
    turn = 2 * np.pi * np.arange(cycles * samples) / samples
    draw = np.random.default_rng(2013).normal(0, noise, (3, turn.size))
    numbers = np.column_stack([turn, WIDTH * 0.795 * (1 + draw[0]), WIDTH * 0.273 * (np.sin(turn) + draw[1]), 100 * (np.sin(turn) + draw[2])])
    rows = "\n".join(",".join(f"{value:.6g}" for value in row) for row in numbers)
    path.write_text(f"Rig 4\nspecimen 12\n\ntime,P,Q,sigma\ns,kN,kN,MPa\n{rows}\n", "utf-8")


def judged(log, f, length, limit):
    """The log, and the loads that it was meant to have, as two tests of a series; what was read, clipped and left out of the log."""
    tests = {"radius": [80, 80], "P [kN]": [WIDTH * 0.795] * 2, "loads": [str(log), None], "Q_max [kN]": [None, WIDTH * 0.273],
             "sigma_max": [None, 100]}
    with warnings.catch_warnings(record=True) as said:
        warnings.simplefilter("always")
        verdict = rwedge.series(tests, f=f, material={**STEEL, "crossland_limit": limit}, criteria="crossland", length=length,
                                units="mm,N,MPa", width=WIDTH, clip=True, turning_points=0.1)
    return verdict, [str(warning.message) for warning in said]


def main():
    picture = shown.arguments(__file__, __doc__).picture
    measured = rwedge.loop(loop_in_gross_slip(), E1=STEEL["E"], nu1=STEEL["nu"], radius=80)
    print(f"the loop: {measured.regime}, f {measured.f:.4f} +- {measured.uncertainty['f']:.4f}, the rig gives way by "
          f"{measured.compliance:.2e} mm per N/mm, {measured.energy:.2f} N a cycle")
    fitted = thresholds(fit_length=True)
    print(f"Crossland's parameter of 16 thresholds scatters by {scatter(fitted['crossland']):.1f} % at the surface, "
          f"by {scatter(fitted['crossland_at_length']):.1f} % at {500 * fitted.length:.0f} um, half of a length of {fitted.length:.4f} mm")
    with tempfile.TemporaryDirectory() as folder:
        log = Path(folder) / "rig.csv"
        write_log(log)
        limit = float(np.mean(fitted["crossland_at_length"]))
        verdict, said = judged(log, measured.f, fitted.length, limit)
    print("\n".join(text.split(".csv: ")[-1] for text in said if "tests.csv" not in text))
    for i, name in enumerate(("the log", "as it was meant to be")):
        print(f"{name}: Crossland {verdict['crossland'][i]:.0f} MPa at x = {verdict['crossland_x'][i]:.3f}, "
              f"{verdict['crossland_at_length'][i]:.0f} MPa at the length; {verdict['crossland_load_factor'][i]:.2f} times these loads start a crack")
    depths = np.geomspace(1e-3, 0.2, 40)
    curve = np.array([scatter(thresholds(length=2 * depth)["crossland_at_length"]) for depth in depths])

    figure, axes = shown.plt.subplots(figsize=(4.5, 3.2))
    axes.semilogx(1000 * depths, curve, **shown.style(1))
    axes.set(xlabel="depth, um", ylabel="scatter, %", title="Crossland's parameter of 16 thresholds", ylim=(0, None))
    shown.save(figure, picture, depth=depths, scatter=curve)


if __name__ == "__main__":
    main()
