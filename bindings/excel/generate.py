#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Writes the module for Excel from the header: generate.py ../../include/rwedge.h template.bas > rwedge.bas

Each function of the header becomes a declaration (c_..., private) and a worksheet function (RWEDGE_...). What has one
result gives a number; what has several, a row; what takes arrays, columns. A handle is never seen: its functions take the
history, or the samples, that it is made of.
"""
import re
import sys
import textwrap
from dataclasses import dataclass

WIDTH = 128
# Only one way to make a series is offered, and nobody copies what he cannot hold.
NOT_DECLARED = {"contact_copy", "contact_memory", "series_create", "series_terms"}
# Declared for the template's own functions.
NOT_IN_CELLS = {"version", "strerror", "contact_create", "contact_load", "contact_destroy", "series_fit", "series_destroy"}
# Basic does not tell a from A.
NAMES = {"A": "compliance"}

# What a handle is made of: worksheet arguments, and the template's function that makes it.
HANDLES = {
    "contact": (["ByVal theta As Double", "ByVal a As Double", "ByVal compliance As Double", "ByVal f As Double",
                 "ByVal P_history As Variant", "ByVal Q_history As Variant"], "contact_after"),
    "series": (["ByVal x_samples As Variant", "ByVal p_samples As Variant", "ByVal terms As Long"], "series_through"),
}

# C's parameters: pattern, kind, how Basic declares it.
KINDS = [
    (r"double (\w+)", "number", "ByVal {} As Double"),
    (r"int32_t (\w+)", "integer", "ByVal {} As Long"),
    (r"size_t (\w+)", "size", "ByVal {} As LongPtr"),
    (r"const double (\w+)\[\]", "list", "ByRef {} As Double"),
    (r"double \*(\w+)", "result", "ByRef {} As Double"),
    (r"double (\w+)\[\]", "results", "ByRef {} As Double"),
    (r"(?:const )?rwedge_\w+ \*(\w+)", "handle", "ByVal {} As LongPtr"),
    (r"rwedge_\w+ \*\*(\w+)", "new handle", "ByRef {} As LongPtr"),
]
RETURNS = {"double": "Double", "int32_t": "Long", "const char *": "LongPtr", "void": None}


@dataclass
class Parameter:
    name: str
    kind: str
    declared: str


@dataclass
class Function:
    comments: list
    returns: str
    name: str
    parameters: list

    def of(self, *kinds):
        return [p.name for p in self.parameters if p.kind in kinds]


def parameter(text):
    for pattern, kind, declared in KINDS:
        match = re.fullmatch(pattern, text)
        if match:
            name = NAMES.get(match[1], match[1])
            return Parameter(name, kind, declared.format(name))
    sys.exit(f"rwedge.h: no type of Basic for the parameter '{text}'")


def functions(header):
    """What the header declares, each with the comments since the last declaration."""
    comments = []
    for token in re.finditer(r"/\*(.*?)\*/|^RWEDGE_API (.*?)\brwedge_(\w+)\((.*?)\);|^(?:typedef|enum)\b", header, re.S | re.M):
        comment, returns, name, parameters = token.groups()
        if comment is not None:
            comments.append([re.sub(r"^ \* ?", "", line).strip("\n") for line in comment.strip(" \n").split("\n")])
        elif returns is not None:
            split = [re.sub(r"\s+", " ", p).strip() for p in parameters.split(",")]
            yield Function(comments, returns.strip(), name, [parameter(p) for p in split if p != "void"])
            comments = []


def filled(items, width):
    """Lines of items with commas between them, none of them broken."""
    lines = textwrap.wrap(", ".join(i.replace(" ", "\0") for i in items), width, break_on_hyphens=False)
    return [x.replace("\0", " ") for x in lines]


def wrapped(start, items, end, indent=8):
    """start(items)end, over as many lines as it takes."""
    line = f"{start}({', '.join(items)}){end}"
    if len(line) <= WIDTH:
        return line
    lines = filled(items, WIDTH - indent - max(2, len(end) + 1))
    return f"{start}( _\n" + " _\n".join(" " * indent + x for x in lines) + f"){end}"


def names(parameters):
    return [re.match(r"By(?:Val|Ref) (\w+)", p)[1] for p in parameters]


def declaration(f):
    result = RETURNS[f.returns]
    what = "Function" if result else "Sub"
    return wrapped(f'Private Declare PtrSafe {what} c_{f.name} Lib "rwedge.dll" Alias "rwedge_{f.name}" ',
                   [p.declared for p in f.parameters], f" As {result}" if result else "", 4)


def description(comment, before):
    """The comment's prose, without its references at the right, in the 255 characters that Insert Function shows. before is
    the function that "the same" refers to."""
    prose = []
    for line in comment:
        line = re.sub(r"\s{2,}(Eq\.|Fig|Sec\.|new|Dundurs|see).*", "", line)
        if line.startswith("  ") or line.startswith("RWEDGE_"):
            break
        prose.append(line.strip())
    text = re.sub("^The same", f"As {before}", " ".join(p for p in prose if p)).replace('"', '""')
    if len(text) > 255:
        text = text[:254]
        text = text[:max(text.rfind(". "), text.rfind("; ")) + 1].rstrip(";") or text[:text.rfind(" ")]
    return text


def statements(f, name, handle):
    """Status by status, then the result or its error."""
    lists, single, several = f.of("list"), f.of("result"), f.of("results")
    passed = {"list": "{}_list(0)", "results": "{}(0)"}
    call = f"c_{f.name}({', '.join(passed.get(p.kind, '{}').format(p.name) for p in f.parameters)})"
    variables = [f"{x} As Double" for x in single] + [f"{x}_list() As Double" for x in lists]
    variables += [f"{x}() As Double" for x in several] + (["n As Long"] if lists else [])
    lines = ["status = find_library()"]
    if handle:
        variables.append(f"{handle} As LongPtr")
        lines = [f"status = {HANDLES[handle][1]}({', '.join(names(HANDLES[handle][0]) + [handle])})"]
    lines += [f"If status = RWEDGE_OK Then status = read_list({x}, {x}_list, n)" for x in lists]
    if f.returns == "double":
        result = f"finite({call})"
    elif several:
        sizes = ", ".join(f"{x}(0 To n - 1)" for x in several)
        lines += ["If status = RWEDGE_OK Then", f"    ReDim {sizes}", f"    status = {call}", "End If"]
        result = f"table_of(n, {', '.join(several)})"
    else:
        lines.append(f"If status = RWEDGE_OK Then status = {call}")
        result = f"Array({', '.join(single)})"
    lines += ["If status = RWEDGE_OK Then", f"    {name} = {result}", "Else", f"    {name} = failure(status)", "End If"]
    if handle:
        lines.append(f"If {handle} <> 0 Then c_{handle}_destroy {handle}")
    dims = ["Dim " + line.rstrip(",") for line in filled(variables + ["status As Long"], WIDTH - 8)]
    return [f"    {line}" for line in dims + lines]


def cell_name(f):
    return f"RWEDGE_{f.name.upper()}"


def worksheet_function(f, before):
    name = cell_name(f)
    handle = next(iter(f.of("handle")), None)
    parameters = list(HANDLES[handle][0]) if handle else []
    for p in f.parameters:
        if p.kind in ("number", "integer"):
            parameters.append(p.declared)
        elif p.kind == "list":
            parameters.append(f"ByVal {p.name} As Variant")
    notes = []
    if handle:
        notes.append(f"In a cell: the {handle} is made of {', '.join(names(HANDLES[handle][0]))}.")
    if f.of("results"):
        notes.append(f"In a cell: a row for each point: {', '.join(f.of('results'))}.")
    elif f.of("result"):
        notes.append(f"In a cell: the row {', '.join(f.of('result'))}.")
    comments = "\n\n".join("\n".join(("' " + line).rstrip() for line in c) for c in f.comments)
    return "\n".join([comments] + [f"' {n}" for n in notes] +
                     [wrapped(f"Public Function {name}", parameters, " As Variant"),
                      f'Attribute {name}.VB_Description = "{description(f.comments[-1], cell_name(before))}"',
                      *statements(f, name, handle), "End Function"])


def main():
    header = open(sys.argv[1], encoding="ascii").read()
    template = open(sys.argv[2], encoding="ascii").read()
    introduction = re.search(r"^/\* (rwedge:.*?) \*/", header, re.S | re.M)[1]
    statuses = re.findall(r"^    (RWEDGE_\w+ = \d+)", header, re.M)
    start = header.index("/* ---- Materials")
    declared = [f for f in functions(header) if f.name not in NOT_DECLARED]
    offered = [f for f in functions(header[start:]) if f.name not in NOT_DECLARED | NOT_IN_CELLS]
    module = (template.replace("{introduction}", re.sub("(?m)^ \\*", "'", "' " + introduction))
              .replace("{statuses}", "\n".join(f"    {s}" for s in statuses))
              .replace("{declares}", "\n".join(declaration(f) for f in declared))
              .replace("{functions}", "\n\n".join(map(worksheet_function, offered, offered[:1] + offered))))
    # Basic's editor takes no other ends of lines
    sys.stdout.write("".join(line + "\r\n" for line in module.rstrip("\n").split("\n")))


if __name__ == "__main__":
    main()
