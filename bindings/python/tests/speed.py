# SPDX-License-Identifier: GPL-3.0-or-later
"""Prints what a call costs: formulas over arrays, some of them beside the library's own function of arrays, in one process and in
turns; a case study; and single calls.     speed.py [POINTS]     CPU time, the fastest of some runs."""
import ctypes
import sys
import time
import timeit

import numpy as np

import rwedge
from rwedge._library import function

GENERATOR = np.random.default_rng(1)
IN_C = {"elastic_limit": "elastic_limits", "stress": "stresses"}  # with the same loop, in C


def arguments(name, points):
    """The numbers that all points share come first or last."""
    alpha, f, x, y = (GENERATOR.uniform(*limits, points) for limits in ((1e-3, 1), (0, 0.8), (-1, 1), (0.01, 1)))
    return {"load": (alpha,), "pressure": (alpha, x), "elastic_limit": (alpha, f, 0.3), "stress": (0.25, 0.3, 0.5, x, y)}[name]


def cpu_time(call):
    start = time.process_time()
    call()
    return time.process_time() - start


def ratio(name, points, runs=9):
    """Time of a ufunc over that of C's own loop."""
    numbers, count = arguments(name, points), ctypes.c_size_t(points)
    by_ufunc, by_c = np.empty((2, 3 if name == "stress" else 1, points))
    passed = [value.ctypes.data if np.ndim(value) else value for value in (*numbers, *by_c)]
    first = next(i for i, value in enumerate(numbers) if np.ndim(value))
    times = [(cpu_time(lambda: getattr(rwedge, name).ufunc(*numbers, out=tuple(by_ufunc))),
              cpu_time(lambda: function(IN_C[name])(*passed[:first], count, *passed[first:]))) for _ in range(runs)]
    assert (by_ufunc == by_c).all()
    ufunc, c = (min(column) for column in zip(*times))
    return ufunc / c


def case_study():
    """Seconds for 48 loads at 20000 points, and for Smith, Watson and Topper's parameter there with its plane."""
    start = rwedge.Contact(0.01, 0.5, 1.8e-5, 0.6)
    start.load(2000)
    x, y = start.half_width * np.linspace(-2, 2, 200), start.half_width * np.linspace(0, 1, 100)[:, None]
    Q, cycles = 900 * np.cos(np.linspace(0, 2 * np.pi, 48)), []
    stresses = min(cpu_time(lambda: cycles.append(start.copy().stresses_after({"Q": Q}, x, y))) for _ in range(5))
    return stresses, min(cpu_time(lambda: rwedge.smith_watson_topper(*cycles[0], 72e3, 0.33, axis=0)) for _ in range(5))


def main(points=1_000_000):
    for name in ("load", "pressure", "elastic_limit", "stress"):
        numbers = arguments(name, points)
        each = 1e9 / points * min(cpu_time(lambda: getattr(rwedge, name)(*numbers)) for _ in range(3))
        beside = f", {ratio(name, points, 3):.3f} of C's loop" if name in IN_C else ""
        print(f"{name} over {points} points: {each:.1f} ns each{beside}")
    print("48 loads at 20000 points: stresses {:.3f} s, Smith-Watson-Topper {:.3f} s".format(*case_study()))
    load, contact = function("load"), rwedge.Contact(0.01, 0.5, 1.8e-5, 0.6)
    contact.load(2000, 300)
    calls = {"rwedge.load(0.25)": lambda: rwedge.load(0.25), "the same by plain ctypes": lambda: load(0.25),
             "numpy.sqrt(0.25)": lambda: np.sqrt(0.25), "contact.half_width": lambda: contact.half_width,
             "contact.load(2000, 300)": lambda: contact.load(2000, 300), "contact.copy()": contact.copy,
             "contact.tractions(0.1)": lambda: contact.tractions(0.1)}
    for name, call in calls.items():
        print(f"{name}: {min(timeit.repeat(call, number=20_000, repeat=5)) / 20_000 * 1e6:.2f} us")


if __name__ == "__main__":
    main(*map(int, sys.argv[1:]))
