# SPDX-License-Identifier: GPL-3.0-or-later
"""Branches of the sources in a folder, reached by no test and not argued in place.

    branches.py FOLDER GCOV-JSON

GCOV-JSON is what `gcov --json-format --branch-probabilities --stdout` prints, one object a line. An argument is a comment
"unreached: why" on the line of the branch, or alone on the line above. Fails where a branch or a function is neither reached
nor argued, where an argument belongs to a line whose branches are all reached, and where a source has no data at all. "by
rounding: why" is an argument that may be reached, where the last bits decide. The branches of a line that never runs are not
counted against it: the branch that would lead there is.
"""

import json
import re
import sys
from collections import defaultdict
from pathlib import Path

ARGUMENT = re.compile(r"/\*.*\b(unreached|by rounding): \S")
ALONE = re.compile(r"\s*/\*[^*]*\*/\s*$")


def merged(objects, folder):
    """Per file: counts of the branches of each line, of the line, and of functions, summed over translation units."""
    branches, lines, functions = defaultdict(dict), defaultdict(dict), defaultdict(dict)
    for unit in objects:
        for source in unit["files"]:
            path = (Path(unit["current_working_directory"]) / source["file"]).resolve()
            if path.parent != folder:
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


def argued_lines(text):
    """The lines for which it is argued that some branch is not reached: number and kind of argument."""
    found = ((number, line, ARGUMENT.search(line)) for number, line in enumerate(text, 1))
    return {number + bool(ALONE.match(line)): match.group(1) for number, line, match in found if match}


def judge(path, branches, lines, functions):
    """What is wrong with a file, and its counts: all branches, reached, argued."""
    wrong, reached, argued, total = [], 0, 0, 0
    text = path.read_text().splitlines()
    arguments = argued_lines(text)
    for (number, name), count in sorted(functions.items()):
        if count == 0:
            wrong.append(f"{path.name}:{number}: {name}() is never called")
    for number, line in enumerate(text, 1):
        counts = branches.get(number, [])
        missed = counts.count(0)
        total += len(counts)
        reached += len(counts) - missed
        if number in arguments:
            argued += missed
            if missed == 0 and arguments[number] == "unreached":
                wrong.append(f"{path.name}:{number}: argued, but reached: {line.strip()}")
        elif missed and lines[number] > 0:
            wrong.append(f"{path.name}:{number}: {missed} of {len(counts)} branches not reached: {line.strip()}")
        elif missed:
            argued += missed  # by the branch that leads here
    return wrong, total, reached, argued


def main():
    folder, report = Path(sys.argv[1]).resolve(), Path(sys.argv[2])
    branches, lines, functions = merged((json.loads(line) for line in report.read_text().splitlines()), folder)
    wrong, sums = [], [0, 0, 0]
    print("                     branches  reached   argued")
    for path in sorted(folder.glob("*.[ch]")):
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
    total, reached, argued = sums
    print(f"{reached} of {total} branches reached, {argued} argued: {100 * (reached + argued) / max(1, total):.2f} %")
    sys.exit(1 if wrong else 0)


if __name__ == "__main__":
    main()
