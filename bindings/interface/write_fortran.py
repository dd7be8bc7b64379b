# SPDX-License-Identifier: GPL-3.0-or-later
"""Writes the Fortran module, rwedge.f90, from the header and template.f90: interfaces to C, elemental functions, and
subroutines with stat and errmsg; the comments are the header's."""
from __future__ import annotations

import itertools
import math
import textwrap
from operator import itemgetter

from header import EQUATION, NAMES, Function, Interface, Parameter, filled, name_of

WIDTH = 128
# Written in the template: what has another name here or no handle, and what frees.
BY_HAND = {"version", "strerror", "contact_destroy", "cycle_destroy", "series_destroy"}
TYPES = {"double": "real(c_double)", "int32_t": "integer(c_int32_t)", "size_t": "integer(c_size_t)", "const char *": "type(c_ptr)"}


def folded(line: str) -> str:
    """A line over as many as it takes, broken behind spaces, within texts too; comments are short enough."""
    if len(line) <= WIDTH or line.lstrip().startswith("!"):
        return line
    margin = line[:len(line) - len(line.lstrip())] + "    "
    pieces = textwrap.wrap(line.strip(), WIDTH - len(margin) - 2, drop_whitespace=False, break_long_words=False, break_on_hyphens=False)
    return margin[4:] + f"&\n{margin}&".join(pieces)


def block(head: str, lines: list[str], end: str) -> list[str]:
    return [head, *("    " + line for line in lines), end]


def declarations(groups: list[tuple[str, str]]) -> list[str]:
    """(type, name): consecutive ones of a type on one line."""
    return [f"{kind} :: {', '.join(name for _, name in group)}" for kind, group in itertools.groupby(groups, itemgetter(0))]


# ---- Interfaces to C ----


def in_c(p: Parameter) -> tuple[str, str]:
    name = name_of(p)
    if p.role in ("handle", "changed"):
        return "type(c_ptr), value", name
    if p.role == "created":
        return "type(c_ptr), intent(out)", name
    if p.role in ("in", "size"):
        return f"{TYPES[p.kind]}, value", name
    intent = "in" if p.role == "in array" else "inout"
    return f"real(c_double), intent({intent})", name + ("(*)" if "array" in p.role else "")


def interface_of(f: Function) -> list[str]:
    result = {"status": "status", "nothing": ""}.get(f.result, "value")
    unit = "function" if result else "subroutine"
    head = f"{'pure ' * (f.result == 'value')}{unit} c_{f.name}({', '.join(name_of(p) for p in f.parameters)})"
    bind = f'bind(C, name="rwedge_{f.name}")' + (f" result({result})" if result else "")
    groups = [in_c(p) for p in f.parameters] + ([(TYPES[f.returns], result)] if result else [])
    used = sorted({k for kind, _ in groups for k in ("c_double", "c_int32_t", "c_ptr", "c_size_t") if k in kind})
    return block(f"{head} {bind}", [f"import :: {', '.join(used)}", *declarations(groups)], f"end {unit}")


# ---- Procedures ----


def comment(f: Function) -> list[str]:
    return [("!> " + EQUATION.sub(r"   \1", line)).rstrip() for line in f.comment]


def in_fortran(p: Parameter) -> tuple[str, str]:
    name = name_of(p)
    intent = "in" if p.role in ("in", "in array") else "inout"
    shape = {0: "", 1: "(:)", 2: "(:, :)"}[len(p.size)]
    optional = ", optional" if p.optional else ""
    return f"{TYPES[p.kind]}, intent({intent}){optional}", name + shape


def passed(f: Function, sizes: dict[str, str], at: str = "") -> str:
    """The arguments of the call in C; at one element where at says which."""
    words = []
    for p in f.parameters:
        name = name_of(p)
        k = f.outputs.index(p) + 1 if p in f.outputs else 0
        if p.role in ("handle", "changed"):
            owner = "from" if f.is_copy else "this" if f.object == f.family else p.name
            words.append(f"own({owner})")
        elif p.role == "created":
            words.append("created")
        elif p.role == "size":
            words.append(sizes[p.name])
        elif p.optional:
            words.append(f"place({[q for q in f.outputs if q.optional].index(p) + 1})")
        elif at and "array" in p.role:
            words.append(f"{name}({at}:{at})" if p.role == "in array" else f"s({k}:{k})")
        else:
            words.append(name)
    return f"c_{f.name}({', '.join(words)})"


