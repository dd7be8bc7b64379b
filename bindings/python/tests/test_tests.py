# SPDX-License-Identifier: GPL-3.0-or-later
"""A series of tests, as the tool computes it: single calls give the same bits."""
import math
import os
import shutil

import numpy as np
import pytest

import rwedge

pytestmark = pytest.mark.skipif(not (os.environ.get("RWEDGE_TOOL") or shutil.which("rwedge")), reason="the tool is not here")

STEEL = {"E": 206800, "nu": 0.3, "sf": 827, "b": -0.11, "ef": 0.95, "c": -0.64}
TABLE = {"radius": [50, 20.0, 50], "P": [300, 300, 300], "Q_max": [100, 140, 999], "sigma_max": [100.0, 110, math.nan],
         "life_tested": ["88216", ">1e7", None]}


def test_a_series_has_the_bits_of_single_calls():
    with pytest.warns(UserWarning, match="1 of 3 tests have an error"):
        tests = rwedge.series(TABLE, f=0.6, material=STEEL, length=0.05)
    assert len(tests) == 3 and tests.length == 0.05
    A = rwedge.compliance(206800, 0.3, 206800, 0.3)
    for i in range(2):
        contact = rwedge.Contact.cylinder(TABLE["radius"][i], A, 0.6)
        contact.load(300)
        Q, sigma = TABLE["Q_max"][i], TABLE["sigma_max"][i]
        history = {"P": [300, 300], "M": [0, 0], "Q": [Q, -Q], "sigma": [sigma, -sigma]}
        contact.apply(*(np.tile(numbers, 2) for numbers in history.values()))
        cycle = contact.cycle(history)
        stresses = cycle.below(tests["swt_x"][i], 0, 0.05, 0)
        damage = rwedge.smith_watson_topper_damage(*stresses, 206800, 0.3, 0, 827, -0.11, 0.95, -0.64, 0)[0]
        assert tests["swt_at_length"][i] == rwedge.smith_watson_topper_planes(*stresses, 206800, 0.3, 0)[0]
        assert tests["damage"][i] == damage and tests["life"][i] == 1 / damage


def test_lives_over_measured_ones_and_run_outs():
    with pytest.warns(UserWarning, match="1 of 3 tests"):
        tests = rwedge.series(TABLE, f=0.6, material=STEEL)
    assert tests["damage"][0] * tests["life"][0] == pytest.approx(1, rel=1e-15)
    assert tests["tested_over_predicted"][0] == 88216 / tests["life"][0]
    assert tests["tested_over_predicted"][1] == pytest.approx(1e7 / tests["life"][1], rel=1e-5)  # the bound has six digits
    assert list(tests.is_run_out) == [False, True, False] and math.isnan(tests["life"][2])
    assert tests["error"][2].startswith("Q 999: must not exceed") and tests["error"][0] == ""


def test_a_length_is_fitted():
    table = {"radius": [50, 20, 100, 50], "P": [300, 300, 500, 600], "Q_max": [100, 140, 200, 260], "sigma_max": [100, 110, 60, 160]}
    told = rwedge.series(table, f=0.6, material=STEEL, length=0.03)
    fitted = rwedge.series({**table, "life_tested": told["life"]}, f=0.6, material=STEEL, fit_length=True)
    assert fitted.length == pytest.approx(0.03, rel=1e-5)
    assert "scatter by a factor of 1," in " ".join(fitted.remarks)


def test_a_file_and_what_is_wrong(tmp_path):
    path = tmp_path / "tests.csv"
    path.write_text("test;R [m];p0;Q\n1;0.05;600;100\n", "utf-8")
    tests = rwedge.series(path, E1=210e3, nu1=0.3, f=0.6, units="mm,N,MPa", column={"radius": "R [m]", "Q_max": "Q"})
    assert tests["peak_pressure"][0] == pytest.approx(600, rel=1e-13)
    with pytest.raises(rwedge.Error, match="column Q: a test has Q_max"):
        rwedge.series({"radius": [50], "P": [300], "Q": [100]}, E1=210e3, nu1=0.3, f=0.6)


def test_columns_of_different_lengths_are_refused():
    with pytest.raises(ValueError, match="columns of different lengths: {'P': 2, 'Q_max': 1}; allowed: one length"):
        rwedge.series({"P": [300, 300], "Q_max": [100]}, radius=50, f=0.6)
