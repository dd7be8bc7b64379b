#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Exchanges two arguments, or two results, of every call of the library in every binding, and looks whether the binding's door
then gives other answers: exchange.py BUILD [BINDING...]. BUILD is where the tests of the bindings have run.

All functions have an exchange at the same time, each one of its own, but for those that make or change an object, which have
one at a time: their answers are those of all that follows. Exchanges that a compiler refuses are not tried: of a number and
an array, and in Fortran and Python's classes of a real and an integer. Excel's module, which no door runs, is held by bindings/excel/check.py,
which is asked in the same way. Not tried are calls that change no answer: those with which Fortran looks for the element to be named in a message, and the one
with which MATLAB's class looks whether to warn. Nor are calls with *arguments in Python's classes; their tests hold these.

Where a function is symmetric in two arguments, their exchange must change no answer; SYMMETRIC lists these. check.py goes by the
names, and notices these too.
"""
import os
import re
import shutil
import subprocess
import sys
import tempfile
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

TOP = Path(__file__).resolve().parents[2]
HERE = TOP / "tests" / "doors"
INTERFACE = TOP / "bindings" / "interface"
sys.path.insert(0, str(INTERFACE))

import write_excel  # noqa: E402
import write_python  # noqa: E402
import write_web  # noqa: E402
from header import read  # noqa: E402

# Measures of a stress that do not tell its two normal stresses apart: the invariants, and what is made of them.
SYMMETRIC = {name: {"sxx", "syy"} for name in ("von_mises", "out_of_plane_stress", "largest_shear")}

interface = read(TOP / "include" / "rwedge.h")
BUILD = Path(sys.argv[1] if len(sys.argv) > 1 else "build").resolve()
PRIVATE = BUILD / "private" / "prefix"
MADE = BUILD / "private" / "made"
ARCHIVE = str(PRIVATE / "lib" / "librwedge.a")
SHARES = os.cpu_count() or 1  # rounds at the same time


def run(*command, **options):
    done = subprocess.run([str(c) for c in command], capture_output=True, text=True, **options)
    if done.returncode:
        sys.exit(f"FAILED: {' '.join(map(str, command))}\n{done.stdout[-2000:]}{done.stderr[-2000:]}")
    return done.stdout


def arguments(text, start):
    """(start, end) of each argument of the call whose parenthesis opens at start."""
    found, depth, begin, quoted = [], 0, start + 1, False
    for i in range(start, len(text)):
        quoted ^= text[i] in "'\"" and text[i - 1] != "\\"
        depth += 0 if quoted else {"(": 1, "[": 1, ")": -1, "]": -1}.get(text[i], 0)
        if not quoted and (depth == 0 or text[i] == "," and depth == 1):
            found.append((begin, i))
            begin = i + 1
        if depth == 0:
            break
    return [(a + len(text[a:b]) - len(text[a:b].lstrip(" \n&\\_")), b) for a, b in found if text[a:b].strip(" \n&\\_")]


class Site:
    """Two places of a file's text to be exchanged, and the functions that must notice: each with the names of the two there."""

    def __init__(self, functions, file, one, other):
        self.functions, self.file, self.places = functions, file, (one, other)
        self.changes = any(interface[f].of("created", "changed") for f in functions)

    def text(self, texts):
        (a, b), (c, d) = self.places
        return f"{self.file.name}: {', '.join(self.functions)}: {texts[self.file][a:b]} and {texts[self.file][c:d]}"


def pairs(items):
    return [(a, b) for i, a in enumerate(items) for b in items[i + 1:]]


def of_calls(file, text, pattern, name_of, parameters_of, same_kind):
    """The sites of all calls in a text; parameters_of says what stands where."""
    sites = []
    for match in re.finditer(pattern, text):
        name = name_of(match)
        if name not in interface:
            continue
        places = arguments(text, match.end() - 1)
        if file.suffix == ".py" and any(text[a] == "*" for a, _ in places):
            continue  # what stands where is known when it runs
        listed = list(zip(places, parameters_of(interface[name])))
        sites += [Site({name: {one.name, other.name}}, file, p, q) for (p, one), (q, other) in pairs(listed)
                  if one and other and same_kind(one, other)]
    return sites


