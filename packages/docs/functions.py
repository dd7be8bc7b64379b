# SPDX-License-Identifier: GPL-3.0-or-later
"""A page for each function, from the description of include/rwedge.h, and one for each section of the header."""
from __future__ import annotations

import re
from pathlib import Path
from typing import Callable

import examples
import figures
import write_python
from header import EQUATION, SENTENCE, Function, Interface, Reader, paragraphs
from languages import TOP, calls
from readmes import sections, slug

SPECIAL = re.compile(r"rwedge_(\w+)\(\)|RWEDGE_\w+|HUGE_VAL|lib/README\.md|[\\`*_{}\[\]<>#|~^$]")
CODES = re.compile(r"(RWEDGE_E[A-Z]+(,? and|[,;.])? ?)+")
THEORY = "[Theory, errata, accuracy](/lib/README.md)"


class Pages:
    def __init__(self, interface: Interface, answers: Callable[[Function], dict] | None) -> None:
        self.interface, self.answers = interface, answers
        self.status_texts = dict(re.findall(r"(RWEDGE_E\w+) = \d+,? +/\* (.*?) \*/", (TOP / "include/rwedge.h").read_text()))
        self.meanings = {False: Reader.listed(interface.introduction)[0]}
        first = next(f for f in interface.functions if f.dimensional)
        self.meanings[True] = Reader.listed([line for block in first.introduction for line in block])[0]
        self.measured = measured()

    def marked(self, text: str) -> str:
        """Text of the header as Markdown, with links to the functions that it names."""
        def of(match: re.Match) -> str:
            if match[1] in self.interface:
                return f"[`{match[0]}`](/functions/{match[1]}.md)"
            return THEORY if match[0].startswith("lib/") else f"`{match[0]}`" if match[0][0] in "RH" else "\\" + match[0]
        return SPECIAL.sub(of, text)

    def meaning(self, f: Function, name: str, own: str) -> str:
        """What the header says of an argument here, after what it says of it everywhere."""
        shared = self.meanings[f.dimensional].get(name, ("",))[0]
        general = re.split(r", (?=finite|[<>]|\d|at least)", shared)[0]
        general = general.removesuffix(", " + own.split(", ")[0])
        return own if not general or own.startswith(general) or own == shared else f"{general}: {own}".removesuffix(": ")

    def arguments(self, f: Function) -> list[str]:
        rows = [f"| `{p.name}` | {self.marked(self.meaning(f, p.name, p.domain.text))} | {self.marked(', '.join(p.domain.conditions))} |"
                for p in f.inputs]
        return ["| argument | meaning and unit | domain |", "|---|---|---|", *rows, ""] if rows else []

    def results(self, f: Function) -> list[str]:
        """The results, with those of the example."""
        shown = self.answers(f) if self.answers and f.name != "contact_state" else {}
        said = {name: text for name, (text, _) in Reader.listed(f.comment)[0].items()}
        names = f.results
        rows = [(f"| `{n}` |", f" {self.marked(self.meaning(f, n, said.get(n, '')))} |", f" {number(shown.get(n, ''))} |") for n in names]
        title = ("| result |", " meaning and unit |", " of the calls below |")
        used = [k for k in range(3) if any(row[k] != "  |" for row in rows)]
        return ["".join(row[k] for k in used) for row in [title, ("|---|", "---|", "---|"), *rows]] + [""] if rows else []

    def description(self, f: Function) -> list[str]:
        """The header's text, without what has a place of its own on the page."""
        text = f.text
        for sentence in f.accuracy:
            text = text.replace(sentence, "")
        kept = [" ".join(s for s in SENTENCE.split(p) if not CODES.fullmatch(s)) for p in text.split("\n\n")]
        if f.text.startswith("The same"):
            kept.insert(0, f"See rwedge_{f.array_of or self.before(f).name}().")
        return [line for paragraph in kept if paragraph.strip() for line in (self.marked(" ".join(paragraph.split())), "")]

    def before(self, f: Function) -> Function:
        return self.interface.functions[self.interface.functions.index(f) - 1]

    def called(self, f: Function) -> list[str]:
        lines = ["## In each language", ""]
        if f.family and not f.of("created"):
            lines += [self.marked(f"The {f.family} of these calls is that of rwedge_{f.family}_create()" +
                                  (", after the loads P = 2000, Q = 0 and P = 2000, Q = 300" + (", and held." if f.name in examples.HELD else ".")
                                   if f.family == "contact" else
                                   ", of that contact." if f.family == "cycle" else ".")), ""]
        rows = calls(f, {p.name: examples.value_of(f, p) for p in f.inputs})
        if command := examples.COMMANDS.get(f.name):
            rows.append(("Command line", "sh", f"rwedge {command}"))
        lines += ["````{container} languages"]
        for language, lexer, text in rows:
            lines += [f"**{language}**", "", *([f"```{lexer}", text, "```", ""] if lexer else [text, ""])]
        return [*lines, "````", ""]

    def facts(self, f: Function) -> list[str]:
        rows = [("Equation", self.marked(f.equation)), ("Units", self.marked(write_python.units(f))),
                ("Accuracy", self.marked(" ".join(f.accuracy)))]
        rows += [("Measured", f"{what}, in {calls} calls ([all](/lib/README.md#accuracy))") for calls, what in
                 self.measured.get(f.name, [])[:1]]
        rows += [("Errors", "; ".join(f"`{e}`: {self.marked(self.status_texts[e])}" for e in f.errors))]
        return [x for title, text in rows if text for x in (f"{title}\n: {text}", "")]

    def page(self, f: Function) -> str:
        figure = figures.of(f.name)
        return "\n".join([f"# rwedge_{f.name}", "", *self.description(f), *self.arguments(f), *self.results(f), *self.called(f),
                          "## What to know", "", *self.facts(f), *figure])

    def section(self, title: str) -> str:
        own = [f for f in self.interface.functions if f.section == title]
        blocks = [block for name in dict.fromkeys(f.family for f in own) if name for block in self.interface.objects[name]]
        texts = [x for block in blocks + [b for f in own for b in f.introduction] for x in self.prose(block)]
        rows = [f"| [`{f.name}`](/functions/{f.name}.md) | {self.marked(SENTENCE.split(f.text.split(chr(10) * 2)[-1])[0])} |" for f in own]
        return "\n".join([f"# {title}", "", *texts, "| rwedge\\_ | gives |", "|---|---|", *rows, "", "```{toctree}", ":hidden:", "",
                          *(f"{f.name} <../{f.name}>" for f in own), "```", ""])

    def prose(self, block: list[str]) -> list[str]:
        """A comment of the header that stands alone."""
        lines = []
        for paragraph in paragraphs(block):
            said, rest = Reader.listed(paragraph)
            lines += [self.marked(" ".join(EQUATION.sub("", " ".join(rest)).split())), ""]
            if said:
                rows = [f"| `{name}` | {self.marked(text)} |" for name, (text, _) in said.items()]
                lines += ["| argument | meaning, unit, domain |", "|---|---|", *rows, ""]
        return lines

    def index(self, titles: list[str]) -> str:
        return "\n".join(["# Functions", "", *self.prose(self.interface.introduction), "```{toctree}", ":maxdepth: 1", "",
                          *(f"{slug(t)}/index" for t in titles), "```", ""])

    def write(self, folder: Path) -> None:
        titles = list(dict.fromkeys(f.section for f in self.interface.functions))
        texts = {"index": self.index(titles), **{f"{slug(t)}/index": self.section(t) for t in titles},
                 **{f.name: self.page(f) for f in self.interface.functions}}
        for name, text in texts.items():
            file = folder / f"{name}.md"
            file.parent.mkdir(parents=True, exist_ok=True)
            file.write_text(text, encoding="utf-8")


def number(result: object) -> str:
    if isinstance(result, list):
        return ", ".join(map(number, result))
    return f"{result:.6g}" if isinstance(result, (int, float)) else str(result)


def measured() -> dict[str, list[tuple[str, str]]]:
    """Of each function the calls and the worst error, from the table of lib/README.md."""
    rows: dict[str, list[tuple[str, str]]] = {}
    for line in sections((TOP / "lib/README.md").read_text(encoding="utf-8"))["accuracy"]:
        cells = [c.strip() for c in re.split(r"(?<!\\)\|", line)]
        if len(cells) > 6 and cells[1].startswith("`"):
            for name in cells[1].strip("`").split(", "):
                rows.setdefault(name, []).append((cells[3], cells[6]))
    return rows
