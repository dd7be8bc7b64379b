# SPDX-License-Identifier: GPL-3.0-or-later
"""Judges mutants of the library: compiled as the build compiles it, linked in front of it with one test program after the
other, until one notices. Mutants that do not compile, and those whose object code is that of the original, do not count.

    mutation.py [options] LIB BUILD PROGRAM...
"""

import argparse
import json
import math
import random
import re
import resource
import shlex
import shutil
import subprocess
import sys
import threading
import time
from collections import Counter, defaultdict
from pathlib import Path

import mutants

sys.path.insert(0, str(Path(__file__).parents[1] / "coverage"))
from branches import unjudged_lines  # noqa: E402

WANTED = 0.90
ENOUGH = 500  # of a smaller sample only the upper end of the interval is held against it
MEMORY = 1 << 20  # KiB
LINKING = 0.1  # s, about
ARGUMENTS = {"strength_survey": ["300"], "test_calls": ["100"]}  # fewer cases than by default


def run(command, folder, seconds=None):
    return subprocess.run(command, cwd=folder, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                          timeout=seconds, check=False)


class Program:
    """A test program: how to link it with other objects, what it needs of the library, how long it takes."""

    def __init__(self, name, build):
        link = next((build / "tests").rglob(f"{name}.dir/link.txt"))
        self.name, self.folder = name, link.parents[2]
        self.command = shlex.split(link.read_text())
        self.output = self.command.index("-o") + 1
        traced = run([*self.command, "-Wl,-t,-t"], self.folder).stdout.decode()
        self.units = set(re.findall(r"librwedge\w*\.a\)(\w+\.c)\.o", traced))
        self.limit = 60
        before = resource.getrusage(resource.RUSAGE_CHILDREN)
        if self.notices(self.folder / name, self.folder):
            sys.exit(f"FAILED: {name} fails without any mutant")
        after = resource.getrusage(resource.RUSAGE_CHILDREN)
        self.seconds = after.ru_utime - before.ru_utime + after.ru_stime - before.ru_stime
        self.limit = math.ceil(4 * self.seconds) + 1

    def link(self, objects, target):
        command = [self.command[0], *map(str, objects), *self.command[1:]]
        command[self.output + len(objects)] = str(target)
        linked = run(command, self.folder)
        if linked.returncode != 0:
            sys.exit("FAILED: " + linked.stdout.decode())

    def notices(self, executable, folder):
        """Whether the program fails, is killed, or takes too long (processor time; or far too long by the clock)."""
        limited = f'ulimit -c 0; ulimit -t {self.limit}; ulimit -v {MEMORY}; exec "$0" "$@"'
        command = ["sh", "-c", limited, str(executable), *ARGUMENTS.get(self.name, [])]
        try:
            return run(["env", "CMOCKA_TEST_ABORT=1", *command], folder, 20 * self.limit + 60).returncode != 0
        except subprocess.TimeoutExpired:
            return True


class Library:
    """How each unit is compiled, where it lies (folder/name), and which units a file goes into. Units are known by their names,
    which are those of their objects; files by folder and name."""

    def __init__(self, lib, build):
        self.lib = lib
        self.commands, self.places, self.includers = {}, {}, defaultdict(list)
        for entry in json.loads((build / "compile_commands.json").read_text()):
            path = Path(entry["file"])
            if path.parent.parent != lib:
                continue
            command = shlex.split(entry["command"].replace(f"-I{lib} ", "-Ilib "))
            self.places[path.name] = f"{path.parent.name}/{path.name}"
            self.commands[path.name] = [word for word in command[: command.index("-o")]]
            listed = run([*self.commands[path.name], "-MM", str(path)], lib.parent).stdout.decode()
            for file in set(re.findall(r"\blib/(\w+/\w+\.[ch])\b", listed)):
                if (lib / file).exists():
                    self.includers[file].append(path.name)

    def compile(self, unit, folder):
        """The object's path, None where it does not compile, or calls what nobody declares. By a path that is the same in every
        folder."""
        target = folder / (unit + ".o")
        target.unlink(missing_ok=True)
        run([*self.commands[unit], "-Werror=implicit-function-declaration", "-c", f"lib/{self.places[unit]}", "-o", target.name], folder)
        return target if target.exists() else None


class Judge:
    """A scratch folder with a copy of the library, in which one mutant after the other is judged."""

    def __init__(self, folder, library, originals):
        self.folder, self.library, self.originals = folder, library, originals
        shutil.rmtree(folder, ignore_errors=True)
        shutil.copytree(library.lib, folder / "lib", ignore=shutil.ignore_patterns("package"))

    def changed_objects(self, file):
        """Of the units that the file goes into, those whose code has changed; None where one does not compile."""
        changed = []
        for unit in self.library.includers[file]:
            compiled = self.library.compile(unit, self.folder)
            if compiled is None:
                return None
            if compiled.read_bytes() != self.originals[unit]:
                changed.append(compiled)
        return changed

    def verdict(self, file, source, mutant, order):
        """'invalid', 'equivalent', 'survived', or the name of the program that noticed."""
        path = self.folder / "lib" / file
        path.write_text(mutants.applied(mutant, source))
        try:
            objects = self.changed_objects(file)
        finally:
            path.write_text(source)
        if objects is None:
            return "invalid"
        if not objects:
            return "equivalent"
        changed = {object.name[:-2] for object in objects}
        for program in order(file):
            if not program.units & changed:
                continue
            program.link([object for object in objects if object.name[:-2] in program.units], self.folder / "program")
            if program.notices(self.folder / "program", self.folder):
                return program.name
        return "survived"