def in_c(one, other):
    return one.role == other.role and one.role in ("in", "in array", "out", "out array", "size")


def of_one_type(one, other):
    return in_c(one, other) and one.kind == other.kind


def all_parameters(f):
    return f.parameters


# ---- The doors: what is exchanged, and how the door is made of it ----


class C:
    """The table of entries, in the door of C."""

    def __init__(self, work):
        self.work = work
        self.files = [MADE / "c" / "entries.h"]

    def sites(self, texts):
        (file,) = self.files
        return of_calls(file, texts[file], r"\brwedge_(\w+)\(", lambda m: m[1], all_parameters, in_c)

    def answers(self, texts, calls):
        (self.work / "entries.h").write_text(texts[self.files[0]])
        run("cc", "-O0", "-w", f"-I{self.work}", f"-I{TOP}/include", HERE / "door.c", ARCHIVE, "-lm", "-o", self.work / "door")
        return run(self.work / "door", input=calls)


class Fortran:
    """The module. Its interfaces have the names alone; the calls are what counts."""

    def __init__(self, work):
        self.work = work
        self.files = [MADE / "fortran" / "rwedge.f90"]

    def sites(self, texts):
        (file,) = self.files
        text = texts[file]
        start = text.index("    end interface\n\ncontains")
        calls = r"\bc_(\w+)\((?![^\n]*\bi:i\b)"
        return [s for s in of_calls(file, text, calls, lambda m: m[1], all_parameters, of_one_type) if s.places[0][0] > start]

    def answers(self, texts, calls):
        (self.work / "rwedge.f90").write_text(texts[self.files[0]])
        run("gfortran", "-O0", "-w", "rwedge.f90", MADE / "fortran" / "door.f90", ARCHIVE, "-lm", "-o", "door",
            cwd=self.work)
        return run(self.work / "door", input=calls)


class Matlab:
    """The MEX file's table, and the functions and classes."""

    def __init__(self, work):
        self.work, self.built = work, None
        self.functions = sorted((MADE / "matlab").glob("*.m"))
        self.files = [MADE / "c" / "entries.h", *self.functions]
        self.include = run("mkoctfile", "-p", "OCTINCLUDEDIR").strip()

    def sites(self, texts):
        sites = of_calls(self.files[0], texts[self.files[0]], r"\brwedge_(\w+)\(", lambda m: m[1], all_parameters, in_c)
        for file in self.functions:
            sites += of_calls(file, texts[file], r"rwedge_mex\((?!'validity', known)(?='(\w+)')", lambda m: m[1],
                              lambda f: [None, *(f.of("handle", "changed") and [None]), *f.inputs],
                              lambda one, other: True)
            text = texts[file]
            for match in re.finditer(r"\[([^]\n]*)\] = rwedge_mex\('(\w+)'", text):
                places = [(match.start(1) + m.start(), match.start(1) + m.end()) for m in re.finditer(r"\w+", match[1])]
                sites += [Site({match[2]: {text[slice(*p)], text[slice(*q)]}}, file, p, q) for p, q in pairs(places)]
        return sites

    def answers(self, texts, calls):
        table = texts[self.files[0]]
        if table != self.built:
            (self.work / "entries.h").write_text(table)
            run("gcc", "-O0", "-w", "-shared", "-fPIC", f"-I{self.work}", f"-I{TOP}/include", f"-I{self.include}",
                TOP / "bindings" / "matlab" / "rwedge_mex.c", ARCHIVE, "-lm", "-o", self.work / "rwedge_mex.mex")
            self.built = table
        for file in self.functions:
            (self.work / file.name).write_text(texts[file])
        return run("octave-cli", "--no-init-file", "--no-history", "--path", self.work,
                   TOP / "bindings" / "matlab" / "door.m", input=calls)


