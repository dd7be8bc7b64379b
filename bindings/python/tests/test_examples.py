# SPDX-License-Identifier: GPL-3.0-or-later
"""The examples run, and their pictures are those that they draw; the sweep by two processes stores the bits of the serial
result; the README's session is as printed."""
import doctest
import re
import runpy
import struct
import subprocess
import sys

import numpy as np
import pytest

import rwedge
from conftest import PACKAGE

EXAMPLES = PACKAGE / "examples"
PICTURES = EXAMPLES / "pictures"
DRAWN = {  # what each must print
    "fretting": r"sxx/p0 +1\.8193 +published +1\.8193[^$]*p0 +3585\.36 +published +3585\.36[^$]*MPa at x = -1\.0000 b, plane 90\.0 ",
    "dovetail": r"the pad tests the dovetail's edge to 1\.\d %",
    "restart": r"\n0 of 72 results differ, 0 numbers of the state\n",
}


@pytest.fixture
def drawn(tmp_path, monkeypatch, capsys):
    """drawn(name): what the example prints, and where its picture is."""
    monkeypatch.syspath_prepend(str(EXAMPLES))
    monkeypatch.setattr(sys, "dont_write_bytecode", True)

    def draw(name):
        monkeypatch.setattr(sys, "argv", [name, str(tmp_path / f"{name}.svg")])
        runpy.run_path(str(EXAMPLES / f"{name}.py"), run_name="__main__")
        return capsys.readouterr().out, tmp_path / f"{name}.svg"

    return draw


@pytest.mark.parametrize("name", DRAWN)
def test_an_example_draws_the_picture_that_is_shipped(drawn, name):
    printed, picture = drawn(name)
    assert re.search(DRAWN[name], printed), printed
    renew = f"renew it: python bindings/python/examples/{name}.py bindings/python/examples/pictures/{name}.svg"
    new, shipped = (np.genfromtxt(folder / f"{name}.csv", delimiter=",", names=True) for folder in (picture.parent, PICTURES))
    assert new.dtype.names == shipped.dtype.names and new.shape == shipped.shape, renew
    for column in new.dtype.names:
        np.testing.assert_allclose(new[column], shipped[column], rtol=1e-7, atol=1e-8 * np.nanmax(abs(shipped[column])),
                                   err_msg=f"{column}: {renew}")
    import shown

    made_of = shown.fingerprint(EXAMPLES / f"{name}.py", PICTURES / f"{name}.csv")
    assert made_of in (PICTURES / f"{name}.svg").read_text(), f"drawn by another script or style, or of other numbers; {renew}"


def test_published_cases_are_met(drawn):
    """To the digits that are published: four at the least."""
    differences = [float(number) for number in re.findall(r"difference +(\S+)", drawn("fretting")[0])]
    assert len(differences) == 11 and max(map(abs, differences)) < 1e-4


@pytest.mark.long
def test_the_sweep_stores_the_bits_of_the_serial_result(tmp_path, run):
    printed = run(PACKAGE / "examples/sweep.py", tmp_path / "limit.zarr", "--rows", 200, "--columns", 100, "--check")
    assert printed.startswith("20000 points in ")
    assert "\n0 differ from the serial result" in printed
    zarr = pytest.importorskip("zarr")
    stored = zarr.open_array(tmp_path / "limit.zarr", mode="r")
    assert stored.shape == (200, 100) and stored.chunks == (50, 100)
    assert stored[199, 99] == rwedge.elastic_limit(np.geomspace(1e-3, 1, 200)[199], 0.8, 0.3)


def test_dask_takes_the_ufuncs_as_they_are():
    da = pytest.importorskip("dask.array")
    x = np.linspace(-1, 1, 1000)
    lazy = rwedge.pressure(0.25, da.from_array(x, chunks=100))
    assert isinstance(lazy, da.Array)
    assert (lazy.compute() == rwedge.pressure(0.25, x)).all()


def test_methods_do_not_wait_until_their_object_is_gone():
    da = pytest.importorskip("dask.array")
    x = np.linspace(-1, 1, 1000)
    at_once = rwedge.Series(0.25, 60).pressure(da.from_array(x, chunks=100))
    assert isinstance(at_once, np.ndarray)
    assert (at_once == rwedge.Series(0.25, 60).pressure(x)).all()
    with pytest.raises(rwedge.Error, match=r"y\[3\] = -1.0"):
        rwedge.stresses(0.25, 0.3, 0.0, 0.1, da.from_array(np.array([1, 1, 1, -1.0]), chunks=2))


def test_the_figure_is_drawn(tmp_path, run):
    run(PACKAGE / "examples/figure4.py", tmp_path / "figure.png")
    png = (tmp_path / "figure.png").read_bytes()
    assert png.startswith(b"\x89PNG") and struct.unpack(">II", png[16:24]) == (770, 550)


@pytest.mark.long
@pytest.mark.parametrize("example", ["figure4.py", "sweep.py", "fretting.py"])
def test_without_its_argument_an_example_says_how_it_is_called(example):
    done = subprocess.run([sys.executable, PACKAGE / "examples" / example], capture_output=True, text=True)
    assert done.returncode == 2
    assert done.stderr.startswith(f"usage: {example}") and "arguments are required" in done.stderr


def test_the_readme_is_as_it_runs():
    failed, tried = doctest.testfile(str(PACKAGE / "README.md"), module_relative=False, optionflags=doctest.ELLIPSIS)
    assert tried > 15 and failed == 0
