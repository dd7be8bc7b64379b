# SPDX-License-Identifier: GPL-3.0-or-later
"""Writes the Fortran module, rwedge.f90, from the header and template.f90: interfaces to C, elemental functions, and
subroutines with stat and errmsg; the comments are the header's."""
from __future__ import annotations

import math
import sys
import textwrap

from header import EQUATION, Function, Interface, Parameter, template

WIDTH = 128
# Written in the template: what has another name here or no handle, and what frees.
BY_HAND = {"version", "strerror", "contact_destroy", "series_destroy"}
NAMES = {"A": "compliance"}  # Fortran takes a and A for one name
TYPES = {"double": "real(c_double)", "int32_t": "integer(c_int32_t)", "size_t": "integer(c_size_t)", "const char *": "type(c_ptr)"}
OWN_NAMES = {"this", "stat", "errmsg", "created", "from", "s", "i", "status", "place"}


def name_of(p: Parameter) -> str:
    return NAMES.get(p.name, p.name)


def folded(line: str, indent: int) -> str:
    """A statement over as many lines as it takes, broken at ", ", outside of texts where it can be."""
    margin, lines, in_text = " " * indent, [], False
    while len(margin) + len(line) > WIDTH:
        quoted, places = in_text, {True: 0, False: 0}
        for i, letter in enumerate(line[:WIDTH - len(margin) - 2]):
            quoted ^= letter == "'"
            if line[i - 1:i + 1] == ", ":
                places[quoted] = i + 1
        in_text = places[False] == 0
        best = places[in_text]
        if best == 0:
            sys.exit(f"write_fortran.py: no place to break the line {line}")
        lines.append(margin + line[:best] + "&")
        line, margin = "&" * in_text + line[best:], " " * (indent + 4)
    return "\n".join([*lines, margin + line])


def declarations(groups: list[tuple[str, str]]) -> list[str]:
    """(type, name): consecutive ones of a type on one line."""
    lines: list[tuple[str, list[str]]] = []
    for kind, name in groups:
        if lines and lines[-1][0] == kind:
            lines[-1][1].append(name)
        else:
            lines.append((kind, [name]))
    return [f"{kind} :: {', '.join(names)}" for kind, names in lines]


def is_pure(f: Function) -> bool:
    return f.result == "value"


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


def interface_of(f: Function) -> str:
    result = {"status": "status", "nothing": ""}.get(f.result, "value")
    unit = "function" if result else "subroutine"
    head = f"{'pure ' if is_pure(f) else ''}{unit} c_{f.name}({', '.join(name_of(p) for p in f.parameters)})"
    bind = f'bind(C, name="rwedge_{f.name}")' + (f" result({result})" if result else "")
    lines = [f"        {head} {bind}"] if len(head) + len(bind) < 118 else [folded(f"{head} &", 8), f"            &{bind}"]
    groups = [in_c(p) for p in f.parameters] + ([(TYPES[f.returns], result)] if result else [])
    used = sorted({k for kind, _ in groups for k in ("c_double", "c_int32_t", "c_ptr", "c_size_t") if k in kind})
    lines.append(f"            import :: {', '.join(used)}")
    lines += [f"            {x}" for x in declarations(groups)]
    return "\n".join([*lines, f"        end {unit}"])


# ---- Procedures ----


def comment(f: Function) -> str:
    return "\n".join(("    !> " + EQUATION.sub(r"   \1", line)).rstrip() for line in f.comment)


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
            owner = "from" if f.of("created") else "this"
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


def reason(f: Function, indent: int) -> str:
    """When there is no result, as a text of Fortran."""
    pieces = textwrap.wrap("; ".join(filter(None, [f.reasons.get("RWEDGE_EABSENT", ""), f.path])), 90, drop_whitespace=False)
    return f" // &\n{' ' * indent}".join(f"'{piece}'" for piece in pieces)


