# SPDX-License-Identifier: GPL-3.0-or-later
"""What the JavaScript package takes from the header, written when the package is built.

    description.mjs  the statuses; each function's arguments, results and domains, for runtime.mjs
    rwedge.mjs       the functions and classes: calls of runtime.mjs
    rwedge.d.mts     their types and texts
"""
from __future__ import annotations

import json
import math
import textwrap

from header import WITHOUT_NULL, Function, Interface, Parameter, replaced

TOP = """\
// SPDX-License-Identifier: GPL-3.0-or-later
// Made by bindings/interface from rwedge.h: do not edit.
"""
IN_JAVASCRIPT = (  # statuses, pointers and limits, in the words of JavaScript
    WITHOUT_NULL, (r"(; |, )?RWEDGE_ENULL", ""),
    (r"rwedge_(?:contact|cycle|series)_(\w+\(\))", r"\1"), (r"rwedge_(\w+\(\w*\))", r"\1"), ("HUGE_VAL", "Infinity"), ("RWEDGE_E", "E"), ("RWEDGE_MEASURE_", "Measure."),
    ("RWEDGE_FACES_", "Faces."))


def told(f: Function, size: Parameter) -> bool:
    """Does an array, or a function, tell this size?"""
    arrays = [p.size for p in f.of("in array")]
    return bool(size.given_by) or any(sizes == (size.name,) or len(sizes) == 2 and sizes[1] == size.name for sizes in arrays)


def arguments(f: Function) -> list[Parameter]:
    """What JavaScript gives: the numbers and arrays, and the sizes that no array tells."""
    return [p for p in f.parameters if p in f.inputs or p.role == "size" and not told(f, p)]


def made_of(f: Function) -> list[str]:
    """The object of another kind that it makes its own of."""
    return [f.object] if f.of("created") and f.object and not f.is_copy else []


def is_formula(f: Function) -> bool:
    """Is it of numbers alone, so that it can be asked for many at a time?"""
    return not f.family and bool(f.of("in")) and f.result != "text" and {p.role for p in f.parameters} <= {"in", "out"}


def of_points(f: Function) -> bool:
    return is_formula(f) or f.pointwise


def finite(value: float) -> float | None:
    return value if math.isfinite(value) else None


def about_parameter(p: Parameter) -> dict:
    about = {"name": p.name, "role": p.role, "kind": p.kind}
    if p.size:
        about["size"] = p.size
    if p.given_by:
        about["givenBy"] = p.given_by
    if d := p.domain:
        about["domain"] = {"text": words(", ".join(d.conditions)), "low": finite(d.low), "high": finite(d.high), "lowOpen": d.low_open,
                           "highOpen": d.high_open, "orZero": d.or_zero, "finite": d.finite, "smallest": d.smallest, "any": d.any}
    return about


def description(interface: Interface) -> str:
    functions = {f.name: {"result": f.result, "pointwise": of_points(f), "arguments": [p.name for p in arguments(f)],
                          "reasons": {interface.statuses[status]: words(why) for status, why in f.reasons.items()
                                      if status in ("RWEDGE_EABSENT", "RWEDGE_EPATH") and "obstacle" not in why},
                          "parameters": [about_parameter(p) for p in f.parameters],
                          "implied": [{"name": p.name, "fixed": p.fixed, "givenBy": p.given_by, "givenFrom": p.given_from} for p in f.implied]}
                 for f in interface.functions}
    lines = [f"    {name}: {json.dumps(about)}," for name, about in functions.items()]
    statuses = json.dumps(interface.statuses)
    return "\n".join([TOP, f"export const statuses = Object.freeze({statuses});", "export const functions = {", *lines, "};", ""])


def call(f: Function) -> str:
    names = ", ".join(p.name for p in arguments(f))
    if is_formula(f):
        return f'formula("{f.name}", [{names}])'
    this = "null" if not f.object else "this" if f.object == f.family else f.object
    return f'call("{f.name}", {this}, [{names}])'


def definition(f: Function) -> str:
    names = ", ".join(p.name for p in arguments(f))
    if not f.family:
        return f"export function {f.name}({names}) {{\n    return {call(f)};\n}}\n"
    if f.method == "create":
        names = ", ".join([*made_of(f), *(p.name for p in arguments(f))])
        return f'    constructor({names}) {{\n        adopt(this, "{f.family}", {call(f)});\n    }}\n'
    if f.method == "destroy":
        return "    free() {\n        free(this);\n    }\n"
    if f.of("created"):
        head, prototype = (f.method, "Object.getPrototypeOf(this)") if f.is_copy else (f"static {f.method}", "this.prototype")
        names = ", ".join([*made_of(f), *(p.name for p in arguments(f))])
        return f'    {head}({names}) {{\n        return adopt(Object.create({prototype}), "{f.family}", {call(f)});\n    }}\n'
    return f"    {f.method}({names}) {{\n        return {call(f)};\n    }}\n"


