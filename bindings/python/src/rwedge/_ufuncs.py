# SPDX-License-Identifier: GPL-3.0-or-later
"""NumPy ufuncs of the library's functions: of the loops in src/loops.c, with the signatures and docstrings of the header.

PyUFunc_FromFuncAndDataAndSignature() comes from the table of functions that NumPy gives every compiled extension, in a capsule:
so the shared library needs no header of Python or NumPy, and one build serves all their versions. Its place in the table is part
of NumPy's binary interface, which only a new major version may change.
"""
from __future__ import annotations

import ctypes
import importlib
import inspect
import warnings
from typing import Any, NoReturn

import numpy as np

from ._blocks import in_blocks
from ._header import FUNCTIONS
from ._labels import aligned
from ._library import EABSENT, EDOMAIN, EPATH, OK, check, function
from ._library import library as _library
from ._validity import outside

if np.lib.NumpyVersion(np.__version__) >= "3.0.0":
    raise ImportError(f"rwedge knows the binary interface of NumPy 1 and 2; this is {np.__version__}")
_core = "numpy._core" if np.lib.NumpyVersion(np.__version__) >= "2.0.0" else "numpy.core"
_ufunc_api = importlib.import_module(_core + "._multiarray_umath")._UFUNC_API

FROM_FUNC_AND_DATA_AND_SIGNATURE = 31  # its place in the table
NO_IDENTITY = -1
OPTIONS = ("out", "where", "casting", "order", "dtype", "subok", "signature", "axis", "axes", "keepdims")  # of any ufunc
DOUBLE, INTEGER, ADDRESS = (np.dtype(kind).num for kind in (np.float64, np.int64, np.intp))
OBJECTS = {"const rwedge_contact *", "const rwedge_series *"}
ARGUMENTS = {"double": DOUBLE, "int32_t": INTEGER, "const double *": DOUBLE, **dict.fromkeys(OBJECTS, ADDRESS)}

_capsule_pointer = ctypes.pythonapi.PyCapsule_GetPointer
_capsule_pointer.restype, _capsule_pointer.argtypes = ctypes.c_void_p, (ctypes.py_object, ctypes.c_char_p)
_table = ctypes.cast(_capsule_pointer(_ufunc_api, None), ctypes.POINTER(ctypes.c_void_p))
_from_func_and_data = ctypes.PYFUNCTYPE(
    ctypes.py_object, ctypes.c_void_p, ctypes.c_void_p, ctypes.c_char_p, ctypes.c_int, ctypes.c_int, ctypes.c_int,
    ctypes.c_int, ctypes.c_char_p, ctypes.c_char_p, ctypes.c_int, ctypes.c_char_p)(_table[FROM_FUNC_AND_DATA_AND_SIGNATURE])
_entry = getattr(_library, "rwedge_entry")
_entry.restype, _entry.argtypes = ctypes.c_void_p, (ctypes.c_char_p,)
_kept: list[object] = []  # what the ufuncs point to, for as long as the process lives


def ufunc(name: str, loop: str = "points") -> np.ufunc:
    """The ufunc of rwedge_name(): of a formula; of a function with several results; of the points of an object, whose
    address is then the first argument; or the generalized one of a function of a cycle. The loop "quiet" tells nothing but by
    a NaN."""
    parameters = [kind for kind, _ in FUNCTIONS[name]["parameters"]]
    arguments = [kind for kind in parameters if kind in ARGUMENTS]
    inputs = [ARGUMENTS[kind] for kind in arguments]
    outputs, signature = parameters.count("double *") or 1, None
    if FUNCTIONS[name]["made"] == "gufunc":
        loop, inputs = "cycles", [DOUBLE] * len(arguments)
        axes = [_axis(name, parameter) for kind, parameter in FUNCTIONS[name]["parameters"] if kind != "size_t"]
        signature = f"{','.join(axes[:len(arguments)])}->{','.join(axes[len(arguments):] or ['()'])}".encode()
    symbol = ctypes.c_char.in_dll(_library, "rwedge_loop_" + loop)
    pointers = (ctypes.c_void_p * 1)(ctypes.addressof(symbol)), (ctypes.c_void_p * 1)(_entry(name.encode()))
    texts = bytes([*inputs, *[DOUBLE] * outputs]), name.encode(), FUNCTIONS[name]["doc"].encode()
    _kept.append((pointers, texts, signature))
    (loops, datas), (types, title, doc) = pointers, texts
    return _from_func_and_data(loops, datas, types, 1, len(inputs), outputs, NO_IDENTITY, title, doc, 0, signature)


