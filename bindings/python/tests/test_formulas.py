# SPDX-License-Identifier: GPL-3.0-or-later
"""The formulas are ufuncs: right, broadcasting, quiet, picklable; the docstrings are the header's."""
import inspect
import os
import pickle
import re
import threading
import time
from pathlib import Path

import numpy as np
import pytest
import speed

import rwedge
from rwedge._header import FUNCTIONS

FORMULAS = {name: value for name, value in vars(rwedge).items() if isinstance(getattr(value, "ufunc", None), np.ufunc)
            and not name.startswith("_")}
UFUNCS = {name: value for name, value in FORMULAS.items() if value.signature is None}  # others are of a cycle: test_stress_history.py


def first_calls():
    """An argument list of each function: the first call in tests/answers that C answers with numbers."""
    calls = {}
    for call, answer in zip(*(Path(os.environ["RWEDGE_ANSWERS"], name).read_text().splitlines() for name in ("calls.csv", "answers.csv"))):
        name, arguments = call.partition(":")[0], call.split(",")[1:]
        if name in UFUNCS and not re.search("nan|error", answer):
            kinds = [int if kind == "int32_t" else float for kind, _ in FUNCTIONS[name]["parameters"]]
            calls.setdefault(name, tuple(kind(argument) for kind, argument in zip(kinds, arguments)))
    return calls


if "RWEDGE_ANSWERS" not in os.environ:
    pytest.skip("test.sh says where the calls of all languages are", allow_module_level=True)
INSIDE = first_calls()


def results(name, *arguments):
    """A tuple, however many there are."""
    result = UFUNCS[name](*arguments)
    return result if isinstance(result, tuple) else (result,)


def test_every_formula_of_the_header_is_a_ufunc():
    numbers = {"double", "int32_t", "double *"}
    formulas = {name for name, about in FUNCTIONS.items()
                if name not in ("strerror", "version", "validity", "validity_text")
                and about["result"] != "size_t" and {kind for kind, _ in about["parameters"]} <= numbers
                and any(kind == "double" for kind, _ in about["parameters"]) and not about["sizes"]}
    assert UFUNCS.keys() == formulas == INSIDE.keys()


@pytest.mark.parametrize("name", UFUNCS)
def test_broadcasts_over_strided_arrays_of_any_shape(name):
    factors = np.linspace(0.9, 1, 24).reshape(2, 3, 4)[:, ::-1, ::2]
    varied = [factors * value if isinstance(value, float) else value for value in INSIDE[name]]
    varied[0] = np.asfortranarray(varied[0])
    varied[-1] = np.asarray(varied[-1])[..., :1, :] if np.ndim(varied[-1]) else varied[-1]
    together = results(name, *varied)
    flat = np.broadcast_arrays(*varied)
    for index in np.ndindex(flat[0].shape):
        assert tuple(result[index] for result in together) == results(name, *[a[index].item() for a in flat])


def test_long_arrays_with_shared_arguments_are_those_point_by_point():
    x, y = np.random.default_rng(1).uniform(-2, 2, (2, 1000))
    y[::2] = abs(y[::2])
    y[1::2] = 0
    x[[3, 700]] = np.nan
    together = rwedge.stress(0.25, 0.3, 0.4, x, y)
    for i in range(len(x)):
        np.testing.assert_array_equal([s[i] for s in together], rwedge.stress(0.25, 0.3, 0.4, x[i], y[i]))


def test_keywords_of_ufuncs():
    """They are NumPy's, with its errors."""
    x, out = np.linspace(-0.9, 0.9, 6), np.full(6, 7.0)
    expected, where = rwedge.pressure(0.25, x), abs(x) < 0.5
    for keyword in ({"dtype": float}, {"order": "F"}, {"subok": False}, {"signature": "dd->d"}):
        np.testing.assert_array_equal(rwedge.pressure(0.25, x=x, **keyword), expected)
    assert rwedge.pressure(0.25, x, out=out, where=where) is out
    assert (out == np.where(where, expected, 7)).all()
    np.testing.assert_array_equal(rwedge.pressure.outer([0.25, 0.5], x)[0], expected)
    limit, place = np.empty((2, 2))
    assert rwedge.yield_point([0.25, 0.5], 0.1, 0.3, out=(limit, place, None))[0] is limit
    np.testing.assert_array_equal(place, rwedge.yield_point([0.25, 0.5], 0.1, 0.3)[1])
    for keyword, error in (({"dtype": np.float32}, TypeError), ({"axis": 0}, TypeError), ({"out": np.empty(6, int)}, TypeError),
                           ({"out": np.empty(5)}, ValueError)):
        with pytest.raises(error):
            rwedge.pressure(0.25, x=x, **keyword)


def test_outputs_may_overlap_what_is_given():
    """As NumPy promises: what is written is never read again as an argument."""
    numbers = np.linspace(0.1, 0.9, 9)
    expected = rwedge.load(numbers[:-1])
    np.testing.assert_array_equal(rwedge.load(numbers[:-1], out=numbers[1:]), expected)
    x, y = np.array([[0.0, 0.1], [2.0, 3.0]])
    expected, three = rwedge.stress(0.25, 0.3, 0, x, y), np.array([x, y, x])
    rwedge.stress(0.25, 0.3, 0, three[0], three[1], out=(three[1], three[0], three[2]))
    np.testing.assert_array_equal(three[[1, 0, 2]], expected)


def test_in_place_still_tells_a_nan_given_from_one_made():
    x = np.array([0.3, np.nan])
    expected = rwedge.pressure(0.25, x)
    rwedge.pressure(0.25, x, out=x)
    np.testing.assert_array_equal(x, expected)
    with pytest.warns(RuntimeWarning, match="invalid value encountered in pressure"):
        rwedge.pressure(x, np.array([np.inf, 0.1]), out=x)


