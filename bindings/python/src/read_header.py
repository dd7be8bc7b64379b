# SPDX-License-Identifier: GPL-3.0-or-later
"""Writes the module _header, what the package knows of the C library, from its header: the signature and the source of each
function, the domain of each argument, and the docstrings of the formulas.

    read_header.py rwedge.h _header.py
"""
import re
import sys
import textwrap
from pathlib import Path

SECTION = re.compile(r"/\* -{4} (.*?) -+ \*/")
FUNCTION = re.compile(r"^RWEDGE_API (.*?)rwedge_(\w+)\((.*?)\);", re.DOTALL | re.MULTILINE)
PIECE = re.compile(rf"{SECTION.pattern}|/\*(.*?)\*/|{FUNCTION.pattern}", re.DOTALL | re.MULTILINE)
SOURCE = re.compile(r"\n? {2,}((?:Eqs?\.|Sec\.|Figs?\.|Dundurs|new).*)$", re.MULTILINE)
ARGUMENT = re.compile(r"^   (\w+(?:, \w+)*)  +(\S.*(?:\n {5,}\S.*)*)\n?", re.MULTILINE)
LIKE = re.compile(r"arguments as for (\w+)\(\); (.*)")
SENTENCE_END = re.compile(r"(?<=\.)(?<!Fig\.)\s+")
IN_PYTHON = (  # statuses, pointers and limits, in the words of a formula
    (r"(; |, )RWEDGE_ENULL", ""), (r"RWEDGE_EDOMAIN\.", "NaN outside the domain."), (r"RWEDGE_E\w+", "NaN"),
    (r"rwedge_(\w+\(\))", r"\1"), ("HUGE_VAL", "inf"))
NATURAL = "Natural units: lengths in b, stresses in theta/A."
CONSISTENT = "Any consistent set of units."
UNITS = dict.fromkeys(("Materials", "Dimensional quantities", "A contact with a load history"), CONSISTENT)


def plain(comment):
    """A comment's lines without the stars."""
    return "\n".join(line.strip(" ").lstrip("*").rstrip() for line in comment.split("\n"))


def one_line(text):
    return " ".join(text.split())


def arguments_of(text):
    """The lines "name, name  meaning" of a comment, and the comment without them."""
    found = {name: one_line(match[2]) for match in ARGUMENT.finditer(text) for name in match[1].split(", ")}
    return found, ARGUMENT.sub("", text)


def parameters(declaration):
    """(type, name) of each parameter; arrays are pointers."""
    for parameter in one_line(declaration).split(", "):
        kind, name = re.fullmatch(r"(.*?)(\w+(?:\[\])?)", parameter).groups()
        yield (kind.strip() + (" *" if "[" in name else ""), name.removesuffix("[]"))


def in_python(text):
    for c, python in IN_PYTHON:
        text = re.sub(c, python, text)
    return text


def is_formula(result, kinds):
    """Does the function take and give nothing but numbers?"""
    return result == "double" and kinds <= {"double", "int32_t"} or kinds == {"double", "double *"}


def docstring(name, inputs, outputs, domains, text, source, units):
    """The help on a function of numbers, as NumPy's users are used to it."""
    *general, own = text.split("\n\n")
    first, *rest = SENTENCE_END.split(one_line(own), maxsplit=1)
    domain = [] if "NaN outside the domain" in text else ["NaN outside the domain."]
    lines = [f"{name}({', '.join(inputs)})", "", *textwrap.wrap(first, 100), "", "Parameters", "----------"]
    for argument in inputs:
        lines += [f"{argument} : array_like", *textwrap.wrap(domains.get(argument, ""), 96, initial_indent="    ",
                                                             subsequent_indent="    ")]
    lines += ["", "Returns", "-------", f"{', '.join(outputs) or name} : float64, in the broadcast shape of the arguments"]
    notes = one_line(" ".join([*rest, *general, *domain, units]))
    lines += ["", "Notes", "-----", *textwrap.wrap(notes, 100), f"Source: {source}."]
    return "\n".join(lines)


def functions(header):
    """name -> result, parameters, domains of the arguments, source, and the docstring of a formula."""
    found, shared, comment, source, units = {}, {NATURAL: {}, CONSISTENT: {}}, "", "", NATURAL
    for match in PIECE.finditer(header):
        section, remark, result, name, declaration = match.groups()
        if section:
            units = UNITS.get(section, NATURAL)
            continue
        if remark:
            comment = in_python(plain(remark))
            general, rest = arguments_of(comment)
            if "Arguments that return" in comment:
                shared[units].update(general)
            continue
        listed = [] if declaration == "void" else list(parameters(declaration))
        own, text = arguments_of(comment)
        formula = is_formula(result.strip(), {kind for kind, _ in listed})
        # a formula that has none has that of the one before: "at the surface"
        source = one_line(" ".join(SOURCE.findall(text))) or (source if formula else "")
        like = LIKE.search(text)
        domains = {**shared[NATURAL], **shared[units], **(found[like[1]]["domains"] if like else {}), **own}
        outputs = [n for kind, n in listed if kind == "double *"]
        inputs = [n for kind, n in listed if n not in outputs]
        found[name] = {
            "result": result.strip(), "parameters": tuple(listed), "source": source,
            "domains": {n: domains[n] for n in inputs if n in domains},
            "doc": docstring(name, inputs, outputs, domains, LIKE.sub(r"\2.", SOURCE.sub("", text)), source, units)
            if formula else ""}
    return found


TOP = '''# SPDX-License-Identifier: GPL-3.0-or-later
"""Made by src/read_header.py from rwedge.h: do not edit."""
from __future__ import annotations

from typing import Any

FUNCTIONS: dict[str, dict[str, Any]] = {'''


def main(header, module):
    lines = [TOP]
    for name, function in functions(Path(header).read_text(encoding="utf-8")).items():
        lines.append(f"    {name!r}: {{")
        lines += [f"        {key!r}: {value!r}," for key, value in function.items()]
        lines.append("    },")
    Path(module).write_text("\n".join([*lines, "}", ""]), encoding="utf-8")


if __name__ == "__main__":
    main(*sys.argv[1:])