def conclude(f: Function, status: str, names: list[str], values: list[str], more: str = "", at: str = "",
             indent: int = 8, why: str = "") -> list[str]:
    why = why or reason(f, indent + 8)
    call_text = f"'{call_name(f)}({', '.join(names) if names or not f.inputs else '...'})'"
    array = f"[{', '.join(values)}]" if values else "[real(c_double) ::]"
    why = f", why={why}" if why else ""
    text, end = allowed(f) + more, f", stat, errmsg{', ' + at if at else ''}{why})"
    head = f"call conclude({status}, {call_text}, {array}, "
    if indent + len(head + text + end) + 2 <= WIDTH:
        return [f"{' ' * indent}{head}'{text}'{end}"]
    end = end.replace(", why=", f", &\n{' ' * (indent + 8)}why=")
    margin = " " * (indent + 4)
    pieces = textwrap.wrap(text.replace("'", "''"), 100 - indent, drop_whitespace=False, break_long_words=False) or [""]
    return [folded(head, indent).rstrip() + " &", margin + f" // &\n{margin}".join(f"'{p}'" for p in pieces) + end]


def extent(f: Function, size: str, kind: str = "") -> tuple[Parameter, str]:
    """The first array that has a size, and how Fortran asks for it; loads are the second dimension, C's first."""
    arrays = [p for p in f.inputs + f.outputs if size in p.size]
    first = next((p for p in arrays if len(p.size) == 1), arrays[0])
    dimension = f", {2 - first.size.index(size)}" if len(first.size) == 2 else ""
    return first, f"size({name_of(first)}{dimension}{kind})"


def sizes_of(f: Function) -> dict[str, str]:
    return {p.name: extent(f, p.name, ", kind=c_size_t")[1] for p in f.of("size")}


def agreement(f: Function) -> list[str]:
    """The conditions that arrays fit each other."""
    conditions = []
    for size in f.of("size"):
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
        return ["        if (status == rwedge_edomain) then", f"            do i = 1, size({name_of(arrays[0])})",
                folded(f"if ({alone} == rwedge_ok) cycle", 16), *conclude(f, "status", *in_message(f.inputs, "i"), at="i", indent=16),
                "                return", "            end do", "        end if"]
    lines = []
    for p in (p for p in arrays if len(p.size) == 1):
        together = [q for q in arrays if q.size == p.size]
        lines += [folded(f"i = first_outside({name_of(p)}, {bounds(p)})", 8), "        if (status == rwedge_edomain .and. i > 0) then",
                  *conclude(f, "status", *in_message(together, "i"), at="i", indent=12), "            return", "        end if"]
    return lines


def body(f: Function) -> tuple[list[tuple[str, str]], list[str]]:
    """Local variables and statements of a subroutine."""
    local: list[tuple[str, str]] = []
    arrays = f.of("in array", "out array")
    optional = [p for p in f.outputs if p.optional]
    if optional:
        local.append(("real(c_double)", f"place({len(optional)})"))
    if f.of("created"):
        local.append(("type(c_ptr)", "created"))
    call = passed(f, sizes_of(f))
    if not (arrays or optional or f.of("created") or f.name == "contact_apply"):
        return local, conclude(f, call, *in_message(f.inputs))
    local.append(("integer(c_int32_t)", "status"))
    if f.name == "contact_apply":
        return local, [f"        status = {call}", "        if (status == rwedge_epath) then",
                       *conclude(f, "status", *in_message(f.inputs), indent=12, why="this%obstacle(P, M, Q, sigma)"),
                       "            return", "        end if", *conclude(f, "status", *in_message(f.inputs))]
    fits = agreement(f)
    lines = [folded(f"status = {call}", 8)]
    if fits:
        lines = ["        status = rwedge_erange", folded(f"if ({' .and. '.join(fits)}) &", 8), folded(f"status = {call}", 12)]
    if f.of("created"):
        lines.append(f"        if (status == rwedge_ok) call own_{f.family}(this, created)")
    for k, p in enumerate(optional, 1):
        lines.append(f"        if (status == rwedge_ok .and. present({name_of(p)})) {name_of(p)} = place({k})")
    if f.of("in array"):
        if any(len(p.size) == 1 for p in f.of("in array")):
            local.append(("integer", "i"))
        if f.pointwise:
            local.insert(0, ("real(c_double)", f"s({len(f.outputs)})"))
        lines += search(f)
    names, numbers = in_message([] if f.pointwise else [p for p in f.inputs if not p.size])
    if f.of("in array") and not f.pointwise:
        counted = [extent(f, p.name)[1] for p in f.of("size")]
        names, numbers = counted + names, [f"real({c}, c_double)" for c in counted] + numbers
    return local, [*lines, *conclude(f, "status", names, numbers, "; arrays of one size" if fits else "")]