def _axis(name: str, parameter: str) -> str:
    """The axis of an array, "(n)" or "(3)", as NumPy's signatures have it; "()" of a number."""
    return f"({','.join(FUNCTIONS[name]['sizes'].get(parameter, ()))})"


UFUNCS = {name: ufunc(name) for name, about in FUNCTIONS.items() if about["made"] in ("ufunc", "gufunc")}


def __getattr__(name: str) -> np.ufunc:
    """Pickle looks for a ufunc by its name in every module."""
    if name not in UFUNCS:
        raise AttributeError(f"module {__name__} has no attribute {name}")
    return UFUNCS[name]


_are_numbers = {float, np.float64, int}.issuperset


class Formula:
    """A ufunc that takes its arguments by name too. The ufunc itself is the attribute ``ufunc``, whose methods and attributes
    this one has as well, such as ``outer``."""

    def __init__(self, function: np.ufunc) -> None:
        self.ufunc, self.__name__, self.__doc__, self.__module__ = function, function.__name__, function.__doc__, "rwedge"
        self._about = about = FUNCTIONS[self.__name__]
        arguments = [(kind, name) for kind, name in about["parameters"] if kind in ARGUMENTS]
        self._names, self._core = [name for _, name in arguments], tuple(int("*" in kind) for kind, _ in arguments)
        sizes = [name for kind, name in about["parameters"] if kind == "size_t"]
        self._of_loads = [about["sizes"].get(name, ("",))[0] in sizes for name in self._names]
        # For plain numbers, as it costs less than to have the warnings told to us
        self._quiet = ufunc(self.__name__, "quiet") if about["made"] == "ufunc" else None
        self.__signature__ = inspect.Signature([inspect.Parameter(name, inspect.Parameter.POSITIONAL_OR_KEYWORD)
                                                for name in self._names])

    def __call__(self, *values: Any, **options: Any) -> Any:
        if self._quiet and not options and _are_numbers(map(type, values)):
            results = self._quiet(*values)
            first = results[0] if type(results) is tuple else results
            if first == first:
                return results
        return self._evaluated(values, options)

    def _evaluated(self, values: tuple[Any, ...], options: dict[str, Any]) -> Any:
        """The result of the ufunc. Where NumPy would warn or raise, that names the line that called, and says why."""
        if options:
            values, options = self._in_order(values, options)
        mode, refused = np.geterr()["invalid"], list[Any]()
        noted: Any = {"invalid": "call", "call": lambda *_: refused.append(_)} if mode in ("warn", "raise") else {}
        with np.errstate(**noted):
            if np.ndarray in map(type, values) and not options:
                results = in_blocks(self.ufunc, values, self._core)
            else:
                results = self.ufunc(*values, **options)
        if refused and mode == "raise":
            raise FloatingPointError(self._why(values, results))
        if refused:
            warnings.warn(self._why(values, results), RuntimeWarning, stacklevel=outside())
        return results

    def _why(self, values: tuple[Any, ...], results: Any) -> str:
        """Which arguments were refused first, and whether it was for want of a closed form."""
        name = self.__name__
        if self._about["implied"] and (why := self._wrong_size(values)):
            return f"invalid value encountered in {name}: {why}"
        if EPATH in self._about["reasons"]:
            first, *numbers = np.broadcast_arrays(results[0], *values)
            places = [ctypes.c_double() for _ in results]
            for place in np.argwhere(np.isnan(first)):
                status = function(name)(*(number[tuple(place)] for number in numbers), *map(ctypes.byref, places))
                if status not in (OK, EABSENT):
                    break
            if status == EPATH:
                return f"no closed form encountered in {name}: {self._about['reasons'][EPATH]}"
        return f"invalid value encountered in {name}"

    def _wrong_size(self, values: tuple[Any, ...]) -> str:
        """Which array has not so many numbers as a function tells, if it is that."""
        given = dict(zip(self._names, values))
        for size, (_, teller, of) in self._about["implied"].items():
            told = int(function(teller)(int(np.max(given[of])))) if teller else 0
            for name, sizes in self._about["sizes"].items():
                if told and size in sizes and np.shape(given[name])[-1] < told:
                    return f"{name} has {np.shape(given[name])[-1]} numbers, {told} are needed"
        return ""

    def _in_order(self, values: tuple[Any, ...], options: dict[str, Any]) -> tuple[tuple[Any, ...], dict[str, Any]]:
        """The arguments that were given by name, out of the options and behind the others; those of a cycle with its axis last."""
        names = self._names[len(values):]
        wrong = [name for name in options if name not in names and name not in OPTIONS]
        if wrong or not options.keys() >= set(names):
            raise TypeError(f"{self.__name__}() takes {', '.join(self._names)}: {len(values)} given by place, and "
                            f"{', '.join(wrong or options)} by name")
        values += tuple([options.pop(name) for name in names])
        if "axis" in options and any(self._of_loads):
            axis = options.pop("axis")
            values = tuple(np.moveaxis(value if hasattr(value, "ndim") else np.asarray(value), axis, -1) if of_loads else value
                           for value, of_loads in zip(values, self._of_loads))
        return values, options

    def __getattr__(self, name: str) -> Any:
        return getattr(self.ufunc, name)

    def __reduce__(self) -> str:
        return self.__name__

    def __repr__(self) -> str:
        return f"<formula rwedge.{self.__name__}({', '.join(self._names)})>"


