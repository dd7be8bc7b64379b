# SPDX-License-Identifier: GPL-3.0-or-later
"""How a function is called from each language: by the names of its arguments, or with numbers. The pages of packages/docs show it,
and tests/answers/ makes its calls by it."""
from __future__ import annotations

import math
import textwrap
from pathlib import Path

import write_excel
import write_fortran
import write_matlab
import write_python
import write_web
from header import Function, Parameter

TOP = Path(__file__).resolve().parents[2]
# Where a language has no such call, what serves there.
FREED = "It is freed when the last variable that holds it goes."
INSTEAD = {
    ("strerror", "Python"): "It is the message of `rwedge.Error`; `.status` is the number.",
    ("contact_destroy", "Python"): FREED, ("cycle_destroy", "Python"): FREED, ("series_destroy", "Python"): FREED,
    ("contact_create", "Excel"): "No cell holds a contact: `RWEDGE_CONTACT_...` take what it is made of, and its loads.",
    ("cycle_create", "Excel"): "No cell holds a cycle: `RWEDGE_CYCLE_...` take what its contact is made of, and its loads.",
    ("cycle_create_guided", "Excel"): "No cell holds a cycle, and `RWEDGE_CYCLE_...` take moments.",
    ("cycle_create_driven", "Excel"): "No cell holds a cycle, and `RWEDGE_CYCLE_...` take forces.",
    ("series_create", "Excel"): "No cell holds a series: `RWEDGE_SERIES_...` take the samples of a fit.",
    ("series_fit", "Excel"): "`RWEDGE_SERIES_...` take the samples, and fit them in every cell.",
    ("strerror", "Excel"): "The cell shows `#NUM!`, `#N/A` or `#VALUE!`.",
    ("contact_stress_history", "Excel"): "`RWEDGE_CONTACT_STRESSES` gives the stresses after the last of the loads.",
}
NO_OBJECT = "No cell holds an object."
# What is not called by the rule.
OTHERS = {
    ("version", "Python"): "rwedge.__version__",
    ("contact_loads", "Python"): "P, M, Q, sigma = contact.loads",
    ("cycle_create", "Python"): "cycle = rwedge.Cycle(contact, dict(P={}, M={}, Q={}, sigma={}))",
    ("cycle_create_guided", "Python"): "cycle = rwedge.Cycle.guided(contact, dict(P={}, tilt={}, Q={}, sigma={}))",
    ("cycle_create_driven", "Python"): "cycle = rwedge.Cycle.driven(contact, dict(P={}, M={}, sigma={}, displacement={}), {})",
    ("cycle_loads", "Python"): "value = len(cycle)",
    ("series_coefficient", "Python"): "series.coefficients[{}]",
    ("series_potential", "Python"): "re_plus_i_im = series.potential({})",
    ("elastic_limits", "Python"): "limit = rwedge.elastic_limit({})",
    ("contact_copy", "MATLAB, Octave"): "copy = contact.copy()",
    ("contact_destroy", "MATLAB, Octave"): "delete(contact)", ("cycle_destroy", "MATLAB, Octave"): "delete(cycle)", ("series_destroy", "MATLAB, Octave"): "delete(series)",
    ("strerror", "Fortran"): "text = rwedge_error_text({})",
    ("contact_copy", "Fortran"): "copy = contact",
    ("version", "Excel"): "=RWEDGE_VERSION()",
    ("contact_load", "Excel"): "=RWEDGE_CONTACT_HISTORY(theta, a, compliance, f, P_history, Q_history)",
}


def flat(numbers: list) -> list:
    return [v for row in numbers for v in (row if isinstance(row, list) else [row])]


def plain(value) -> str:
    """A number as most languages read it, to the last bit; a name stays."""
    short = str(value) if isinstance(value, (int, str)) else f"{value:g}"
    return short if isinstance(value, (int, str)) or float(short) == value and short != "-0" else repr(value)


