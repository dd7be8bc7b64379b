#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Writes what Sphinx reads.

    pages.py TOOL FOLDER    all pages, with what the Python package and the tool answer
    pages.py --check        every function has a page; figures and commands are of functions that there are
    pages.py --answers      the Python package answers each call that the pages show
"""
import sys
from pathlib import Path

TOP = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(TOP / "bindings" / "interface"))

import examples  # noqa: E402
import figures  # noqa: E402
from functions import Pages  # noqa: E402
from header import read  # noqa: E402
from readmes import Site  # noqa: E402


def check(interface, answers) -> int:
    pages = Pages(interface, answers)
    for f in interface.functions:
        pages.page(f)
    named = {name for _, _, names in figures.FIGURES.values() for name in names.split()} | set(examples.COMMANDS)
    unknown = named - {f.name for f in interface.functions}
    for name in sorted(unknown):
        print(f"FAILED: packages/docs/ shows {name}, which is no function")
    print(f"{len(interface.functions)} functions")
    return bool(unknown)


def main() -> int:
    interface = read(TOP / "include/rwedge.h")
    if sys.argv[1:] == ["--check"]:
        return check(interface, None)
    from answers import answers  # which needs the Python package

    if sys.argv[1:] == ["--answers"]:
        return check(interface, answers)
    tool, folder = sys.argv[1], Path(sys.argv[2])
    site = Site(TOP, folder)
    site.write()
    figures.draw(tool, folder / "figures")
    (folder / "gallery.md").write_text(figures.gallery(), encoding="utf-8")
    Pages(interface, answers).write(folder / "functions")
    return 0


sys.exit(main())