def procedure(f: Function) -> str:
    own = [(f"class(rwedge_{f.family}), intent({'in' if f.of('handle') and not f.of('created') else 'inout'})", "this")] \
        if f.family else []
    if f.of("created") and f.of("handle"):
        own.append((f"type(rwedge_{f.family})" + ", intent(in)", "from"))
    name = f.name if f.family else f"rwedge_{f.name}"
    parameters = [p for p in f.parameters if p in f.inputs or p in f.outputs]
    dummies = own + [in_fortran(p) for p in parameters]
    names = [n.split("(")[0] for _, n in dummies]
    check_names(f, names)
    if f.result == "text":
        lines = [*declarations(dummies + [("character(:), allocatable", "text")]), f"text = text_of({passed(f, {})})"]
        return "\n".join([comment(f), folded(f"function {name}({', '.join(names)}) result(text)", 4),
                          *(folded(x, 8) for x in lines), "    end function\n"])
    if f.result == "value":
        elemental = "elemental" if f.inputs or not f.family else "pure"
        head = f"{elemental} function {name}({', '.join(names)}) result(value)"
        lines = [*declarations(dummies + [(TYPES[f.returns], "value")]), f"value = {passed(f, {})}"]
        inner = [folded(x, 8) for x in lines]
        return "\n".join([comment(f), folded(head, 4), *inner, "    end function\n"])
    plain = bool(f.of("changed", "created", "in array", "out array") or any(p.optional for p in f.outputs))
    head = f"{'' if plain else 'impure elemental '}subroutine {name}({', '.join(names + ['stat', 'errmsg'])})"
    local, statements = body(f)
    dummies += [("integer, intent(out), optional", "stat"), ("character(*), intent(inout), optional", "errmsg")]
    return "\n".join([comment(f), folded(head, 4), *(folded(x, 8) for x in declarations(dummies) + declarations(local)),
                      *statements, "    end subroutine\n"])


def check_names(f: Function, names: list[str]) -> None:
    lower = [n.lower() for n in names]
    clash = {n for n in lower if lower.count(n) > 1} | {p.name for p in f.inputs + f.outputs if name_of(p).lower() in OWN_NAMES}
    if clash:
        sys.exit(f"write_fortran.py: rwedge_{f.name}(): Fortran takes {', '.join(sorted(clash))} for another name: see NAMES")


# ---- The module ----


def procedures(interface: Interface) -> str:
    parts, section = [], ""
    for f in interface.functions:
        if f.name in BY_HAND:
            continue
        if f.section != section:
            section = f.section
            parts.append(f"    ! ---- {section} ".ljust(121, "-") + "\n")
        parts.append(procedure(f))
        if has_grid(f):
            parts.append(grid(f))
    return "\n".join(parts).rstrip("\n")


def bound(interface: Interface, family: str) -> str:
    lines = []
    for f in (f for f in interface.functions if f.family == family):
        if has_grid(f):
            lines += [f"        procedure, private :: {f.method}_of_list => {f.name}",
                      f"        procedure, private :: {f.method}_of_grid => {f.name}_of_grid",
                      f"        generic :: {f.method} => {f.method}_of_list, {f.method}_of_grid"]
        else:
            lines.append(f"        procedure :: {f.method} => {f.name}")
    return "\n".join(lines)


def has_grid(f: Function) -> bool:
    """A method of points takes them as a grid too."""
    return bool(f.family) and f.pointwise and all(len(p.size) == 1 for p in f.inputs + f.outputs)


def grid(f: Function) -> str:
    """The same of arrays of rank 2: those of the list, laid out again."""
    names = [name_of(p) for p in f.inputs + f.outputs]
    first, others = names[0], names[1:]
    fits = " .and. ".join(f"all([{', '.join(f'size({n}, {k})' for n in others)}] == size({first}, {k}))" for k in (1, 2))
    lists = ", ".join(f"reshape({name_of(p)}, [size({name_of(p)})])" if p in f.inputs else f"list_{name_of(p)}"
                      for p in f.inputs + f.outputs)
    dummies = [(f"class(rwedge_{f.family}), intent(in)", "this")]
    dummies += [(in_fortran(p)[0], f"{name_of(p)}(:, :)") for p in f.inputs + f.outputs]
    dummies += [("integer, intent(out), optional", "stat"), ("character(*), intent(inout), optional", "errmsg")]
    dummies += [("real(c_double), allocatable", f"list_{name_of(p)}(:)") for p in f.outputs]
    lines = declarations(dummies)
    lines += [f"if (.not. ({fits})) then",
              f"    call conclude(rwedge_erange, '{call_name(f)}(...)', [real(c_double) ::], 'arrays of one shape', stat, &",
              "        &errmsg)",
              "    return", "end if"]
    lines += [f"list_{name_of(p)} = reshape({name_of(p)}, [size({name_of(p)})])" for p in f.outputs]
    lines.append(f"call this%{f.method}({lists}, stat, errmsg)")
    lines += [f"{name_of(p)} = reshape(list_{name_of(p)}, shape({name_of(p)}))" for p in f.outputs]
    head = f"subroutine {f.name}_of_grid({', '.join(['this', *names, 'stat', 'errmsg'])})"
    return "\n".join(["    !> The same of arrays of rank 2.", folded(head, 4),
                      *(folded(x.lstrip(), 8 + len(x) - len(x.lstrip())) for x in lines), "    end subroutine\n"])