class C:
    name, lexer = "C, C++", "c"

    def signature(self, f: Function) -> str:
        parameters = ", ".join(p.declared for p in f.parameters) or "void"
        text = f"{f.returns} rwedge_{f.name}({parameters});".replace("* rwedge", "*rwedge")
        return "\n".join(textwrap.wrap(text, 88, subsequent_indent="        "))

    def call(self, f: Function, values: dict) -> str:
        """With the variables that it needs."""
        arrays = {p.name: values[p.name] for p in f.of("in array") if isinstance(values[p.name], list)}
        counts = {}
        for p in f.of("in array"):
            if p.name in arrays:
                lengths = (len(arrays[p.name]), len(arrays[p.name][0])) if len(p.size) == 2 else (len(arrays[p.name]),)
                counts.update({n: str(k) for n, k in zip(p.size, lengths)})
        lines = [f"const double {name}[] = {{{', '.join(map(plain, flat(numbers)))}}};" for name, numbers in arrays.items()]
        made = [p.name + (f"[{' * '.join(counts.get(n, n) for n in p.size)}]" if p.size else "") for p in f.outputs]
        lines += [f"double {', '.join(made)};"] if made else []
        lines += [f"rwedge_{p.kind} *{p.name};" for p in f.of("created")]
        result = {"status": "int32_t status = ", "nothing": "", "text": "const char *text = "}.get(f.result, f"{f.returns} value = ")
        return "\n".join([*lines, f"{result}rwedge_{f.name}({', '.join(self.passed(p, values, counts) for p in f.parameters)});"])

    @staticmethod
    def passed(p: Parameter, values: dict, counts: dict[str, str]) -> str:
        if p.role == "in":
            return plain(values[p.name])
        if p.role in ("out", "created"):
            return f"&{p.name}"
        return p.kind if p.role in ("handle", "changed") else counts.get(p.name, p.name)


class Language:
    """A language whose signature is the call with names."""

    name = lexer = ""

    def of_name(self, p: Parameter) -> str:
        return p.name

    def signature(self, f: Function) -> str:
        return self.form(f, [self.of_name(p) for p in f.inputs])

    def call(self, f: Function, values: dict) -> str:
        return self.form(f, [self.text(values[p.name], p) for p in f.inputs])

    def form(self, f: Function, values: list[str]) -> str:
        if (f.name, self.name) in INSTEAD:
            return ""
        other = OTHERS.get((f.name, self.name))
        places = values if other and other.count("{}") > 1 else [", ".join(values)]
        return other.format(*places) if other else self.rule(f, values)

    def text(self, value, p: Parameter) -> str:
        return f"[{', '.join(self.text(v, p) for v in value)}]" if isinstance(value, list) else plain(value)


class Python(Language):
    name, lexer = "Python", "python"

    def rule(self, f: Function, values: list[str]) -> str:
        bare = not f.inputs and write_python.is_general(f) and bool(f.of("handle"))
        names = ", ".join(p.name for p in f.outputs + f.of("created"))
        owner = f"rwedge.{f.family.title()}" if f.of("created") and not f.is_copy else f.family or "rwedge"
        values = [f.object] * bool(f.of("created") and f.object and not f.is_copy) + values
        called = ".".join(filter(None, [owner, f.method.removeprefix("create").lstrip("_")]))
        return f"{names} = " * bool(names) + called + ("" if bare else f"({', '.join(values)})")


class Matlab(Language):
    name, lexer = "MATLAB, Octave", "matlab"

    def text(self, value, p: Parameter) -> str:
        if not isinstance(value, list):
            return plain(value)
        rows = zip(*value) if len(p.size) == 2 else [value]  # of two sizes, a row for each point
        return f"[{'; '.join(' '.join(map(plain, row)) for row in rows)}]"

    def rule(self, f: Function, values: list[str]) -> str:
        return write_matlab.called(f, values)


