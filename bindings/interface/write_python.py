# SPDX-License-Identifier: GPL-3.0-or-later
"""What the Python package takes from the header, written when the package is built.

    _header.py   FUNCTIONS: types, domains, sources, and the docstrings
    _made.py     functions and methods that no module defines by hand
    entries.h    the functions as src/loops.c calls them
    __init__.pyi the types for checkers
"""
from __future__ import annotations

import math
import re
import textwrap
from itertools import starmap
from pathlib import Path

import write_c
from domain import Domain
from header import SENTENCE, WITHOUT_NULL, Function, Interface, Parameter, replaced

IN_PYTHON = (  # statuses, pointers and limits, in the words of Python
    (r"Unless RWEDGE_OK, the contact", "After an error the contact"), (r"([,;.]? ?RWEDGE_ENULL)?[,;]? ?RWEDGE_ENOMEM", ""), (r"Free with rwedge_\w+_destroy\(\)\.", ""),
    WITHOUT_NULL, (r",? ?never NULL", ""), (r"Static text\.| ?Nothing is written unless every\s+point is in the domain\.", ""), (r"\bat n points\b", "at points"),
    (": RWEDGE_EABSENT", ": NaN, without a warning"), ("would return RWEDGE_EPATH", "would raise PathError"), (r"(; |, )?RWEDGE_ENULL", ""),
    ("0, which a new contact has,", "0"), ("RWEDGE_EPATH", "PathError"), ("RWEDGE_ESLIDING", "SlidingError"), ("RWEDGE_(EDOMAIN|ERANGE)", "ValueError"),
    (r"rwedge_contact_(\w+)\(\)", r"Contact.\1()"), (r"rwedge_cycle_create\(\)", r"Cycle()"), (r"rwedge_(cycle|series)_(\w+)\(\)", lambda m: f"{m[1].title()}.{m[2]}()"), (r"rwedge_(\w+\(\w*\))", r"\1"),
    ("HUGE_VAL", "inf"), ("RWEDGE_MEASURE_", "Measure."), ("RWEDGE_FACES_", "Faces."))
EXCEPTIONS = {"RWEDGE_EABSENT": "AbsentError", "RWEDGE_EPATH": "PathError", "RWEDGE_ESLIDING": "SlidingError"}
# What the classes of src/rwedge/ define by hand, as it does more than to call the library; besides what makes or frees an object.
BY_HAND = {"contact_load", "contact_apply", "contact_yield_factor", "contact_loads", "contact_state", "series_coefficient",
           "series_potential", "cycle_loads", "cycle_stresses", "cycle_friction", "cycle_growth", "cycle_closing_growth",
           "stresses", "elastic_limits", "version", "strerror"}
# Of these the methods that have the header's text, with what Python adds to it.
ALL_OR_NONE = "Of arrays, one load after the other: all of them, or none where one is refused."
TOLERANCE = "``tolerance``, of q over f times the peak pressure, is as ``Contact`` has it."
LAW_AND_VERDICT = "law may be a mapping too, without ds0 and K_c where they are infinite. The result's ``verdict`` says it in words."
ADDED = {"contact_load": ALL_OR_NONE, "contact_apply": ALL_OR_NONE + " What has no closed form is computed, and ``error`` tells how exactly, "
         "unless the contact's ``tolerance`` is 0.", "contact_create_flat": TOLERANCE, "contact_create_profile": TOLERANCE,
         "contact_yield_factor": "", "contact_state": "``Contact.restore(state)`` goes on to the same bits.", "contact_restore": "",
         "cycle_create_guided": "The loads have P, tilt, Q and sigma by name, in a dict or a frame; what has no name keeps its value. "
         "``loads.M`` has the moments.",
         "cycle_create_driven": "The loads have P, M, sigma and displacement by name, in a dict or a frame; what has no name keeps its "
         "value. ``loads.Q`` has the forces.",
         "cycle_stresses": "The result unpacks into sxx, syy, txy, each an array of (load, point).", "cycle_friction": "",
         "cycle_growth": LAW_AND_VERDICT, "cycle_closing_growth": LAW_AND_VERDICT,
         "series_fit": "x and p are of one dimension and the same length. At least terms samples, samples times terms <= 2^27, samples times terms^2 <= 2^33 (half a minute).",
         "series_potential": "The result is complex."}


def one_line(text: str) -> str:
    return " ".join(text.split())


def is_ufunc(f: Function) -> bool:
    """Does it take and give nothing but doubles, and take whole numbers too?"""
    return (f.result == "status" or f.returns == "double") and {p.role for p in f.parameters} <= {"in", "out"} and any(p.kind == "double" for p in f.inputs)


