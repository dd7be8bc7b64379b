# SPDX-License-Identifier: GPL-3.0-or-later
"""The paper's series: its coefficients, fitted ones, and misuse."""
import copy
import pickle

import numpy as np
import pytest

import rwedge


def test_coefficients_are_those_of_the_formula():
    series = rwedge.Series(0.5, 41)
    assert series.terms == 41
    assert (series.coefficients[::2] == rwedge.coefficient(0.5, np.arange(21))).all()
    assert (series.coefficients[1::2] == 0).all()


def test_fit_recovers_a_pressure():
    x = np.cos(np.linspace(0, np.pi, 202)[1:-1])
    p = -np.sqrt(1 - x**2) * (1.5 + 0.25 * 2 * x)  # U_0 = 1, U_1 = 2 x
    fitted = rwedge.Series.fit(x, p, 3)
    np.testing.assert_allclose(fitted.coefficients, [1.5, 0.25, 0], atol=1e-14)
    assert fitted.residual < 1e-14
    assert repr(fitted).startswith("<rwedge.Series of 3 terms, residual ")


def test_a_copy_is_the_series_itself():
    series = rwedge.Series(0.5, 20)
    assert copy.copy(series) is series
    assert copy.deepcopy({"pressure": [series]})["pressure"][0] is series
    with pytest.raises(TypeError, match="a Series cannot be pickled"):
        pickle.dumps(series)


def test_nan_gives_nan_and_misuse_raises():
    series = rwedge.Series(0.5, 20)
    assert np.isnan(series.pressure([np.nan, 0.1])).tolist() == [True, False]
    assert np.isnan(series.potential(0.3, np.nan, 1.0))
    with pytest.raises(rwedge.Error, match="y = -1.0"):
        series.stress(0.3, 0.0, -1.0)
    with pytest.raises(rwedge.Error, match="x = inf"):
        series.pressure(np.inf)
    with pytest.raises(rwedge.Error, match="terms = 0.*1 <= terms"):
        rwedge.Series(0.5, 0)
    with pytest.raises(rwedge.Error, match="terms = 1099511627776: a size is out of range"):
        rwedge.Series(0.5, 2**40)
    with pytest.raises(TypeError):
        rwedge.Series(0.5, 20.5)
    with pytest.raises(rwedge.Error, match="do not determine"):
        rwedge.Series.fit([0.1, 0.1, 0.1], [1, 1, 1], 2)
    with pytest.raises(rwedge.Error, match="same length"):
        rwedge.Series.fit([0.1, 0.2], [1, 1, 1], 2)
    with pytest.raises(rwedge.Error, match=r"x\[2\] = 1.5, p\[2\] = 1.0: an argument is outside its domain.*\|x\| < 1"):
        rwedge.Series.fit([0.1, 0.2, 1.5], [1, 1, 1], 2)
    with pytest.raises(rwedge.Error, match=r"p\[1\] = nan"):
        rwedge.Series.fit([0.1, 0.2, 0.3], [1, np.nan, 1], 2)
    many = np.linspace(-0.9, 0.9, 2**14)
    with pytest.raises(rwedge.Error, match=r"samples = 16384, terms = 8192: a size is out of range.*terms\^2 <= 2\^33"):
        rwedge.Series.fit(many, many, 2**13)  # it took hours
    for wrong in (["0.1", "0.2"], [0.1j, 0.2], np.array([0.1, 0.2], object)):
        with pytest.raises(TypeError):
            rwedge.Series.fit(wrong, [1, 1], 1)
