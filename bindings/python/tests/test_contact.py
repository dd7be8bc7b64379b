# SPDX-License-Identifier: GPL-3.0-or-later
"""Contacts with a load history: values, copies, errors, threads."""
import copy
import gc
import inspect
import pickle
import threading

import numpy as np
import pytest

import rwedge


def test_results_have_the_shape_of_the_points(contact):
    x, y = np.linspace(-1, 1, 5)[:, None], np.linspace(0.1, 1, 7)
    assert [s.shape for s in contact.stresses(x, y)] == [(5, 7)] * 3
    assert [t.shape for t in contact.tractions(x)] == [(5, 1)] * 2
    assert contact.slip([]).shape == (0,)
    assert isinstance(contact.slip(0.1), float)
    for i, j in np.ndindex(5, 7):
        assert tuple(s[i, j] for s in contact.stresses(x, y)) == contact.stresses(x[i, 0], y[j])


def test_nan_gives_nan(contact):
    for values in (*contact.tractions([0.1, np.nan]), *contact.stresses([0.1, np.nan], 0.2), contact.slip([0.1, np.nan])):
        assert np.isfinite(values[0]) and np.isnan(values[1])


@pytest.mark.parametrize("twin_of", [copy.copy, copy.deepcopy, rwedge.Contact.copy])
def test_a_copy_is_independent(contact, twin_of):
    twin = twin_of(contact)
    x = np.linspace(-1, 1, 9)
    assert (np.array(twin.tractions(x)) == contact.tractions(x)).all()
    assert repr(twin) == repr(contact)
    twin.load(2000, 700)
    assert contact.Q == -600 and twin.Q == 700
    assert (twin.slip(x) != contact.slip(x)).any()
    del contact
    gc.collect()
    assert twin.half_width > 0


def test_repr_tells_parameters_and_loads(contact):
    assert repr(contact) == "<rwedge.Contact theta=0.01, a=0.5, A=1.8e-05, f=0.6, at P=2000.0, Q=-600.0>"


@pytest.mark.parametrize("call, error, message", [
    (lambda c: c.load(2000, 1300), rwedge.SlidingError, "P = 2000.0, Q = 1300.0: the tangential force exceeds"),
    (lambda c: c.load(-1), rwedge.Error, "P = -1.0.*P: 0, or 1e-60 to 1e60"),
    (lambda c: c.stresses(np.inf, 1.0), rwedge.Error, "^x = inf: an argument is outside its domain"),
    (lambda c: c.slip([0.1, 30.0]), rwedge.Error, r"x\[1\] = 30.0: .*\|x\| <= b"),
    (lambda c: c.stresses([1, 2], [1, 2, 3]), ValueError, "broadcast"),
    (lambda c: c.yield_factor(0.7, 300), rwedge.Error, "nu = 0.7.*0 <= nu <= 0.5"),
    (lambda c: c.set_beta(0.1), rwedge.Error, r"^beta = 0.1: .*\|beta\| <= 1/2.*; refused where the bodies touch\)$"),
    (lambda c: c.set_beta(0.7), rwedge.Error, r"^beta = 0.7: .*\|beta\| <= 1/2, [^;]*$"),
    (lambda c: c.set_strain(1e-5), rwedge.Error, "strain_per_tension = 1e-05: .*refused where the bodies touch"),
    (lambda c: c.set_bodies(2e5, 0.3, 2e5, 0.3), rwedge.Error, "refused where the bodies touch, where their compliance"),
    *((lambda c, wrong=wrong: c.load(wrong), TypeError, "P: ") for wrong in ("2000", None, 1j)),
    (lambda c: c.tractions("here"), TypeError, None),
    (lambda c: rwedge.Contact(2, 1, 1e-5, 0.3), rwedge.Error, "theta = 2.0.*0 < theta < pi/2"),
    (lambda c: rwedge.Contact("0.01", 1, 1e-5, 0.3), TypeError, "theta: must be real number, not str"),
    (lambda c: rwedge.Contact(0.01, 1, 1e-5, 0.3).yield_factor(0.3, 300), rwedge.AbsentError, "unloaded"),
    *((lambda c, wrong=wrong: rwedge.Contact(0.1, 0.4, 0.5, 0.5, tolerance=wrong), rwedge.Error, "tolerance = .*1e-6 to 1e-2")
      for wrong in (-1, 1e-7, np.nan)),
    *((lambda c, wrong=wrong: rwedge.Contact.restore(wrong(c.state())), rwedge.Error, "state, of .* numbers: they are not those that")
      for wrong in (lambda state: state[:-1], lambda state: [], lambda state: state + 1)),
    (lambda c: rwedge.Contact.restore("abc"), TypeError, None),
])
def test_errors_say_why_and_leave_the_contact_as_it_was(contact, call, error, message):
    before = contact.state()
    with pytest.raises(error, match=message) as caught:
        call(contact)
    assert isinstance(caught.value, (ValueError, TypeError)) and (contact.state() == before).all()