def allowed(f: Function) -> str:
    """What the arguments may be, of each where the condition does not name it."""
    parts: dict[str, str] = {}
    for p in f.inputs:
        conditions = [c.replace(p.name, name_of(p)) if p.name in NAMES else c for c in p.domain.conditions]
        text = ", ".join(conditions)
        named = any(c.startswith(("0 <", "1 <", "-1 <")) and f" {p.name} " in f" {c} " or c.startswith(f"|{p.name}|")
                    for c in conditions)
        parts[name_of(p)] = text if named else f"{name_of(p)} {text}"
    sizes = [f"{p.name} {', '.join(p.domain.conditions)}" for p in f.of("size") if p.domain and p.domain.conditions]
    return "; ".join([*parts.values(), *sizes])


def call_name(f: Function) -> str:
    return f"rwedge_{f.family}%{f.method}" if f.family else f"rwedge_{f.name}"


def in_message(names: list[Parameter], at: str = "") -> tuple[list[str], list[str]]:
    """How a message names these arguments, and their values; of arrays the element at."""
    words = [name_of(p) + (f"({at})" if p.size else "") for p in names]
    return [name_of(p) for p in names], [f"real({w}, c_double)" if p.kind == "int32_t" else w for p, w in zip(names, words)]


def conclude(f: Function, status: str, names: list[str], values: list[str], more: str = "", at: str = "", why: str = "") -> str:
    """Hands over the status with what its message needs; why there is no result is told by the function where nothing else does."""
    absent = "; ".join(filter(None, [f.reasons.get("RWEDGE_EABSENT", ""), f.path]))
    why = why or (f"'{absent}'" if absent else "")
    call_text = f"'{call_name(f)}({', '.join(names) if names or not f.inputs else '...'})'"
    array = f"[{', '.join(values)}]" if values else "[real(c_double) ::]"
    given = ["stat", "errmsg", *[at] * bool(at), *[f"why={why}"] * bool(why)]
    text = (allowed(f) + more).replace("'", "''")
    return f"call conclude({status}, {call_text}, {array}, '{text}', {', '.join(given)})"


def extent(f: Function, size: str, kind: str = "") -> tuple[Parameter, str]:
    """The first array that has a size, and how Fortran asks for it; loads are the second dimension, C's first."""
    about = next(p for p in f.sizes if p.name == size)
    if about.role == "implied":
        return about, str(about.fixed or f"c_{about.given_by}({about.given_from})")
    arrays = [p for p in f.inputs + f.outputs if size in p.size]
    first = next((p for p in arrays if len(p.size) == 1), arrays[0])
    dimension = f", {2 - first.size.index(size)}" if len(first.size) == 2 else ""
    return first, f"size({name_of(first)}{dimension}{kind})"


def sizes_of(f: Function) -> dict[str, str]:
    return {p.name: extent(f, p.name, ", kind=c_size_t")[1] for p in f.of("size")}


def agreement(f: Function) -> list[str]:
    """The conditions that arrays fit each other."""
    conditions = []
    for size in f.sizes:
        first, of_first = extent(f, size.name)
        others = [p for p in f.inputs + f.outputs if p.size == (size.name,) and p is not first]
        if len(others) == 1:
            conditions.append(f"size({name_of(others[0])}) == {of_first}")
        elif others:
            conditions.append(f"all([{', '.join(f'size({name_of(p)})' for p in others)}] == {of_first})")
    for p in f.inputs + f.outputs:
        if len(p.size) == 2 and p is not extent(f, p.size[0])[0]:
            rows, columns = (extent(f, n)[1] for n in reversed(p.size))
            conditions.append(f"all(shape({name_of(p)}) == [{rows}, {columns}])")
    return conditions


def bounds(p: Parameter) -> str:
    d = p.domain
    low = "-huge(1.0_c_double)" if math.isinf(d.low) else f"{d.low!r}_c_double"
    high = "huge(1.0_c_double)" if math.isinf(d.high) else f"{d.high!r}_c_double"
    marks = (f".{str(x).lower()}." for x in (d.low_open, d.high_open, d.or_zero))
    return ", ".join([low, high, f"{d.smallest!r}_c_double", *marks])


def search(f: Function) -> list[str]:
    """Says which element was refused: of points by trying each, of other arrays by their domain."""
    arrays = f.of("in array")
    if f.pointwise:
        alone = passed(f, {f.of("size")[0].name: "1_c_size_t"}, "i")
        tried = [f"if ({alone} == rwedge_ok) cycle", conclude(f, "status", *in_message(f.inputs, "i"), at="i"), "return"]
        return block("if (status == rwedge_edomain) then", block(f"do i = 1, size({name_of(arrays[0])})", tried, "end do"), "end if")
    lines = []
    for p in (p for p in arrays if len(p.size) == 1):
        told = conclude(f, "status", *in_message([q for q in arrays if q.size == p.size], "i"), at="i")
        lines += [f"i = first_outside({name_of(p)}, {bounds(p)})",
                  *block("if (status == rwedge_edomain .and. i > 0) then", [told, "return"], "end if")]
    return lines


