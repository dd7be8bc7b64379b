# SPDX-License-Identifier: GPL-3.0-or-later
"""The paper's series: its coefficients, fitted ones, and misuse."""
import copy
import pickle

import numpy as np
import pytest

import rwedge


def test_what_a_series_has():
    series = rwedge.Series(0.5, 41)
    assert (series.coefficients[::2] == rwedge.coefficient(0.5, np.arange(21))).all()
    assert repr(series).startswith("<rwedge.Series of 41 terms, residual ")


def test_a_copy_is_the_series_itself():
    series = rwedge.Series(0.5, 20)
    assert copy.copy(series) is series
    assert copy.deepcopy({"pressure": [series]})["pressure"][0] is series
    with pytest.raises(TypeError, match="a Series cannot be pickled"):
        pickle.dumps(series)


MANY = np.linspace(-0.9, 0.9, 2**14)


@pytest.mark.parametrize("call, error, message", [
    (lambda: rwedge.Series(0.5, 20).stress(0.3, 0.0, -1.0), rwedge.Error, "y = -1.0"),
    (lambda: rwedge.Series(0.5, 20).pressure(np.inf), rwedge.Error, "x = inf"),
    (lambda: rwedge.Series(0.5, 0), rwedge.Error, "terms = 0.*1 <= terms"),
    (lambda: rwedge.Series(0.5, 2**40), rwedge.Error, "terms = 1099511627776: a size is out of range"),
    (lambda: rwedge.Series(0.5, 20.5), TypeError, None),
    (lambda: rwedge.Series.fit([0.1, 0.1, 0.1], [1, 1, 1], 2), rwedge.Error, "do not determine"),
    (lambda: rwedge.Series.fit([0.1, 0.2], [1, 1, 1], 2), rwedge.Error, "same length"),
    (lambda: rwedge.Series.fit([0.1, 0.2, 1.5], [1, 1, 1], 2), rwedge.Error, r"^x\[2\] = 1.5: an argument is outside.*\|x\| < 1"),
    (lambda: rwedge.Series.fit(MANY, MANY, 2**13), rwedge.Error, r"samples = 16384, terms = 8192: a size.*terms\^2 <= 2\^33"),  # took hours
    (lambda: rwedge.Series.fit(["0.1"], [1], 1), TypeError, None), (lambda: rwedge.Series.fit([0.1j], [1], 1), TypeError, None),
])
def test_misuse_raises(call, error, message):
    with pytest.raises(error, match=message):
        call()