def module(interface: Interface) -> str:
    parts = [TOP, 'import { adopt, call, formula, free } from "./runtime.mjs";\n\n'
             'export { statuses } from "./description.mjs";\nexport { RwedgeError } from "./runtime.mjs";\n']
    parts += [f"export const {kind} = Object.freeze({json.dumps(numbers)});" for kind, numbers in interface.enumerations.items()]
    parts += [definition(f) for f in interface.of("")]
    for family in interface.objects:
        methods = [definition(f) for f in interface.of(family)]
        parts.append(f"export class {family.title()} {{\n" + "\n".join(methods) + "}\n")
    return "\n".join(parts)


# ---- Types ----


def words(text: str) -> str:
    return " ".join(replaced(text, IN_JAVASCRIPT).split())


def domain_text(p: Parameter) -> str:
    """As the header says it, and what its first page says of whatever has a size."""
    size = next((c for c in p.domain.conditions if p.domain.smallest and ("e60" in c or "e-60" in c)), "")
    return words(p.domain.text) + (f"; {size}" if size and size not in p.domain.text else "")


def comment(f: Function, margin: str) -> list[str]:
    lines = [line for paragraph in f.text.split("\n\n") for line in textwrap.wrap(words(paragraph), 110)]
    lines += [f"{f.equation}."] if f.equation else []
    for p in arguments(f):
        if p.domain:
            lines += textwrap.wrap(f"@param {p.name} {domain_text(p)}", 110, subsequent_indent="    ")
    return [f"{margin}/**", *(f"{margin} * {line}" for line in lines), f"{margin} */"]


def argument_type(p: Parameter) -> str:
    return "Numbers" if p.role == "in array" else "number"


def result_type(f: Function, single: str, many: str) -> str:
    """single: the type of an output that is a number, many: of an array."""
    if f.result in ("value", "text"):
        return "string" if f.result == "text" else single
    types = {p.name: many if p.role == "out array" else single for p in f.outputs}
    if not types:
        return "void"
    return next(iter(types.values())) if len(types) == 1 else "{ " + "; ".join(f"{n}: {t}" for n, t in types.items()) + " }"


def typed(parameters: list[Parameter], kind: str | None = None) -> str:
    return ", ".join(f"{p.name}: {kind or argument_type(p)}" for p in parameters)


def declarations(f: Function) -> list[str]:
    """One line, or two where it takes numbers as well as arrays."""
    parameters = arguments(f)
    head = "" if f.family else "export function "
    if f.family and f.method == "create":
        return [f"constructor({', '.join([*(f'{kind}: {kind.title()}' for kind in made_of(f)), typed(parameters)])});"]
    if f.method == "destroy":
        return ["free(): void;"]
    if f.of("created"):
        static = "" if f.is_copy else "static "
        return [f"{static}{f.method}({typed(parameters)}): {f.family.title()};"]
    if of_points(f):
        mixed = ", ".join(f"{p.name}: {'number | Numbers' if p.kind == 'double' and (is_formula(f) or p.role == 'in array') else 'number'}"
                          for p in parameters)
        return [f"{head}{f.method}({typed(parameters, 'number')}): {result_type(f, 'number', 'number')};",
                f"{head}{f.method}({mixed}): {result_type(f, 'Float64Array', 'Float64Array')};"]
    return [f"{head}{f.method}({typed(parameters)}): {result_type(f, 'number', 'Float64Array')};"]


TYPES = """
/** An array of numbers. */
export type Numbers = readonly number[] | Float64Array | Float32Array | Int32Array | Uint32Array | Int16Array | Uint16Array |
    Int8Array | Uint8Array | Uint8ClampedArray;

/** The header's statuses: strerror() takes their numbers. */
export const statuses: {statuses};

/** What a status of the library other than RWEDGE_OK becomes. */
export class RwedgeError extends Error {
    /** The header's name of it, such as "RWEDGE_EDOMAIN". */
    readonly status: keyof typeof statuses;
}
"""


def types(interface: Interface) -> str:
    statuses = "".join(f"    readonly {name}: {value};\n" for name, value in interface.statuses.items())
    lines = [TOP, TYPES.replace("{statuses}", f"{{\n{statuses}}}")]
    for kind, numbers in interface.enumerations.items():
        of_kind = "; ".join(f"readonly {name}: {value}" for name, value in numbers.items())
        lines += [f"/** The numbers RWEDGE_{kind.upper()}_... of the header. */", f"export const {kind}: {{ {of_kind} }};", ""]
    for f in interface.of(""):
        lines += [*comment(f, ""), *declarations(f), ""]
    for family in interface.objects:
        lines.append(f"export class {family.title()} {{")
        for f in interface.of(family):
            lines += [*comment(f, "    "), *(f"    {line}" for line in declarations(f)), ""]
        lines += ["}", ""]
    return "\n".join(lines)


def texts(interface: Interface) -> dict[str, str]:
    return {"description.mjs": description(interface), "rwedge.mjs": module(interface), "rwedge.d.mts": types(interface)}
