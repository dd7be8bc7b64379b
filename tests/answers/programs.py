# SPDX-License-Identifier: GPL-3.0-or-later
"""How the calls of calls.py are written for a language: as the documentation shows them, with what tells their results. For C and
Fortran they make a program; others evaluate a text, which stands behind the call and a tab."""
from header import Function, Parameter, filled, name_of
from languages import C, Fortran, JavaScript, Matlab, Python, plain
from write_fortran import folded

TEMPLATES = {"c": "../tests/answers/answer.c.in", "fortran": "fortran/answer.f90.in"}
# A procedure of some calls, and how it is called: compilers take the longer for one the longer it is.
PARTS = {"c": ("static void part_{}(void)\n{{", "}}", "part_{}();"), "fortran": ("subroutine part_{}()", "end subroutine", "call part_{}()")}
LENGTH = 100
TEXTS = {"javascript": JavaScript(), "matlab": Matlab(), "python": Python()}  # which evaluate a text


def in_c(f: Function, line: str, values: dict, counts: dict[str, int]) -> list[str]:
    first = f.family or ", ".join(plain(values[p.name]) for p in f.of("in"))
    lines = [f"const size_t {p.name} = rwedge_{p.given_by}({first});" for p in f.of("size") if p.given_by]
    for p in f.of("in array"):
        if values[p.name] == "before":
            lines += [f"const double *const {p.name} = before;", f"const size_t {p.size[0]} = count_before;"]
    lines += C().call(f, values).split("\n")
    told = [(" * ".join(str(counts.get(n, n)) for n in p.size) or "1", "&" * (not p.size) + p.name) for p in f.outputs]
    if not f.outputs and f.results:
        lines.append(f"const double number = (double){'strlen(text)' if f.result == 'text' else 'value'};")
        told = [("1", "&number")]
    lines += [f"if (begin(\"{line}\", {'status' if f.result == 'status' else 'RWEDGE_OK'})) {{",
              *(f"    tell({count}, {numbers});" for count, numbers in told), *(f"    keep_{p.kind}({p.name});" for p in f.of("created")), "}"]
    return ["{", *(f"    {x}" for x in lines), "}"]


def teller(f: Function, size: Parameter, values: dict) -> str:
    """How Fortran asks for a size."""
    numbers = ", ".join(Fortran().text(values[p.name], p) for p in f.of("in"))
    return size.given_by.replace("_", "%", 1) + "()" if f.family else f"rwedge_{size.given_by}({numbers})"


def in_fortran(f: Function, line: str, values: dict, counts: dict[str, int]) -> list[str]:
    text = Fortran().call(f, values)
    if not f.outputs and f.results:
        value = text.partition(" = ")[2]
        return [f"call tell('{line}', [real({f'len({value})' if f.result == 'text' else value}, c_double)], rwedge_ok)"]
    known = {**{p.name: teller(f, p, values) for p in f.of("size")}, **counts}
    sizes = [[str(known.get(size, size)) for size in reversed(p.size)] for p in f.outputs]  # last to first
    lines = [f"real(c_double) :: {name_of(p)}" + f"({', '.join(own)})" * bool(own) for p, own in zip(f.outputs, sizes)]
    lines += ["stat = rwedge_ok", text, "contact = copy"] if f.method == "copy" else [f"{text[:-1]}, stat)"]
    lines.append(f"call tell('{line}', [{', '.join(map(name_of, f.outputs)) or 'real(c_double) ::'}], stat)")
    return ["block", *(f"    {x}" for x in lines), "end block"]


def written(language: str, f: Function, line: str, values: dict, counts: dict[str, int]) -> list[str]:
    """The lines of a call."""
    if language in PARTS:
        return (in_c if language == "c" else in_fortran)(f, line, values, counts)
    if language not in TEXTS:
        return [line]
    text = TEXTS[language].call(f, values)
    if language == "python" and f.name.startswith("contact_create"):
        text = f"{text[:-1]}, tolerance=0)"  # as in all other languages
    return ["\t".join([line, text, *[", ".join(f.results)] * (language == "matlab")])]


def program(language: str, calls: list[list[str]]) -> str:
    if language not in TEMPLATES:
        return "\n".join(line for call in calls for line in call)
    begin, end, called = PARTS[language]
    parts = [calls[i:i + LENGTH] for i in range(0, len(calls), LENGTH)]
    lines = [x for k, part in enumerate(parts)
             for x in [begin.format(k), *(f"    {line}" for call in part for line in call), end.format(), ""]]
    text = filled(TEMPLATES[language], {"calls": [called.format(k) for k in range(len(parts))], "parts": lines})
    return text if language == "c" else "\n".join(map(folded, text.split("\n")))