class Campaign:
    """Judges a sequence of mutants with several judges at a time, until there are as many verdicts as wanted."""

    def __init__(self, candidates, wanted, programs, log):
        self.candidates, self.wanted, self.programs, self.log = candidates, wanted, programs, log
        self.verdicts, self.next, self.viable, self.broken = {}, 0, 0, []
        self.noticed = defaultdict(Counter)
        self.lock = threading.Lock()

    def order(self, file):
        """First what is likely to notice, for its time."""
        counts = self.noticed[file]
        return sorted(self.programs, key=lambda p: -(counts[p.name] + 0.5) / (p.seconds + LINKING))

    def work(self, judge):
        try:
            self.judge_all(judge)
        except BaseException as error:  # which would end this thread alone, and the sample with it
            self.broken.append(error)

    def judge_all(self, judge):
        while True:
            with self.lock:
                if self.broken or self.viable >= self.wanted or self.next == len(self.candidates):
                    return
                index = self.next
                self.next += 1
            file, source, mutant = self.candidates[index]
            verdict = judge.verdict(file, source, mutant, self.order)
            with self.lock:
                self.verdicts[index] = verdict
                if verdict not in ("invalid", "equivalent"):
                    self.viable += 1
                    self.noticed[file][verdict] += 1
                number, _, after = mutants.described(mutant, source)
                print(f"{index}\t{verdict}\t{file}:{number}\t{after}", file=self.log, flush=True)

    def result(self):
        """(candidate, verdict) in the order of the sample, and no more than wanted of those that count."""
        kept, viable = [], 0
        for index in sorted(self.verdicts):
            if viable == self.wanted:
                break
            verdict = self.verdicts[index]
            viable += verdict not in ("invalid", "equivalent")
            kept.append((self.candidates[index], verdict))
        return kept


def wilson(part, whole):
    """The 95 % confidence interval of a fraction (Wilson 1927)."""
    z, p = 1.959964, part / whole
    middle = (p + z * z / (2 * whole)) / (1 + z * z / whole)
    half = z * math.sqrt(p * (1 - p) / whole + z * z / (4 * whole * whole)) / (1 + z * z / whole)
    return middle - half, middle + half


def report(kept, total, seconds):
    """Prints the figures and the survivors; whether enough was noticed."""
    verdicts = Counter(verdict for _, verdict in kept)
    invalid, equivalent, survived = (verdicts.pop(kind, 0) for kind in ("invalid", "equivalent", "survived"))
    killed = sum(verdicts.values())
    if killed + survived == 0:
        sys.exit("FAILED: no mutant could be judged")
    per_file = defaultdict(Counter)
    for (file, source, mutant), verdict in kept:
        if verdict in ("invalid", "equivalent"):
            continue
        per_file[file]["survived" if verdict == "survived" else "killed"] += 1
        if verdict == "survived":
            number, before, after = mutants.described(mutant, source)
            print(f"lib/{file}:{number}: {before}\n    survived: {after or '(nothing)'}")
    for file, counts in sorted(per_file.items()):
        print(f"{file:26} {counts['killed']:5} killed {counts['survived']:5} survived")
    low, high = wilson(killed, killed + survived)
    score = killed / (killed + survived)
    print(f"{len(kept)} of {total} mutants: {invalid} do not compile, {equivalent} are the same code, {killed} killed, "
          f"{survived} survived; {seconds:.0f} s")
    print(f"score {100 * score:.1f} %, 95 % confidence {100 * low:.1f} to {100 * high:.1f} %; wanted {100 * WANTED:.0f} %")
    return (score if killed + survived >= ENOUGH else high) >= WANTED


def of_reached_lines(source):
    """The mutants of a file, without those of lines that no test is asked to reach."""
    unjudged = unjudged_lines(source.splitlines())
    return [mutant for mutant in mutants.mutants(source) if mutants.described(mutant, source)[0] not in unjudged]


def arguments():
    parser = argparse.ArgumentParser()
    parser.add_argument("--sample", type=int, default=1000, help="how many mutants to judge")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--jobs", type=int, default=2)
    parser.add_argument("--only", default="", help="regular expression of the files of lib/ to change")
    parser.add_argument("--tests", default="", help="regular expression of the programs to run")
    parser.add_argument("lib", type=Path)
    parser.add_argument("build", type=Path)
    parser.add_argument("programs", nargs="+")
    return parser.parse_args()


def main():
    given = arguments()
    start = time.monotonic()
    programs = [Program(name, given.build) for name in given.programs if re.search(given.tests, name)]
    programs = [program for program in programs if program.units]  # not of headers alone
    if not programs:
        sys.exit("FAILED: no test program links a unit of the library, as far as the linker's trace tells")
    library = Library(given.lib, given.build)
    first = Judge(given.build / "judge0", library, {})
    originals = {unit: library.compile(unit, first.folder).read_bytes() for unit in library.commands}
    files = {f"{path.parent.name}/{path.name}": path for path in sorted(given.lib.glob("*/*.[ch]"))}
    candidates = [(name, path.read_text(), mutant) for name, path in files.items()
                  if re.search(given.only, name) for mutant in of_reached_lines(path.read_text())]
    random.Random(given.seed).shuffle(candidates)
    judges = [Judge(given.build / f"judge{i}", library, originals) for i in range(given.jobs)]
    with open(given.build / "verdicts", "w") as log:
        campaign = Campaign(candidates, given.sample, programs, log)
        threads = [threading.Thread(target=campaign.work, args=(judge,)) for judge in judges]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
    if campaign.broken:
        raise campaign.broken[0]
    kept = campaign.result()
    well = report(kept, len(candidates), time.monotonic() - start)
    sys.exit(0 if well else 1)


main()
