# SPDX-License-Identifier: GPL-3.0-or-later
"""What makes results doubtful is said by warnings, in the library's words, to the line that called."""
import math
import warnings

import pytest

import rwedge


def texts_of(call):
    with warnings.catch_warnings(record=True) as caught:
        warnings.simplefilter("always")
        call()
    assert all(w.category is rwedge.ValidityWarning and w.filename == __file__ for w in caught)
    return [str(w.message) for w in caught]


def test_the_function_and_its_texts():
    assert rwedge.validity(0.2, math.nan, 0.1, 0.3, math.nan, 2.0) == 3
    assert rwedge.validity_text(1) == "theta is above 0.1 rad: the wedge is hardly a half-plane"
    assert rwedge.validity_text(3) == ""
    assert rwedge.validity(*[math.nan] * 6) == 0


def test_a_large_angle_and_dissimilar_bodies():
    assert texts_of(lambda: rwedge.Contact(0.1, 1, 1e-5, 0.3, beta=0)) == []
    assert texts_of(lambda: rwedge.Contact(1.15, 1, 1e-5, 0.3)) == [rwedge.validity_text(1)]
    beta = rwedge.dundurs_beta(2.1e5, 0.3, 7e4, 0.33)
    assert texts_of(lambda: rwedge.Contact(0.01, 1, 1e-5, 0.3, beta)) == [rwedge.validity_text(2)]
    assert texts_of(lambda: rwedge.Contact(0.01, 1, 1e-5, 0, beta)) == []


def test_units_that_look_mixed():
    contact = rwedge.Contact(0.01, 1, rwedge.compliance(210, 0.3, 210, 0.3), 0.6)  # GPa beside N/mm
    assert texts_of(lambda: contact.load(500)) == [rwedge.validity_text(8)]
    sharp = rwedge.Contact(0.01, 0, 1e-5, 0.6)
    for loads in ([500], [200, 500]):
        assert texts_of(lambda loads=loads: contact.load(loads)) == [rwedge.validity_text(8)] * len(loads)
    assert texts_of(lambda: sharp.load(500)) == texts_of(lambda: sharp.load(0)) == []


def test_yield():
    contact = rwedge.Contact(0.01, 0.5, 1.8e-5, 0.3)
    contact.load(2000)
    assert texts_of(lambda: contact.yield_factor(0.3, 1e4)) == []
    assert texts_of(lambda: contact.yield_factor(0.3, 10)) == [rwedge.validity_text(4)]


def test_as_an_error_it_leaves_the_contact_as_it_was():
    contact = rwedge.Contact(0.01, 0.5, 1.8e-5, 0.3)
    contact.load(2000)
    with warnings.catch_warnings():
        warnings.simplefilter("error", rwedge.ValidityWarning)
        with pytest.raises(rwedge.ValidityWarning):
            contact.load(1e7)
    assert contact.P == 2000


def test_a_formula_warns_of_each_line_that_called():
    with warnings.catch_warnings(record=True) as caught:
        warnings.simplefilter("default")
        first = rwedge.load(-1)
        second = rwedge.load(-1)
        third = rwedge.load([1, -1])
    assert math.isnan(first + second + third[1])
    lines = {w.lineno for w in caught if w.filename == __file__ and str(w.message) == "invalid value encountered in load"}
    assert len(lines) == len(caught) == 3


DOVETAIL = 0.1, 17.8, 4.81e-5, 0.65


def test_permanent_stick_tells_no_closed_form_from_no_stick_zone():
    with pytest.warns(RuntimeWarning, match="no closed form encountered in permanent_stick: where the edges slip in opposite directions"):
        assert math.isnan(rwedge.permanent_stick(*DOVETAIL, 300, 0, 0, 0, 300, 0, 0, 900)[0])
    assert math.isnan(rwedge.permanent_stick(*DOVETAIL, 300, 0, 195, 0, 300, 0, -195, 0)[0])  # all slides: there is none
    with pytest.warns(RuntimeWarning, match="invalid value encountered in permanent_stick"):
        rwedge.permanent_stick(*DOVETAIL, 300, 0, 400, 0, 300, 0, 0, 0)
