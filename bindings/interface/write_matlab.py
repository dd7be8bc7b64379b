# SPDX-License-Identifier: GPL-3.0-or-later
"""Writes the functions and classes for MATLAB and GNU Octave: each a call of rwedge_mex, with the comment of rwedge.h as its
help text. What is not the same for every function of a class is in rwedge_contact.m.in, rwedge_cycle.m.in and
rwedge_series.m.in."""
from __future__ import annotations

import re
import textwrap

from header import ARGUMENT, EQUATION, FURTHER, Function, Interface, filled, replaced
from write_c import reason

ARRAYS = "The arguments are arrays of one size; where one has the size 1, it goes with all along that dimension."
IN_MATLAB = (  # arrays have sizes and two dimensions, results need no place
    (r"(rwedge_(?:contact|cycle|series))_create\(", r"\1("), (r"(rwedge_(?:contact|cycle|series))_(\w+)\(", r"\1.\2("),
    (r"each receives loads \* n numbers, the n of the first load first(; not one of the\s+inputs)?", "results, a column for each load"),
    (r"(?:each )?receives? [nm] numbers: ", "result: "),
    (r"each receives? ([nm]) numbers", r"results, \1 numbers each"), (r"receives? ([nm]) numbers", r"result, \1 numbers"), (r"receives? one number", "result"), (r"loads \* n stresses", "points by loads, stresses"),
    (r"at \[i n \+ j\]", "at (j, i)"), (r"loads numbers each", "a number for each load"),
    (r"loads \* n numbers each", "points by loads"),
    (r"RWEDGE_MEASURE_(\w+)", r"rwedge_measure('\1')"), (r"RWEDGE_FACES_(\w+)", r"rwedge_faces('\1')"))
LICENCE = "\n% SPDX-License-Identifier: GPL-3.0-or-later\n"  # last: the first comment is the help text


def inputs(f: Function) -> list[str]:
    return [p.name for p in f.inputs]


def is_method(f: Function) -> bool:
    """Is it a method that is a call and nothing else?"""
    return bool(f.family) and not f.of("created") and f.result != "nothing"


def call(results: list[str], name: str, arguments: list[str]) -> str:
    """[p, q] = name(x)"""
    left = f"[{', '.join(results)}] = " if len(results) > 1 else f"{results[0]} = " if results else ""
    return f"{left}{name}({', '.join(arguments)})"


def called(f: Function, values: list[str]) -> str:
    """How a user calls it."""
    if f.of("created"):
        made_of = [f.object] * bool(f.object and not f.is_copy)
        return call([f.family], f"rwedge_{f.family}" + f".{f.method}" * (f.method != "create"), made_of + values)
    return call(f.results, f"{f.family}.{f.method}" if f.family else f"rwedge_{f.array_of or f.name}", values)


def without_pointers(text: str, method: bool) -> str:
    """A method's object may have been deleted, which is rwedge:handle; nothing else can be NULL."""
    text = text.replace("RWEDGE_ENULL", "rwedge:handle") if method else re.sub(r"(?m)[,;] RWEDGE_ENULL|^RWEDGE_ENULL, ", "", text)
    text = re.sub(r"[;,] (NaN|-?[01]|and) for NULL|,? and NaN for NULL|\s+or\s+NULL|; (each )?may be NULL|,\s+never\s+NULL", "", text)
    return re.sub(r" ?\bNaN for NULL\. ?", "", text)


def without_sizes(f: Function, lines: list[str]) -> list[str]:
    """Arrays tell their sizes: nobody gives them."""
    kept, sizes, left_out = [], {p.name for p in f.of("size")}, False
    for line in lines:
        argument = ARGUMENT.fullmatch(line)
        left_out = set(argument[1].split(", ")) <= sizes if argument else left_out and bool(FURTHER.fullmatch(line))
        kept += [] if left_out else [line]
    return kept


def shared(f: Function) -> list[str]:
    """The domains that the comment leaves to the list of arguments that many functions share."""
    groups: dict[str, list[str]] = {}
    for p in f.inputs:
        if p.domain and not p.described:
            groups.setdefault(p.domain.text, []).append(p.name)
    width = max((len(", ".join(n)) for n in groups.values()), default=0)
    return [f"  {', '.join(names):{width}}  {text}" for text, names in groups.items()]


def help_lines(f: Function) -> list[str]:
    """The help text after its first line: the comment, and the arguments that it does not list itself."""
    method = bool(f.family) and f.method not in ("create", "fit") and f.of("handle", "changed") != []
    lines = [EQUATION.sub(r"   \1", line) for line in f.comment if not re.fullmatch(r"  \w+  +receives the handle", line)]
    text = without_pointers("\n".join(lines), method).replace(" Free with rwedge_series_destroy().", "")
    text = re.sub(r"Unless\s+RWEDGE_OK, the contact is as before\.", "After an error the contact is as before;\n"
                  "of vectors, all loads are taken or none.", text)
    text = "\n".join([*without_sizes(f, text.split("\n")), *shared(f)])
    text = re.sub(r"RWEDGE_E[A-Z]+", lambda m: f"rwedge:{reason(m[0])}", replaced(text, IN_MATLAB))
    return text.replace("HUGE_VAL", "Inf").split("\n")


