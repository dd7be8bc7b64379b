#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Names the functions of the header whose promised error is not measured, and those that no test claims something of. There a
function stands as `rwedge_NAME`, or as `{"NAME"`, which begins a row of accuracy."""
import re
import sys
from pathlib import Path

from header import read

TOP = Path(__file__).resolve().parents[2]
CLAIMS = "tests/lib/*/*.c tests/proof/*.c tests/embedding/test_*.c"
ROWS = "tests/proof/accuracy/rows/*.cpp"
# Their promised errors have no row: slip, energies, yield factors and cracks have reference values in tests/data/; the others tell
# errors.
WITHOUT_ROW = {"contact_allow_error", "contact_error", "contact_slip", "contact_dissipated_energy", "contact_yield_factor",
               "contact_displacement", "crack_weights", "cycle_closing_crack", "series_residual"}


def texts(patterns):
    files = [file for pattern in patterns.split() for file in sorted(TOP.glob(pattern))]
    return "\n".join(file.read_text(encoding="utf-8") for file in files)


def not_in_the_table():
    """Rows of accuracy whose figures lib/README.md does not show."""
    rows = re.findall(r'^    \{"([^"]+)"', texts(ROWS), re.MULTILINE)
    table = texts("lib/README.md").partition("## Accuracy")[2]
    return [f"the table of accuracy in lib/README.md lacks `{name}`" for name in rows if f"\n| `{name}` |" not in table]


def main():
    lacking, rows = not_in_the_table(), texts(ROWS)
    written = rows + texts(CLAIMS)
    for f in read(TOP / "include/rwedge.h").functions:
        if f.array_of or f.name.endswith("_field"):
            continue  # tests/embedding/test_arrays.c goes through all of them: they have the bits of single calls
        promised = f.accuracy and f.name not in WITHOUT_ROW
        if not re.search(rf'\brwedge_{f.name}\b|{{"{f.name}"', rows if promised else written):
            lacking.append(f"rwedge_{f.name}() lacks " + (f"a row of accuracy ({ROWS})" if promised else f"a claim ({CLAIMS})"))
    for text in lacking:
        print(f"FAILED: {text}: see bindings/interface/README.md, How to add a function")
    sys.exit(bool(lacking))


main()