def body(f: Function) -> tuple[list[tuple[str, str]], list[str]]:
    """Local variables and statements of a subroutine."""
    local: list[tuple[str, str]] = []
    optional = [p for p in f.outputs if p.optional]
    if optional:
        local.append(("real(c_double)", f"place({len(optional)})"))
    if f.of("created"):
        local.append(("type(c_ptr)", "created"))
    call = passed(f, sizes_of(f))
    if not (f.of("in array", "out array", "created") or optional or f.name == "contact_apply"):
        return local, [conclude(f, call, *in_message(f.inputs))]
    local.append(("integer(c_int32_t)", "status"))
    if f.name == "contact_apply":
        obstacle = conclude(f, "status", *in_message(f.inputs), why="this%obstacle(P, M, Q, sigma)")
        return local, [f"status = {call}", *block("if (status == rwedge_epath) then", [obstacle, "return"], "end if"),
                       conclude(f, "status", *in_message(f.inputs))]
    fits = agreement(f)
    lines = ["status = rwedge_erange", f"if ({' .and. '.join(fits)}) status = {call}"] if fits else [f"status = {call}"]
    if f.of("created"):
        lines.append(f"if (status == rwedge_ok) call own_{f.family}(this, created)")
    lines += [f"if (status == rwedge_ok .and. present({name_of(p)})) {name_of(p)} = place({k})" for k, p in enumerate(optional, 1)]
    if any(len(p.size) == 1 for p in f.of("in array")):
        local.append(("integer", "i"))
        if f.pointwise:
            local.insert(0, ("real(c_double)", f"s({len(f.outputs)})"))
        lines += search(f)
    names, numbers = in_message([] if f.pointwise else [p for p in f.inputs if not p.size])
    if f.of("in array") and not f.pointwise:
        counted = [extent(f, p.name)[1] for p in f.of("size")]
        names, numbers = counted + names, [f"real({c}, c_double)" for c in counted] + numbers
    return local, [*lines, conclude(f, "status", names, numbers, "; arrays of one size" if fits else "")]


ERROR = [("integer, intent(out), optional", "stat"), ("character(*), intent(inout), optional", "errmsg")]


def procedure(f: Function) -> list[str]:
    own = [(f"class(rwedge_{f.family}), intent({'in' if f.of('handle') and not f.of('created') else 'inout'})", "this")] \
        if f.family else []
    if f.of("created") and f.of("handle"):
        own.append((f"type(rwedge_{f.object}), intent(in)", "from" if f.is_copy else f.object))
    name = f.name if f.family else f"rwedge_{f.name}"
    dummies = own + [in_fortran(p) for p in f.parameters if p in f.inputs or p in f.outputs]
    names = [n.split("(")[0] for _, n in dummies]
    if f.result in ("value", "text"):
        arrays = bool(f.of("in array"))
        elemental = "" if f.result == "text" else "elemental " if not arrays and (f.inputs or not f.family) else "pure "
        kind = "character(:), allocatable" if f.result == "text" else TYPES[f.returns]
        value = passed(f, {}) if f.result == "value" else f"text_of({passed(f, {})})"
        fitting = [f"value = ieee_value(value, ieee_quiet_nan)", f"if ({' .and. '.join(agreement(f))}) value = {value}"]
        return [*comment(f), *block(f"{elemental}function {name}({', '.join(names)}) result({f.result})",
                                    [*declarations([*dummies, (kind, f.result)]), *(fitting if arrays else [f"{f.result} = {value}"])],
                                    "end function"), ""]
    plain = bool(f.of("changed", "created", "in array", "out array") or any(p.optional for p in f.outputs))
    head = f"{'' if plain else 'impure elemental '}subroutine {name}({', '.join(names + ['stat', 'errmsg'])})"
    local, statements = body(f)
    return [*comment(f), *block(head, [*declarations(dummies + ERROR), *declarations(local), *statements], "end subroutine"), ""]


def called(f: Function, arguments: list[str]) -> str:
    """How a user calls it, but for what stands before."""
    made_of = [f.object] * bool(f.of("created") and f.object and not f.is_copy)
    return f"{f'{f.family}%' if f.family else 'rwedge_'}{f.method}({', '.join(made_of + arguments)})"


