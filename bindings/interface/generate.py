#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Writes what each language takes from include/rwedge.h.    generate.py FOLDER [LANGUAGE...]    -> FOLDER/LANGUAGE/

A file that is as it should be is left alone. The languages are c, excel, fortran, matlab, python, web; without one, all."""
from __future__ import annotations

import sys
from importlib import import_module
from pathlib import Path

from header import Refused, read

HEADER = Path(__file__).resolve().parents[2] / "include/rwedge.h"
LANGUAGES = ("c", "excel", "fortran", "matlab", "python", "web")


def write(folder: Path, texts: dict[str, str]) -> None:
    folder.mkdir(parents=True, exist_ok=True)
    for stale in set(folder.iterdir()) - {folder / name for name in texts}:
        stale.unlink()
    for name, text in texts.items():
        made = text.encode("ascii")
        if not (folder / name).exists() or (folder / name).read_bytes() != made:
            (folder / name).write_bytes(made)


def main() -> None:
    folder, *languages = sys.argv[1:]
    try:
        interface = read(HEADER)
    except Refused as error:
        sys.exit(f"REFUSED: {error}")
    for language in languages or LANGUAGES:
        write(Path(folder) / language, import_module(f"write_{language}").texts(interface))


if __name__ == "__main__":
    main()