@pytest.mark.parametrize("name", UFUNCS)
def test_nan_gives_nan_without_a_warning(name):  # pytest makes errors of warnings
    for position, value in enumerate(INSIDE[name]):
        if isinstance(value, int):
            continue
        arguments = [*INSIDE[name][:position], [value, np.nan], *INSIDE[name][position + 1:]]
        for result in results(name, *arguments):
            assert np.isfinite(result[0]) and np.isnan(result[1])


@pytest.mark.parametrize("name", UFUNCS)
def test_outside_the_domain_numpy_decides(name):
    outside = (-np.inf, *INSIDE[name][1:])
    with pytest.warns(RuntimeWarning, match=f"invalid value encountered in {name}"):
        assert np.isnan(results(name, *outside)).all()
    with np.errstate(invalid="raise"), pytest.raises(FloatingPointError, match=name):
        results(name, *outside)
    with np.errstate(invalid="ignore"):
        results(name, *outside)


def test_a_warning_survives_numpys_buffers():
    alpha = np.full(100_000, 0.25, dtype=np.float32)  # cast in blocks of 8192
    alpha[5] = -1
    with pytest.warns(RuntimeWarning, match="invalid"):
        rwedge.load(alpha)


def test_valid_calls_raise_no_exception_of_the_processor():
    alpha = np.array([0, 1e-60, 1e-40, 1e-16, 3e-9, 0.25, 1, 2, 1e10, 1e60])
    with np.errstate(all="raise"):
        rwedge.pressure(alpha[:, None], np.linspace(0.01, 1, 50))
        rwedge.stress(alpha[:, None], 0.3, 0.2, np.linspace(0.01, 1, 50), 1e-60)
        assert np.isnan(rwedge.subsurface_yield(0.25, 1e3, 0.3)).all()  # absent, not invalid
        assert rwedge.yield_load(0.01, 2, 1e-5, 0, 0.5, 1e6) == np.inf


def test_types_and_shapes():
    assert rwedge.load(1) == rwedge.load(1.0) and rwedge.load(np.float32(0.25)) == rwedge.load(0.25)
    for call in (lambda: rwedge.load("0.25"), lambda: rwedge.coefficient(0.25, 1.5)):
        with pytest.raises(TypeError):
            call()
    with pytest.raises(ValueError, match="broadcast"):
        rwedge.pressure([0.1, 0.2], [0.1, 0.2, 0.3])
    with pytest.warns(RuntimeWarning, match="invalid"):
        assert np.isnan(rwedge.coefficient(0.25, [-1, 2**31])).all()


@pytest.mark.parametrize("name", FORMULAS)
def test_pickles_by_name(name):
    assert pickle.loads(pickle.dumps(FORMULAS[name])) is FORMULAS[name]
    assert pickle.loads(pickle.dumps(FORMULAS[name].ufunc)) is FORMULAS[name].ufunc


@pytest.mark.parametrize("name", UFUNCS)
def test_arguments_by_name(name):
    names, values = list(inspect.signature(UFUNCS[name]).parameters), INSIDE[name]
    for by_place in range(len(values) + 1):
        by_name = dict(reversed(list(zip(names[by_place:], values[by_place:]))))
        assert UFUNCS[name](*values[:by_place], **by_name) == UFUNCS[name](*values)


def test_wrong_names_are_named():
    out = np.empty(2)
    assert rwedge.elastic_limit([0.25, 0.3], f=0.1, nu=0.3, out=out) is out
    for placed, named in (((0.25,), {"nu": 0.3}), ((0.25, 0.1), {"f": 0.1, "nu": 0.3}), ((), {"alpha": 0.25}),
                         ((0.25, 0.1, 0.3), {"friction": 1})):
        with pytest.raises(TypeError, match=f"takes alpha, f, nu: {len(placed)} given by place"):
            rwedge.elastic_limit(*placed, **named)
    with pytest.raises(TypeError, match="takes alpha, f, nu: 1 given by place, and friction by name"):
        rwedge.elastic_limit(0.25, friction=0.1, nu=0.3)
    assert repr(rwedge.pressure) == "<formula rwedge.pressure(alpha, x)>"


def test_stresses_raises_and_names_the_point():
    x = np.zeros((2, 3))
    y = np.array([[1, 2, 3], [4, -5.0, 6]])
    with pytest.raises(rwedge.Error, match=r"^y\[1, 1\] = -5.0: an argument is outside its domain.*y: 0, or 1e-60 to 1e60, not the apex"):
        rwedge.stresses(0.25, 0.3, 0, x, y)
    y[1, 1] = np.nan
    for raising, ufunc in zip(rwedge.stresses(0.25, 0.3, 0, x, y), rwedge.stress(0.25, 0.3, 0, x, y)):
        np.testing.assert_array_equal(raising, ufunc)
        assert np.isnan(raising[1, 1]) and np.isfinite(raising).sum() == 5


def test_the_gil_is_released():
    alpha, beats = np.full(40_000, 0.25), []
    worker = threading.Thread(target=lambda: rwedge.elastic_limit(alpha, 0.1, 0.3))
    worker.start()
    while worker.is_alive():
        beats.append(None)
        time.sleep(0.001)
    assert len(beats) > 20  # some 300 ms of C code; with the GIL held it would be one or two


@pytest.mark.long
@pytest.mark.parametrize("name", speed.IN_C)
def test_a_ufunc_is_as_fast_as_a_loop_in_c(name):
    """The bound is twice what is expected, as machines are busy: speed.py prints the figures."""
    assert min(speed.ratio(name, 10_000) for _ in range(2)) < 2
