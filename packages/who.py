# SPDX-License-Identifier: GPL-3.0-or-later
"""What only a person knows of who publishes this: who.json has it, once.
    who.py            says which of its fields are empty, and what stands there instead
    who.py FIELD      name, address, url or doi, or what stands there instead
    who.py --write    brings CITATION.cff's authors and codemeta.json up to date
    who.py --check    fails where they are not
"""
import json
import pathlib
import re
import sys

top = pathlib.Path(__file__).resolve().parent.parent
INSTEAD = {"name": "The rwedge maintainers", "address": "rwedge@rwedge.invalid", "url": "", "doi": ""}
MEANING = {"name": "who maintains it", "address": "the e-mail address", "url": "where the source is", "doi": "of the archived release"}
known = json.loads((top / "packages" / "who.json").read_text())
who = {field: known[field] or INSTEAD[field] for field in INSTEAD}
assert known.keys() == INSTEAD.keys(), "who.json has other fields"


def empty():
    """The sentences that each packaging step says."""
    return [f"packages/who.json: {field} ({MEANING[field]}) is empty; it says '{INSTEAD[field]}'" for field in INSTEAD if not known[field]]


def citation():
    """CITATION.cff with this author and what is known besides."""
    text = (top / "CITATION.cff").read_text()
    text = re.sub(r"^authors:\n  - name: .*$", f'authors:\n  - name: "{who["name"]}"', text, count=1, flags=re.M)
    text = re.sub(r"^(repository-code|doi): .*\n", "", text, flags=re.M)
    more = [f"repository-code: {who['url']}\n"] * bool(who["url"]) + [f"doi: {who['doi']}\n"] * bool(who["doi"])
    return text.replace("references:\n", "".join(more) + "references:\n", 1)


def codemeta(title, version, date):
    """codemeta.json with these; its other fields stand there alone."""
    author = {"@type": "Organization", "name": who["name"], **({"email": known["address"]} if known["address"] else {})}
    fields = {**json.loads((top / "codemeta.json").read_text()), "alternateName": title, "version": version, "dateModified": date,
              "author": [author], "codeRepository": who["url"], "identifier": who["doi"] and f"https://doi.org/{who['doi']}"}
    return json.dumps({name: value for name, value in fields.items() if value}, indent=1) + "\n"


def papers():
    """Each file and its text, as the version, the date and who.json make it."""
    text = citation()
    facts = [re.search(rf'^{key}: "?(.*?)"?$', text, flags=re.M).group(1) for key in ("title", "version", "date-released")]
    return {"CITATION.cff": text, "codemeta.json": codemeta(*facts)}


request = sys.argv[1:]
if not request:
    print("\n".join(empty()) or "packages/who.json: nothing is empty")
elif request == ["--write"]:
    for name, text in papers().items():
        (top / name).write_text(text)
elif request == ["--check"]:
    stale = [name for name, text in papers().items() if (top / name).read_text() != text]
    sys.exit(f"FAILED: {', '.join(stale)}: not what python3 packages/who.py --write writes" if stale else None)
else:
    print(who[request[0]])
