# SPDX-License-Identifier: GPL-3.0-or-later
"""The READMEs as pages: lays out what Sphinx reads. Each README that a link leads to is a page, other files are copied.

A file in pages/ takes a section of a README by the line

    @README.md#get-it              with its heading
    @README.md#get-it as Title     with another
    @README.md                     what stands before the first section

    @others                        what no file in pages/ names, in a list of pages

The README at the top is no page: its sections are where pages/ shows them.
"""
from __future__ import annotations

import os
import re
import shutil
import sys
from pathlib import Path, PurePosixPath

LINK = re.compile(r"(\[[^\]]*\])\(([^()#\s:]*)(#[^()\s]*)?\)")
TAKEN = re.compile(r"@([\w./-]+\.md)(?:#(\S+))?(?: as (.*))?")
HEADING = re.compile(r"(#+) (.*)")
FENCE = re.compile(r"```(\S+).*")
FRONT = "README.md"
PAGES = PurePosixPath("packages/docs/pages")
WITHOUT_COLOURS = {"csv": "text"}


def slug(title: str) -> str:
    """The anchor of a heading."""
    return re.sub(r"[^\w -]", "", title.lower()).replace(" ", "-")


def outside_of_blocks(text: str):
    """(line, whether it is text)."""
    inside = False
    for line in text.split("\n"):
        fence = line.startswith("```")
        yield line, not (inside or fence)
        inside ^= fence


def sections(text: str) -> dict[str, list[str]]:
    """slug -> lines; "" has what stands before the first section, without the title."""
    parts: dict[str, list[str]] = {"": []}
    for line, is_text in outside_of_blocks(text):
        heading = HEADING.fullmatch(line) if is_text else None
        if heading and len(heading[1]) == 2:
            parts[slug(heading[2])] = []
        if not (heading and len(heading[1]) == 1):
            list(parts.values())[-1].append(line)
    return parts


class Site:
    def __init__(self, top: Path, target: Path) -> None:
        self.top, self.target = top, target
        self.room = sorted((top / PAGES).glob("*.md"))
        self.shown: dict[str, str] = {}  # anchor of the front README -> page
        self.waiting = [PAGES / p.name for p in self.room]
        self.seen = set(self.waiting)

    def text(self, path: PurePosixPath) -> str:
        return (self.top / path).read_text(encoding="utf-8")

    @staticmethod
    def place(path: PurePosixPath) -> str:
        """Where a file is shown: those in pages/ at the top."""
        return path.name if path.parent == PAGES else str(path)

    def find_shown(self) -> None:
        parts = sections(self.text(PurePosixPath(FRONT)))
        for page in self.room:
            for match in map(TAKEN.fullmatch, page.read_text(encoding="utf-8").split("\n")):
                if match and match[1] == FRONT:
                    headings = filter(None, map(HEADING.fullmatch, parts[match[2] or ""]))
                    self.shown.update({"": page.name} if not match[2] else {slug(h[2]): page.name for h in headings})
        lost = [name for name in parts if name not in self.shown]
        if lost:
            sys.exit(f"FAILED: no page of {PAGES} shows these sections of {FRONT}: {', '.join(lost)}")

    def moved(self, link: str, anchor: str, origin: PurePosixPath, page: str) -> str:
        """A link of the file origin, as it is shown on the page."""
        target = PurePosixPath(os.path.normpath(origin.parent / link)) if link else origin
        if not (self.top / target).is_file():
            sys.exit(f"FAILED: {origin}: the link {link} leads to no file")
        if target not in self.seen and str(target) != FRONT:
            self.seen.add(target)
            self.waiting.append(target)
        place = self.shown[anchor[1:]] if str(target) == FRONT else self.place(target)
        return anchor if place == page and anchor else os.path.relpath(place, PurePosixPath(page).parent) + anchor

    def shown_on(self, page: str, origin: PurePosixPath, lines: list[str]) -> list[str]:
        """The lines of the file origin, with its links and blocks as the page needs them."""
        result = []
        for line, is_text in outside_of_blocks("\n".join(lines)):
            if is_text and not line.startswith("    "):
                line = LINK.sub(lambda m: f"{m[1]}({self.moved(m[2], m[3] or '', origin, page)})", line)
                if HEADING.fullmatch(line) and (link := LINK.search(line)):
                    line = f"{LINK.sub(lambda m: m[1][1:-1], line)}\n\n{link[0]}"  # a heading cannot be a link
            elif fence := FENCE.fullmatch(line):
                line = "```" + WITHOUT_COLOURS.get(fence[1], fence[1])
            result.append(line)
        return result

    def taken(self, match: re.Match, page: str) -> list[str]:
        path, name, title = PurePosixPath(match[1]), match[2] or "", match[3]
        parts = sections(self.text(path))
        if name not in parts:
            sys.exit(f"FAILED: {page}: {path} has no section {name}")
        lines = parts[name]
        return self.shown_on(page, path, [f"## {title}", *lines[1:]] if title else lines)

    def write_page(self, path: PurePosixPath) -> None:
        page, lines = self.place(path), []
        for line in self.text(path).split("\n"):
            match = TAKEN.fullmatch(line) if path.parent == PAGES else None
            lines += self.taken(match, page) if match else [line]
        if path.parent != PAGES:
            lines = self.shown_on(page, path, lines)
        file = self.target / page
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text("\n".join(lines), encoding="utf-8")

    def write(self) -> None:
        self.find_shown()
        while self.waiting:
            path = self.waiting.pop()
            if path.suffix == ".md":
                self.write_page(path)
            else:
                (self.target / path).parent.mkdir(parents=True, exist_ok=True)
                shutil.copyfile(self.top / path, self.target / path)
        self.name_others()

    def name_others(self) -> None:
        named = {line for page in self.room for line in page.read_text(encoding="utf-8").split("\n")}
        others = {self.place(p).removesuffix(".md") for p in self.seen if p.suffix == ".md"} - {p.stem for p in self.room} - named
        for page in self.room:
            text = (self.target / page.name).read_text(encoding="utf-8")
            text = text.replace("\n@others\n", "\n".join(["", *sorted(others), ""]))
            (self.target / page.name).write_text(text, encoding="utf-8")