class Python:
    """The loops of the ufuncs, and the calls of the classes."""

    def __init__(self, work):
        self.work, self.built = work, None
        self.python = BUILD / "python" / "venv" / "bin" / "python"
        package = next((BUILD / "python" / "venv").glob("lib/*/site-packages/rwedge"))
        shutil.copytree(package, work / "rwedge")
        self.made = work / "loops.h"
        self.made.write_text(write_python.loops_h(interface))
        self.classes = {family: TOP / f"bindings/python/src/rwedge/_{family}.py" for family in ("contact", "series")}
        self.files = [self.made, *self.classes.values()]

    def sites(self, texts):
        text = texts[self.made]
        sites = of_calls(self.made, text, r"\brwedge_(\w+)\(", lambda m: m[1], all_parameters, in_c)
        for match in re.finditer(r"FORMULA_LOOP\((\w+), [^()]*\([^()]*\), \(", text):
            functions = [f for f in interface.functions if write_python.is_ufunc(f) and f.result == "value"
                         and "".join(p.kind[0] for p in f.parameters) == match[1]]
            sites += [Site({f.name: {f.parameters[i].name, f.parameters[j].name} for f in functions}, self.made, p, q)
                      for (i, p), (j, q) in pairs(list(enumerate(arguments(text, match.end() - 1))))]
        for family, file in self.classes.items():
            sites += of_calls(file, texts[file], r"(?<![\w.])_(\w+)\(", lambda m, family=family: f"{family}_{m[1]}",
                              all_parameters, of_one_type)
        return sites

    def answers(self, texts, calls):
        if texts[self.made] != self.built:
            folder = self.work / "include"
            folder.mkdir(exist_ok=True)
            (folder / "loops.h").write_text(texts[self.made])
            run("cc", "-O0", "-w", "-shared", "-fPIC", f"-I{folder}", f"-I{TOP}/include", TOP / "bindings/python/src/loops.c",
                "-Wl,--whole-archive", ARCHIVE, "-Wl,--no-whole-archive", "-lm", "-o", self.work / "rwedge/_rwedge.so")
            self.built = texts[self.made]
        for file in self.classes.values():
            (self.work / "rwedge" / file.name).write_text(texts[file])
        return run(self.python, "-B", TOP / "bindings/python/tests/door.py", input=calls,
                   env={"PYTHONPATH": str(self.work), "PYTHONPYCACHEPREFIX": str(BUILD / "python" / "pycache")})


class Excel:
    """The module of Basic: declarations and calls, by what check.py says of them."""

    def __init__(self, work):
        self.work = work
        self.files = [MADE / "excel" / "rwedge.bas"]
        folder = BUILD / "excel"
        self.given = [TOP / "include/rwedge.h", folder / "prototypes", folder / "tables"]

    def sites(self, texts):
        (file,) = self.files
        text = texts[file]
        declared = r'Alias "rwedge_(\w+)" \('
        return of_calls(file, text, declared, lambda m: m[1], all_parameters, in_c) + \
            of_calls(file, text, r"(?<!Function )(?<!Sub )\bc_(\w+)\(", lambda m: m[1], all_parameters, in_c)

    def answers(self, texts, calls):
        """A line for each function: what check.py says of it."""
        module = self.work / "rwedge.bas"
        module.write_bytes(texts[self.files[0]].encode("ascii"))
        said = subprocess.run([sys.executable, "-B", TOP / "bindings/excel/check.py", module, *self.given], capture_output=True,
                              text=True).stdout
        names = [f.name for f in interface.functions if f.name not in write_excel.NOT_DECLARED]
        return "\n".join(f"{n}:{re.findall(rf'(?m)^.*(?:rwedge|c)_{n}: .*$', said)}" for n in names)


class Web:
    """The module of JavaScript: all of its calls."""

    def __init__(self, work):
        self.work = work / "package"
        shutil.copytree(BUILD / "web" / "package", self.work)
        self.files = [BUILD / "web" / "package" / "rwedge.mjs"]

    def sites(self, texts):
        (file,) = self.files
        return of_calls(file, texts[file], r'(?:formula|call)\("(\w+)", (?:null, |this, )?\[', lambda m: m[1],
                        write_web.arguments, lambda one, other: True)

    def answers(self, texts, calls):
        (self.work / "rwedge.mjs").write_text(texts[self.files[0]])
        return run("node", TOP / "bindings/web/test/door.mjs", self.work, input=calls)