def is_gufunc(f: Function) -> bool:
    """Is it of arrays, such as a cycle and the constants of a criterion, and of numbers, which give numbers, or so many of them?"""
    numbers = f.result == "status" or f.returns == "double"
    implied = {p.name for p in f.implied}
    arrays = bool(f.of("in array") or f.implied) and all(len(p.size) == 1 for p in f.of("in array"))
    return numbers and not f.family and not f.of("handle", "changed", "created") and arrays and len(f.of("size")) < 2 and \
        all(set(p.size) <= implied for p in f.of("out array"))


def of_loads(f: Function, p: Parameter) -> bool:
    """Is it an array of the size that is an argument, such as a number for each load?"""
    return p.role == "in array" and set(p.size) <= {q.name for q in f.of("size")}


def is_formula(f: Function) -> bool:
    return is_ufunc(f) or is_gufunc(f)


def is_general(f: Function) -> bool:
    """Is it made from its description alone?"""
    return not (is_formula(f) or f.of("created") or f.result == "nothing" or f.name in BY_HAND)


def is_reading(f: Function) -> bool:
    """Does it tell a number of an object?"""
    return bool(f.of("handle")) and f.result == "value" and not f.inputs


def is_of_points(f: Function) -> bool:
    """Does a method take arrays of points that broadcast?"""
    plain = set(f.errors) <= {"RWEDGE_EDOMAIN", "RWEDGE_ENULL", "RWEDGE_EPATH"}  # EPATH is of the object, not of a point
    return plain and bool(f.of("handle") and f.inputs) and (f.pointwise or f.family == "series")


def units(f: Function) -> str:
    natural = not f.dimensional and f.section != "Materials"
    return "Natural units: lengths in b, stresses in theta/A." if natural else "Any consistent set of units."


def source(f: Function, before: str) -> str:
    """A formula that has no source has that of the one before: "at the surface"."""
    return one_line(f.equation) or (before if is_formula(f) else "")


def listed(inputs: list[Parameter], f: Function) -> list[str]:
    lines = []
    for p in inputs:
        kind = "array_like" if is_formula(f) or is_of_points(f) or p.role == "in array" else "int" if p.kind == "int32_t" else "float"
        of_cycle = ", (..., n)" if is_gufunc(f) and of_loads(f, p) else ", (..., m)" if is_gufunc(f) and p.role == "in array" else ""
        lines += [f"{p.name} : {kind}{of_cycle}", *indented(replaced(p.domain.text, IN_PYTHON))]
    return lines


def indented(text: str) -> list[str]:
    return textwrap.wrap(text, 96, initial_indent="    ", subsequent_indent="    ")


def sentences(paragraph: str) -> list[str]:
    """Without those that list statuses: they are said by raised()."""
    kept = [s for s in SENTENCE.split(one_line(replaced(paragraph, IN_PYTHON))) if s and "RWEDGE_E" not in s]
    return [kept[0][0].upper() + kept[0][1:], *kept[1:]] if kept else []


def refused(f: Function) -> list[str]:
    """What a formula gives where it has no result."""
    reasons = {status: replaced(why, IN_PYTHON) for status, why in f.reasons.items()}
    known = any("NaN outside the domain" in s for s in sentences(f.text))
    more = f", and {reasons['RWEDGE_EPATH']}" if "RWEDGE_EPATH" in reasons else ""
    lines = [] if known and not more else [f"NaN outside the domain{more}."]
    return lines + [f"NaN {why}, without a warning." for status, why in reasons.items() if status == "RWEDGE_EABSENT"]


def raised(f: Function) -> list[str]:
    """The section on exceptions, of what is not a formula."""
    causes: dict[str, list[str]] = {}
    general = {"RWEDGE_EDOMAIN": "outside the domain", "RWEDGE_ERANGE": "where a size is out of range", "RWEDGE_ESLIDING": "where |Q| > f P",
               "RWEDGE_EPATH": "where there is no closed form", "RWEDGE_EABSENT": "", "RWEDGE_ERANK": ""}
    for status in f.errors if f.result == "status" else []:
        if status in general:
            why = f.reasons.get(status) or general[status]
            causes.setdefault(EXCEPTIONS.get(status, "ValueError"), []).append(replaced(why, IN_PYTHON))
    lines = [line for name, reasons in causes.items() for line in (name, *indented("; ".join(dict.fromkeys(reasons))))]
    return ["", "Raises", "------", *lines] if lines else []


