# SPDX-License-Identifier: GPL-3.0-or-later
"""Stresses through many loads in one call, the forms that other packages take, and the parameters of a cycle."""
import pickle
import sys

import numpy as np
import pytest

import rwedge
import rwedge.plot

X, Y = np.linspace(-3, 3, 7)[:, None], np.array([0.0, 0.4])
Q = np.array([300, -300, -1000, 700.0])
NU, E = 0.3, 200e3


@pytest.fixture
def pad():
    loaded = rwedge.Contact(0.01, 0.5, 1.8e-5, 0.6)
    loaded.load(2000)
    return loaded


def test_a_cycle_has_the_bits_of_loads_one_by_one(pad):
    single = pad.copy()
    cycle = pad.stresses_after({"P": 2000, "Q": Q}, X, Y)
    assert cycle.stress.shape == (4, 7, 2, 3)
    for tensor, q in zip(cycle.stress, Q):
        single.load(2000, q)
        assert (tensor == np.stack(single.stresses(X, Y), axis=-1)).all()
    assert (pad.state() == single.state()).all()
    assert (np.asarray(cycle) == cycle.stress).all() and (np.stack(list(cycle), -1) == cycle.stress).all()


def test_loads_are_named_or_by_place(pad):
    expected = pad.copy().stresses_after({"P": 2000, "Q": Q}, X, Y).stress
    rows = np.column_stack([np.full(4, 2000), Q])
    four = [rwedge.Loads(2000, 0, q, 0) for q in Q]
    for loads in ({"Q": Q}, rows, rows.tolist(), four):
        assert (pad.copy().stresses_after(loads, X, Y).stress == expected).all()
    moment = rwedge.Contact(0.01, 0.5, 1.8e-5, 0.6)
    moment.apply(2000, 300, 0, 0)
    assert (moment.stresses_after({"P": [2000, 0, 2000]}, X, 0.1).loads.M == [300, 0, 0]).all()


def test_vectors_of_loads_are_loads_one_after_the_other(pad):
    single, many = pad.copy(), pad.copy()
    for q in Q:
        single.load(2000, q)
        single.apply(2000, 0, 0.9 * q, 0)
    many.load(2000, np.column_stack([Q, 0.9 * Q]).ravel())
    assert (single.state() == many.state()).all() and single.dissipated_energy == many.dissipated_energy
    before = pad.state()
    with pytest.raises(rwedge.SlidingError, match=r"P\[1\] = 2000.0, .* Q\[1\] = 1300.0"):
        pad.load(2000, [1, 1300])
    assert (pad.state() == before).all()
    pad.apply(2000, 0, [500, 600], [10, 20])
    assert pad.loads == (2000, 0, 600, 20)


@pytest.mark.parametrize("loads, x, y, message", [
    ({"Q": [100, 1300]}, 0, 1, r"Q\[1\] = 1300.0, sigma\[1\] = 0.0: the tangential force exceeds"),
    ({"Q": [100, 200]}, [0, 1], [1, -1], r"^y\[1\] = -1.0: an argument is outside"),
    ({"Q": [100, 100], "sigma": [0, 500]}, 0, 1, r"P\[1\] = 2000.0.*sigma\[1\] = 500.0: no closed form: the two edges would"),
    *(({"P": [2000], name: [100]}, 0, 1, "the names of loads are P, M, Q and sigma, without a unit")
      for name in ("q", " Q", "Q ", "Q [N/mm]", "Q / N", "Q/N", "Q in N", "Q_N", "Q(kN)", "Q\u00a0[N/mm]", "Q\u200b", "\uff31",
                   "Sigma", "sigma MPa", "M_Nmm")),
    ({"P": [1, 2], "Q": [1, 2, 3]}, 0, 1, r"differ in number: P \(2,\), Q \(3,\)"),
    ({"Q": [1, np.nan]}, 0, 1, r"Q\[1\] is not a number"),
    ([[1, 2, 3]], 0, 1, r"loads has the shape \(1, 3\): a row for each load"),
])
def test_bad_input_says_where(pad, loads, x, y, message):
    pad.allow_error(0)
    before = pad.state()
    with pytest.raises(rwedge.Error, match=message):
        pad.stresses_after(loads, x, y)
    assert (pad.state() == before).all()