def commented(lines: list[str]) -> list[str]:
    return [f"%   {line}".rstrip() for line in lines]


def routine(head: str, name: str, form: str, text: list[str], count: int, body: list[str], step: str = "") -> str:
    """A function with its help. A call with fewer arguments is refused: it would end in words about the function's own lines."""
    few = [f"if nargin < {count}", f"    error('rwedge:arguments', 'too few arguments: {form}');", "end"] if count else []
    lines = [f"function {head}", f"%{name.upper()}  {form}", *commented(text), *(step + line for line in [*few, *body]), "end", ""]
    return "\n".join(lines)


def function_text(f: Function) -> str:
    form, lines = called(f, inputs(f)), help_lines(f)
    lines += ["", ARRAYS] if inputs(f) and not f.of("in array", "out array") else []
    if any("rwedge:absent" in line for line in lines):
        lines.append("Where rwedge:absent is said above, the results are NaN, and no error.")
    return routine(form, f"rwedge_{f.name}", form, lines, len(inputs(f)), [call(f.results, "rwedge_mex", [f"'{f.name}'", *inputs(f)]) + ";"]) + LICENCE


def method_text(f: Function) -> str:
    loads = bool(f.of("changed")) and "P" in inputs(f)
    is_plain = loads and not f.of("in array") and not f.results
    body = [call([], f"{f.family}.go_on", [f"'{f.name}'", *inputs(f)]) if is_plain else
            call(f.results, "rwedge_mex", [f"'{f.name}'", f"{f.family}.number", *inputs(f)])]
    body += [f"{f.family}.warn_of_size()"] if loads and not is_plain else []
    body += [f"{f.family}.warn('safety', factor)"] if "factor" in f.results else []
    head = call(f.results, f.method, [f.family, *inputs(f)])
    return "\n" + routine(head, f.method, called(f, inputs(f)), help_lines(f), len(inputs(f)) and len(inputs(f)) + 1, [f"{line};" for line in body], "    ")


def maker_text(f: Function) -> str:
    """A function that makes an object other than by the class's own name: a static method."""
    made_of = [f.object] * bool(f.of("handle"))
    numbers = [repr(f.name), *(f"{name}.number" for name in made_of), *inputs(f)]
    body = [f"{f.family} = rwedge_{f.family}();", call([f"{f.family}.number"], "rwedge_mex", numbers) + ";"]
    return routine(call([f.family], f.method, made_of + inputs(f)), f.method, called(f, inputs(f)), help_lines(f), len(made_of + inputs(f)), body, "    ")


def class_text(interface: Interface, family: str) -> str:
    own = interface.of(family)
    makers = [f for f in own if f.of("created") and not f.is_copy and f.method != "create"]
    text = filled(f"matlab/rwedge_{family}.m.in", {
        "forms": [f"%   {call(f.results, family[0] + '.' + f.method, inputs(f))}" for f in own if is_method(f)],
        "methods": ["".join(method_text(f) for f in own if is_method(f)).removesuffix("\n")],
        "static": ["\n".join(map(maker_text, makers)).removesuffix("\n")],
        **{f.name: commented(help_lines(f)) for f in own}})
    return re.sub(r"^% SPDX[^\n]*\n", "", text) + LICENCE


def enumeration_text(kind: str, numbers: dict[str, int]) -> str:
    """A function that gives a number by its name."""
    name, names = f"rwedge_{kind.lower()}", textwrap.wrap(", ".join(numbers), 100)
    pairs = textwrap.wrap(", ".join(f"'{each}', {value}" for each, value in numbers.items()), 100, break_long_words=False)
    body = ["numbers = struct(" + ", ...\n    ".join(x.rstrip(",") for x in pairs) + ");", "if ~isfield(numbers, name)",
            f"    error('rwedge:domain', '{name}: name = %s; allowed is %s', name, strjoin(fieldnames(numbers)', ', '));", "end",
            "number = numbers.(name);"]
    text = ["The number that the library has for a name, one of", *names]
    return routine(f"number = {name}(name)", name, f"number = {name}(name)", text, 1, body) + LICENCE


def texts(interface: Interface) -> dict[str, str]:
    made = {f"rwedge_{f.name}.m": function_text(f) for f in interface.functions if not f.family and not f.array_of}
    made.update({f"rwedge_{kind.lower()}.m": enumeration_text(kind, numbers) for kind, numbers in interface.enumerations.items()})
    made.update({f"rwedge_{family}.m": class_text(interface, family) for family in interface.objects})
    return made
