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


def pad(a=1, A=1e-5, f=0.6, P=(), **more):
    contact = rwedge.Contact(0.01, a, A, f, **more)
    contact.load(P or 0)
    return contact


BETA, MIXED = rwedge.dundurs_beta(2.1e5, 0.3, 7e4, 0.33), rwedge.compliance(210, 0.3, 210, 0.3)  # GPa beside N/mm


@pytest.mark.parametrize("call, doubts", [
    (lambda: rwedge.Contact(0.1, 1, 1e-5, 0.3, beta=0), []), (lambda: rwedge.Contact(1.15, 1, 1e-5, 0.3), [1]),
    (lambda: pad(beta=BETA), [2]), (lambda: pad(f=0, beta=BETA), []),
    (lambda: pad(A=MIXED, P=500), [8]), (lambda: pad(A=MIXED, P=[200, 500]), [8, 8]), (lambda: pad(0, P=500), []),
    (lambda: pad(0.5, 1.8e-5, P=2000).yield_factor(0.3, 1e4), []), (lambda: pad(0.5, 1.8e-5, P=2000).yield_factor(0.3, 10), [4]),
])
def test_what_is_doubtful(call, doubts):
    assert texts_of(call) == list(map(rwedge.validity_text, doubts))


def test_the_numbers_of_the_header_have_names():
    """The help once told of RWEDGE_MEASURE_..., which only C has."""
    assert rwedge.validity_text(rwedge.Doubt.YIELD) == rwedge.validity_text(4) and rwedge.Measure.SWT == 1
    assert "Measure.STRESS_RANGE and so on" in rwedge.Cycle.worst.__doc__


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


def test_permanent_stick_tells_no_closed_form_from_no_stick_zone():
    dovetail = rwedge.Contact(0.1, 17.8, 4.81e-5, 0.65)
    with pytest.raises(rwedge.PathError, match="where the edges slip in opposite directions"):
        dovetail.permanent_stick(300, 0, 0, 0, 300, 0, 0, 900)
    with pytest.raises(rwedge.AbsentError):  # all slides
        dovetail.permanent_stick(300, 0, 195, 0, 300, 0, -195, 0)
    with pytest.raises(rwedge.SlidingError):
        dovetail.permanent_stick(300, 0, 400, 0, 300, 0, 0, 0)