@pytest.mark.parametrize("column, kind", [(["1,5", "2"], "list"), (np.array(["1,5", "2"], dtype=object), "object"), ("2", "str")])
def test_a_column_of_texts_is_named(pad, column, kind):
    with pytest.raises(TypeError, match=f"^Q must be numbers, not {kind}$"):
        pad.stresses_after({"P": 2000, "Q": column}, 0, 1)


@pytest.mark.parametrize("loads, message", [
    ((-1, 0, 0, 0), "^P = -1.0: .* (P: 0, or 1e-60 to 1e60, not below 1e-8 of the last P)$"),
    ((0, 5, 0, 0), "P = 0.0, M = 5.0, .*M: .*, 0 where P is 0; "),
])
def test_a_refused_load_is_named_with_what_is_allowed_and_no_more(pad, loads, message):
    with pytest.raises(rwedge.Error, match=message.replace("(", r"\(").replace(")", r"\)")) as caught:
        pad.apply(*loads)
    assert len(str(caught.value)) < 400


def test_nan_among_the_points_gives_nan(pad):
    x = np.array([0.1, np.nan, 0.3])
    stress = pad.copy().stresses_after({"Q": Q}, x, 0.5).stress
    assert np.isnan(stress[:, 1]).all()
    assert (stress[:, [0, 2]] == pad.stresses_after({"Q": Q}, x[[0, 2]], 0.5).stress).all()


@pytest.mark.parametrize("name", ["sigma_B", "sig", "tau", "T", "time force"])
def test_a_column_of_numbers_that_is_no_load_is_named(pad, name):
    """A tension was left out without a word where its column was called sigma_B."""
    with pytest.warns(UserWarning, match=f"columns with numbers that are not used: '{name}'"):
        pad.copy().stresses_after({"Q": Q, name: Q}, 0.1, 0.5)


@pytest.mark.parametrize("name", ["time", "Time [s]", "time_s", "t", "Zeit", "N_f", "Load", "No.", "case"])
def test_a_label_of_rows_is_no_forgotten_load(pad, name):  # pytest makes errors of warnings
    pad.copy().stresses_after({"Q": Q, name: Q, "note": ["a", "b", "c", "d"]}, 0.1, 0.5)


@pytest.mark.long
def test_forms_of_other_packages(pad):
    pandas, xarray = pytest.importorskip("pandas"), pytest.importorskip("xarray")
    cycle = pad.copy().stresses_after({"Q": Q}, X, Y)
    frame = pandas.DataFrame({"time": [1, 2, 3, 4], "P": 2000, "Q": Q})
    assert (pad.copy().stresses_after(frame, X, Y).stress == cycle.stress).all()
    szz = NU * (cycle.sxx + cycle.syy)
    zero = np.zeros_like(szz)
    np.testing.assert_allclose(cycle.voigt(NU), np.stack([cycle.sxx, cycle.syy, szz, zero, zero, cycle.txy], -1), rtol=1e-15)
    frame = cycle.to_pandas(NU)
    assert list(frame) == ["S11", "S22", "S33", "S12", "S13", "S23"] and frame.index.names == ["load", "point"]
    assert (frame.loc[(2, 5), ["S11", "S22", "S12"]] == cycle.stress[2, 2, 1]).all()
    assert frame["S33"].iloc[0] == cycle.szz(NU)[0, 0, 0]
    data = cycle.to_xarray(NU, length="m", stress="Pa")
    assert data.sxx.dims == ("load", "point_0", "point_1") and (data.szz.values == cycle.szz(NU)).all()
    assert data.txy.units == "Pa" and data.P.units == "Pa m" and data.x.units == "m" and data.M.units == "Pa m m"
    assert (data.Q == Q).all() and data.syy.long_name == "stress normal to the surface"
    x, y = xarray.DataArray(X[:, 0], dims="x", coords={"x": X[:, 0]}), xarray.DataArray(Y, dims="y", coords={"y": Y})
    named = pad.copy().stresses_after({"Q": Q}, x, y).to_xarray()
    assert named.sxx.dims == ("load", "x", "y") and named.sxx.sel(x=-1, y=0.4, load=1) == cycle.sxx[1, 2, 1]
    assert named.x.units == "mm" and "szz" not in named
    series = pandas.Series([0.1, 0.2], index=["a", "b"])
    assert list(pad.stresses_after({"Q": Q}, series, 0.5).to_pandas(NU).index[:3]) == [(0, "a"), (0, "b"), (1, "a")]


