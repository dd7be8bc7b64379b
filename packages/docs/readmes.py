# SPDX-License-Identifier: GPL-3.0-or-later
"""The READMEs as pages: a copy of the tree for Sphinx, whose links lead on from the top.

A file in pages/, which stands at the top there, takes a section of a README by the line

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
import subprocess
import sys
from pathlib import Path, PurePosixPath

LINK = re.compile(r"(\[[^\]]*\])\(([^()#\s:]*)(#[^()\s]*)?\)")
TAKEN = re.compile(r"^@([\w./-]+\.md)(?:#(\S+))?(?: as (.*))?$", re.MULTILINE)
HEADING = re.compile(r"(#+) (.*)")
FRONT = "README.md"
PAGES = "packages/docs/pages"


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
        self.pages = {path.name: path.read_text(encoding="utf-8") for path in sorted((top / PAGES).glob("*.md"))}
        self.shown = self.find_shown()

    def parts(self, path: str) -> dict[str, list[str]]:
        return sections((self.top / path).read_text(encoding="utf-8"))

    def find_shown(self) -> dict[str, str]:
        """The page of each anchor of the front README."""
        parts, shown = self.parts(FRONT), {}
        for page, text in self.pages.items():
            for path, name, _ in TAKEN.findall(text):
                if path == FRONT:
                    headings = filter(None, map(HEADING.fullmatch, parts[name])) if name else ()
                    shown.update({slug(heading[2]): page for heading in headings} or {"": page})
        if lost := parts.keys() - shown.keys():
            sys.exit(f"FAILED: no page of {PAGES} shows these sections of {FRONT}: {', '.join(sorted(lost))}")
        return shown

    def moved(self, text: str, link: str, anchor: str, origin: PurePosixPath) -> str:
        """A link of the file origin, from the top."""
        path = os.path.normpath(origin.parent / link) if link else str(origin)
        return f"{text}(/{self.shown[anchor[1:]] if path == FRONT else path}{anchor})"

    def linked(self, origin: str, lines: list[str]) -> str:
        result = []
        for line, is_text in outside_of_blocks("\n".join(lines)):
            if is_text and not line.startswith("    "):
                line = LINK.sub(lambda m: self.moved(m[1], m[2], m[3] or "", PurePosixPath(origin)), line)
                if HEADING.fullmatch(line) and (link := LINK.search(line)):
                    line = f"{LINK.sub(lambda m: m[1][1:-1], line)}\n\n{link[0]}"  # a heading cannot be a link
            result.append(line)
        return "\n".join(result)

    def taken(self, match: re.Match) -> str:
        path, name, title = match[1], match[2] or "", match[3]
        parts = self.parts(path)
        if name not in parts:
            sys.exit(f"FAILED: {PAGES}: {path} has no section {name}")
        return self.linked(path, [f"## {title}", *parts[name][1:]] if title else parts[name])

    def files(self) -> list[str]:
        """What is committed; where there is no clone, all files."""
        committed = subprocess.run(["git", "-C", str(self.top), "ls-files", "-z"], capture_output=True, text=True, check=False).stdout
        if committed:
            return [file for file in committed.split("\0")[:-1] if (self.top / file).is_file()]
        present = (file.relative_to(self.top).as_posix() for file in self.top.rglob("*") if file.is_file())
        return [file for file in present if not file.startswith(("build", "."))]

    def write(self) -> None:
        for file in self.files():
            (self.target / file).parent.mkdir(parents=True, exist_ok=True)
            shutil.copyfile(self.top / file, self.target / file)
        for folder in (PAGES, "packages/paper"):
            shutil.rmtree(self.target / folder)
        (self.target / FRONT).unlink()
        others = []
        for file in sorted(self.target.rglob("*.md")):
            path = file.relative_to(self.target).as_posix()
            file.write_text(self.linked(path, file.read_text(encoding="utf-8").split("\n")), encoding="utf-8")
            others.append(path.removesuffix(".md"))
        named = {line for text in self.pages.values() for line in text.split("\n")}
        listed = "\n".join(other for other in others if other not in named)
        for page, text in self.pages.items():
            (self.target / page).write_text(TAKEN.sub(self.taken, text).replace("@others", listed), encoding="utf-8")
