# SPDX-License-Identifier: GPL-3.0-or-later
"""Contacts of other pads than the wedge: cylinder, flat pad with rounded edges, profile. What is right of them is proven in C."""
import pickle

import pytest

import rwedge

R, A, F = 10.0, 1e-4, 0.5
WORN = [-1, -0.4, 0.1, 0.5, 0.8], [-0.1, -0.02, -0.02, 0.05, 0.12]


@pytest.mark.parametrize("contact, shown", [
    (rwedge.Contact.flat(0.5, R, A, F), "<rwedge.Contact.flat a=0.5, R=10.0, A=0.0001, f=0.5, at P=0.0, Q=0.0>"),
    (rwedge.Contact.cylinder(R, A, F), "<rwedge.Contact.cylinder R=10.0, A=0.0001, f=0.5, at P=0.0, Q=0.0>"),
    (rwedge.Contact.profile(*WORN, A, F), "<rwedge.Contact.profile theta=0.11, a=0.4714285714285716, A=0.0001, f=0.5, at P=0.0, Q=0.0>"),
])
def test_a_pad_says_what_it_is(contact, shown):
    """A flat pad once said that its angle was 1 and its rounding R."""
    assert repr(contact) == repr(contact.copy()) == repr(pickle.loads(pickle.dumps(contact))) == shown


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