def returned(f: Function) -> str:
    if is_formula(f):
        cycle = ", without the axis of the loads" * any(of_loads(f, p) for p in f.inputs)
        more = "".join(f"; {p.name} with a last axis of {p.size[0]}" for p in f.of("out array"))
        return "float64, in the broadcast shape of the arguments" + cycle + more
    if is_of_points(f):
        return "ndarray, in the broadcast shape of the arguments; NaN gives NaN"
    if f.result == "text" and not f.outputs:
        return "str"
    shapes = dict.fromkeys(f"({', '.join(p.size)})" for p in f.outputs if p.size)
    return f"ndarray, {' or '.join(shapes)}" if shapes else "int" if f.returns != "double" and f.result == "value" else "float"


CYCLES = ("A generalized ufunc: the loads are along the last axis, or along that of ``axis=``, such as 0 for what "
          "``Contact.cycle`` gives; the other axes broadcast.")


def docstring(f: Function, equation: str) -> str:
    """The help on a function, as NumPy's users are used to it."""
    *general, own = f.text.split("\n\n")
    first, *rest = sentences(own)
    inputs, outputs = f.inputs, [p.name for p in f.outputs]
    lines = [f"{f.method}({', '.join(p.name for p in inputs)})", "", *textwrap.wrap(first, 100), ""]
    if inputs:
        lines += ["Parameters", "----------", *listed(inputs, f), ""]
    if f.results:
        lines += ["Returns", "-------", f"{', '.join(outputs) or f.method} : {returned(f)}"]
    lines += [] if is_formula(f) else raised(f)
    end = [*(refused(f) if is_formula(f) else []), *[CYCLES] * (is_gufunc(f) and any(of_loads(f, p) for p in f.inputs)), units(f)]
    notes = one_line(" ".join([ADDED.get(f.name, ""), *rest, *(s for paragraph in general for s in sentences(paragraph)), *end]))
    text = "\n".join([*lines, "", "Notes", "-----", *textwrap.wrap(notes, 100), f"Source: {equation}."])
    return re.sub(r"\|([^|\n]+)\|", r"abs(\1)", text)  # |Q| is a substitution to what reads reStructuredText


def allowed(domain: Domain | None) -> str:
    """The conditions that the header states, as the other languages' messages have them."""
    return replaced(", ".join(domain.conditions), IN_PYTHON) if domain else ""


def bounds(domain: Domain) -> tuple:
    """What a number that is refused is held against, to say which it was."""
    high = domain.high if domain.finite else math.inf
    return domain.low, high, domain.low_open, domain.high_open, domain.or_zero, domain.smallest


def header_py(interface: Interface) -> str:
    lines = ["# SPDX-License-Identifier: GPL-3.0-or-later", '"""Made by bindings/interface from rwedge.h and cli/model/reading: do not edit."""',
             "from __future__ import annotations", "", "from math import inf", "from typing import Any", "", "FUNCTIONS: dict[str, dict[str, Any]] = {"]
    equation = ""
    for f in interface.functions:
        equation = source(f, equation)
        kind = "ufunc" if is_ufunc(f) else "gufunc" if is_gufunc(f) else "general" if is_general(f) else "by hand"
        about = {
            "result": f.returns,
            "parameters": tuple((re.sub(r" ?\w+(\[\d*\])?$", " *" if "[" in p.declared else "", p.declared), p.name)
                                for p in f.parameters),
            "roles": tuple(p.role for p in f.parameters),
            "sizes": {p.name: p.size for p in f.parameters if p.size},
            "implied": {p.name: (p.fixed, p.given_by, p.given_from) for p in f.implied},
            "given by": {p.name: p.given_by for p in f.parameters if p.given_by},
            "reasons": {interface.statuses[status]: replaced(why, IN_PYTHON) for status, why in f.reasons.items()},
            "domains": {p.name: allowed(p.domain) for p in f.parameters if allowed(p.domain)},
            "bounds": {p.name: bounds(p.domain) for p in f.inputs if not p.domain.any},
            "made": kind, "family": f.family, "status": f.result == "status",
            "doc": docstring(f, equation) if is_formula(f) else ""}
        lines += [f"    {f.name!r}: {{", *(f"        {key!r}: {value!r}," for key, value in about.items()), "    },"]
    return "\n".join([*lines, "}", ""])


