# SPDX-License-Identifier: GPL-3.0-or-later
"""Arrays with labels: numbers meet by their labels, and results have them; or it is refused."""
import numpy as np
import pytest

import rwedge

X, Y = np.array([-0.2, 0.1, 0.3]), np.array([0.1, 0.4, 0.7])


@pytest.mark.long
def test_xarray_dimensions_make_a_grid(contact):
    xarray = pytest.importorskip("xarray")
    x, y = xarray.DataArray(X, dims="x", coords={"x": X}), xarray.DataArray(Y, dims="y", coords={"y": Y})
    for labelled, plain in zip(contact.stresses(x, y), contact.stresses(X[:, None], Y)):
        assert labelled.dims == ("x", "y") and (labelled.values == plain).all() and (labelled.x == X).all()
    assert contact.slip(x).dims == ("x",) and contact.tractions(x)[1].dims == ("x",)
    assert rwedge.Series(0.25, 20).stress(0.3, abs(y), x + 1)[2].dims == ("y", "x")
    with pytest.raises(rwedge.Error, match=r"^y\[0, 2\] = -1.0"):
        contact.stresses(x, xarray.DataArray([0.1, 0.2, -1.0], dims="y"))


@pytest.mark.long
def test_pandas_rows_meet_by_their_index(contact):
    pandas = pytest.importorskip("pandas")
    x, y = pandas.Series(X, index=list("abc")), pandas.Series(Y[::-1], index=list("cba"))
    for labelled, plain in zip(contact.stresses(x, y), contact.stresses(X, Y)):
        assert list(labelled.index) == list("abc") and (labelled.values == plain).all()
    assert list(contact.slip(x).index) == list("abc")
    missing = contact.stresses(x, pandas.Series([0.1], index=["b"]))[0]
    assert missing.isna().tolist() == [True, False, True]
    with pytest.raises(rwedge.Error, match=r"y\[1\] = -1.0"):
        contact.stresses(x, pandas.Series([1.0, -1.0, 1.0], index=list("abc")))


@pytest.mark.long
def test_loads_of_different_indexes_are_refused(contact):
    """They follow one another by place: P[2] and Q of the label 2 may be different loads."""
    pandas, xarray = pytest.importorskip("pandas"), pytest.importorskip("xarray")
    P, Q = [2000.0, 2100.0, 2200.0], [100.0, 200.0, 300.0]
    alike = {"P": pandas.Series(P, index=[3, 4, 5]), "Q": pandas.Series(Q, index=[3, 4, 5])}
    assert (contact.copy().stresses_after(alike, 0.1, 0.2).stress == contact.copy().stresses_after({"P": P, "Q": Q}, 0.1, 0.2).stress).all()
    for other in (pandas.Series(Q[::-1], index=[5, 4, 3]), xarray.DataArray(Q, dims="load")):
        with pytest.raises(rwedge.Error, match=r"P and Q have different indexes: .* Q.to_numpy\(\)"):
            contact.stresses_after({**alike, "Q": other}, 0.1, 0.2)
        with pytest.raises(rwedge.Error, match="P and Q have different indexes"):
            contact.load(alike["P"], other)
    with pytest.raises(rwedge.Error, match="different indexes"):
        contact.load(xarray.DataArray(P, dims="load", coords={"load": [1, 2, 3]}), xarray.DataArray(Q, dims="load", coords={"load": [2, 3, 4]}))


@pytest.mark.long
def test_arrays_that_belong_together_as_a_whole_refuse_labels(contact):
    """What pairs them by place says so, and what to give it."""
    pandas, xarray = pytest.importorskip("pandas"), pytest.importorskip("xarray")
    for labelled in (pandas.Series([2000.0]), xarray.DataArray([2000.0], dims="load"), pandas.DataFrame({"P": [2000.0]})):
        with pytest.raises(TypeError, match=r"P has labels, which would be lost: give .* P.to_numpy\(\)"):
            contact.stress_history(labelled, [0], [0], [0], [0.1], [0.2])


@pytest.mark.long
def test_series_of_pyarrow_are_taken_and_given_back(contact):
    pandas = pytest.importorskip("pandas")
    pytest.importorskip("pyarrow")
    x = pandas.Series([0.1, None, 0.3], index=list("abc"), dtype="float64[pyarrow]")
    labelled = contact.tractions(x)[0]
    assert list(labelled.index) == list("abc") and labelled["c"] == contact.tractions(0.3)[0] and labelled.isna().tolist() == [False, True, False]


def test_masked_elements_are_not_looked_at_and_stay_masked(contact):
    x = np.ma.array([0.1, 100.0, -0.2], mask=[0, 1, 0])
    slip = contact.slip(x)
    assert slip.mask.tolist() == [False, True, False] and slip[2] == contact.slip(-0.2)
    assert [part.mask.tolist() for part in contact.stresses(x, 0.1)] == [[False, True, False]] * 3
    with pytest.raises(rwedge.Error, match=r"x\[2\] = 30.0"):
        contact.slip(np.ma.array([0.1, 100.0, 30.0], mask=[0, 1, 0]))


class Quantity:
    """A number with a unit, as pint has it: NumPy takes it without."""

    units = property(lambda self: "metre")

    def __array__(self, dtype=None, copy=None):
        return np.array(0.001)


@pytest.mark.parametrize("call", [lambda c, q: c.tractions(q), lambda c, q: c.stresses_after({"Q": 100}, q, 0), lambda c, q: c.stresses_after({"Q": q}, 0, 0),
                                  lambda c, q: rwedge.Series(0.25, 4).pressure(q), lambda c, q: c.stress_history(q, [0], [0], [0], [0], [0])])
def test_quantities_with_a_unit_are_refused(contact, call):
    with pytest.raises(TypeError, match="has a unit, which would be lost"):
        call(contact, Quantity())