class Fortran(Language):
    name, lexer = "Fortran", "fortran"

    def of_name(self, p: Parameter) -> str:
        return write_fortran.name_of(p)

    def text(self, value, p: Parameter) -> str:
        if isinstance(value, list):
            text = f"[{', '.join(self.text(v, p) for v in flat(value))}]"
            return f"reshape({text}, [{len(value[0])}, {len(value)}])" if len(p.size) == 2 else text
        number = plain(value)
        named = isinstance(value, str) or not math.isfinite(value)
        return number if p.kind == "int32_t" or named else number.replace("e", "d") + "d0" * ("e" not in number)

    def rule(self, f: Function, values: list[str]) -> str:
        if f.result in ("value", "text"):
            return f"{f.result} = {write_fortran.called(f, values)}"
        passed = dict(zip([p.name for p in f.inputs], values))
        return "call " + write_fortran.called(f, [passed.get(p.name, self.of_name(p)) for p in f.parameters if p in f.inputs + f.outputs])


class JavaScript(Language):
    """Sizes that no array tells are given too; an array of two sizes is flat."""

    name, lexer = "JavaScript", "javascript"

    def signature(self, f: Function) -> str:
        return self.form(f, [p.name for p in write_web.arguments(f)])

    def call(self, f: Function, values: dict) -> str:
        loads = [str(len(values[p.name])) for p in f.inputs if len(p.size) == 2]
        return self.form(f, [loads[0] if p.role == "size" else self.text(values[p.name], p) for p in write_web.arguments(f)])

    def text(self, value, p: Parameter) -> str:
        return super().text(flat(value) if isinstance(value, list) else value, p)

    def rule(self, f: Function, values: list[str]) -> str:
        arguments, made_by = ", ".join([*write_web.made_of(f), *values]), f.family.title()
        if f.of("created"):
            maker = f"new {made_by}" if f.method == "create" else f"{f.family if f.is_copy else made_by}.{f.method}"
            return f"const {f.of('created')[0].name} = {maker}({arguments});"
        names = ", ".join(p.name for p in f.outputs)
        left = f"const {{ {names} }} = " if len(f.outputs) > 1 else f"const {names} = " if names else ""
        name = f"{f.family}.{'free' if f.method == 'destroy' else f.method}" if f.family else f.name
        return f"{left}{name}({arguments});"


class Excel(Language):
    """A handle is made in the cell, of what stands first."""

    name, lexer = "Excel", "text"
    MADE_OF = {"contact": ["0.01", "2", "1.82E-5", "0.3", "P2:P3", "Q2:Q3"], "series": ["X2:X4", "P2:P4", "2"], "": []}
    MADE_OF["cycle"] = [*MADE_OF["contact"], "P2:P3", "M2:M3", "Q2:Q3", "S2:S3"]

    def of_name(self, p: Parameter) -> str:
        return write_excel.name_of(p)

    def signature(self, f: Function) -> str:
        made_of = write_excel.names(write_excel.HANDLES[f.family][0]) if f.family else []
        return self.form(f, [*made_of, *map(self.of_name, f.inputs)])

    def call(self, f: Function, values: dict) -> str:
        columns = [p.name.upper() if len(p.name) == 1 else letter for p, letter in zip(f.inputs, "ABCDEFGHIJKL")]
        texts = [f"{column}2:{column}{len(values[p.name]) + 1}" if p.size else plain(values[p.name]).replace("e", "E")
                 for p, column in zip(f.inputs, columns)]
        return self.form(f, self.MADE_OF[f.family] + texts)

    def rule(self, f: Function, values: list[str]) -> str:
        return f"={write_excel.cell_name(f)}({', '.join(values)})" if write_excel.is_offered(f) else ""


LANGUAGES = (C(), Python(), Matlab(), Fortran(), JavaScript(), Excel())


def instead_of(f: Function, language: str) -> str:
    if f.name.endswith("_field"):
        return f"`RWEDGE_{f.name.removesuffix('_field').upper()}` is for one point; a cell has no array of two sizes."
    return INSTEAD.get((f.name, language), NO_OBJECT)


def calls(f: Function, values: dict) -> list[tuple[str, str, str]]:
    """(language, lexer, text) of each; where the lexer is empty the text says what serves instead."""
    result = []
    for language in LANGUAGES:
        lines = [language.signature(f), language.call(f, values)]
        if lines[0]:
            result.append((language.name, language.lexer, "\n".join(dict.fromkeys(lines))))
        else:
            result.append((language.name, "", instead_of(f, language.name)))
    return result
