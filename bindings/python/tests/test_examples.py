# SPDX-License-Identifier: GPL-3.0-or-later
"""The examples run, print what they must and draw; the README's session is as printed."""
import doctest
import importlib
import inspect
import os
import re
import runpy
import shutil
import subprocess
import sys

import numpy as np
import pytest

import rwedge
import rwedge.plot
from conftest import PACKAGE

EXAMPLES = PACKAGE / "examples"
DRAWN = {  # what each must print
    "fretting": r"sxx/p0 +1\.8193 +published +1\.8193[^$]*p0 +3585\.36 +published +3585\.36[^$]*MPa at x = -1\.0000 b, plane 90\.0 ",
    "dovetail": r"the pad tests the dovetail's edge to 1\.\d %",
    "pads": r"the flat pad has 0\.87 times the cylinder's",
    "phase": r"\n +0° +1\.4774 +0\.2531 +0e\+00\n[^$]*\n +90° +0\.894\d +0\.978\d [^$]*\nthe log: [2-9]\d of 96 loads exact",
    "spectrum": r"with vibration +46 [^$]*\nthe vibration does 94 % of the damage",
    "total_life": r"\n +2\.0000 [^$]*\nlife 7\.[78]\d*e\+05 cycles, of which [^$]*start a crack of 0\.04",
    "rig": r"^the loop: gross slip, f 0\.(80[01]|799)\d [^$]*\nCrossland[^$]* 15\.6 % at the surface, by 6\.3 % at 44 um[^$]*\n--turning-points: \d\d of 2000 rows[^$]*"
           r"the log: Crossland 48\d MPa [^$]*; 0\.9[345] times [^$]*to be: Crossland 48\d MPa [^$]*; 0\.9[56] times",
    "design": r"^2460 pads in [^$]*\n0 differ from the serial result[^$]*\nfriction up to 0\.6: R of at least 41\.5 mm",
    "many": r"^60 pads and logs, 0 numbers differ [^$]*Q = 50: 0\.0004\d* N dissipated, Q = 100: 0\.005",
    "gradients": r"^10000 gradients under vmap: 0 of 30000 numbers differ [^$]*, b 0\.2500 mm: [^$]*off the root by [1-9]e-(1\d|0[89]) ",
}
LONG = {"design", "gradients", "many", "dovetail", "pads", "phase"}  # test.sh fetches zarr, jax, scipy, Dask and pandas then
OPTIONS = {"design": "--rows 60 --columns 41 --workers 0 --check 1", "many": "--pads 60 --workers 0"}


@pytest.fixture
def drawn(tmp_path, monkeypatch, capsys):
    """drawn(name): what the example prints, and where its picture is."""
    monkeypatch.syspath_prepend(str(EXAMPLES))
    monkeypatch.setattr(sys, "dont_write_bytecode", True)

    def draw(name, options=""):
        monkeypatch.setattr(sys, "argv", [name, str(tmp_path / f"{name}.svg"), *options.split()])
        try:
            runpy.run_path(str(EXAMPLES / f"{name}.py"), run_name="__main__")
        except SystemExit as end:
            assert not end.code
        return capsys.readouterr().out, tmp_path / f"{name}.svg"

    yield draw
    importlib.import_module("matplotlib.pyplot").close("all")  # whose axes others would draw on


@pytest.mark.filterwarnings("ignore:The inplace keyword")  # Dask's own call of pandas, as it writes Parquet
@pytest.mark.parametrize("name", [pytest.param(name, marks=pytest.mark.long) if name in LONG else name for name in DRAWN])
def test_an_example_prints_its_results_and_draws(drawn, name):
    if name == "gradients":
        pytest.importorskip("jax")
    if name == "rig" and not (os.environ.get("RWEDGE_TOOL") or shutil.which("rwedge")):
        pytest.skip("the tool is not here")
    printed, picture = drawn(name, OPTIONS.get(name, ""))
    assert re.search(DRAWN[name], printed), printed
    if name == "fretting":  # to the digits that are published: four at the least
        differences = [float(number) for number in re.findall(r"difference +(\S+)", printed)]
        assert len(differences) == 11 and max(map(abs, differences)) < 1e-4
    numbers = np.genfromtxt(picture.with_suffix(".csv"), delimiter=",", names=True)
    assert numbers.size > 30 and picture.read_text().count("<path") > 10


