#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Names the functions of the header whose promised error is not measured, and those that no test claims something of. There a
function stands as `rwedge_NAME`, or as `{"NAME"`, which begins a row of accuracy. Names also the functions of 1.2.0 that are
gone or have other arguments, where bindings/README.md or Python's AttributeError does not say what serves now."""
import re
import runpy
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


def interface(file):
    """The functions of a stored binary interface, each with its types."""
    lines = [line.split(" ", 2) for line in texts(f"tests/package/{file}").splitlines() if "(" in line]
    return {name: types for name, _, types in lines}


def not_renamed():
    """Functions of 1.2.0 that are gone, or have other arguments, of which nothing says what serves now."""
    now, page = interface("interface.txt"), texts("bindings/README.md").partition("## Old names")[2]
    python = runpy.run_path(str(TOP / "bindings/python/src/rwedge/_renamed.py"))["now_called"]
    kept, lacking = texts("bindings/python/src/rwedge/_named.py"), []
    for name, types in interface("interface-1.2.0.txt").items():
        if now.get(name) != types and not re.search(rf"\brwedge_{name}\b", page):
            lacking.append(f"bindings/README.md does not say what serves in place of rwedge_{name}() of 1.2.0")
        in_python = re.sub("^contact_", "Contact.", name)
        if name not in now and not python(in_python) and f'"{name}"' not in kept:
            lacking.append(f"bindings/python/src/rwedge/_renamed.py lacks {in_python} of 1.2.0")
    return lacking


def main():
    lacking, rows = not_in_the_table() + not_renamed(), texts(ROWS)
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
