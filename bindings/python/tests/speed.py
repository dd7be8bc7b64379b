# SPDX-License-Identifier: GPL-3.0-or-later
"""Prints what a call costs: the ufuncs over arrays beside C's own loop over the same function of the same library, in one
process and alternating; and single calls.     speed.py [POINTS]

needs cc. CPU time, the fastest of some runs.
"""
import ctypes
import subprocess
import sys
import tempfile
import time
import timeit
from pathlib import Path

import numpy as np

import rwedge
from rwedge._library import function, library

ARGUMENTS = {  # ranges of the arguments
    "load": [(1e-3, 2)], "pressure": [(1e-3, 2), (-1, 1)], "elastic_limit": [(1e-3, 1), (0, 0.8), (0.3, 0.3)]}


def c_loops():
    """The library of loop.c."""
    with tempfile.TemporaryDirectory() as folder:
        subprocess.run(["cc", "-O2", "-shared", "-fPIC", "-o", f"{folder}/loop.so", Path(__file__).with_name("loop.c")],
                       check=True)
        return ctypes.CDLL(f"{folder}/loop.so")


def cpu_time(call):
    start = time.process_time()
    call()
    return time.process_time() - start


def ratio(loops, name, points, runs):
    """Time of a ufunc over that of C's loop, and its time per point in ns."""
    generator = np.random.default_rng(1)
    arrays = [generator.uniform(*limits, points) for limits in ARGUMENTS[name]]
    by_ufunc, by_c = np.empty(points), np.empty(points)
    formula = ctypes.cast(getattr(library, "rwedge_" + name), ctypes.c_void_p)
    pointers = [ctypes.c_void_p(array.ctypes.data) for array in (*arrays, by_c)]
    loop = getattr(loops, f"loop_{len(arrays)}")
    times = [(cpu_time(lambda: getattr(rwedge, name)(*arrays, out=by_ufunc)),
              cpu_time(lambda: loop(formula, ctypes.c_size_t(points), *pointers))) for _ in range(runs)]
    assert (by_ufunc == by_c).all()
    ufunc, c = (min(column) for column in zip(*times))
    return ufunc / c, 1e9 * ufunc / points


def microseconds(call):
    return min(timeit.repeat(call, number=20_000, repeat=5)) / 20_000 * 1e6


def case_study():
    """Seconds for 48 loads at 20000 points, and for Smith, Watson and Topper's parameter there with its plane."""
    start = rwedge.Contact(0.01, 0.5, 1.8e-5, 0.6)
    start.load(2000)
    x, y = start.half_width * np.linspace(-2, 2, 200), start.half_width * np.linspace(0, 1, 100)[:, None]
    Q, found = 900 * np.cos(np.linspace(0, 2 * np.pi, 48)), []
    stresses = min(cpu_time(lambda: found.append(start.copy().cycle({"Q": Q}, x, y))) for _ in range(5))
    return stresses, min(cpu_time(lambda: rwedge.smith_watson_topper(*found[0], 72e3, 0.33, axis=0)) for _ in range(5))


def main(points=1_000_000):
    loops = c_loops()
    for name in ARGUMENTS:
        over_c, each = ratio(loops, name, points, 3 if name == "elastic_limit" else 9)
        print(f"{name} over {points} points: {each:.1f} ns each, {over_c:.3f} of C's loop")
    print("48 loads at 20000 points: stresses {:.3f} s, Smith-Watson-Topper {:.3f} s".format(*case_study()))
    load, contact = function("load"), rwedge.Contact(0.01, 0.5, 1.8e-5, 0.6)
    contact.load(2000, 300)
    calls = {"rwedge.load(0.25)": lambda: rwedge.load(0.25), "the same by plain ctypes": lambda: load(0.25),
             "numpy.sqrt(0.25)": lambda: np.sqrt(0.25), "contact.half_width": lambda: contact.half_width,
             "contact.load(2000, 300)": lambda: contact.load(2000, 300), "contact.copy()": contact.copy,
             "contact.tractions(0.1)": lambda: contact.tractions(0.1)}
    for name, call in calls.items():
        print(f"{name}: {microseconds(call):.2f} us")


if __name__ == "__main__":
    main(*map(int, sys.argv[1:]))
