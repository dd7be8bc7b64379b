#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Writes the module for Excel, rwedge.bas, from the header and template.bas.

Each function of the header becomes a declaration (c_..., private) and a worksheet function (RWEDGE_...). What has one
result gives a number; what has several, a row; what takes arrays, columns. A handle is never seen: its functions take the
history, or the samples, that it is made of.
"""
from __future__ import annotations

import re
import textwrap

from header import EQUATION, Function, Interface, Parameter, filled, name_of

WIDTH = 128
# Declared for the template's own functions.
FOR_TEMPLATE = {"version", "strerror", "contact_create", "contact_load", "contact_destroy", "cycle_create", "cycle_destroy",
                "series_fit", "series_destroy"}
# Histories are of P and Q, who gives a cycle knows its loads, and who fits a series how many terms.
NOT_OFFERED = {"cycle_loads", "contact_error", "contact_obstacle", "series_terms"}

# What a handle is made of: worksheet arguments, and the template's function that makes it.
HANDLES = {
    "contact": (["ByVal theta As Double", "ByVal a As Double", "ByVal compliance As Double", "ByVal f As Double",
                 "ByVal P_history As Variant", "ByVal Q_history As Variant"], "contact_after"),
    "cycle": (["ByVal theta As Double", "ByVal a As Double", "ByVal compliance As Double", "ByVal f As Double",
               "ByVal P_history As Variant", "ByVal Q_history As Variant", "ByVal P As Variant", "ByVal M As Variant",
               "ByVal Q As Variant", "ByVal sigma As Variant"], "cycle_after"),
    "series": (["ByVal x_samples As Variant", "ByVal p_samples As Variant", "ByVal terms As Long"], "series_through"),
}

DECLARED = {"in": {"double": "ByVal {} As Double", "int32_t": "ByVal {} As Long"}, "size": "ByVal {} As LongPtr",
            "in array": "ByRef {} As Double", "out": "ByRef {} As Double", "out array": "ByRef {} As Double",
            "handle": "ByVal {} As LongPtr", "changed": "ByVal {} As LongPtr", "created": "ByRef {} As LongPtr"}
RETURNS = {"double": "Double", "int32_t": "Long", "size_t": "LongPtr", "const char *": "LongPtr", "void": None}


def declared(p: Parameter) -> str:
    form = DECLARED[p.role]
    return (form[p.kind] if isinstance(form, dict) else form).format(name_of(p))


def names_of(f: Function, *roles: str) -> list[str]:
    return [name_of(p) for p in f.of(*roles)]


def broken(items, width):
    """Lines of items with commas between them, none of them broken."""
    lines = textwrap.wrap(", ".join(i.replace(" ", "\0") for i in items), width, break_on_hyphens=False)
    return [x.replace("\0", " ") for x in lines]


def wrapped(start, items, end, indent=8):
    """start(items)end, over as many lines as it takes."""
    line = f"{start}({', '.join(items)}){end}"
    if len(line) <= WIDTH:
        return line
    lines = broken(items, WIDTH - indent - max(2, len(end) + 1))
    return f"{start}( _\n" + " _\n".join(" " * indent + x for x in lines) + f"){end}"


def names(parameters):
    return [re.match(r"By(?:Val|Ref) (\w+)", p)[1] for p in parameters]


def declaration(f):
    result = RETURNS[f.returns]
    unit = "Function" if result else "Sub"
    return wrapped(f'Private Declare PtrSafe {unit} c_{f.name} Lib "rwedge.dll" Alias "rwedge_{f.name}" ',
                   [declared(p) for p in f.parameters], f" As {result}" if result else "", 4)


def description(f: Function, before: Function) -> str:
    """The comment's prose, without its references at the right, in the 255 characters that Insert Function shows."""
    prose = []
    for line in f.comment:
        line = EQUATION.sub("", line)
        if line.startswith("  ") or line.startswith("RWEDGE_"):
            break
        prose.append(line.strip())
    text = re.sub("^The same", f"As {cell_name(before)}", " ".join(p for p in prose if p)).replace('"', '""')
    if len(text) > 255:
        text = text[:254]
        text = text[:max(text.rfind(". "), text.rfind("; ")) + 1].rstrip(";") or text[:text.rfind(" ")]
    return text