MADE = '''# SPDX-License-Identifier: GPL-3.0-or-later
"""Made by bindings/interface from rwedge.h: do not edit. What no other module defines."""
from __future__ import annotations

import enum
from typing import Any, SupportsFloat, SupportsIndex

from numpy.typing import NDArray

from ._general import call
from ._labels import Numbers
from ._library import function
from ._object import Object
from ._ufuncs import Points

__all__: list[str] = {names}
{functions}

{enumerations}

'''
TYPES = {"in array": "Numbers", "double": "SupportsFloat", "int32_t": "SupportsIndex"}


def result_type(f: Function) -> str:
    if f.result == "value":
        return "NDArray[Any]" if is_of_points(f) else {"double": "float"}.get(f.returns, "int")
    if f.result == "text":
        return f"tuple[{', '.join(['str', *['float'] * len(f.outputs)])}]" if f.outputs else "str"
    types = ["NDArray[Any]" if p.size or is_of_points(f) else "float" for p in f.outputs]
    return f"tuple[{', '.join(types)}]" if len(types) > 1 else types[0] if types else "None"


def definition(f: Function, margin: str) -> str:
    """A function, a method, or a property where there is nothing to be given."""
    parameters = [f"{p.name}: {'Numbers' if is_of_points(f) else TYPES.get(p.role) or TYPES[p.kind]}" for p in f.inputs]
    own = ["self"] if f.family else []
    called = ("self._read(_{})" if is_reading(f) else "self._at(_{})" if is_of_points(f) else
              "self._call('{}')" if f.family else "call('{}', None)").format(f.name)
    body = f"return {called[:-1]}{''.join(f', {p.name}' for p in f.inputs)})"
    doc = docstring(f, f.equation or "new").replace("\\", "\\\\").split("\n", 2)[2]
    lines = ["@property"] if f.family and not f.inputs and f.of("handle") else []
    lines += [f"def {f.method}({', '.join(own + parameters)}) -> {result_type(f)}:",
              *textwrap.indent(f'"""{doc}\n"""', "    ").split("\n"), f"    {body}", ""]
    return "\n".join(margin + x if x else x for x in lines)


def inherited(f: Function) -> str:
    """The text of a method that the class defines itself: there it has none."""
    kind = ["@classmethod"] if f.of("created") else []
    doc = textwrap.indent(f'"""{docstring(f, f.equation or "new").split(chr(10), 2)[2]}\n"""', "    ").split("\n")
    lines = [*kind, f"def {f.method.removeprefix('create_')}({'cls' if kind else 'self'}, *given: Any, **named: Any) -> Any:", *doc,
             "    raise NotImplementedError", ""]
    return textwrap.indent("\n".join(lines), "    ")


def enumeration(kind: str, numbers: dict[str, int]) -> str:
    """A class of whole numbers; of bits where none is 0."""
    lines = [f"class {kind}(enum.Int{'Enum' if 0 in numbers.values() else 'Flag'}):",
             f'    """The numbers RWEDGE_{kind.upper()}_... of the library, by name."""', "",
             *(f"    {name} = {value}" for name, value in numbers.items())]
    return "\n".join(lines)


def made_py(interface: Interface) -> str:
    made = [f for f in interface.functions if is_general(f)]
    functions = [f"_{f.name} = function({f.name!r})" for f in made if is_reading(f)]
    functions += [f"_{f.name} = Points({f.name!r})" for f in made if is_of_points(f)]
    text = MADE.format(names=[*interface.enumerations, *(f.name for f in made if not f.family)], functions="\n".join(functions),
                       enumerations="\n\n\n".join(starmap(enumeration, interface.enumerations.items())))
    text += "\n".join(definition(f, "") + "\n" for f in made if not f.family)
    for family in interface.objects:
        methods = [definition(f, "    ") for f in interface.of(family) if is_general(f)]
        methods += [inherited(interface[name]) for name in ADDED if interface[name].family == family]
        text += f"\nclass {family.title()}Methods(Object):\n" + ("\n".join(methods) or "    pass\n") + "\n"
    return text


HERE = Path(__file__).resolve()
# In a source distribution the library is a folder of the package.
PACKAGE = next(folder / "src/rwedge" for folder in (HERE.parents[1] / "python", HERE.parents[3]) if (folder / "src/rwedge").exists())
NAMED = re.findall(r'^    "(\w+)": \("', (PACKAGE / "_named.py").read_text(encoding="utf-8"), re.M)
# The classes that are written by hand, by their modules.
CLASSES = {"_contact": "Contact YieldFactor", "_criteria": "Damage Plane", "_cycle": "Cycle Friction Growth", "_files": "Case read_case", "_loads": "Loads", "_loop": "Loop loop", "_series": "Series", "_stress_history": "StressHistory", "_tests": "Tests series",
           "_library": "AbsentError Error PathError SlidingError", "_validity": "ValidityWarning"}
