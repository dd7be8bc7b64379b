#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""check.py FOLDER: every link leads to a file, and to a place in it; nothing is loaded from elsewhere."""
import re
import sys
from html.parser import HTMLParser
from pathlib import Path
from urllib.parse import unquote, urlsplit

LOADED = {("img", "src"), ("script", "src"), ("link", "href"), ("iframe", "src"), ("source", "src"), ("object", "data")}


class Page(HTMLParser):
    def __init__(self, path: Path) -> None:
        super().__init__()
        self.anchors: set[str] = set()
        self.links: list[tuple[str, bool]] = []
        self.feed(path.read_text(encoding="utf-8"))

    def handle_starttag(self, tag: str, attributes: list) -> None:
        for name, value in attributes:
            if name in ("id", "name"):
                self.anchors.add(value)
            if name in ("href", "src", "data"):
                self.links.append((value, (tag, name) in LOADED))


def faults(folder: Path) -> list[str]:
    pages = {path: Page(path) for path in sorted(folder.rglob("*.html"))}
    problems = [] if len(pages) > 50 else [f"only {len(pages)} pages"]
    for path, page in pages.items():
        for link, is_loaded in page.links:
            parts = urlsplit(link)
            target = (path.parent / unquote(parts.path)).resolve() if parts.path else path
            if parts.scheme or parts.netloc:
                wrong = is_loaded and parts.scheme != "data" and "is loaded from elsewhere"
            else:
                wrong = not target.exists() and "leads to no file" or \
                    parts.fragment and target in pages and unquote(parts.fragment) not in pages[target].anchors and "has no such place"
            if wrong:
                problems.append(f"{path.relative_to(folder)}: {link}: {wrong}")
    for path in folder.rglob("*.css"):
        problems += [f"{path.relative_to(folder)}: {url} is loaded from elsewhere"
                  for url in re.findall(r"url\(['\"]?((?:https?:)?//[^)]*)", path.read_text(encoding="utf-8"))]
    texts = (folder / "_static" / "texts.js").read_text(encoding="utf-8")  # in which the search shows the line that it finds
    problems += [f"{name}: not in the search's texts" for name in (folder / "searchindex.js").read_text(encoding="utf-8")
              .partition('"docnames":[')[2].partition("]")[0].replace('"', "").split(",") if f'"{name}": "' not in texts]
    problems += [f"{path.relative_to(folder)}: a formula in dollars" for path in pages if re.search(r"\\(?:frac|varphi)", path.read_text("utf-8"))]
    print(f"{len(pages)} pages, {sum(len(p.links) for p in pages.values())} links")
    return problems


def main() -> int:
    problems = faults(Path(sys.argv[1]).resolve())
    for fault in problems:
        print(f"FAILED: {fault}")
    return bool(problems)


sys.exit(main())
