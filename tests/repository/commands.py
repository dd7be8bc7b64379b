# SPDX-License-Identifier: GPL-3.0-or-later
"""The commands of every README, run as written, in a fresh clone.

    commands.py SOURCE           only looks: every command stands in a block that says whether it is run
    commands.py SOURCE --run     clones SOURCE into a folder with a space, an apostrophe and an accent, and runs them

In a README these blocks are run, one after the other, at the top of the clone:

    ```sh              commands
    ```console         commands after "$ ", each with what it prints (if anything is shown)
    ```LANGUAGE FILE   not a command: the content of a file that later commands use

Not run is a block ```sh not run: REASON. The reason is printed. What is indented and begins like a command fails.
"""

import os
import re
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

COMMAND = re.compile(r"    (\$ |\./|build/|~/|(apt-get|cc|cmake|ctest|gfortran|octave-cli|pip|python3?|sh|x86_64-\S+) )")
NEEDS = {"gfortran ": "gfortran", "octave-cli ": "octave-cli", "rwedge figure ": "gnuplot"}
PLACEHOLDER = re.compile(r"(?<!\$)\b[A-Z]{4,}\b")  # a synopsis: run.sh FOLDER


def readmes(source):
    paths = sorted(p.relative_to(source) for p in source.rglob("README.md") if p.relative_to(source).parts[0] != "build")
    return sorted(paths, key=lambda path: len(path.parts))


def blocks(path):
    """(first line, info string, lines) of each fenced block; info None for an indented command."""
    inside = None
    for number, line in enumerate(path.read_text().splitlines(), 1):
        if line.startswith("```"):
            if inside is None:
                inside = (number, line[3:].strip(), [])
            else:
                yield inside
                inside = None
        elif inside is not None:
            inside[2].append(line)
        elif COMMAND.match(line) and not PLACEHOLDER.search(line):
            yield number, None, [line]


def sections(readme, fenced):
    """The commands of a README, as (line, script, the lines that it must print or none)."""
    for number, info, lines in fenced:
        if info == "sh":
            yield number, "\n".join(lines), []
        elif info == "console":
            for example in "\n".join(lines)[2:].split("\n$ "):
                command, *shown = example.split("\n")
                yield number, command, shown


def look(source):
    """Prints what is not run; the number of commands that no block holds."""
    faults = run = 0
    for readme in readmes(source):
        for number, info, lines in blocks(source / readme):
            if info is None:
                print(f"FAILED: {readme}:{number}: not in a block that says whether it is run: {lines[0].strip()}")
                faults += 1
            elif info.startswith("sh not run: "):
                for line in lines:
                    print(f"not run: {readme}: {line.split('  #')[0].strip()}: {info[12:]}")
            elif info == "sh":
                run += len(lines)
            elif info == "console":
                run += sum(line.startswith("$ ") for line in lines)
            elif info.split(" ")[0] == "sh":
                print(f"FAILED: {readme}:{number}: ```{info}")
                faults += 1
    print(f"{run} commands to run")
    if run < 20:
        print("FAILED: these are too few: the READMEs were not read")
        faults += 1
    return faults


SHIM = """#!/bin/sh
# ctest within the suite's own test: that there are tests to run, and the first of them.
case " $* " in
*' -R '*) exec {ctest} --no-tests=error "$@" -N ;;
*) exec {ctest} --no-tests=error "$@" -I 1,1 ;;
esac
"""


class Clone:
    def __init__(self, source, work):
        self.top = work / "a user's cl\u00f4ne"
        subprocess.run(["git", "clone", "--quiet", source, self.top], check=True)
        tools = work / "tools"
        tools.mkdir()
        (tools / "ctest").write_text(SHIM.format(ctest=shutil.which("ctest")))
        (tools / "ctest").chmod(0o755)
        home = work / "home"
        home.mkdir()
        path = f"{self.top}/build/cli:{tools}:{os.environ['PATH']}"
        self.environment = {**os.environ, "HOME": str(home), "PATH": path, "CMAKE_BUILD_PARALLEL_LEVEL": str(os.cpu_count())}

    def run(self, script, shown):
        """Whether the script ends well, and prints what is shown."""
        ended = subprocess.run(["sh", "-e", "-c", script], cwd=self.top, env=self.environment, text=True,
                               stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
        if shown and ended.stdout.splitlines() == shown:
            return True  # a shown message may be an error's
        if shown or ended.returncode != 0:
            print(ended.stdout[-4000:], f"status {ended.returncode}", sep="\n")
            return False
        return True

    def is_clean(self):
        """Whether no file of the repository has changed."""
        changed = subprocess.run(["git", "status", "--porcelain", "--untracked-files=no"], cwd=self.top, text=True,
                                 check=True, stdout=subprocess.PIPE).stdout
        print(changed, end="")
        return changed == ""


def run(source):
    faults = 0
    with tempfile.TemporaryDirectory() as work:
        clone = Clone(source, Path(work))
        for readme in readmes(source):
            fenced = list(blocks(clone.top / readme))
            for _, info, lines in fenced:
                words = (info or "").split(" ")
                if len(words) == 2 and "." in words[1]:
                    (clone.top / words[1]).write_text("\n".join(lines) + "\n")
            for number, script, shown in sections(readme, fenced):
                missing = [tool for part, tool in NEEDS.items() if part in script and not shutil.which(tool)]
                if missing:
                    print(f"not run: {readme}: {script}: no {missing[0]} here")
                    continue
                print(f"{readme}:{number}: {script}", flush=True)
                if not clone.run(script, shown):
                    print(f"FAILED: {readme}:{number}")
                    faults += 1
                if not clone.is_clean():
                    print(f"FAILED: {readme}:{number}: it changes files of the repository")
                    return faults + 1
    return faults


def main():
    source = Path(sys.argv[1]).resolve()
    faults = look(source)
    if "--run" in sys.argv[2:] and faults == 0:
        if not (source / ".git").exists() or not shutil.which("git"):
            print("SKIPPED: not a clone, or no git here")
            return 77
        faults = run(source)
    return faults != 0


sys.exit(main())
