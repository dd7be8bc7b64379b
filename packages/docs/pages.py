#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Writes what Sphinx reads.

    pages.py TOOL FOLDER    all pages, with what the Python package and the tool answer
    pages.py --check        every function has a page with every language
"""
import re
import sys
from pathlib import Path

TOP = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(TOP / "bindings" / "interface"))

import examples  # noqa: E402
import figures  # noqa: E402
import write_excel  # noqa: E402
import write_fortran  # noqa: E402
import write_matlab  # noqa: E402
from functions import Pages  # noqa: E402
from header import read  # noqa: E402
from languages import calls  # noqa: E402
from readmes import Site  # noqa: E402

# Where a language has its names, and how they look in a call and there.
DEFINED = {
    "MATLAB, Octave": (write_matlab, r"\b(?:rwedge_|contact\.|series\.)(\w+)", r"(?:\b|rwedge_){}\b"),
    "Fortran": (write_fortran, r"(?:rwedge_|contact%|series%)(\w+)", r"(?:\b|rwedge_){}\b"),
    "Excel": (write_excel, r"=(RWEDGE_\w+)", r"Public Function {}\b"),
}


def check(interface) -> int:
    faults = 0
    texts = {language: "\n".join(name + text for name, text in writer.texts(interface).items()) for language, (writer, _, _) in DEFINED.items()}
    pages = Pages(interface, None)
    for f in interface.functions:
        page = pages.page(f)
        for language, lexer, text in calls(f, {p.name: examples.value_of(f, p) for p in f.inputs}):
            if f"**{language}**" not in page or not text:
                print(f"FAILED: rwedge_{f.name}(): the page says nothing of {language}")
                faults += 1
            for name in re.findall(DEFINED[language][1], text) if lexer and language in DEFINED else []:
                if not re.search(DEFINED[language][2].format(name), texts[language]):
                    print(f"FAILED: rwedge_{f.name}(): {language} has no {name}")
                    faults += 1
    unknown = {name for _, _, names in figures.FIGURES.values() for name in names.split()} | set(examples.COMMANDS)
    for name in unknown - {f.name for f in interface.functions}:
        print(f"FAILED: packages/docs/ shows {name}, which is no function")
        faults += 1
    print(f"{len(interface.functions)} functions")
    return faults != 0


def main() -> int:
    interface = read(TOP / "include/rwedge.h")
    if sys.argv[1:] == ["--check"]:
        return check(interface)
    from answers import answers  # which needs the Python package

    tool, folder = sys.argv[1], Path(sys.argv[2])
    site = Site(TOP, folder)
    site.write()
    figures.draw(tool, folder / "figures")
    (folder / "gallery.md").write_text(figures.gallery(), encoding="utf-8")
    Pages(interface, answers).write(folder / "functions")
    return 0


sys.exit(main())
