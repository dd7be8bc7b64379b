#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Counts the lines of two sets of answers that differ, and how much: compare.py ANSWERS ANSWERS LARGEST-DIFFERENCE

A difference is told in parts of the largest result of its line. A point where something is greatest may have a coordinate that is
0 but for rounding.
"""
import math
import struct
import sys


# Of what a search finds the place of the value among the results; the others are where it is. The value is level to rounding over
# 1e-8 of them, so its last digits decide between neighbours.
SEARCHED = {"contact_deepest_wear": 0, "contact_yield_factor": 0, "cycle_worst": 1, "sliding_limit": 0}
OF_PLACE = 1e-7
# Of steps that end where the squares do not fall any more.
FITTED = {"contact_loop_fit"}
OF_FIT = 1e-6


def results(line):
    """The numbers of an answer: the last words, of which the second field of the line has the count."""
    call, *words = line.split(",")
    count = int(call.split(":")[1])
    if "error" in words[-1:]:
        return ["error"]
    return [math.nan if word == "nan" else struct.unpack(">d", bytes.fromhex(word))[0] for word in words[len(words) - count:]]


def difference(a, b):
    """In parts of the largest of a."""
    if len(a) != len(b) or "error" in a + b or [math.isnan(x) for x in a] != [math.isnan(x) for x in b]:
        return math.inf
    size = max((abs(x) for x in a if not math.isnan(x)), default=0.0)
    return max((abs(x - y) for x, y in zip(a, b) if x != y and not math.isnan(x)), default=0.0) / (size or 1.0)


def differences(first, second, allowed):
    """Pairs: how much a part of the answers differs, and how much it may."""
    a, b = results(first), results(second)
    if first.split(":")[0] in FITTED:
        return [(difference(a, b), OF_FIT)]
    value = SEARCHED.get(first.split(":")[0])
    if value is None or "error" in a + b:
        return [(difference(a, b), allowed)]
    without = [numbers[:value] + numbers[value + 1:] for numbers in (a, b)]
    return [(difference(a[value:value + 1], b[value:value + 1]), allowed), (difference(*without), OF_PLACE)]


def main():
    lines = [open(path, encoding="ascii").read().splitlines() for path in sys.argv[1:3]]
    allowed = float(sys.argv[3])
    if not lines[0] or len(lines[0]) != len(lines[1]):
        sys.exit(f"FAILED: {len(lines[0])} and {len(lines[1])} lines")
    different, largest = 0, 0.0
    for first, second in zip(*lines):
        if first != second:
            different += 1
            for found, most in differences(first, second, allowed):
                largest = max(largest, found)
                if not found <= most:
                    sys.exit(f"FAILED: {first}\n    but: {second}")
    print(f"{different} of {len(lines[0])} lines differ, by {largest:.1e} at most")


main()
