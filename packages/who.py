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

DESCRIPTION = (
    "Contact of a wedge with a rounded apex, a cylinder, a flat pad with rounded edges or any convex profile and an elastically similar "
    "half-plane: pressure, partial slip, stresses, elastic limit, maximum tension and histories of load in closed form; criteria and "
    "life of fatigue. A C library, a command-line tool, and bindings to Python, MATLAB, Octave, Fortran, JavaScript and Excel."
)
KEYWORDS = ["contact mechanics", "flat and rounded pad", "fretting", "half-plane", "partial slip", "wedge"]


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
    return {
        "@context": "https://w3id.org/codemeta/3.0",
        "@type": "SoftwareSourceCode",
        "name": "rwedge",
        "alternateName": title,
        "description": DESCRIPTION,
        "version": version,
        "dateModified": date,
        "license": "https://spdx.org/licenses/GPL-3.0-or-later",
        "author": [{"@type": "Organization", "name": who["name"], **({"email": known["address"]} if known["address"] else {})}],
        "programmingLanguage": ["C", "Python", "Fortran", "MATLAB", "JavaScript"],
        "softwareRequirements": ["GSL", "LAPACK"],
        "keywords": KEYWORDS,
        **({"codeRepository": who["url"]} if who["url"] else {}),
        **({"identifier": f"https://doi.org/{who['doi']}"} if who["doi"] else {}),
    }


def papers():
    """Each file and its text, as the version, the date and who.json make it."""
    text = citation()
    facts = [re.search(rf'^{key}: "?(.*?)"?$', text, flags=re.M).group(1) for key in ("title", "version", "date-released")]
    return {"CITATION.cff": text, "codemeta.json": json.dumps(codemeta(*facts), indent=1) + "\n"}


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