def test_one_contact_in_many_threads(contact):
    """Loads and readings of one contact wait for each other: no reading sees half a load."""
    x = np.linspace(-1, 1, 2000)
    sums = {Q: contact.copy() for Q in (-600.0, 600.0)}
    sums[600.0].load(2000, 600)
    contact.load(2000, 600)
    contact.load(2000, -600)
    sums[-600.0].load(2000, 600)
    sums[-600.0].load(2000, -600)
    allowed = {contact_at.tractions(x)[1].tobytes() for contact_at in sums.values()}
    seen, errors = set(), []

    def read():
        try:
            for _ in range(50):
                seen.add(contact.tractions(x)[1].tobytes())
        except Exception as error:
            errors.append(error)

    readers = [threading.Thread(target=read) for _ in range(3)]
    for reader in readers:
        reader.start()
    while any(reader.is_alive() for reader in readers):
        contact.load(2000, 600)
        contact.load(2000, -600)
    assert not errors and seen <= allowed


def test_a_path_without_closed_form_is_refused_and_explained():
    contact = rwedge.Contact(0.1, 0.4, 0.5, 0.5, tolerance=0)
    contact.apply(0.5, 0.1, 0, 0)
    with pytest.raises(rwedge.PathError, match=r"no closed form: .*; or have it computed: Contact\(..., tolerance=1e-4\)$"):
        contact.apply(0.5, 0.1, 0, 1)
    assert "opposite directions" in contact.obstacle(0.5, 0.1, 0, 1)
    assert contact.obstacle(0.5, 0.1, 0.1, 0) == ""


def test_a_path_without_closed_form_is_computed_unless_that_is_refused():
    loads = [(0.5, 0.1, 0, 0), (0.5, 0.1, 0, 1), (0.52, 0.1, 0.1, 0.5)]
    coarse, fine = (rwedge.Contact(0.1, 0.4, 0.5, 0.5, **options) for options in ({}, {"tolerance": 1e-6}))
    x = np.linspace(-0.4, 0.4, 41)
    for contact in (coarse, fine):
        contact.apply(*loads[0])
        assert contact.error == 0
        contact.apply(*loads[1])
        assert contact.error > 0
    cycle = coarse.stresses_after(loads[2:], x, 0.1)
    fine.apply(*loads[2])
    p, q = fine.tractions(x)
    np.testing.assert_allclose(coarse.tractions(x)[1], q, rtol=0, atol=1e-4 * 0.5 * -p.min())
    np.testing.assert_allclose(cycle.stress[0], np.stack(fine.stresses(x, 0.1), -1), rtol=0, atol=4e-4 * 0.5 * -p.min())
    assert copy.copy(coarse).error == pickle.loads(pickle.dumps(coarse)).error == coarse.error


def test_what_a_history_of_stresses_refuses_is_named(contact):
    good = {"P": [2000, 2000], "M": [0, 0], "Q": [-600, 300], "sigma": [0, 0], "x": [0.1], "y": [0.2]}
    contact.allow_error(0)
    before = contact.state()
    for change, words in (({"Q": [-600, 3000]}, r"P\[1\] = 2000.0, .*Q\[1\] = 3000.0.*friction"),
                          ({"P": [2000, np.nan]}, r"P\[1\] = nan"), ({"sigma": [0, 1e5]}, r"sigma\[1\] = 100000.0.*: no closed form: "),
                          ({"y": [-0.2]}, r"^y\[0\] = -0.2: "), ({"x": [np.nan]}, r"x\[0\] = nan: it must be a number"),
                          ({"M": [0]}, r"M has the shape \(1,\), where others have 2")):
        with pytest.raises(rwedge.Error, match=words):
            contact.stress_history(**{**good, **change})
        assert (contact.state() == before).all()


def test_what_an_unloaded_contact_has_not_is_absent_as_an_attribute():
    contact = rwedge.Contact(0.01, 0.5, 1.8e-5, 0.6)
    assert not hasattr(contact, "edges") and getattr(contact, "stick_zone", None) is None
    assert "half_width" in dict(inspect.getmembers(contact))
    with pytest.raises(rwedge.AbsentError, match=r"does not exist for these arguments \(when separated\)"):
        contact.edges
