#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Holds the module for Excel against the library: check.py rwedge.bas HEADER PROTOTYPES EXPORTS

PROTOTYPES is what the C compiler itself makes of the header (gcc -aux-info), EXPORTS what the DLL's export table says
(objdump -p): neither comes from the generator, whose mistakes are to be found. The names and the order of the arguments,
which these do not have, come from the reader of the header.
"""
import re
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "interface"))

from header import read  # noqa: E402
from write_excel import is_declared, name_of  # noqa: E402

# C's type, the names of rwedge's structures left out: how Basic passes the same.
PASSED = {
    "double": "ByVal Double", "int32_t": "ByVal Long", "size_t": "ByVal LongPtr",
    "const double *": "ByRef Double", "double *": "ByRef Double",
    "const struct *": "ByVal LongPtr", "struct *": "ByVal LongPtr", "struct **": "ByRef LongPtr",
}
RETURNED = {"double": "Double", "int32_t": "Long", "size_t": "LongPtr", "const char *": "LongPtr", "void": None}

DECLARATION = re.compile(r'Private Declare PtrSafe (Function|Sub) c_(\w+) Lib "rwedge\.dll" Alias "rwedge_(\w+)" \((.*)\)(?: As (\w+))?')

problems = []


def expect(truth, problem):
    if not truth:
        problems.append(problem)


def prototypes(text):
    """name: (type of the result, passed arguments), of the C compiler."""
    functions = {}
    for returned, name, arguments in re.findall(r"extern (.*?) ?\brwedge_(\w+) \((.*)\);", text):
        types = [re.sub(r"rwedge_\w+", "struct", a) for a in arguments.split(", ") if a != "void"]
        functions[name] = (RETURNED[returned], [PASSED[t] for t in types])
    return functions


def check_declarations(module, interface, in_c):
    """The names of the functions that are declared, as C has them, with the header's names for their arguments."""
    declared = set()
    for line in re.findall(r"^.*\bDeclare\b.*$", module, re.M):
        if re.match(r'Private Declare PtrSafe (Function|Sub) \w+ Lib "kernel32" ', line):
            continue
        kind, name, alias, arguments, returned = (match := DECLARATION.fullmatch(line)) and match.groups() or [""] * 5
        passed = re.findall(r"(ByVal|ByRef) (\w+)(?:\(\))? As (\w+)", arguments)
        expect(name == alias and name in in_c, f"not understood, or not in the header: {line}")
        signature = returned, [f"{how} {kind}" for how, _, kind in passed]
        expect(signature == in_c.get(alias), f"{alias}: {signature}, but C has {in_c.get(alias)}")
        expect((kind == "Sub") == (returned is None) and arguments.count(" As ") == len(passed), f"not understood: {line}")
        names = [name_of(p) for p in interface[alias].parameters] if alias in interface else []
        expect([n for _, n, _ in passed] == names, f"{alias}: {passed}, but the header has {names}")
        declared.add(name)
    meant = {f.name for f in interface.functions if is_declared(f)}
    expect(declared == meant, f"declared or meant to be, but not both: {declared ^ meant}")
    return declared


def check_code(module, declared):
    """Every declaration is called, and no two names of a procedure differ by case alone. What the calls pass is shown by test/cells.bas."""
    code = re.sub(r"(?m)^ *'.*$|^.*\bDeclare\b.*$|^Attribute.*$", "", module)
    called = set(re.findall(r"\bc_(\w+)", code))
    expect(called == declared, f"declared but never called: {declared - called}, called but not declared: {called - declared}")
    for name, body in re.findall(r"^(?:Public|Private) (?:Function|Sub) (\w+)(.*?)^End (?:Function|Sub)", code, re.S | re.M):
        names = re.findall(r"\b(\w+)(?:\(\))? As ", body)
        expect(len(names) == len({n.lower() for n in names} | {name.lower()}) - 1, f"{name}: a name twice in {names}")
        expect(not name.startswith("RWEDGE_") or f"Attribute {name}.VB_Description" in module, f"{name}: no description")
    expect(not re.search(r"\bMsgBox\b|\bOn Error\b", code), "a message box, or errors passed over")
    expect("\nOption Explicit\n" in module, "no Option Explicit")


def main():
    raw = open(sys.argv[1], "rb").read()
    in_c = prototypes(open(sys.argv[3], encoding="ascii").read())
    table = open(sys.argv[4], encoding="ascii").read().split("[Ordinal/Name Pointer] Table")[1].split("\n\n")[0]
    exported = set(re.findall(r"\[ *\d+\] rwedge_(\w+)$", table, re.M))
    expect(raw.count(b"\r\n") == raw.count(b"\n") == raw.count(b"\r"), "lines do not end as Basic's editor wants: CR, LF")
    expect(raw.isascii() and max(map(len, raw.split(b"\r\n"))) < 1000, "not ASCII, or a line longer than Basic's editor takes")
    expect(exported == set(in_c), f"the DLL and the header differ in {exported ^ set(in_c)}")
    module = re.sub(r" _\n\s*", "", raw.decode("ascii", "replace").replace("\r\n", "\n"))
    declared = check_declarations(module, read(sys.argv[2]), in_c)
    check_code(module, declared)
    for problem in problems:
        print(f"{sys.argv[1]}: {problem}")
    if not problems:
        offered = len(re.findall(r"^Public Function RWEDGE_", module, re.M))
        print(f"{len(exported)} functions in the DLL and the header, {len(declared)} of them declared, {offered} for cells")
    sys.exit(bool(problems))


main()