class Points:
    """A ufunc that raises where an argument is outside its domain, and says which. A NaN still gives NaN. Labels are kept.

    It is evaluated at once, for lazy arrays (Dask's) too: later the object, whose address it is given, may be gone.
    """

    def __init__(self, name: str) -> None:
        self.name, self.ufunc = name, ufunc(name)
        self.arguments = [argument for kind, argument in FUNCTIONS[name]["parameters"] if kind in ARGUMENTS]
        self._core = (0,) * len(self.arguments)

    def __call__(self, *values: Any) -> Any:
        arguments, labelled = aligned(values)
        try:
            with np.errstate(invalid="raise"):
                results = in_blocks(self.ufunc, arguments, self._core)
        except FloatingPointError:
            self._complain(arguments)
        if labelled is None:
            return results
        return tuple(map(labelled, results)) if isinstance(results, tuple) else labelled(results)

    def _complain(self, arguments: tuple[Any, ...]) -> NoReturn:
        """Raises for the first point outside the domain."""
        with np.errstate(invalid="ignore"):
            results = self.ufunc(*arguments)
        result = results[0] if isinstance(results, tuple) else results
        broadcast = {argument: np.broadcast_to(value, result.shape) for argument, value in zip(self.arguments, arguments)}
        outside = np.isnan(result)
        for value in broadcast.values():
            outside &= ~np.isnan(value)
        index = np.unravel_index(np.argmax(outside), result.shape)
        place = f"[{', '.join(map(str, index))}]" if index else ""
        values = {argument: float(value[index]) for argument, value in broadcast.items() if argument not in ("contact", "series")}
        check(self.name, EDOMAIN, values, place)
        raise AssertionError("the ufunc refused what it accepts one by one")
