#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs the module's own code in LibreOffice's Basic, which understands most of Excel's, on the claims of cells.bas: run_cells.py
MODULE CLAIMS FOLDER. It cannot call DLLs: functions of Basic stand for them. Needs LibreOffice and its Python module uno."""
import os
import re
import signal
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[3] / "tests" / "support"))

from office import Office  # noqa: E402

LONGEST = 100


def translated(module):
    """Without what LibreOffice does not know: declarations, Attribute, LongPtr, Debug, Value2, LSet of structures; and with
    arrays passed whole, not by their first element."""
    module = re.sub(r" _\n\s*", " ", module.replace("\r\n", "\n"))
    module = re.sub(r"(?m)^(Attribute|Private Declare) .*\n", "", module)
    for its, ours in ("LongPtr", "Long"), ("Debug.Print", "note"), ("Value2", "Value"):
        module = module.replace(its, ours)
    module, structures = re.subn(r"LSet bits = number", "bits.high = high_half(number.value)", module)
    assert structures == 1
    return re.sub(r"\bc_\w+\(.*\)", lambda call: re.sub(r"(\w+)\(0\)", r"\1", call[0]), module)


def main():
    module, claims, folder = sys.argv[1:]
    # variables stand before the first procedure
    variables, procedures = open(claims, encoding="ascii").read().split("' ----", 1)
    code = translated(open(module, newline="", encoding="ascii").read())
    code = code.replace("Option Explicit\n", f"Option VBASupport 1\nOption Explicit\n{variables}") + "' ----" + procedures
    signal.alarm(LONGEST)  # ends this program, and by it LibreOffice
    signal.signal(signal.SIGALRM, lambda *_: sys.exit(f"FAILED: LibreOffice takes more than {LONGEST} s"))
    office = Office(folder)
    try:
        document = office.open("private:factory/scalc", MacroExecutionMode=4)
        document.BasicLibraries.VBACompatibilityMode = True
        document.BasicLibraries.getByName("Standard").insertByName("rwedge", code)
        script = document.getScriptProvider().getScript(
            "vnd.sun.star.script:Standard.rwedge.all_claims?language=Basic&location=document")
        answer = script.invoke((), (), ())[0]
        document.close(True)
    finally:
        office.end()
    print(f"in LibreOffice's Basic: {answer}", flush=True)
    os._exit(not str(answer).startswith("ok "))  # at once: uno's threads can crash when they outlive LibreOffice


main()
