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

DECLARATION = (r'Private Declare PtrSafe (Function|Sub) (c_\w+) Lib "rwedge\.dll" Alias "(\w+)" '
               r"\((.*)\)(?: As (\w+))?")

problems = []


def expect(truth, problem):
    if not truth:
        problems.append(problem)


def prototypes(text):
    """name: (type of the result, passed arguments), of the C compiler."""
    found = {}
    for returned, name, arguments in re.findall(r"extern (.*?) ?\b(rwedge_\w+) \((.*)\);", text):
        types = [re.sub(r"rwedge_\w+", "struct", a) for a in arguments.split(", ") if a != "void"]
        found[name] = (RETURNED[returned], [PASSED[t] for t in types])
    return found


def parameters(text):
    """(ByVal or ByRef and type, name) of each parameter of Basic."""
    return [(f"{m[1]} {m[3]}", m[2]) for m in re.finditer(r"(ByVal|ByRef) (\w+)(?:\(\))? As (\w+)", text)]


def check_declarations(module, interface, declared_in_c, exported):
    """name in Basic: the names of its arguments."""
    declared = {}
    for line in re.findall(r"^.*\bDeclare\b.*$", module, re.M):
        match = re.fullmatch(DECLARATION, line)
        if not match:
            expect(re.match(r'Private Declare PtrSafe (Function|Sub) \w+ Lib "kernel32" ', line), f"not understood: {line}")
            continue
        what, name, alias, arguments, returned = match.groups()
        passed = parameters(arguments)
        expect(name == alias.replace("rwedge_", "c_", 1), f"{name} is {alias}")
        expect(alias in exported, f"{alias}: not in the DLL")
        expect(alias in declared_in_c, f"{alias}: not in the header")
        wanted = declared_in_c.get(alias, (None, []))
        expect((returned, [p for p, _ in passed]) == wanted, f"{alias}: {returned} {passed}, but C has {wanted}")
        expect((what == "Sub") == (returned is None), f"{alias}: {what} with result {returned}")
        expect(arguments.count(" As ") == len(passed), f"{alias}: {arguments}: not understood")
        declared[name] = [n for _, n in passed]
        names = [name_of(p) for p in interface[alias[7:]].parameters] if alias[7:] in interface else []
        expect(declared[name] == names, f"{alias}: {declared[name]}, but the header has {names}")
    missing = {n.replace("rwedge_", "") for n in declared_in_c} - {n.replace("c_", "", 1) for n in declared}
    meant = {f.name for f in interface.functions if not is_declared(f)}
    expect(missing == meant, f"not declared: {missing - meant}; declared, though it is not meant: {meant - missing}")
    return declared


def check_code(module, declared):
    """Every declaration is called, and no two names of a procedure differ by case alone. What the calls pass is shown by test/cells.bas."""
    code = re.sub(r"(?m)^ *'.*$|^.*\bDeclare\b.*$|^Attribute.*$", "", module)
    called = set(re.findall(r"\bc_\w+", code))
    expect(called == declared, f"declared but never called: {declared - called}, called but not declared: {called - declared}")
    for name, body in re.findall(r"^(?:Public|Private) (?:Function|Sub) (\w+)(.*?)^End (?:Function|Sub)", code, re.S | re.M):
        names = re.findall(r"\b(\w+)(?:\(\))? As ", body)
        expect(len(names) == len({n.lower() for n in names} | {name.lower()}) - 1, f"{name}: a name twice in {names}")
        expect(not name.startswith("RWEDGE_") or f"Attribute {name}.VB_Description" in module, f"{name}: no description")
    expect(not re.search(r"\bMsgBox\b|\bOn Error\b", code), "a message box, or errors passed over")
    expect("\nOption Explicit\n" in module, "no Option Explicit")


def main():
    raw = open(sys.argv[1], "rb").read()
    interface = read(sys.argv[2])
    declared_in_c = prototypes(open(sys.argv[3], encoding="ascii").read())
    export_table = open(sys.argv[4], encoding="ascii").read().split("[Ordinal/Name Pointer] Table")[1].split("\n\n")[0]
    exported = set(re.findall(r"\[ *\d+\] (\w+)$", export_table, re.M))
    expect(raw.count(b"\r\n") == raw.count(b"\n") == raw.count(b"\r"), "lines do not end as Basic's editor wants: CR, LF")
    expect(raw.isascii(), "not ASCII")
    expect(max(map(len, raw.split(b"\r\n"))) < 1000, "a line longer than Basic's editor takes")
    expect(exported == set(declared_in_c), f"the DLL and the header differ in {exported ^ set(declared_in_c)}")
    module = re.sub(r" _\n\s*", "", raw.decode("ascii", "replace").replace("\r\n", "\n"))
    declared = check_declarations(module, interface, declared_in_c, exported)
    check_code(module, set(declared))
    for problem in problems:
        print(f"{sys.argv[1]}: {problem}")
    if not problems:
        offered = len(re.findall(r"^Public Function RWEDGE_", module, re.M))
        print(f"{len(exported)} functions in the DLL and the header, {len(declared)} of them declared, {offered} for cells")
    sys.exit(bool(problems))


main()