PYI = '''# SPDX-License-Identifier: GPL-3.0-or-later
from typing import Any, Protocol, overload, type_check_only

from numpy import float64, ufunc
from numpy.typing import NDArray

{classes}
from ._labels import Numbers, Scalar

__version__: str
__all__ = [
{names}
]

# A formula is a ufunc that takes its arguments by name too.

{formulas}

def stresses(
    alpha: Numbers, f: Numbers, c: Numbers, x: Numbers, y: Numbers
) -> tuple[NDArray[Any], NDArray[Any], NDArray[Any]]: ...
'''
FORMULA = '''@type_check_only
class _{name}(Protocol):
    ufunc: ufunc
    @overload
    def __call__(self, {scalars}) -> {result}: ...
    @overload
    def __call__(
        self, {numbers}, *, out: Any = ..., where: Numbers = ..., casting: str = ..., order: str = ..., dtype: Any = ...,
        subok: bool = ..., signature: Any = ...
    ) -> Any: ...
    def __getattr__(self, name: str) -> Any: ...

{name}: _{name}'''
OF_CYCLE = '''@type_check_only
class _{name}(Protocol):
    ufunc: ufunc
    @overload
    def __call__(
        self, {numbers}, *, axis: int = ..., axes: Any = ..., out: Any = ..., casting: str = ..., order: str = ..., dtype: Any = ...,
        subok: bool = ..., signature: Any = ...
    ) -> {result}: ...
    @overload
    def __call__(
        self, *cycle: Numbers, {named}, axis: int = ..., axes: Any = ..., out: Any = ..., casting: str = ..., order: str = ...,
        dtype: Any = ..., subok: bool = ..., signature: Any = ...
    ) -> {result}: ...
    def __getattr__(self, name: str) -> Any: ...

{name}: _{name}'''


def formula_type(f: Function) -> str:
    result = f"tuple[{', '.join(['float64'] * len(f.outputs))}]" if f.outputs else "float64"
    scalars = ", ".join(f"{p.name}: {'Numbers' if p.size else 'Scalar' if p.kind == 'double' else 'int'}" for p in f.inputs)
    numbers = ", ".join(f"{p.name}: Numbers" for p in f.inputs)
    if any(of_loads(f, p) for p in f.inputs):
        named = ", ".join(f"{p.name}: Numbers" for p in f.of("in"))
        return OF_CYCLE.format(name=f.name, numbers=numbers, named=named, result=f"tuple[{', '.join(['Any'] * len(f.outputs))}]")
    if is_gufunc(f):
        result = f"tuple[{', '.join(['Any'] * len(f.outputs))}]" if f.outputs else "Any"
    return FORMULA.format(name=f.name, scalars=scalars, numbers=numbers, result=result)


def init_pyi(interface: Interface) -> str:
    classes = {name: module for module, names in CLASSES.items() for name in names.split()}
    functions = [f for f in interface.functions if is_formula(f) or is_general(f) and not f.family]
    names = textwrap.wrap(", ".join(f'"{n}"' for n in [*classes, "stresses", *NAMED, *interface.enumerations, *(f.name for f in functions)]) + ",", 120, initial_indent="    ",
                          subsequent_indent="    ")
    formulas = [f"from ._made import {name} as {name}" for name in interface.enumerations]
    formulas += ["from ._named import Named", "", *(f"{name}: Named" for name in NAMED), ""]
    formulas += [formula_type(f) if is_formula(f) else f"from ._made import {f.name} as {f.name}" for f in functions]
    return PYI.format(names="\n".join(names), classes="\n".join(f"from .{classes[name]} import {name} as {name}" for name in classes),
                      formulas="\n".join(formulas))


def labels_py() -> str:
    """What columns of loads are called that say which row it is: the tool's list."""
    source = HERE.parents[2] / "cli/model/reading/reading.h"
    names = re.search(r'#define LABEL_NAMES\s+\\\s+"(.*)"', source.read_text(encoding="utf-8"))
    return f"\nLABEL_NAMES = {tuple(names[1].split())!r}\n"  # type: ignore[index]


def texts(interface: Interface) -> dict[str, str]:
    return {**write_c.texts(interface), "_header.py": header_py(interface) + labels_py(), "_made.py": made_py(interface),
            "__init__.pyi": init_pyi(interface)}