@pytest.mark.skipif(not shutil.which("ccx"), reason="ccx is not installed (Debian: calculix-ccx)")
@pytest.mark.long
def test_finite_elements_approach_the_closed_form(drawn):
    printed, _ = drawn("calculix", "--refine 1")
    coarse, fine = ([float(word) for word in line.split()[1:4]] for line in printed.splitlines()[2:])  # of pressure, shear, stresses
    assert np.less(coarse, (0.03, 0.03, 0.01)).all() and np.less(fine, 0.5 * np.array(coarse)).all(), printed


@pytest.mark.skipif(not shutil.which("ccx"), reason="ccx is not installed (Debian: calculix-ccx)")
@pytest.mark.long
def test_finite_elements_approach_the_k_of_a_crack(drawn):
    printed, _ = drawn("crack_elements", "--refine 1")
    coarse, fine = np.array([float(line.split()[-1]) for line in printed.splitlines()[1:]]).reshape(2, -1)  # of each length
    assert (coarse < 0.035).all() and (fine < 0.016).all(), printed


@pytest.mark.long
def test_a_sweep_on_a_cluster_stores_the_bits_of_the_serial_result(tmp_path, run):
    printed = run(EXAMPLES / "design.py", tmp_path / "design.svg", "--rows", 200, "--columns", 100, "--check", 1)
    assert printed.startswith("20000 pads in ") and "\n0 differ from the serial result" in printed
    zarr = pytest.importorskip("zarr")
    stored = zarr.open_array(tmp_path / "design.zarr", mode="r")
    assert stored.shape == (200, 100) and stored.chunks == (50, 100)


@pytest.mark.long
def test_tables_histories_and_contacts_go_to_the_workers_of_a_cluster(tmp_path, run):
    printed = run(EXAMPLES / "many.py", tmp_path / "many.svg", "--pads", 60, "--workers", 2)
    assert re.search(DRAWN["many"], printed), printed


@pytest.mark.long
def test_cloudpickle_sends_a_contact(contact):
    """Dask and Ray send by it what pickle sends by name."""
    cloudpickle = pytest.importorskip("cloudpickle")
    assert (cloudpickle.loads(cloudpickle.dumps(contact)).state() == contact.state()).all()


@pytest.mark.long
def test_dask_takes_the_ufuncs_as_they_are():
    da = pytest.importorskip("dask.array")
    x = np.linspace(-1, 1, 1000)
    lazy = rwedge.pressure(0.25, da.from_array(x, chunks=100))
    assert isinstance(lazy, da.Array)
    assert (lazy.compute() == rwedge.pressure(0.25, x)).all()


@pytest.mark.long
def test_methods_do_not_wait_until_their_object_is_gone():
    da = pytest.importorskip("dask.array")
    x = np.linspace(-1, 1, 1000)
    at_once = rwedge.Series(0.25, 60).pressure(da.from_array(x, chunks=100))
    assert isinstance(at_once, np.ndarray)
    assert (at_once == rwedge.Series(0.25, 60).pressure(x)).all()
    with pytest.raises(rwedge.Error, match=r"y\[3\] = -1.0"):
        rwedge.stresses(0.25, 0.3, 0.0, 0.1, da.from_array(np.array([1, 1, 1, -1.0]), chunks=2))


@pytest.mark.long
def test_without_its_argument_an_example_says_how_it_is_called():
    done = subprocess.run([sys.executable, EXAMPLES / "fretting.py"], capture_output=True, text=True)
    assert done.returncode == 2 and done.stderr.startswith("usage: fretting.py") and "arguments are required" in done.stderr


def test_the_readme_is_as_it_runs():
    failed, tried = doctest.testfile(str(PACKAGE / "README.md"), module_relative=False, optionflags=doctest.ELLIPSIS)
    assert tried > 15 and failed == 0


@pytest.mark.parametrize("module", ["rwedge", "rwedge.plot"])
def test_the_examples_in_the_help_are_as_they_run(module):
    pytest.importorskip("matplotlib").use("Agg")
    failed, tried = doctest.testmod(importlib.import_module(module))
    assert tried > 15 and failed == 0


def test_the_help_has_no_bars_of_restructuredtext():
    """|Q| would be a substitution there."""
    documented = [rwedge, *(getattr(rwedge, name) for name in rwedge.__all__), *vars(rwedge.Contact).values(), *vars(rwedge.plot).values()]
    barred = [text for text in map(inspect.getdoc, documented) if text and re.search(r"\|\w+\|", text)]
    assert not barred, barred[0]
