# SPDX-License-Identifier: GPL-3.0-or-later
"""Where the workbook's numbers come from: the tool and its library. Nothing of the contact is computed in Python."""
import csv
import ctypes
import json
import math
import os
import subprocess
from ctypes import byref, c_char_p, c_double, c_int32
from itertools import product

OK, ABSENT = 0, 8  # statuses of rwedge.h
TABLES = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..")


def rounded(value, digits=10):
    """In ten digits a last bit that differs between math libraries does not show."""
    return float(f"{value:.{digits}g}")


def options_of(values):
    return [f"--{name.replace('_', '-')}={value}" for name, value in values.items()]


class Source:
    def __init__(self, tool, library):
        self.tool, self.library = tool, ctypes.CDLL(library)
        for name in ("load", "max_tension", "elastic_limit"):
            self.function(name).restype = c_double
        self.function("version").restype = c_char_p
        self.version = self.function("version")().decode()

    def function(self, name):
        return getattr(self.library, "rwedge_" + name)

    def number(self, name, *arguments):
        return self.function(name)(*map(c_double, arguments))

    def place(self, name, count, *arguments):
        """What a function of a place gives; all NaN where there is none."""
        results = [c_double(math.nan) for _ in range(count)]
        status = c_int32(self.function(name)(*map(c_double, arguments), *map(byref, results))).value
        if status not in (OK, ABSENT):
            raise ValueError(f"rwedge_{name}{arguments}: status {status}")
        return [result.value for result in results]

    def rows(self, *arguments):
        """What the tool computes, as dictionaries."""
        done = subprocess.run([self.tool, *arguments, "--format=json"], stdout=subprocess.PIPE, check=True)
        return json.loads(done.stdout)

    def table(self, name, **ranges):
        return self.rows("table", name, *options_of(ranges))

    def solve(self, case):
        strength = ["--yield-factor"] if {"k", "yield_stress"} & set(case) else []
        return self.rows("solve", "--layout=row", *strength, *options_of(case))[0]


# ---- What the tool wrote beside the workbook ----

LIMIT_NUS = ("0.25", "0.30", "0.35")


def limits(table):
    """The a/b of a shipped table of P/(bk), and a row for each: the f of the first nu, then those of the next."""
    blocks = []
    for nu in LIMIT_NUS:
        with open(os.path.join(TABLES, f"{table}-nu-{nu}.csv"), encoding="ascii") as file:
            blocks.append(list(csv.DictReader(file)))
    tips = list(dict.fromkeys(row["a_over_b"] for row in blocks[0]))
    rows = [[rounded(float(row["P_over_bk"]), 7) for block in blocks for row in block if row["a_over_b"] == tip] for tip in tips]
    return list(map(float, tips)), rows


def materials():
    """The shipped materials by name, in the order of their names."""
    folder = os.path.join(TABLES, "materials")
    found = {}
    for name in sorted(os.listdir(folder)):
        with open(os.path.join(folder, name), encoding="utf-8") as file:
            found[name.removesuffix(".json")] = json.load(file)
    return found


# ---- The table of yield ----

TIPS, PLACE_STEP, TIP_MIN = 51, 2, 0.003
# The nodes are closer from nu = 0.18 on. There the branch below the surface begins to decide, and near there it ends. Where a value
# of a patch is missing, the surface alone decides. f = 0.385 is above all critical frictions (0.378): beyond it none is below.
NUS = (0, 0.1, 0.175, 0.2, 0.225, 0.25, 0.275, 0.3, 0.325, 0.35, 0.375, 0.4, 0.425, 0.45, 0.475, 0.5)
FRICTIONS = (0, 0.025, 0.05, 0.075, 0.1, 0.125, 0.15, 0.175, 0.2, 0.225, 0.25, 0.275, 0.3, 0.325, 0.35, 0.375, 0.385, 0.5, 0.6,
             0.7, 0.8)
MOST_BELOW = 0.385
# x is odd in f, so x/f is even, as J2 is. This f stands for 0.
SMALL_FRICTION = 1e-3
# A branch whose J2 is less than this share of the other's decides in no cell of the table around it: its place is left out.
FAR_BELOW = 0.7


class YieldTable:
    """(A sqrt(J2)/theta)^2, the largest in the half-plane, for each of the two branches of yield: on the surface, and below it.
    NaN where there is no such branch."""

    def __init__(self, source):
        first = -math.acosh(1 / TIP_MIN)
        self.ts = [rounded(first * (TIPS - 1 - i) / (TIPS - 1)) + 0.0 for i in range(TIPS)]  # ln(tan(phi0/2)), sin(phi0) = a/b; up to 0
        self.tips = [1 / math.cosh(t) for t in self.ts]
        self.ms = [(1 - 2 * nu) * (1 - 2 * nu) / 3 for nu in NUS]
        self.end = rounded(source.number("load", TIP_MIN) / TIP_MIN)
        nodes = list(product(NUS, FRICTIONS))
        self.surface = [[entry(source, tip, "surface_yield", 2, f, nu) for nu, f in nodes] for tip in self.tips]
        self.below = [[entry(source, tip, "subsurface_yield", 3, f, nu) if f <= MOST_BELOW else math.nan for nu, f in nodes]
                      for tip in self.tips]
        self.places = self.find_places(source, nodes)

    def find_places(self, source, nodes):
        """At every other tip: x/(a f) on the surface; then x/(a f), and then y/a, below it."""
        parts = [], [], []
        for i in range(0, TIPS, PLACE_STEP):
            tip, here = self.tips[i], [[], [], []]
            for (nu, f), surface, below in zip(nodes, self.surface[i], self.below[i]):
                f, surface, below = max(f, SMALL_FRICTION), max(0, not_nan(surface)), not_nan(below)
                x = source.place("surface_yield", 2, tip, f, nu)[1] if surface >= FAR_BELOW * below else math.nan
                deep = below > 0 and below >= FAR_BELOW * surface
                below_x, y = source.place("subsurface_yield", 3, tip, f, nu)[1:] if deep else (math.nan, math.nan)
                for part, value in zip(here, (x / (tip * f), below_x / (tip * f), y / tip)):
                    part.append(in_thousandths(value))
            for part, values in zip(parts, here):
                part.append(values)
        return parts[0] + parts[1] + parts[2]


def not_nan(value):
    return 0 if math.isnan(value) else value


def entry(source, tip, branch, results, f, nu):
    """(load/limit)^2. Six digits are enough beside the error of interpolation, and the file is smaller."""
    limit = source.place(branch, results, tip, f, nu)[0]
    ratio = source.number("load", tip) / limit
    return rounded(ratio * ratio, 6) if ratio > 0 else math.nan


def in_thousandths(value):
    """0 as an empty cell, which is the same in formulas."""
    if math.isnan(value):
        return value
    return math.floor(1000 * value + 0.5) / 1000 or math.nan