# What each needs: programs, and what the tests of the binding leave in BUILD.
NEEDS = {"c": (), "fortran": ("gfortran",), "matlab": ("octave-cli", "mkoctfile"), "python": (BUILD / "python/venv/bin/python",),
         "web": ("node", BUILD / "web/package/rwedge.mjs"), "excel": (BUILD / "excel/prototypes", BUILD / "excel/tables")}
DOORS = {"c": C, "fortran": Fortran, "matlab": Matlab, "python": Python, "web": Web, "excel": Excel}

# ---- Rounds of exchanges ----


def exchanged(texts, sites):
    """The texts with all these exchanges; they are of different calls."""
    texts = dict(texts)
    edits = {}
    for site in sites:
        (a, b), (c, d) = site.places
        text = texts[site.file]
        edits.setdefault(site.file, []).extend([(a, b, text[c:d]), (c, d, text[a:b])])
    for file, changes in edits.items():
        text = texts[file]
        for a, b, new in sorted(changes, reverse=True):
            text = text[:a] + new + text[b:]
        texts[file] = text
    return texts


def rounds(sites):
    """Lists of sites that are tried at the same time: one of each function, but one alone that changes an object."""
    alone = [[s] for s in sites if s.changes]
    together = []
    for site in (s for s in sites if not s.changes):
        free = next((r for r in together if not {f for s in r for f in s.functions} & set(site.functions)), None)
        if free is None:
            together.append([site])
        else:
            free.append(site)
    return together + alone


def lines_of(answers):
    """function -> its lines."""
    found = {}
    for line in answers.splitlines():
        found.setdefault(line.split(":")[0], []).append(line)
    return found


def misjudged(site, before, after, symmetric):
    """The functions of a site that answer as if nothing had happened, or of symmetric ones those that do not."""
    if site.changes:
        return [] if before != after else list(site.functions)
    served = {f: [f, *(g.name for g in interface.functions if g.name == f or interface[f].array_of == g.name)]
              for f in site.functions}
    return [f for f, names in served.items()
            if all(before.get(n) == after.get(n) for n in names) != (site.functions[f] == symmetric.get(f))]


def tried(name, calls, share):
    """What every share-th of the rounds shows, in a folder of its own: the sites, and (site, functions) of those that fail."""
    with tempfile.TemporaryDirectory() as work:
        door = DOORS[name](Path(work))
        texts = {file: file.read_bytes().decode("ascii") for file in door.files}
        sites = door.sites(texts)
        before = lines_of(door.answers(texts, calls))
        symmetric = {} if name == "excel" else SYMMETRIC
        missed = []
        for together in rounds(sites)[share::SHARES]:
            after = lines_of(door.answers(exchanged(texts, together), calls))
            missed += [f"{site.text(texts)}: {', '.join(found)}" for site in together
                       if (found := misjudged(site, before, after, symmetric))]
    return sites, missed


def try_all(name, calls):
    with ThreadPoolExecutor(SHARES) as pool:
        parts = list(pool.map(lambda share: tried(name, calls, share), range(SHARES)))
    sites, missed = parts[0][0], [text for _, found in parts for text in found]
    for text in missed:
        print(f"FAILED: nobody notices, or it is not symmetric: {name}: {text}")
    if not sites:
        missed.append(name)
        print(f"FAILED: no calls found: {name}")
    functions = {f for s in sites for f in s.functions}
    print(f"{name}: {len(sites)} exchanges of {len(functions)} functions, {len(missed)} failed", flush=True)
    return missed


def main():
    calls = run(sys.executable, "-B", HERE / "calls.py", "--own")
    missed, skipped = [], []
    for name in sys.argv[2:] or DOORS:
        absent = [str(n) for n in NEEDS[name] if not shutil.which(n) and not Path(n).is_file()]
        if absent:
            skipped.append(name)
            print(f"SKIPPED: {name}, as there is no {', '.join(absent)}")
            continue
        missed += try_all(name, calls)
    sys.exit(1 if missed else 77 if skipped else 0)


main()
