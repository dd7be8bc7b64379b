# SPDX-License-Identifier: GPL-3.0-or-later
"""Contacts of other pads than the wedge: cylinder, flat pad with rounded edges, profile."""
import math
import pickle

import numpy as np
import pytest

import rwedge

R, A, F = 10.0, 1e-4, 0.5
WORN = [-1, -0.4, 0.1, 0.5, 0.8], [-0.1, -0.02, -0.02, 0.05, 0.12]


def test_the_same_pad_made_in_two_ways():
    """What is right of them is proven in C."""
    slopes = [-10.5, -0.5, 0.5, 10.5], [-1, 0, 0, 1]
    for pair in ((rwedge.Contact.flat(0, R, A, F), rwedge.Contact.cylinder(R, A, F)),
                 (rwedge.Contact.flat(0.5, R, A, F), rwedge.Contact.profile(*slopes, A, F))):
        for contact in pair:
            contact.apply(300, 10, 0, 0)
            contact.apply(300, 10, 40, 20)
        this, other = (contact.stresses(np.linspace(-1, 1, 9), 0.1) for contact in pair)
        np.testing.assert_allclose(this, other, rtol=0, atol=1e-11 * 300)


@pytest.mark.parametrize("contact, shown", [
    (rwedge.Contact.flat(0.5, R, A, F), "<rwedge.Contact.flat a=0.5, R=10.0, A=0.0001, f=0.5, at P=0.0, Q=0.0>"),
    (rwedge.Contact.cylinder(R, A, F), "<rwedge.Contact.cylinder R=10.0, A=0.0001, f=0.5, at P=0.0, Q=0.0>"),
    (rwedge.Contact.profile(*WORN, A, F), "<rwedge.Contact.profile theta=0.11, a=0.4714285714285716, A=0.0001, f=0.5, at P=0.0, Q=0.0>"),
])
def test_a_pad_says_what_it_is(contact, shown):
    """A flat pad once said that its angle was 1 and its rounding R."""
    assert repr(contact) == repr(contact.copy()) == repr(pickle.loads(pickle.dumps(contact))) == shown


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
