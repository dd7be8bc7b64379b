#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The one reader of rwedge.h: what every binding, and every test that lists the functions, knows of them comes from here.

    header.py [--names] include/rwedge.h

prints the description as JSON, or the names of the functions. README.md has the conventions of the header. A header that
breaks one is refused with the number of the line.
"""
from __future__ import annotations

import dataclasses
import json
import re
import sys
import textwrap
from dataclasses import dataclass, field
from pathlib import Path

from domain import Domain, domain_of, meaning_of

# How a parameter is declared, and what that makes it. "handle" reads the object, "changed" changes or frees it.
ROLES = (
    (r"double (\w+)", "in"),
    (r"int32_t (\w+)", "in"),
    (r"size_t (\w+)", "size"),
    (r"const double (\w+)\[\]", "in array"),
    (r"double \*(\w+)", "out"),
    (r"double (\w+)\[\d*\]", "out array"),
    (r"const rwedge_(\w+) \*\w+", "handle"),
    (r"rwedge_(\w+) \*\w+", "changed"),
    (r"rwedge_(\w+) \*\*\w+", "created"),
)
MOST_PARAMETERS = 12
RETURNS = ("double", "int32_t", "size_t", "const char *", "void")
SECTION = re.compile(r"/\* ---- (.*?) -+ \*/")
TOKEN = re.compile(r"""
    (?P<section> /\* \ ----\ [^\n]* \n) | (?P<comment> /\* .*? \*/ \n) | (?P<blank> \n) |
    (?P<declaration> RWEDGE_API [^\n;]* (?: \n\ [^\n;]* )* ; \n) | (?P<numbers> enum\ \{ .*? \n\}; \n) |
    (?P<object> typedef\ struct\ (rwedge_\w+)\ \7; \n) | (?P<other> \#(?! \ *define\ +\w+\( )[^\n]* \n | extern\ "C"\ \{\n | \}\n)
    """, re.X | re.S)
EQUATION = re.compile(r"\s{2,}((?:Eqs?\.|Sec\.|Figs?\.|new\b|[A-Za-z][A-Za-z ,]*? \(\d{4}\)).*)$")
ARGUMENT = re.compile(r"  (\w+(?:, \w+)*)  +(\S.*)")
FURTHER = re.compile(r" {4,}(\S.*)")
SENTENCE = re.compile(r"(?<=\.)(?<!Fig\.)\s+")
WITHOUT_SIZE = re.compile(r"These arguments have no size: (.*?)\.")
REASON = re.compile(r"(RWEDGE_E[A-Z]+) ((?:after|in|off|when|where) [^;.:]*)")
REFUSES_MORE = re.compile(r"RWEDGE_EDOMAIN(?: where|, also for)|NaN (?!outside the domain(?: of \w+| or NULL)?[.;]|for NULL[.;])")
TOLD = re.compile(r"rwedge_(\w+)\((\w+)\) numbers")
ELSEWHERE = re.compile(r"as (?:above|(?:in|for) rwedge_(\w+)\(\))")


class Refused(Exception):
    """The header breaks a convention."""


@dataclass
class Parameter:
    name: str
    declared: str  # in C
    role: str
    kind: str  # double, int32_t, size_t, or an object: contact, cycle or series
    domain: Domain | None = None
    size: tuple[str, ...] = ()  # of an array: the names of the sizes whose product it has
    optional: bool = False  # an output that may be NULL
    given_by: str = ""  # of a size: the function that tells it
    given_from: str = ""  # and the argument that this function takes, or "" where it takes the object
    fixed: int = 0  # of a size: the number that it always is
    described: bool = False  # in the function's own comment


@dataclass
class Function:
    name: str  # without rwedge_
    returns: str
    result: str  # value, status, text or nothing
    parameters: list[Parameter]
    section: str
    dimensional: bool
    line: int
    comment: list[str]  # as written, without the stars
    introduction: list[list[str]]  # the comments that stand alone between the declaration before and this one
    implied: list[Parameter] = field(default_factory=list)  # sizes of arrays that are no arguments: fixed, or told by a function
    text: str = ""  # the prose
    equation: str = ""
    errors: list[str] = field(default_factory=list)
    reasons: dict[str, str] = field(default_factory=dict)  # of a status: when it is returned, where the comment says so
    accuracy: list[str] = field(default_factory=list)
    array_of: str = ""  # the function whose results for many points it gives: "The same ..."
    refuses_more: bool = False  # arguments too of which each by itself is in its domain
    may_be_infinite: bool = False  # the value, or a result: HUGE_VAL

    def of(self, *roles: str) -> list[Parameter]:
        return [p for p in self.parameters if p.role in roles]

    @property
    def family(self) -> str:
        """contact, cycle or series where the function is of an object, as the name says too, or nothing: of the one it makes."""
        return next((p.kind for p in self.of("created") + self.of("handle", "changed")), "")

    @property
    def object(self) -> str:
        """The kind of the object that it reads or changes, or nothing."""
        return next((p.kind for p in self.of("handle", "changed")), "")

    @property
    def is_copy(self) -> bool:
        """Does it make an object of another one of its kind?"""
        return bool(self.of("created")) and self.object == self.family

    @property
    def method(self) -> str:
        return self.name[len(self.family) + 1:] if self.family else self.name

    @property
    def inputs(self) -> list[Parameter]:
        """The numbers and arrays that a user gives."""
        return self.of("in", "in array")

    @property
    def outputs(self) -> list[Parameter]:
        return self.of("out", "out array")

    @property
    def sizes(self) -> list[Parameter]:
        """Those that are arguments, and those that are not."""
        return self.of("size") + self.implied

    @property
    def results(self) -> list[str]:
        """The names of what it gives; what it returns is the value, but for a status."""
        return [p.name for p in self.outputs] or ["value"] * (self.result in ("value", "text"))

    @property
    def path(self) -> str:
        """When there is no closed form, where that is not said by rwedge_contact_obstacle()."""
        why = self.reasons.get("RWEDGE_EPATH", "")
        return "" if "closed form is shown" in why else why

    @property
    def pointwise(self) -> bool:
        """Are all its arrays of one size, point by point, with some of them outputs?"""
        sizes = {p.size for p in self.of("in array", "out array")}
        return len(sizes) == 1 and len(next(iter(sizes))) == 1 and bool(self.of("in array") and self.of("out array")) \
            and not self.of("out", "created")


@dataclass
class Interface:
    introduction: list[str]
    statuses: dict[str, int]
    bits: dict[str, int]  # of other enumerations
    functions: list[Function]
    objects: dict[str, list[list[str]]] = field(default_factory=dict)  # by their kinds: the comments above their declaration

    def __getitem__(self, name: str) -> Function:
        return next(f for f in self.functions if f.name == name)

    def __contains__(self, name: str) -> bool:
        return any(f.name == name for f in self.functions)

    def of(self, family: str) -> list[Function]:
        """The functions of an object; of none where the family is empty."""
        return [f for f in self.functions if f.family == family]

    @property
    def enumerations(self) -> dict[str, dict[str, int]]:
        """The numbers by their kinds: RWEDGE_MEASURE_SWT -> Measure, SWT."""
        kinds: dict[str, dict[str, int]] = {}
        for name, value in self.bits.items():
            _, kind, own = name.split("_", 2)
            kinds.setdefault(kind.title(), {})[own] = value
        return kinds


class Reader:
    """Reads the header from top to bottom."""

    def __init__(self, path: Path) -> None:
        self.path, self.text = path, path.read_text(encoding="ascii")
        self.interface = Interface([], {}, {}, [])
        self.section = ""
        self.shared: dict[bool, dict[str, tuple[str, set[str]]]] = {False: {}, True: {}}
        self.dimensional, self.until = False, ""
        self.here: dict[str, tuple[str, set[str]]] = {}  # listed for this section
        self.alone: list[list[str]] = []  # comments that stand alone
        self.comment: list[str] = []

    def refuse(self, line: int, fault: str) -> None:
        raise Refused(f"{self.path}:{line}: {fault}")

    def read(self) -> Interface:
        at = 0
        while at < len(self.text):
            token, line = TOKEN.match(self.text, at), self.text.count("\n", 0, at) + 1
            if not token:
                self.refuse(line, f"neither a comment nor a declaration of the conventions: {self.text[at:].partition(chr(10))[0]}")
            self.take(token.lastgroup, token[0], line)
            at = token.end()
        self.give_sizes()
        return self.interface

    def take(self, kind: str, text: str, line: int) -> None:
        if kind == "section":
            self.begin_section(SECTION.match(text)[1])
        elif kind == "comment":
            self.take_comment([re.sub(r"^(/\*| \*) ?|\s*\*/$", "", x) for x in text.splitlines()], line)
        elif kind == "declaration":
            self.take_declaration(" ".join(text.split()), line)
        elif kind == "numbers":
            self.take_numbers(text.splitlines()[1:-1], line)
        elif kind == "object":
            self.interface.objects[text.split()[2].removeprefix("rwedge_")] = [*self.alone, self.comment]
            self.alone = self.comment = []
        elif kind == "blank":
            self.leave_alone()

    def give_sizes(self) -> None:
        """The first page's domain of whatever has a size: all numbers but those that it names."""
        without = WITHOUT_SIZE.search(" ".join(self.interface.introduction))
        names = set(re.findall(r"\w+", without[1] if without else ""))
        for f in self.interface.functions:
            for p in f.inputs:
                if p.kind == "double" and p.name not in names and "NaN" not in p.domain.text:
                    p.domain = p.domain.of_a_size()

    def begin_section(self, title: str) -> None:
        self.section, self.alone, self.comment, self.here = title, [], [], {}
        if self.until and self.until in title.lower():
            self.dimensional = False

    def leave_alone(self) -> None:
        """A comment that no declaration follows: what it lists holds for the section."""
        if self.comment:
            self.alone.append(self.comment)
            if self.section and "functions share" not in " ".join(self.comment):
                self.here.update(self.listed(self.comment)[0])
        self.comment = []

    def take_comment(self, lines: list[str], first: int) -> None:
        self.comment = self.comment + lines
        if not self.interface.introduction and lines[0].startswith("rwedge:"):
            self.interface.introduction = lines
        if any(re.search("rguments that many functions share", x) for x in lines):
            if match := re.search(r"From here to the (\w+)", " ".join(lines)):
                self.dimensional, self.until = True, match[1]
            elif self.shared[False]:
                self.refuse(first, 'a second list of arguments must say for what it holds: "From here to the ..."')
            self.shared[self.dimensional] = self.listed(lines)[0]

    def take_numbers(self, lines: list[str], first: int) -> None:
        numbers = self.interface.statuses if self.section == "Status" else self.interface.bits
        for i, line in enumerate(lines, first + 1):
            match = re.match(r"    (RWEDGE_[A-Z0-9_]+) = (\d+)(?:,|$| )", line)
            if not match:
                self.refuse(i, f"not a name with its value: {line.strip()}")
            numbers[match[1]] = int(match[2])

    @staticmethod
    def listed(lines: list[str]) -> tuple[dict[str, tuple[str, set[str]]], list[str]]:
        """name -> (text, names of its line), of the lines "  name, name  text"; and the lines that are not of such."""
        arguments: dict[str, tuple[str, set[str]]] = {}
        rest, names = [], []
        for line in lines:
            if (match := ARGUMENT.fullmatch(EQUATION.sub("", line))):
                names = match[1].split(", ")
                arguments.update((n, (match[2].strip(), set(names) - {n})) for n in names)
            elif names and (match := FURTHER.fullmatch(line)):
                arguments.update((n, (f"{arguments[n][0]} {match[1].strip()}", arguments[n][1])) for n in names)
            else:
                names = []
                rest.append(line)
        return arguments, rest

    def take_declaration(self, text: str, line: int) -> None:
        match = re.fullmatch(r"RWEDGE_API (.*?) ?rwedge_([a-z0-9_]+)\(([^()]*)\);", text)
        if not match or match[1] not in RETURNS:
            self.refuse(line, f"not a declaration of the conventions: {text}")
        returns, name, listed = match.groups()
        if not self.comment:
            self.refuse(line, f"rwedge_{name}() has no comment right above it")
        if name in self.interface:
            self.refuse(line, f"rwedge_{name}() is declared twice")
        if not listed:
            self.refuse(line, f"rwedge_{name}() has no parameters, which is not (void)")
        parameters = [self.parameter(p, line) for p in listed.strip().split(", ") if p != "void"]
        if len(parameters) > MOST_PARAMETERS:
            self.refuse(line, f"rwedge_{name}() has {len(parameters)} parameters: more than {MOST_PARAMETERS} want an object, or an array")
        function = Function(name, returns, "", parameters, self.section, self.dimensional, line, self.comment, self.alone)
        if returns.startswith("const") and function.of("created", "changed", "out array"):
            self.refuse(line, f"rwedge_{name}() returns a text: it may only read")
        function.result = ("nothing" if returns == "void" else "text" if returns.startswith("const") else
                           "status" if returns == "int32_t" and function.of("out", "out array", "created", "changed")
                           else "value")
        if function.of("out", "out array", "created") and function.result not in ("status", "text"):
            self.refuse(line, f"rwedge_{name}() has outputs: it must return a status, int32_t")
        if function.family and not name.startswith(function.family + "_"):
            self.refuse(line, f"rwedge_{name}() is a function of a {function.family}: its name must say so")
        self.describe(function)
        self.interface.functions.append(function)
        self.comment, self.alone = [], []

    def parameter(self, text: str, line: int) -> Parameter:
        for pattern, role in ROLES:
            if match := re.fullmatch(pattern, text):
                name = re.search(r"(\w+)(?:\[\d*\])?$", text)[1]
                kind = match[1] if "rwedge_" in pattern else re.search(r"double|int32_t|size_t", text)[0]
                return Parameter(name, text, role, kind)
        self.refuse(line, f"not a parameter of the conventions: {text}")

    def describe(self, function: Function) -> None:
        own, rest = self.listed(function.comment)
        before = self.interface.functions[-1] if rest[0].startswith("The same") and self.interface.functions else None
        equations = [m[1] for m in map(EQUATION.search, function.comment) if m]
        prose = [without for x in rest if (without := EQUATION.sub("", x)) or not x]
        function.text = "\n\n".join(" ".join(" ".join(p).split()) for p in paragraphs(prose))
        function.equation = " ".join(equations) or (before.equation if before else "")
        function.errors = list(dict.fromkeys(re.findall(r"RWEDGE_E[A-Z]+", " ".join(function.comment))))
        function.reasons = dict(REASON.findall(" ".join(function.text.split())))
        if before:
            function.array_of = before.name if function.of("in array") and not before.of("in array") else ""
            function.errors += [e for e in before.errors if e not in function.errors]
        function.accuracy = [s for s in SENTENCE.split(" ".join(function.text.split())) if re.search(r"[Ee]rror (below|of)\b", s)]
        if before and not function.accuracy:
            function.accuracy = before.accuracy
        function.may_be_infinite = function.returns == "double" and "HUGE_VAL" in function.text or \
            any("HUGE_VAL" in own[p.name][0] for p in function.outputs if p.name in own)
        for p in function.parameters:
            self.describe_parameter(function, p, own, before)
        function.refuses_more = bool(REFUSES_MORE.search(function.text)) or bool(before and before.refuses_more) or \
            any(p.domain and p.domain.between for p in function.parameters) or \
            self.dimensional and function.returns == "double" and not function.family and "NaN" not in function.text
        for name in own:
            if name != "others" and name not in {p.name for p in function.parameters}:
                self.refuse(function.line, f"the comment of rwedge_{function.name}() describes {name}, which it does not have")

    def describe_parameter(self, function: Function, p: Parameter, own: dict, before: Function | None) -> None:
        if p.role in ("handle", "changed", "created"):
            return
        p.described = p.name in own
        if p.role in ("in array", "out array"):
            p.size = self.size_of(function, p, own.get(p.name, ("", set()))[0])
        if p.role in ("out", "out array"):
            p.optional = "may be NULL" in own.get(p.name, ("", set()))[0]
            return
        said = own.get(p.name) or own.get("others")
        if said and (match := ELSEWHERE.match(said[0])):
            p.domain = self.domain_elsewhere(function, p, match[1])
        elif p.role == "size":
            match = re.search(r"rwedge_(\w+)\(\)", said[0]) if said else None
            p.given_by = match[1] if match else ""
            p.domain = domain_of(said[0], p.name, said[1]) if said else None
        else:
            p.domain = self.nearest_domain(function, p, said, before)

    def nearest_domain(self, function: Function, p: Parameter, said: tuple | None, before: Function | None) -> Domain | None:
        """Of the function's own comment, of the function that it is like, of the section, or of the list for all: the first
        that has a condition."""
        domains = [domain_of(said[0], p.name, said[1])] if said else []
        domains += [q.domain for q in (before.parameters if before else []) if q.name == p.name and q.domain]
        for listed in (self.here, self.shared[function.dimensional]):
            if p.name in listed:
                domains.append(domain_of(listed[p.name][0], p.name, listed[p.name][1]))
        nearest = next((d for d in domains if d.conditions), None)
        if nearest and not meaning_of(nearest):
            nearest.text = ", ".join([*filter(None, map(meaning_of, domains))][:1] + [nearest.text])
        if not nearest:
            self.refuse(function.line, f"rwedge_{function.name}(): the domain of {p.name} is missing: a line with a condition, "
                                       '"as in rwedge_...()", or a list for several functions')
        return nearest

    def domain_elsewhere(self, function: Function, p: Parameter, name: str | None) -> Domain | None:
        """Of the same argument in the function that is named, or in the one above that has it."""
        for f in reversed(self.interface.functions):
            for q in f.parameters:
                if q.name == p.name and q.role in ("in", "in array", "size") and name in (None, f.name):
                    return q.domain
        self.refuse(function.line, f"rwedge_{function.name}(): there is no argument {p.name} to be as in another function")

    def size_of(self, function: Function, p: Parameter, text: str) -> tuple[str, ...]:
        """That of the declaration, the product that the array's line names, what a function tells, "receives n numbers", as
        elsewhere, or else the size in front of the array."""
        sizes = [q.name for q in function.of("size")]
        if match := re.search(r"\[(\d+)\]$", p.declared):
            return (self.imply(function, match[1], fixed=int(match[1])),)
        if match := TOLD.search(text):
            return (self.imply(function, f"{p.name}_count", given_by=match[1], given_from=match[2]),)
        product = re.search(r"(\w+(?: \* \w+)+) \w", text)
        factors = product[1].split(" * ") if product else []
        if factors and {n for n in factors if not n.isdigit()} <= set(sizes):
            return tuple(self.imply(function, n, fixed=int(n)) if n.isdigit() else n for n in factors)
        if match := re.search(r"receives? (\w+(?: \* \w+)*) numbers", text):
            if match[1] not in sizes:
                self.refuse(function.line, f"rwedge_{function.name}(): {p.name} receives {match[1]} numbers, which is no size")
            return (match[1],)
        if (match := ELSEWHERE.match(text)) and match[1]:
            return self.size_elsewhere(function, p, match[1])
        before = [q.name for q in function.parameters[:function.parameters.index(p)] if q.role == "size"]
        if not before:
            self.refuse(function.line, f"rwedge_{function.name}(): no size stands before the array {p.name}")
        if p.role == "out array" and len(sizes) > 1:
            self.refuse(function.line, f"rwedge_{function.name}(): of {p.name} must be said: receives ... numbers")
        return (before[-1],)

    @staticmethod
    def imply(function: Function, name: str, **about: int | str) -> str:
        """Notes a size that is no argument."""
        if name not in {q.name for q in function.implied}:
            function.implied.append(Parameter(name, "", "implied", "size_t", **about))
        return name

    def size_elsewhere(self, function: Function, p: Parameter, name: str) -> tuple[str, ...]:
        """That of the same array in another function."""
        other = next((f for f in self.interface.functions if f.name == name), None)
        sizes = next((q.size for q in other.parameters if q.name == p.name), ()) if other else ()
        for size in (q for q in other.implied if q.name in sizes) if other else ():
            self.imply(function, size.name, given_by=size.given_by, given_from=size.given_from, fixed=size.fixed)
        return sizes


def paragraphs(lines: list[str]) -> list[list[str]]:
    parts: list[list[str]] = [[]]
    for line in lines:
        if line.strip():
            parts[-1].append(line)
        elif parts[-1]:
            parts.append([])
    return [p for p in parts if p]


def read(path: str | Path) -> Interface:
    return Reader(Path(path)).read()


# ---- For those that write a language ----

NAMES = {"A": "compliance"}  # where a and A are one name
WITHOUT_NULL = (r"[,;] (NaN|-?[01]|and) for NULL| or NULL| ?\bNaN for NULL\.|,? ?\b0 for NULL", "")


def name_of(p: Parameter) -> str:
    """In a language that does not tell a from A."""
    return NAMES.get(p.name, p.name)


def replaced(text: str, pairs: tuple[tuple[str, str], ...]) -> str:
    """Text of the header in the words of another language: patterns of C, and what stands for them."""
    for c, own in pairs:
        text = re.sub(c, own, text)
    return text


def filled(path: str, parts: dict[str, list[str]]) -> str:
    """What stands by hand around the functions, a file of bindings/: lines in place of its marks, {mark}, indented as these."""
    text = (Path(__file__).resolve().parents[1] / path).read_text(encoding="ascii")
    for mark, lines in parts.items():
        text = re.sub(rf"(?m)^( *)\{{{mark}\}}$", lambda m: textwrap.indent("\n".join(lines), m[1]), text)
    return text


def main() -> None:
    *options, path = sys.argv[1:] or [""]
    try:
        interface = read(path)
    except (Refused, OSError) as error:
        sys.exit(f"REFUSED: {error}")
    if options == ["--names"]:
        print("\n".join("rwedge_" + f.name for f in interface.functions))
    else:
        print(json.dumps(dataclasses.asdict(interface), indent=1))


if __name__ == "__main__":
    main()
