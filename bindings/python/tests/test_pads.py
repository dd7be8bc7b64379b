# SPDX-License-Identifier: GPL-3.0-or-later
"""Contacts of other pads than the wedge: cylinder, flat pad with rounded edges, profile."""
import math
import pickle

import numpy as np
import pytest

import rwedge

R, A, F = 10.0, 1e-4, 0.5
WORN = [-1, -0.4, 0.1, 0.5, 0.8], [-0.1, -0.02, -0.02, 0.05, 0.12]


def flat_load(a, b):
    """Ciavarella, Hills and Monno (1998)."""
    return b * b / (A * R) * (math.acos(a / b) - a / b * math.sqrt(1 - (a / b) ** 2))


@pytest.mark.parametrize("a_over_b, tension", [(0.5, 1.6282), (0.9, 3.4057), (0.99, 10.6226)])
def test_a_flat_pad_has_its_edge_tension(a_over_b, tension):
    contact, P = rwedge.Contact.flat(a_over_b, R, A, F), flat_load(a_over_b, 1)
    contact.load(P, F * P)
    assert contact.edges == pytest.approx((-1, 1), rel=1e-12)
    assert contact.stresses(contact.edges[0], 0)[0] / (F * P) == pytest.approx(tension, rel=2e-5)
    assert contact.beyond_flat == pytest.approx((1 - a_over_b, 1 - a_over_b), rel=1e-10)


def test_a_flat_pad_of_no_width_is_a_cylinder():
    one, other = rwedge.Contact.flat(0, R, A, F), rwedge.Contact.cylinder(R, A, F)
    for contact in (one, other):
        contact.load(300, 20)
    assert one.stresses([0, 0.1], 0.2)[0].tolist() == other.stresses([0, 0.1], 0.2)[0].tolist()


def test_a_profile_of_the_slopes_of_a_flat_pad_is_that_pad():
    flat = rwedge.Contact.flat(0.5, R, A, F)
    profile = rwedge.Contact.profile([-10.5, -0.5, 0.5, 10.5], [-1, 0, 0, 1], A, F)
    for contact in (flat, profile):
        contact.apply(300, 10, 0, 0)
        contact.apply(300, 10, 40, 20)
    assert profile.edges == pytest.approx(flat.edges, rel=1e-13)
    assert profile.stick_zone == pytest.approx(flat.stick_zone, rel=1e-11)
    for one, other in zip(profile.stresses(np.linspace(-1, 1, 9), 0.1), flat.stresses(np.linspace(-1, 1, 9), 0.1)):
        np.testing.assert_allclose(one, other, rtol=0, atol=1e-11 * 300)
    assert profile.yield_factor(0.3, 300).factor == pytest.approx(flat.yield_factor(0.3, 300).factor, rel=1e-11)


def test_a_pad_is_kept_by_copies_and_states():
    worn = rwedge.Contact.profile(*WORN, A, F)
    worn.load(300)
    worn.load(300, 40)
    for other in (worn.copy(), pickle.loads(pickle.dumps(worn)), rwedge.Contact.restore(worn.state())):
        other.load(300, -20)
        again = worn.copy()
        again.load(300, -20)
        assert other.stresses(0.1, 0.2) == again.stresses(0.1, 0.2)


@pytest.mark.parametrize("x, slope, said", [
    ([0, 1, 0.5], [-1, 0, 1], r"x\[2\] = 0\.5, slope\[2\] = 1\.0: a place or a slope is less than the one before"),
    ([0, 1, 2], [-1, 0.5, 0], r"x\[2\] = 2\.0, slope\[2\] = 0\.0: a place or a slope is less than the one before"),
    ([0, 1], [-1, 0, 1], "x has 2 places, and slope 3"),
    ([0, 1], [0.1, 0.1], "2 to 1000 places, not all of one slope"),
    ([0], [0.1], "2 to 1000 places, not all of one slope"),
    ([], [], "2 to 1000 places, not all of one slope"),
])
def test_what_is_no_profile_is_refused_with_the_place(x, slope, said):
    with pytest.raises(rwedge.Error, match=said):
        rwedge.Contact.profile(x, slope, A, F)


@pytest.mark.parametrize("a, R, named", [(-1, 1, "a = -1"), (1, 0, "R = 0"), (1, math.nan, "R = nan")])
def test_what_is_no_flat_pad_is_refused(a, R, named):
    with pytest.raises(rwedge.Error, match=named):
        rwedge.Contact.flat(a, R, A, F)


@pytest.mark.parametrize("made", [rwedge.Contact.cylinder, lambda *given, **more: rwedge.Contact.flat(1.0, *given, **more)])
def test_loads_without_a_closed_form_are_computed_unless_the_tolerance_is_0(made):
    usual, strict = made(50.0, A, F), made(50.0, A, F, tolerance=0)
    for contact in usual, strict:
        contact.load(P=100)
    usual.apply(P=100, M=0, Q=3, sigma=40)
    assert 0 < usual.error < 1e-3
    with pytest.raises(rwedge.PathError, match="or have it computed"):
        strict.apply(P=100, M=0, Q=3, sigma=40)
