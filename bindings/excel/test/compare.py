#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Counts the lines of two doors that differ, and how much: compare.py ANSWERS ANSWERS LARGEST-RELATIVE-DIFFERENCE"""
import struct
import sys


def value(word):
    return struct.unpack(">d", bytes.fromhex(word))[0]


def main():
    lines = [open(path, encoding="ascii").read().splitlines() for path in sys.argv[1:3]]
    allowed = float(sys.argv[3])
    if not lines[0] or len(lines[0]) != len(lines[1]):
        sys.exit(f"FAILED: {len(lines[0])} and {len(lines[1])} lines")
    different, largest = 0, 0.0
    for one, other in zip(*lines):
        different += one != other
        for a, b in zip(one.split(","), other.split(",")):
            if a == b:
                continue
            difference = abs(value(a) - value(b)) / abs(value(a)) if "nan" not in (a, b) else float("inf")
            largest = max(largest, difference)
            if not difference <= allowed:
                sys.exit(f"FAILED: {one}\n    but: {other}")
    print(f"{different} of {len(lines[0])} lines differ, by {largest:.1e} at most")


main()
