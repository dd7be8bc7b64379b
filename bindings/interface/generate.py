#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Writes everything that is generated from include/rwedge.h and committed.

    generate.py            renews it
    generate.py --check    says what is not as the header has it, and fails then
"""
from __future__ import annotations

import sys
from pathlib import Path

import write_c
import write_excel
import write_fortran
import write_matlab
import write_python
import write_web
from header import Interface, Refused, read

TOP = Path(__file__).resolve().parents[2]


def template(path: str) -> str:
    return (TOP / "bindings" / path).read_text(encoding="ascii")


def matlab(interface: Interface) -> dict[str, str]:
    templates = {family: template(f"matlab/rwedge_{family}.m.in") for family in ("contact", "series")}
    return {f"matlab/functions/{name}": text for name, text in write_matlab.files(interface, templates).items()}


def fortran(interface: Interface) -> dict[str, str]:
    return {"fortran/rwedge.f90": write_fortran.module(interface, template("fortran/template.f90")),
            "fortran/door.f90": write_fortran.door(interface, template("fortran/door_template.f90"))}


WRITERS = (
    lambda interface: {"interface/entries.h": write_c.entries_h(interface)},
    matlab,
    fortran,
    lambda interface: {"excel/rwedge.bas": write_excel.module(interface, template("excel/template.bas"))},
    lambda interface: write_python.texts(interface) and {},  # made when the package is built; here, what it lacks
    lambda interface: write_web.texts(interface) and {},
)


def files(interface: Interface) -> dict[str, str]:
    """path below bindings/ -> text. Ends with what each binding lacks, if one does."""
    made, lacking = {}, []
    for write in WRITERS:
        try:
            made.update(write(interface))
        except SystemExit as lack:
            lacking.append(str(lack))
    if lacking:
        sys.exit("\n".join(lacking))
    return made


def is_current(path: str, text: str) -> bool:
    file = TOP / "bindings" / path
    return file.exists() and file.read_bytes() == text.encode("ascii")


def main() -> None:
    try:
        made = files(read(TOP / "include/rwedge.h"))
    except Refused as error:
        sys.exit(f"REFUSED: {error}")
    stale = [path for path, text in made.items() if not is_current(path, text)]
    if sys.argv[1:] == ["--check"]:
        for path in stale:
            print(f"FAILED: bindings/{path} is not what include/rwedge.h makes of it: python3 bindings/interface/generate.py")
        sys.exit(bool(stale))
    for path in stale:
        file = TOP / "bindings" / path
        file.parent.mkdir(exist_ok=True)
        file.write_bytes(made[path].encode("ascii"))
        print(f"bindings/{path}")


if __name__ == "__main__":
    main()