def statements(f, name, handle):
    """Status by status, then the result or its error."""
    lists, several = names_of(f, "in array"), names_of(f, "out array")
    taken = {n.lower() for n in names(HANDLES[handle][0])} if handle else set()  # what the object is made of may be told too

    def told_as(n):
        return f"{n}_told" if n.lower() in taken else n
    single = [told_as(n) for n in names_of(f, "out")]
    passed = {"in array": "{}_list(0)", "out array": "{}(0)"}
    call = f"c_{f.name}({', '.join(told_as(name_of(p)) if p.role == 'out' else passed.get(p.role, '{}').format(name_of(p)) for p in f.parameters)})"
    variables = [f"{x} As Double" for x in single] + [f"{x}_list() As Double" for x in lists]
    sizes = {name: f"{p.size[0]}" for name, p in zip(lists, f.of("in array"))}
    variables += [f"{x}() As Double" for x in several] + [f"{n} As Long" for n in dict.fromkeys(sizes.values())]
    told = [f"If status = RWEDGE_OK Then {p.name} = c_{p.given_by}({p.given_from})" for p in f.implied if p.given_by]
    lines = ["status = find_library()"]
    if handle:
        variables.append(f"{handle} As LongPtr")
        lines = [f"status = {HANDLES[handle][1]}({', '.join(names(HANDLES[handle][0]) + [handle])})"]
    lines += told + [f"If status = RWEDGE_OK Then status = read_list({x}, {x}_list, {n})" for x, n in sizes.items()]
    if f.returns == "double":
        result = f"finite({call})"
    elif f.result in ("value", "text"):
        result = call if f.result == "value" else f"text_at({call})"
    elif several:
        count = " * ".join(f.of("out array")[0].size)
        arrays = ", ".join(f"{x}(0 To {count} - 1)" for x in several)
        lines += ["If status = RWEDGE_OK Then", f"    ReDim {arrays}", f"    status = {call}", "End If"]
        result = f"table_of({count}, {', '.join(several)})" if not single else f"Array({', '.join(single + elements(f))})"
    else:
        lines.append(f"If status = RWEDGE_OK Then status = {call}")
        result = f"Array({', '.join(single)})"
    lines += ["If status = RWEDGE_OK Then", f"    {name} = {result}", "Else", f'    {name} = failure(status, "{f.path}")', "End If"]
    if handle:
        lines.append(f"If {handle} <> 0 Then c_{handle}_destroy {handle}")
    dims = ["Dim " + line.rstrip(",") for line in broken(variables + ["status As Long"], WIDTH - 8)]
    return [f"    {line}" for line in dims + lines]


def elements(f: Function) -> list[str]:
    """Those of arrays of a fixed size, which stand in a row with the single results."""
    return [f"{name_of(p)}({k})" for p in f.of("out array") for k in range(int(p.size[0]))]


def fits_cells(f: Function) -> bool:
    """A cell holds and changes no object, and has no array of two sizes nor one whose size a function of the object tells."""
    kinds = {(p.role, p.size) for p in f.outputs}
    fixed = {p.name for p in f.implied if p.fixed}
    return f.returns in ("double", "int32_t", "const char *") and bool(f.results) and not f.of("created", "changed") and \
        not any(p.given_by for p in f.of("size")) and not any(len(p.size) == 2 for p in f.inputs + f.outputs) and \
        (len(kinds) < 2 or all(set(size) <= fixed for _, size in kinds))


def is_offered(f: Function) -> bool:
    return fits_cells(f) and f.name not in FOR_TEMPLATE | NOT_OFFERED


def is_declared(f: Function) -> bool:
    return f.name in FOR_TEMPLATE or is_offered(f)


def cell_name(f):
    return f"RWEDGE_{f.name.upper()}"


def worksheet_function(f: Function, before: Function) -> str:
    name, family = cell_name(f), f.family
    parameters = list(HANDLES[family][0]) if family else []
    parameters += [f"ByVal {name_of(p)} As Variant" if p.role == "in array" else declared(p) for p in f.inputs]
    notes = []
    if family:
        notes.append(f"In a cell: the {family} is made of {', '.join(names(HANDLES[family][0]))}.")
    if f.of("out array") and not f.of("out"):
        row = "of the table" if f.implied and not f.of("size") else "for each point"
        notes.append(f"In a cell: a row {row}: {', '.join(names_of(f, 'out array'))}.")
    elif f.of("out array"):
        notes.append(f"In a cell: the row {', '.join(names_of(f, 'out'))}, and the numbers of {', '.join(names_of(f, 'out array'))}.")
    elif f.of("out"):
        notes.append(f"In a cell: the row {', '.join(names_of(f, 'out'))}.")
    comments = "\n\n".join("\n".join(("' " + line).rstrip() for line in c) for c in [*f.introduction, f.comment])
    if f.section != before.section:
        comments = f"' ---- {f.section} ".ljust(98, "-") + "\n\n" + comments
    return "\n".join([comments] + [f"' {n}" for n in notes] +
                     [wrapped(f"Public Function {name}", parameters, " As Variant"),
                      f'Attribute {name}.VB_Description = "{description(f, before)}"',
                      *statements(f, name, family), "End Function"])


def texts(interface: Interface) -> dict[str, str]:
    offered = list(filter(is_offered, interface.functions))
    first = interface.functions[0]
    text = filled("excel/template.bas", {
        "introduction": [f"' {line}".rstrip() for line in interface.introduction],
        "statuses": [f"{name} = {value}" for name, value in interface.statuses.items()],
        "declares": list(map(declaration, filter(is_declared, interface.functions))),
        "functions": ["\n\n".join(map(worksheet_function, offered, [first] + offered))]})
    # Basic's editor takes no other ends of lines
    return {"rwedge.bas": "".join(line + "\r\n" for line in text.rstrip("\n").split("\n"))}
