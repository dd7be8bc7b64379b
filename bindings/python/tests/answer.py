# SPDX-License-Identifier: GPL-3.0-or-later
"""Answers what tests/answers/calls.py python prints, from standard input: each call with the bits of its results, as 16 hexadecimal
digits, "nan" for every NaN, "error" where it is refused. Prints what the program in C prints."""
import math
import struct
import sys

import numpy as np

import rwedge


def numbers_of(result):
    """All numbers of the results, one after the other; of a text its length."""
    if isinstance(result, str):
        return np.array([len(result)])
    parts = result if isinstance(result, tuple) else (result.real, result.imag) if np.iscomplexobj(result) else (result,)
    return np.concatenate([np.ravel(part) for part in parts])


def bits(value):
    return "nan" if np.isnan(value) else struct.pack(">d", value).hex()


def main():
    known = {"rwedge": rwedge, "inf": math.inf, "nan": math.nan, "before": np.array([])}
    with np.errstate(all="ignore"):  # outside the domain is among the calls
        for line in map(str.rstrip, sys.stdin):
            call, text = line.split("\t")
            try:
                result = eval(text.rpartition(" = ")[2], known)
            except (rwedge.Error, IndexError):
                print(call, "error", sep=",")
                continue
            if isinstance(result, (rwedge.Contact, rwedge.Cycle, rwedge.Series)):  # what makes one begins the next
                known[type(result).__name__.lower()], result = result, None
            if isinstance(result, rwedge.StressHistory):
                result = tuple(result)
            known["before"] = np.array([]) if result is None else numbers_of(result)
            print(call, *map(bits, known["before"]), sep=",")


if __name__ == "__main__":
    main()
