# SPDX-License-Identifier: GPL-3.0-or-later
"""Contacts of other pads than the wedge: cylinder, flat pad with rounded edges, profile. What is right of them is proven in C."""
import pickle

import numpy as np
import pytest

import rwedge

R, A, F = 10.0, 1e-4, 0.5
WORN = [-1, -0.4, 0.1, 0.5, 0.8], [-0.1, -0.02, -0.02, 0.05, 0.12]


@pytest.mark.parametrize("contact, shown", [
    (rwedge.Contact.flat(0.5, R, A, F), "<rwedge.Contact.flat a=0.5, R=10.0, A=0.0001, f=0.5, at P=0.0, Q=0.0>"),
    (rwedge.Contact.cylinder(R, A, F), "<rwedge.Contact.cylinder R=10.0, A=0.0001, f=0.5, at P=0.0, Q=0.0>"),
    (rwedge.Contact.profile(*WORN, A, F), "<rwedge.Contact.profile A=0.0001, f=0.5, at P=0.0, Q=0.0>"),
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


@pytest.mark.parametrize("contact, kind, numbers", [
    (rwedge.Contact(0.1, 0.5, A, F), rwedge.Pad.WEDGE, (0.1, 0.5, 0, A, F)),
    (rwedge.Contact.cylinder(R, A, F), rwedge.Pad.CYLINDER, (0, 0, R, A, F)),
    (rwedge.Contact.flat(0.5, R, A, F), rwedge.Pad.FLAT, (0, 0.5, R, A, F)),
    (rwedge.Contact.profile(*WORN, A, F), rwedge.Pad.PROFILE, (0, 0, 0, A, F)),
])
def test_a_contact_tells_its_pad(contact, kind, numbers):
    for one in contact, contact.copy(), pickle.loads(pickle.dumps(contact)):
        assert one.kind == kind and one.pad == numbers
        assert (one.theta, one.a, one.R, one.A, one.f) == numbers
        assert one.tolerance == 1e-4 and one.strain == pytest.approx(A / 4, rel=1e-15)
    like = rwedge.Contact.profile(*contact.places, A, F)
    for one in contact, like:
        one.load(100)
    assert like.edges == pytest.approx(contact.edges, rel=1e-12)


# A wedge of theta = 0.05, a = 0.3 under P = 1e-6, as version 1.1.0 wrote it.
OF_1_1_0 = [
    1.0, 3980492017642981.0, 0.05, 0.3, 2e-05, 0.5, 1e-06, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
    1.0, 2.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, -np.inf, np.inf, 1e-06, 0.0, 0.0, -0.0, 0.0,
    -8.740387444736632e-06, 8.740387444736632e-06, -np.inf, np.inf, 0.0, 0.0,
]


def test_a_state_of_1_1_0_is_still_a_wedge_that_warns():
    """It was called a profile, and lost its warnings: the numbers have other places in it."""
    contact = rwedge.Contact.restore(np.array(OF_1_1_0))
    assert repr(contact) == "<rwedge.Contact theta=0.05, a=0.3, A=2e-05, f=0.5, at P=1e-06, Q=0.0>"
    with pytest.warns(rwedge.ValidityWarning, match="a/b"):
        contact.load(1e-6, 1e-7)
