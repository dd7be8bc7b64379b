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
import write_matlab
from header import Interface, Refused, read

TOP = Path(__file__).resolve().parents[2]


def files(interface: Interface) -> dict[str, str]:
    """path -> text."""
    bindings = TOP / "bindings"
    matlab = {family: (bindings / f"matlab/rwedge_{family}.m.in").read_text(encoding="ascii") for family in ("contact", "series")}
    return {
        "bindings/interface/entries.h": write_c.entries_h(interface),
        **{f"bindings/matlab/functions/{n}": text for n, text in write_matlab.files(interface, matlab).items()},
        "bindings/excel/rwedge.bas": write_excel.module(interface, (bindings / "excel/template.bas").read_text(encoding="ascii")),
    }


def is_current(path: str, text: str) -> bool:
    file = TOP / path
    return file.exists() and file.read_bytes() == text.encode("ascii")


def main() -> None:
    try:
        made = files(read(TOP / "include/rwedge.h"))
    except Refused as error:
        sys.exit(f"REFUSED: {error}")
    stale = [path for path, text in made.items() if not is_current(path, text)]
    if sys.argv[1:] == ["--check"]:
        for path in stale:
            print(f"FAILED: {path} is not what include/rwedge.h makes of it: python3 bindings/interface/generate.py")
        sys.exit(bool(stale))
    for path in stale:
        (TOP / path).parent.mkdir(exist_ok=True)
        (TOP / path).write_bytes(made[path].encode("ascii"))
        print(path)


if __name__ == "__main__":
    main()