@pytest.mark.parametrize("package, call", [("pandas", lambda pad: pad.stresses_after({"P": [2000]}, 0, 1).to_pandas(0.3)),
                                           ("xarray", lambda pad: pad.stresses_after({"P": [2000]}, 0, 1).to_xarray()),
                                           ("matplotlib", rwedge.plot.tractions)])
def test_a_missing_package_is_named_with_its_command(pad, monkeypatch, package, call):
    monkeypatch.setitem(sys.modules, package, None)
    with pytest.raises(ModuleNotFoundError, match=f"needs {package}, which is not installed: pip install {package}"):
        call(pad)


def test_parameters_of_cycles_broadcast(pad):
    cycle = pad.stresses_after({"Q": Q}, X, Y)
    last = [np.moveaxis(component, 0, -1).copy() for component in cycle]
    moduli = np.array([200e3, 70e3])
    for formula, numbers in ((rwedge.smith_watson_topper, (NU,)), (rwedge.fatemi_socie, (NU, 1e-3))):
        value, angle = formula(*last, E, *numbers)
        assert value.shape == (7, 2)
        for place in np.ndindex(value.shape):
            single = formula(*(component[place] for component in last), E, *numbers)
            assert single == (value[place], angle[place]) and np.ndim(single[0]) == 0
        first = formula(*cycle, E, *numbers, axis=0)
        assert (first[0] == value).all() and (first[1] == angle).all()
        assert (formula(*last, moduli, *numbers)[0][:, 0] == formula(*(c[:, 0] for c in last), E, *numbers)[0]).all()
        assert pickle.loads(pickle.dumps(formula)) is formula
        named = dict(zip(("E", "nu", "k_over_sy"), (E, *numbers)))
        assert (formula(*last, **named)[0] == value).all()
    von_mises = rwedge.von_mises(*cycle, NU)
    s1, s2, _ = rwedge.principal_stresses(*cycle)
    assert von_mises.shape == s1.shape == (4, 7, 2) and (s1 >= s2).all()


def test_parameters_outside_their_domain_are_nan():
    sxx, syy, txy = np.array([[1.0, 2], [3, 4]]), np.zeros(2), np.zeros(2)
    with pytest.warns(RuntimeWarning, match="invalid value encountered in smith_watson_topper"):
        assert np.isnan(rwedge.smith_watson_topper(sxx, syy, txy, [-1, E], NU)[0]).tolist() == [True, False]
    sxx[0, 1] = np.nan
    assert np.isnan(rwedge.smith_watson_topper(sxx, syy, txy, E, NU)).tolist() == [[True, False]] * 2
    with np.errstate(invalid="raise"), pytest.raises(FloatingPointError):
        rwedge.fatemi_socie([1e61], [0.0], [0.0], E, NU, 0)


def test_columns_that_are_no_loads_are_left_alone(pad):
    others = {name: [7.0] for name in ("t", "Time", "quality", "P_yield", "Q_over_fP", "sigma_max", "sxx")}
    with pytest.warns(UserWarning, match="not used: 'quality', 'P_yield', 'Q_over_fP', 'sigma_max', 'sxx'; "):
        pad.stresses_after({"P": [2000], "Q": [100], **others}, 0, 1)
    assert pad.loads == (2000, 0, 100, 0)


METAL = {"E": E, "nu": NU, "yield_stress": 500, "fs_k": 0.5, "findley_k": 0.3, "kappa": 30, "lambda": 100, "t_A": 160, "su": 500, "crossland_alpha": 0.3,
         "dang_van_alpha": 0.2, "sf": 475.4, "b": -0.078, "ef": 0.612, "c": -0.62, "G": 62e3, "tf": 450, "b0": -0.08, "gf": 0.7, "c0": -0.6}


@pytest.mark.parametrize("plane_stress", [False, True])
def test_criteria_by_a_material_are_those_of_the_functions(pad, plane_stress):
    cycle, nu = pad.stresses_after({"Q": Q}, X, Y), 0 if plane_stress else NU
    expected = {"smith_watson_topper": rwedge.smith_watson_topper_planes(*cycle, E, NU, plane_stress, axis=0),
                "fatemi_socie": rwedge.fatemi_socie_planes(*cycle, E, NU, plane_stress, 0.5 / 500, axis=0),
                "findley": rwedge.findley(*cycle, nu, 0.3, axis=0), "modified_wohler": rwedge.modified_wohler(*cycle, nu, 30, 100, axis=0),
                "mcdiarmid": rwedge.mcdiarmid(*cycle, nu, 160, 500, axis=0), "crossland": rwedge.crossland(*cycle, nu, 0.3, axis=0),
                "dang_van": rwedge.dang_van(*cycle, nu, 0.2, axis=0)}
    for name, results in expected.items():
        assert np.array_equal(np.array(getattr(cycle, name)(METAL, plane_stress)), np.array(results))


