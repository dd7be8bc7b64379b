# SPDX-License-Identifier: GPL-3.0-or-later
"""Arrays with labels: numbers meet by their labels, and results have them; or it is refused."""
import numpy as np
import pytest

import rwedge

X, Y = np.array([-0.2, 0.1, 0.3]), np.array([0.1, 0.4, 0.7])


def test_xarray_dimensions_make_a_grid(contact):
    xarray = pytest.importorskip("xarray")
    x, y = xarray.DataArray(X, dims="x", coords={"x": X}), xarray.DataArray(Y, dims="y", coords={"y": Y})
    for found, plain in zip(contact.stresses(x, y), contact.stresses(X[:, None], Y)):
        assert found.dims == ("x", "y") and (found.values == plain).all() and (found.x == X).all()
    assert contact.slip(x).dims == ("x",) and contact.tractions(x)[1].dims == ("x",)
    assert rwedge.stresses(0.25, 0.3, 0.2, x, y)[0].shape == (3, 3)
    assert rwedge.Series(0.25, 20).stress(0.3, abs(y), x + 1)[2].dims == ("y", "x")
    with pytest.raises(rwedge.Error, match=r"x\[0, 2\] = .*, y\[0, 2\] = -1.0"):
        contact.stresses(x, xarray.DataArray([0.1, 0.2, -1.0], dims="y"))


def test_pandas_rows_meet_by_their_index(contact):
    pandas = pytest.importorskip("pandas")
    x, y = pandas.Series(X, index=list("abc")), pandas.Series(Y[::-1], index=list("cba"))
    for found, plain in zip(contact.stresses(x, y), contact.stresses(X, Y)):
        assert list(found.index) == list("abc") and (found.values == plain).all()
    assert list(contact.slip(x).index) == list("abc")
    missing = contact.stresses(x, pandas.Series([0.1], index=["b"]))[0]
    assert missing.isna().tolist() == [True, False, True]
    with pytest.raises(rwedge.Error, match=r"y\[1\] = -1.0"):
        contact.stresses(x, pandas.Series([1.0, -1.0, 1.0], index=list("abc")))


def test_samples_of_a_fit_meet_by_their_index():
    pandas = pytest.importorskip("pandas")
    x = np.cos(np.linspace(0, np.pi, 40)[1:-1])
    p = -np.sqrt(1 - x**2)
    samples = pandas.Series(x), pandas.Series(p)
    assert (rwedge.Series.fit(samples[0], samples[1][::-1], 3).coefficients == rwedge.Series.fit(x, p, 3).coefficients).all()


def test_arrays_that_belong_together_as_a_whole_refuse_labels(contact):
    """What pairs them by place says so, and what to give it."""
    pandas, xarray = pytest.importorskip("pandas"), pytest.importorskip("xarray")
    for labelled in (pandas.Series([2000.0]), xarray.DataArray([2000.0], dims="load"), pandas.DataFrame({"P": [2000.0]})):
        with pytest.raises(TypeError, match=r"P has labels, which would be lost: give .* P.to_numpy\(\)"):
            contact.stress_history(labelled, [0], [0], [0], [0.1], [0.2])


def test_what_has_no_labels_is_paired_by_place(contact):
    plain = contact.stresses(X, Y)[0]
    for kind in (list, tuple, np.ma.array):
        assert (contact.stresses(kind(X), kind(Y))[0] == plain).all()