# ---- The module ----


def procedures(interface: Interface) -> list[str]:
    lines, section = [], ""
    for f in interface.functions:
        if f.name in BY_HAND:
            continue
        if f.section != section:
            section = f.section
            lines += [f"! ---- {section} ".ljust(117, "-"), ""]
        lines += procedure(f) + (grid(f) if has_grid(f) else [])
    return lines[:-1]


def bound(interface: Interface, family: str) -> list[str]:
    lines = []
    for f in interface.of(family):
        if has_grid(f):
            lines += [f"procedure, private :: {f.method}_of_list => {f.name}", f"procedure, private :: {f.method}_of_grid => {f.name}_of_grid",
                      f"generic :: {f.method} => {f.method}_of_list, {f.method}_of_grid"]
        else:
            lines.append(f"procedure :: {f.method} => {f.name}")
    return lines


def has_grid(f: Function) -> bool:
    """A method of points takes them as a grid too."""
    return bool(f.family) and f.pointwise and all(len(p.size) == 1 for p in f.inputs + f.outputs)


def grid(f: Function) -> list[str]:
    """The same of arrays of rank 2: those of the list, laid out again."""
    names, outputs = [name_of(p) for p in f.inputs + f.outputs], [name_of(p) for p in f.outputs]
    first, others = names[0], names[1:]
    fits = " .and. ".join(f"all([{', '.join(f'size({n}, {k})' for n in others)}] == size({first}, {k}))" for k in (1, 2))
    lists = [f"list_{n}" if n in outputs else f"reshape({n}, [size({n})])" for n in names]
    dummies = [(f"class(rwedge_{f.family}), intent(in)", "this")]
    dummies += [(in_fortran(p)[0], f"{name_of(p)}(:, :)") for p in f.inputs + f.outputs]
    refused = f"call conclude(rwedge_erange, '{call_name(f)}(...)', [real(c_double) ::], 'arrays of one shape', stat, errmsg)"
    lines = [*declarations([*dummies, *ERROR, *(("real(c_double), allocatable", f"list_{n}(:)") for n in outputs)]),
             *block(f"if (.not. ({fits})) then", [refused, "return"], "end if"),
             *(f"list_{n} = reshape({n}, [size({n})])" for n in outputs),
             f"call this%{f.method}({', '.join(lists)}, stat, errmsg)",
             *(f"{n} = reshape(list_{n}, shape({n}))" for n in outputs)]
    head = f"subroutine {f.name}_of_grid({', '.join(['this', *names, 'stat', 'errmsg'])})"
    return ["!> The same of arrays of rank 2.", *block(head, lines, "end subroutine"), ""]


def shared(interface: Interface) -> list[str]:
    """The kinds of objects that never change once made, so that copies share them."""
    return [kind for kind in interface.objects if not any(f.of("changed") and f.result == "status" for f in interface.of(kind))]


def shared_type(interface: Interface, kind: str) -> list[str]:
    return ["! It never changes once made, so that copies share it.", f"type, extends(owner), public :: rwedge_{kind}", "    private",
            "    integer, pointer :: users => null()", "contains", *("    " + line for line in bound(interface, kind)),
            f"    procedure, private :: assign_{kind}", f"    generic :: assignment(=) => assign_{kind}",
            f"    final :: finalize_{kind}", "end type", ""]


def shared_life(kind: str) -> list[str]:
    return filled("fortran/shared.f90", {}).replace("{kind}", kind).split("\n")[2:]


def module(interface: Interface) -> str:
    statuses = ", ".join(f"{name.lower()} = {value}" for name, value in {**interface.statuses, **interface.bits}.items())
    public = [f"rwedge_{f.name}" for f in interface.functions if not f.family and f.name not in BY_HAND]
    return filled("fortran/template.f90", {
        "statuses": [f"integer(c_int32_t), parameter, public :: {statuses}"], "public": [f"public :: {', '.join(public)}"],
        "contact procedures": bound(interface, "contact"),
        "shared types": [line for kind in shared(interface) for line in shared_type(interface, kind)][:-1],
        "shared assignments": [f"module procedure assign_several_of_{kind}, assign_{kind}_to_all" for kind in shared(interface)],
        "shared life": [line for kind in shared(interface) for line in shared_life(kind)][:-1],
        "interfaces": [line for f in interface.functions for line in [*interface_of(f), ""]][:-1],
        "procedures": procedures(interface)})


def texts(interface: Interface) -> dict[str, str]:
    return {"rwedge.f90": "\n".join(map(folded, module(interface).split("\n")))}