def test_a_constant_that_the_material_lacks_is_named(pad):
    cycle = pad.stresses_after({"Q": Q}, X, 0)
    with pytest.raises(rwedge.Error, match="the material has no sf"):
        cycle.damage({"E": E, "nu": NU})
    assert set(cycle.damage(METAL).cycles.ravel()) <= {0, 1} and np.isinf(cycle.life({**METAL, "swt_limit": 1e4})).all()
    with pytest.raises(rwedge.Error, match="must be one of swt, fatemi_socie$"):
        cycle.damage(METAL, "findley")
    with pytest.raises(rwedge.Error, match="the material has no lambda"):
        cycle.modified_wohler({"nu": NU, "kappa": 30})


def test_a_criterion_has_one_name_in_all_methods(pad):
    cycle = pad.stresses_after({"Q": Q}, X, 0)
    metal = {**METAL, "yield_stress": 500, "G": 62e3, "tf": 300, "b0": -0.08, "gf": 1, "c0": -0.6}
    for method in cycle.damage, cycle.life, cycle.criterion:
        assert np.array_equal(method(metal, "fatemi_socie"), method(metal, "fatemi-socie"))
    with pytest.raises(TypeError, match="material is the text 'steel': it must be a dict of constants"):
        cycle.life("steel")


@pytest.mark.parametrize("wrong, message", [
    ({"swt_limt": 1}, "swt_limt, which is no constant that is known: did you mean swt_limit"),
    ({"fs_K": 1}, "did you mean fs_k"),
    ({"b": 0.078}, "b = 0.078: allowed is -2 to -0.01"),
    ({"swt_limit": -1}, "swt_limit = -1: allowed is 0, or 1e-60 to 1e"),
    ({"E": 72.1}, "E = 72.1, less than ten times sf = .*: is it in GPa"),
])
def test_a_constant_that_is_unknown_or_wrong_is_an_error(pad, wrong, message):
    with pytest.raises(rwedge.Error, match=message):
        pad.stresses_after({"Q": Q}, X, 0).damage({**METAL, **wrong})


def test_a_criterion_by_its_number_is_that_by_its_name(pad):
    cycle = pad.stresses_after({"Q": Q}, X, 0)
    last = [np.moveaxis(component, 0, -1) for component in cycle]
    value, angle, out_of_plane = rwedge.criterion(rwedge.Measure.FINDLEY, [0.3], *last, NU, 0)
    assert np.array_equal(cycle.criterion(METAL, "findley"), (value, angle, out_of_plane))
    assert np.array_equal(rwedge.findley(*last, nu=NU, k=0.3), (value, angle, out_of_plane))
    assert np.array_equal(rwedge.criterion(7, np.array([0.3, 0.0])[:, None, None, None], *last, NU, 0)[0][0], value)
    metal = [E, 475.4, -0.078, 0.612, -0.62, 0]
    sum_, cycles, plane = rwedge.damage(rwedge.Measure.SWT, metal, *last, NU, 0)
    assert plane.shape == (*sum_.shape, 2)
    damage = cycle.damage(METAL)
    assert np.array_equal(damage.value, sum_) and np.array_equal(damage.out_of_plane, plane[..., 1])
    assert rwedge.life(1, metal, [1.0, 2.0]).shape == (2,)
    assert rwedge.life(1, metal, 1.0) == rwedge.smith_watson_topper_life(1.0, E, 475.4, -0.078, 0.612, -0.62, 0)
    with pytest.warns(RuntimeWarning, match="constants has 1 numbers, 3 are needed"):
        rwedge.criterion(rwedge.Measure.MODIFIED_WOHLER, [30], *last, NU, 0)


def test_an_old_name_says_the_new_one():
    with pytest.raises(AttributeError, match=r"findley_field has another name since version 2.0: criterion_field\("):
        rwedge.findley_field