def module(interface: Interface) -> str:
    statuses = ", ".join(f"{name.lower()} = {value}" for name, value in {**interface.statuses, **interface.bits}.items())
    public = [f"rwedge_{f.name}" for f in interface.functions if not f.family and f.name not in BY_HAND]
    replaced = {
        "{statuses}": folded(f"integer(c_int32_t), parameter, public :: {statuses}", 4),
        "{public}": folded(f"public :: {', '.join(public)}", 4),
        "{contact procedures}": bound(interface, "contact"), "{series procedures}": bound(interface, "series"),
        "{interfaces}": "\n\n".join(map(interface_of, interface.functions)),
        "{procedures}": procedures(interface)}
    module_text = template("fortran/template.f90")
    for mark, text in replaced.items():
        module_text = module_text.replace(mark, text)
    return module_text


# ---- The program that answers: a case for each call of tests/answers/ ----


def in_answer(f: Function, p: Parameter) -> str:
    if p in f.outputs:
        k = f.outputs.index(p) + 1
        return {0: f"s(1, 1, {k})", 1: f"s(:, 1, {k})", 2: f"s(:, :, {k})"}[len(p.size)]
    value = f"v({f.inputs.index(p) + 1})%x"
    value += {0: "(1)", 1: "", 2: "x"}[len(p.size)]
    return f"int({value}, c_int32_t)" if p.kind == "int32_t" else value


def answer_case(f: Function) -> str:
    arguments = [in_answer(f, p) for p in f.parameters if p in f.inputs or p in f.outputs]
    name = f"{f.family}%{f.method}" if f.family else f"rwedge_{f.name}"
    lines = [f"case ('{f.name}')"]
    if f.result in ("value", "text"):
        value = f"{name}({', '.join(arguments)})"
        value = f"len({value})" if f.result == "text" else value
        return "\n".join([folded(lines[0], 8), folded(f"r = [{value if f.returns == 'double' else f'real({value}, c_double)'}]", 12)])
    shape = {}
    for k, p in enumerate(f.inputs, 1):
        if len(p.size) == 1:
            shape.setdefault(p.size[0], f"size(v({k})%x)")
        elif p.size:
            shape.update({p.size[0]: f"size(v({k})%xx, 2)", p.size[1]: f"size(v({k})%xx, 1)"})
    shape.update({p.name: f"int(contact%{p.given_by.removeprefix('contact_')}())" for p in f.of("size") if p.given_by})
    if f.outputs:
        dimensions = next((p.size for p in f.outputs if p.size), ())
        lines.append(f"allocate (s({', '.join([shape[n] for n in reversed(dimensions)] + ['1'] * (2 - len(dimensions)))}, {len(f.outputs)}))")
    if f.of("created") and f.of("handle"):
        lines += [f"call other%{f.method}({f.family}, stat)", f"{f.family} = other"]
    else:
        lines.append(f"call {name}({', '.join(arguments + ['stat'])})")
    lines.append("r = [s]" if f.outputs else "r = [real(c_double) ::]")
    return "\n".join([folded(lines[0], 8), *(folded(x, 12) for x in lines[1:])])


def answer(interface: Interface) -> str:
    cases = [answer_case(f) for f in interface.functions if f.name not in BY_HAND]
    return template("fortran/answer_template.f90").replace("{cases}", "\n".join(cases))


def texts(interface: Interface) -> dict[str, str]:
    return {"rwedge.f90": module(interface), "answer.f90": answer(interface)}
