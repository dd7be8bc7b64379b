# SPDX-License-Identifier: GPL-3.0-or-later
"""Branches of the sources in the sub-folders of a folder, reached by no test and not argued in place.

    branches.py FOLDER GCOV-JSON

GCOV-JSON is what `gcov --json-format --branch-probabilities --stdout` prints, one object a line. Conditions in ALWAYS() and
NEVER() are constants there and have no branches. A comment "by rounding: why", on the line of the branch or alone on the line
above, excuses a branch that is reached or not as the last bits decide. Fails where a branch or a function is neither reached
nor excused, and where a source has no data at all. The branches of a line that never runs are not counted against it: the
branch that would lead there is.
"""

import json
import re
import sys
from collections import defaultdict
from pathlib import Path

EXCUSE = re.compile(r"/\*.*\bby rounding: \S")
ARGUED = re.compile(r"\b(ALWAYS|NEVER)\(")
ALONE = re.compile(r"\s*/\*[^*]*\*/\s*$")


def merged(objects, folder):
    """Per file: counts of the branches of each line, of the line, and of functions, summed over translation units."""
    branches, lines, functions = defaultdict(dict), defaultdict(dict), defaultdict(dict)
    for unit in objects:
        for source in unit["files"]:
            path = (Path(unit["current_working_directory"]) / source["file"]).resolve()
            if folder not in path.parents:
                continue
            for function in source["functions"]:
                key = function["start_line"], function["name"]
                functions[path][key] = functions[path].get(key, 0) + function["execution_count"]
            for line in source["lines"]:
                number = line["line_number"]
                lines[path][number] = lines[path].get(number, 0) + line["count"]
                counts = [branch["count"] for branch in line["branches"]]
                before = branches[path].setdefault(number, [0] * len(counts))
                if len(before) != len(counts):
                    sys.exit(f"FAILED: {path}:{number} has {len(before)} branches in one unit, {len(counts)} in another")
                branches[path][number] = [a + b for a, b in zip(before, counts)]
    return branches, lines, functions


def excused_lines(text):
    """Numbers of the lines some branch of which may not be reached."""
    return {number + bool(ALONE.match(line)) for number, line in enumerate(text, 1) if EXCUSE.search(line)}


def unjudged_lines(text):
    """These, and those whose condition is argued: a change there need not be noticed by any test."""
    return excused_lines(text) | {number for number, line in enumerate(text, 1) if ARGUED.search(line)}


def judge(path, branches, lines, functions):
    """What is wrong with a file, and its counts: all branches, reached, excused."""
    wrong, reached, excused, total = [], 0, 0, 0
    text = path.read_text().splitlines()
    excused_here = excused_lines(text)
    for (number, name), count in sorted(functions.items()):
        if count == 0:
            wrong.append(f"{path.name}:{number}: {name}() is never called")
    for number, line in enumerate(text, 1):
        counts = branches.get(number, [])
        missed = counts.count(0)
        total += len(counts)
        reached += len(counts) - missed
        if number in excused_here:
            excused += missed
        elif missed and lines[number] > 0:
            wrong.append(f"{path.name}:{number}: {missed} of {len(counts)} branches not reached: {line.strip()}")
        elif missed:
            excused += missed  # by the branch that leads here
    return wrong, total, reached, excused


def main():
    folder, report = Path(sys.argv[1]).resolve(), Path(sys.argv[2])
    branches, lines, functions = merged((json.loads(line) for line in report.read_text().splitlines()), folder)
    wrong, sums = [], [0, 0, 0]
    print("                     branches  reached  excused")
    for path in sorted(folder.glob("*/*.[ch]")):
        if path not in lines:
            if path.suffix == ".c":
                wrong.append(f"{path.name}: no data")
            continue
        complaints, *counts = judge(path, branches[path], lines[path], functions[path])
        wrong += complaints
        sums = [a + b for a, b in zip(sums, counts)]
        print(f"{path.name:20}" + "".join(f"{count:9}" for count in counts))
    print(f"{'all':20}" + "".join(f"{count:9}" for count in sums))
    if sums[0] == 0:
        wrong.append("no branches at all: was gcov called with --branch-probabilities?")
    for complaint in wrong:
        print("FAILED:", complaint)
    total, reached, excused = sums
    print(f"{reached} of {total} branches reached, {excused} excused: {100 * (reached + excused) / max(1, total):.2f} %")
    sys.exit(1 if wrong else 0)


if __name__ == "__main__":
    main()
