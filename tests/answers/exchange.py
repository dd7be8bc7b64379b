#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Whether the calls tell the arguments and the results of every function apart: exchange.py PROGRAM < CALLS

A binding that exchanges two of them answers as C answers the calls with these two exchanged. So the answers of the PROGRAM in C must
change with each exchange: then the tests of the bindings, which compare every answer, notice it. CALLS are those of `calls.py --own`.
"""
import subprocess
import sys
from itertools import combinations, zip_longest
from pathlib import Path

TOP = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(TOP / "bindings" / "interface"))

from header import read  # noqa: E402

# Measures of a stress that do not tell its two normal stresses apart: the invariants, and what is made of them.
INVARIANT = ("von_mises", "out_of_plane_stress", "largest_shear", "crossland", "crossland_field", "dang_van", "dang_van_field")
SYMMETRIC = {(name, "sxx", "syy") for name in INVARIANT}

interface = read(TOP / "include" / "rwedge.h")


def name_of(call):
    return call.split(":")[0]


def answers(asked):
    """What the program answers to each call, without the call."""
    said = subprocess.run([sys.argv[1]], input="\n".join(asked) + "\n", capture_output=True, text=True, check=True).stdout
    return [line[len(call):] for line, call in zip(said.splitlines(), asked)]


calls = sys.stdin.read().splitlines()
usual = answers(calls)


def exchanged(call, places):
    words = call.split(",")
    i, j = places
    words[1 + i], words[1 + j] = words[1 + j], words[1 + i]
    return ",".join(words)


def pairs_of(function):
    """The places of two arguments that a compiler would let pass for each other."""
    return [(i, j) for (i, p), (j, q) in combinations(enumerate(function.inputs), 2) if (p.kind, len(p.size)) == (q.kind, len(q.size))]


def unnoticed(functions, kept):
    """Exchanges that change no answer. Each function has one at a time; `kept` are the functions whose calls these need."""
    for pairs in zip_longest(*map(pairs_of, functions)):
        places = {f.name: pair for f, pair in zip(functions, pairs) if pair}
        asked, before = zip(*[both for both in zip(calls, usual) if name_of(both[0]) in {*places, *kept}])
        after = answers([exchanged(call, places[name_of(call)]) if name_of(call) in places else call for call in asked])
        differ = {name_of(call) for call, old, new in zip(asked, before, after) if old != new}
        for f in functions:
            if f.name in places and not differ & ({f.name} | (kept if f.of("created", "changed") else set())):
                yield (f.name, *(f.inputs[i].name for i in places[f.name]))


def unnoticed_results():
    """Pairs of results that are equal in every call."""
    equal = {}
    for call, answer in zip(calls, usual):
        results = interface[name_of(call)].outputs
        words = answer.split(",")[1:]
        each = len(words) // max(len(results), 1)
        for i, j in combinations(range(len(results)), 2):
            same = words[i * each:(i + 1) * each] == words[j * each:(j + 1) * each]
            key = (name_of(call), results[i].name, results[j].name)
            equal[key] = equal.get(key, True) and same
    return {key for key, same in equal.items() if same}


def main():
    called = {name_of(call) for call in calls}
    functions = [f for f in interface.functions if f.name in called]
    changing = [f for f in functions if f.of("created", "changed")]
    reading = [f for f in functions if f not in changing and f.of("handle")]
    formulas = [f for f in functions if f not in changing and f not in reading]
    missed = {*unnoticed(formulas, set()), *unnoticed(reading, {f.name for f in changing}), *unnoticed_results()}
    quick = {g.name for g in changing + reading if not g.of("size")}
    for f in changing:  # each by itself, as its exchange is in the answers of all that follows
        missed |= {*unnoticed([f], quick | {"contact_create", "series_create", "series_fit"})}
    if missed != SYMMETRIC:
        sys.exit(f"FAILED: no answer changes with {sorted(missed - SYMMETRIC)}; changes with {sorted(SYMMETRIC - missed)}")
    print(f"ok: {sum(len(pairs_of(f)) for f in functions)} exchanges of arguments change the answers of {len(functions)} functions")


main()
