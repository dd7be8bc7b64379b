#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Prints the calls that a program in each language answers: calls.py [LANGUAGE] > CALLS

A line is NAME:NUMBERS,ARGUMENT,...: the function without rwedge_, how many numbers its results are, and its arguments. The number
of a text is its length. The numbers of an array have spaces between them, and ; between the loads of one of two sizes. @ is the array
of the numbers that the line before gave. A function that makes an object makes the one that the following lines are about. With a
language, programs.py writes them for it.

Every function of the header is called, with arguments that differ from each other, so that no two of them can be exchanged
unnoticed; then come the ends of the domains.
"""
import csv
import math
import sys
from pathlib import Path

TOP = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(TOP / "bindings" / "interface"))

from header import read  # noqa: E402

from programs import program, written  # noqa: E402

VARIANTS = 7  # calls of a function with numbers from the middle of their domains
POINTS = 3  # the numbers of an array
LOADS = 2  # the first size of a function of two: the loads

# Values of an argument, by its name; those outside the domain of a function are left out. Arguments of other names have values
# that are made of their domain.
QUANTITIES = {
    "alpha": [0.25, 0.37, 0.003, 0.81, 1.7, 1e-6, 0.02],
    "f": [0.3, 0.45, 0.1, 0.72, 0.05],
    "nu": [0.31, 0.27, 0.4, 0.15],
    "c": [0.52, 0.13, 0.77, 0.35, 0.94],
    "x": [-0.61, 0.28, 0.84, -0.17, 0.49, -0.9, 0.07, 0.66, -0.38],
    "y": [0.23, 0.71, 0.04, 1.3, 0.55],
    "n": [3, 0, 11, 1000000],
    "Q_over_fP": [0.42, 0.85, 0.11, 0.63],
    "AP_over_theta_a": [7.5, 0.8, 130, 2.3],
    "E1": [200e3, 72e3, 110e3], "nu1": [0.3, 0.25, 0.33, 0.11], "E2": [70e3, 205e3, 3.1e3, 400e3], "nu2": [0.35, 0.2, 0.42],
    "theta": [0.01, 0.023, 0.005],
    "a": [0.5, 1.9, 0.08, 6.3],
    "A": [1.8e-5, 3.1e-5, 7e-6],
    "R": [200, 35, 810],
    "P": [1000, 2300, 640, 90],
    "Q": [270, -410, 130],
    "b": [2.4, 0.7, 11, 5.5],
    "k": [310, 180, 455],
    "k_over_E": [0.002, 1e-6, 0.3], "safety": [1.4, 0.7, 0.2], "beta": [0, 0.3, 0.2, -0.1],
    "p": [-0.35, -0.92, -0.71, -1.3, -1.1, -0.6, -0.83, -0.2, -0.97],
    "terms": [4, 7, 9],
    "sxx": [120, -80, 45, 210, -33, 7], "syy": [-64, 31, 150, -12, 88], "txy": [55, -140, 26, 73],
    "E": [200e3, 72e3, 110e3],
    "k_over_sy": [0.0025, 0.001, 0.0042],
    "criterion": [1, 2, 7, 8, 9, 10, 11, 12, 13], "measure": [1, 2, 7, 10], "j": [0], "parameter": [0.9, 0.02, 3], "plane_stress": [0, 1], "held": [0, 1], "beta_f": [0.02, -0.01],
    "state": "@", "doubt": [1, 2, 4, 8, 3],
    "M": [60], "sigma": [1],
    "sf": [475, 900], "ef": [0.6, 0.3], "tf": [450, 300], "gf": [0.7, 1.1], "G": [62e3, 27e3], "limit": [0],
    "line": [1], "length": [0.4], "angle": [0.3],
    "Q_a": [200, 350],
    "P1": [1000], "M1": [40], "Q1": [2, 5], "sigma1": [0.01],
    "P2": [1010], "M2": [30, 50], "Q2": [45, 40], "sigma2": [0.05, -0.03],
}
# Where a function needs others.
OWN = {
    ("series_coefficient", "k"): [2, 0, 3, 1, 50],
    ("criterion_factor", "limit"): [45, 90, 210],  # above what the mean stress alone has
    ("contact_tractions", "x"): [-0.8, 0.31, 2, -0.5, 4.2, 0, 0.07],
    ("contact_stresses", "x"): [-0.8, 0.31, 2, -0.5, 4.2, 0, 0.07],
    ("subsurface_yield", "alpha"): [0.25, 0.37, 0.81, 1.7],  # and little friction: the branch must exist
    ("subsurface_yield", "f"): [0.1, 0.02, 0.07],
    ("subsurface_yield", "nu"): [0.31, 0.27, 0.33],
    ("subsurface_shakedown", "alpha"): [0.25, 0.37, 0.81, 1.7], ("subsurface_shakedown", "f"): [0.1, 0.02, 0.07],
    ("subsurface_shakedown", "nu"): [0.31, 0.27, 0.33],
    ("half_width", "P"): [1000, 0, 2300],  # of A and P it has the product: 0 tells which is which
    ("contact_create", "f"): [0.6],
    ("crack_ranges", "shear"): [0, 1, 2], ("cycle_closing_ranges", "shear"): [0, 1, 2],
    ("contact_stress_history", "P"): [2000],
    ("contact_stress_history", "Q"): [100, -500, 700, -900],
    ("cycle_create_driven", "P"): [2000], ("cycle_create_driven", "M"): [60], ("cycle_create_driven", "sigma"): [-2],
    ("cycle_create_driven", "displacement"): [1e-4, -1e-4, 5e-5], ("cycle_create_driven", "compliance"): [1e-6],
    ("contact_loop_fit", "P"): [2000], ("contact_loop_fit", "M"): [0], ("contact_loop_fit", "sigma"): [0],
    ("contact_loop_fit", "displacement"): [0.001, 0.002, 0.0032, 0.001, -0.001, -0.003, -0.001, 0.001, 0.003, 0.002, -0.002],
    ("contact_loop_fit", "Q"): [453, 676, 863, -97, -526, -836, 70, 516, 835, 257, -687],  # f = 0.6, compliance 1e-6
    ("cycle_create_guided", "P"): [2000], ("cycle_create_guided", "tilt"): [1e-3, -2e-3, 0], ("cycle_create_guided", "Q"): [100, -300, 200],
    ("cycle_create_guided", "sigma"): [0],
    ("cycle_create", "P"): [2000], ("cycle_create", "M"): [60], ("cycle_create", "Q"): [100, -300, 200], ("cycle_create", "sigma"): [-2],
    ("cycle_friction", "x"): [1.75, -1.9, 2.2, 1.82, -1.72, 1.95, -2.25],  # at the edges, where it slips
    ("contact_create_profile", "slope"): [-0.01, 0, 0.01], ("contact_create_profile", "f"): [0.6], ("contact_create_flat", "f"): [0.6],
    ("cycle_worst", "y"): [0],
    ("validity", "theta"): [0.01, 0.2, 0.05, 1.1],
    ("validity", "f"): [0, 0.3, 0.05],
    ("profile_fit", "arcs"): [0, 1, 2],
}
# Places from left to right, and heights of a bowl that no parabola is: whichever follow each other.
for _name in ("profile_hull", "profile_slopes", "profile_fit"):
    OWN[_name, "x"] = [0.25 * i for i in range(64)]
    OWN[_name, "height"] = [(i - 32) ** 4 / 1e5 + i * 7 % 5 / 100 for i in range(64)]
for _name in ("cycle_growth", "cycle_closing_growth"):
    OWN.update({(_name, "shear"): [0, 1, 2], (_name, "law"): [0.5, 2, 1, 3, 4], (_name, "initial"): [0.01, 0.02], (_name, "final"): [1, 2]})
# The constants of each criterion; those of its damage, where there are more, from its own on.
CONSTANTS = {1: [200e3], 2: [200e3, 0.6, 400], 7: [0.3], 8: [40, 120, 0.7], 9: [160, 500], 10: [0.3], 11: [0.2], 12: [72e3], 13: [72e3, 0.5, 350]}
OF_LIFE = {1: [475, -0.078, 0.6, -0.62, 0], 2: [62e3, 450, -0.08, 0.7, -0.6, 0]}
NOT_EVERYWHERE = {"version", "strerror"}  # of another name, or none, in some languages
SAMPLES = {"series_fit": 9, "cycle_growth": 5, "cycle_closing_growth": 5, "profile_fit": 12, "contact_loop_fit": 11}
# The objects, each with the calls that change it: bodies, strain by tension, normal load, both loads together, Q reversed, P and Q to and fro;
# held at a tilt; with moment and tension;
# on a specimen of finite thickness.
OBJECTS = {
    "contact": [("contact_set_beta", (0.3,)), ("contact_set_bodies", (4 / 1.8e-5, 0, 4 / 1.8e-5, 0)),
                ("contact_set_strain", (0,)), ("contact_set_strain", (3.1e-6,))] +
               [("contact_load", pair) for pair in
                ((1000, 0), (2000, 300), (2000, -600), (2500, -200), (1800, 700), (1800, -900))] +
               [("contact_drive", (2000, 0, 0, 1e-3, 1e-6)), ("contact_load", (0, 0))] +
               [("contact_set_rotation", (1,)), ("contact_guide", (2000, 0.001, 400, 0)), ("contact_set_rotation", (0,))] +
               [("contact_apply", four) for four in
                ((0, 0, 0, 1), (2000, 60, 0, 1), (2000, 60, 400, 3), (2000, 60, -300, -2))] +
               [("contact_apply", (0, 0, 0, 1)), ("contact_set_thickness", (20, 2000))] +
               [("contact_apply", four) for four in ((2000, 60, 0, 1), (2000, 60, 400, 3), (2000, 60, -300, -2))],
    "cycle": [],  # of the last contact
    "series": [],
}
# What only a contact that slides can tell.
OF_SLIDING = {"contact_shakedown_factor"}
# As long as some hundred calls: asked once.
LONG = {"contact_loop_fit"}
# Made, and asked nothing: its forces are found, and another math library ends at other last digits, which what the cycle tells
# follows; or the contact is held for it.
ALONE = {"cycle_create_driven", "cycle_create_guided"}
interface = read(TOP / "include" / "rwedge.h")
LANGUAGE = "".join(sys.argv[1:])
calls = []  # the lines of each


def inside(domain, value):
    if domain.or_zero and value == 0:
        return True
    return (domain.low < value or domain.low == value and not domain.low_open) and \
        (value < domain.high or value == domain.high and not domain.high_open)


def values(function, parameter):
    chosen = OWN.get((function.name, parameter.name), QUANTITIES.get(parameter.name)) or of_domain(parameter)
    if chosen != "@":
        chosen = [v for v in chosen if inside(parameter.domain, v)] or [v for v in of_domain(parameter) if inside(parameter.domain, v)]
        if not chosen:
            sys.exit(f"FAILED: calls.py has no value of {parameter.name} in its domain in rwedge_{function.name}(): add some to OWN")
    return chosen


def of_domain(parameter):
    """Numbers for an argument of a name that is not above; another name has others."""
    d, seed = parameter.domain, sum(map(ord, parameter.name))
    parts = [(0.618034 * (seed + i)) % 1 for i in range(1, 6)]
    if parameter.kind == "int32_t":
        return [int(max(d.low, 0)) + int(20 * part) for part in parts]
    if d.high - d.low <= 10:
        return [d.low + part * (d.high - d.low) for part in parts]
    sign = -1 if d.low < 0 else 1
    return [(sign if i % 2 else 1) * (0.05 + 2 * part) for i, part in enumerate(parts)]


def call(function, arguments):
    """arguments: a number, a list of them or "@" for each argument."""
    counts = {}
    for p, value in zip(function.inputs, arguments):
        if p.size and value != "@":
            counts.update(zip(p.size, (len(value), len(value[0]) if isinstance(value[0], list) else 0)))
    numbers = sum(math.prod(int(size) if size.isdigit() else counts.get(size, 0) for size in p.size) for p in function.outputs)
    line = ",".join([f"{function.name}:{numbers or len(function.results)}", *map(text_of, arguments)])
    values = {p.name: "before" if value == "@" else value for p, value in zip(function.inputs, arguments)}
    calls.append(written(LANGUAGE, function, line, values, counts))


def text_of(value):
    if isinstance(value, list):
        return (";" if isinstance(value[0], list) else " ").join(map(text_of, value))
    return value if value == "@" else repr(value)


def sampled(function, variant):
    """The arguments of a call; other arguments take other steps through their values."""
    arguments = []
    for j, p in enumerate(function.inputs):
        numbers, stride = values(function, p), 1 + j % 3
        teller = next((q for q in function.implied if q.given_by and q.name in p.size), None)
        if numbers == "@":
            arguments.append(numbers)
        elif teller:
            criterion = arguments[[q.name for q in function.inputs].index(teller.given_from)]
            arguments.append(CONSTANTS[criterion] + (OF_LIFE[criterion] if teller.given_by == "damage_constants" else []))
        elif len(p.size) == 2:
            arguments.append([[numbers[(stride * variant + LOADS * i + j) % len(numbers)] for i in range(POINTS)] for j in range(LOADS)])
        elif p.size:
            told = function.of("size")[0 if function.name == "profile_fit" else -1].name
            size = LOADS if p.size[0] != told else SAMPLES.get(function.name, POINTS)
            arguments.append([numbers[(stride * variant + i) % len(numbers)] for i in range(size)])
        else:
            arguments.append(numbers[stride * variant % len(numbers)])
    return arguments


def sample(function, count):
    for variant in range(count if function.inputs else 1):
        call(function, sampled(function, variant))


# What a contact of another pad goes through.
ANOTHER_PAD = [("contact_apply", (0, 0, 0, 1)), ("contact_apply", (2000, 60, 0, 1)), ("contact_apply", (2000, 60, 100, 1))]


def formulas():
    for f in interface.functions:
        if not f.family and f.result != "nothing" and f.name not in NOT_EVERYWHERE:
            sample(f, VARIANTS)


def objects():
    """Every way to make one, then its history, and after each load what it tells."""
    for family, history in OBJECTS.items():
        own = [f for f in interface.functions if f.family == family and f.result != "nothing"]
        readers = [f for f in own if f.of("handle") and not f.of("created") and f.name not in OF_SLIDING | LONG]
        others = [f for f in own if f.of("changed") and f.name not in {name for name, _ in history}]
        for maker in (f for f in own if f.of("created")):
            inputs = sampled(maker, 0)
            if "@" in inputs:
                call(interface["contact_state"], [])
            is_guided = maker.name == "cycle_create_guided"
            if is_guided:
                call(interface["contact_set_rotation"], (1,))
            call(maker, inputs)
            if is_guided:
                call(interface["contact_set_rotation"], (0,))
            if maker.name in ALONE:
                continue
            steps = history if maker.method == "create" else ANOTHER_PAD if maker.method.startswith("create_") else history[-1:]
            for name, arguments in steps:
                call(interface[name], arguments)
                if arguments[0] == 0 or name.startswith("contact_set_"):
                    continue  # separated, it tells nothing
                for f in readers:
                    sample(f, 1 if maker.method != "create" else 2)
            for f in others:
                sample(f, 2)
                for reader in readers:
                    sample(reader, 1)
            if not steps:
                for f in readers:
                    sample(f, 4)
            if family == "contact" and maker.method == "create":
                call(maker, inputs)
                call(interface["contact_load"], (1000, 600))
                for f in own:
                    if f.name in OF_SLIDING | LONG:
                        sample(f, 1 if f.name in LONG else 2)


def stored():
    """Contacts as earlier versions wrote them: what each language makes of them."""
    told = [interface["contact_" + name] for name in ("kind", "pad", "places", "strain", "tolerance", "error", "loads", "edges")]
    for path in sorted((TOP / "tests" / "data").glob("state-*.csv")):
        names, *rows = csv.reader(path.read_text().splitlines())
        for row in rows:
            x = [float(row[names.index(f"x{i}")]) for i in range(1, 6)]
            call(interface["contact_restore"], [list(map(float, row[names.index("state"):]))])
            call(interface["contact_tractions"], [x])
            for f in told:
                call(f, [])


def ends():
    """Of formulas: each argument in turn at the ends of its domain, and beyond."""
    for f in (f for f in interface.functions if f.result == "value" and not f.family):
        for j, p in enumerate(f.inputs):
            if p.size:
                continue
            d = p.domain
            edges = [v for v in (d.low, d.high) if math.isfinite(v)] + [0.0, 1e-300, 1e300, -1.0, math.inf, math.nan]
            if p.kind == "int32_t":
                edges = [0, -1, 2**31 - 1]
            for edge in dict.fromkeys(edges):
                arguments = sampled(f, 0)
                arguments[j] = edge
                call(f, arguments)


def main():
    formulas()
    objects()
    stored()
    ends()
    print(program(LANGUAGE, calls))


main()
