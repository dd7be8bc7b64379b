# SPDX-License-Identifier: GPL-3.0-or-later
"""The shared library: the bits of the C library, what it needs, documentation."""
import inspect
import os
import re
import subprocess
from pathlib import Path

import pytest

import rwedge
from conftest import PACKAGE, TOP
from rwedge._header import FUNCTIONS
from rwedge._library import library


def test_version_is_that_of_the_header():
    assert f'RWEDGE_VERSION "{rwedge.__version__}"' in (TOP / "include" / "rwedge.h").read_text()


@pytest.mark.skipif("RWEDGE_ANSWERS" not in os.environ, reason="test.sh says where the answers of C are")
def test_answer_prints_the_bits_of_the_c_library(run):
    calls, expected = (Path(os.environ["RWEDGE_ANSWERS"], name).read_text() for name in ("calls.python", "answers.csv"))
    assert expected.count("\n") == calls.count("\n") > 900
    assert run(PACKAGE / "tests/answer.py", input=calls) == expected


def test_it_needs_the_c_and_the_math_library_only():
    needed = re.findall(r"NEEDED.*\[(.*)\]", subprocess.run(["readelf", "-d", library._name], capture_output=True, text=True,
                                                            check=True).stdout)
    assert set(needed) <= {"libc.so.6", "libm.so.6"}
    symbols = subprocess.run(["nm", "-D", "--defined-only", library._name], capture_output=True, text=True, check=True).stdout
    names = {line.split()[-1] for line in symbols.splitlines()}
    assert {name for name in names if not name.startswith("rwedge_")} == set()
    assert {"rwedge_" + name for name in FUNCTIONS} <= names


@pytest.mark.parametrize("kind, maker", [(rwedge.Contact, "contact_create"), (rwedge.Cycle, "cycle_create"), (rwedge.Series, "series_create")])
def test_an_object_and_all_it_does_is_explained(kind, maker):
    """By the header, of which the methods have their texts; those of the classes are written by hand."""
    for argument, domain in FUNCTIONS[maker]["domains"].items():
        for condition in re.findall(r"finite|[-\w./]+ (?:<=|<) \w+ (?:<=|<) [-\w./^]+", domain):
            assert re.search(rf"{argument} : .*\n.*{re.escape(condition)}", kind.__doc__)
    public = [name for name in dir(kind) if not name.startswith("_")]
    texts = [getattr(kind, name).__doc__ for name in public]
    assert all(texts)
    assert not re.search(r"[,;] ?\.(\s|$)", "\n".join(texts))  # what is left where the header names a status
    family = kind.__name__.lower() + "_"
    methods = {re.sub(r"create_|^coefficient$", "", name[len(family):]) for name in FUNCTIONS if name.startswith(family)}
    assert methods - {"", "create", "destroy"} <= set(public)


USE = """
import rwedge
contact = rwedge.Contact(0.01, 2, 1e-5, 0.3)
contact.load(P=1000)
b: float = contact.half_width
p, q = contact.tractions([0.1, 0.2])
factor: float = contact.yield_factor(0.3, 300).factor
limit = rwedge.elastic_limit([0.1, 0.2], 0.3, 0.3)
one: float = rwedge.load(0.25)
stresses = contact.stresses_after({"P": 1000, "Q": [100, -100]}, [0.1, 0.2], 0)
sxx, syy, txy = stresses
worst, angle = rwedge.smith_watson_topper(sxx, syy, txy, 200e3, nu=0.3, axis=0)
worst, angle = rwedge.smith_watson_topper(*stresses, E=200e3, nu=0.3, axis=0)
contact.load([1000, 1100], 10)
cycle = contact.cycle({"P": 1000, "Q": [100, -100]})
slip_range = cycle.friction([0.1, 0.2]).slip_range
left, right = cycle.permanent_stick
contact.load("a")  # type: ignore[arg-type]
named = rwedge.elastic_limit(0.25, f=[0.1, 0.2], nu=0.3, out=None)
contact.load()  # type: ignore[call-arg]
rwedge.yield_point("a", 3, 4)  # type: ignore[arg-type]
rwedge.load(0.25, 3)  # type: ignore[call-overload]
rwedge.load(1j)  # type: ignore[call-overload]
rwedge.load(0.25, friction=3)  # type: ignore[call-overload]
contact.stresses_after({"P": 1000}, "a", 3)  # type: ignore[arg-type]
contact.stresses("a", 3)  # type: ignore[arg-type]
rwedge.absent(1)  # type: ignore[attr-defined]
"""


@pytest.mark.long
def test_types_of_the_stub_are_those_of_the_package(run):
    """The stub lists what is there; mypy knows right from wrong (where nothing is wrong it minds the "ignore")."""
    for check in (["mypy.stubtest", "rwedge"], ["mypy", "--strict", "--no-warn-return-any", "-p", "rwedge"],
                  ["mypy", "--strict", "-c", USE]):
        assert "Success" in run("-m", *check)
