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
from typing import Any, NoReturn

import numpy as np

from ._header import FUNCTIONS
from ._labels import aligned
from ._library import EDOMAIN, check
from ._library import library as _library

if np.lib.NumpyVersion(np.__version__) >= "3.0.0":
    raise ImportError(f"rwedge knows the binary interface of NumPy 1 and 2; this is {np.__version__}")
_core = "numpy._core" if np.lib.NumpyVersion(np.__version__) >= "2.0.0" else "numpy.core"
_ufunc_api = importlib.import_module(_core + "._multiarray_umath")._UFUNC_API

FROM_FUNC_AND_DATA_AND_SIGNATURE = 31  # its place in the table
NO_IDENTITY = -1
DOUBLE, INTEGER, ADDRESS = (np.dtype(kind).num for kind in (np.float64, np.int64, np.intp))
OBJECTS = {"const rwedge_contact *", "const rwedge_series *"}
ARGUMENTS = {"double": DOUBLE, "int32_t": INTEGER, "const double *": DOUBLE, **dict.fromkeys(OBJECTS, ADDRESS)}

_capsule_pointer = ctypes.pythonapi.PyCapsule_GetPointer
_capsule_pointer.restype, _capsule_pointer.argtypes = ctypes.c_void_p, (ctypes.py_object, ctypes.c_char_p)
_table = ctypes.cast(_capsule_pointer(_ufunc_api, None), ctypes.POINTER(ctypes.c_void_p))
_from_func_and_data = ctypes.PYFUNCTYPE(
    ctypes.py_object, ctypes.c_void_p, ctypes.c_void_p, ctypes.c_char_p, ctypes.c_int, ctypes.c_int, ctypes.c_int,
    ctypes.c_int, ctypes.c_char_p, ctypes.c_char_p, ctypes.c_int, ctypes.c_char_p)(_table[FROM_FUNC_AND_DATA_AND_SIGNATURE])
_kept: list[object] = []  # what the ufuncs point to, for as long as the process lives


def _address(symbol: str) -> ctypes.Array[ctypes.c_void_p]:
    """An array of one pointer: that to rwedge_symbol."""
    return (ctypes.c_void_p * 1)(ctypes.addressof(ctypes.c_char.in_dll(_library, "rwedge_" + symbol)))


def ufunc(name: str) -> np.ufunc:
    """The ufunc of rwedge_name(): of a formula; of a function with several results; of the points of an object, whose
    address is then the first argument; or the generalized one of a function of a cycle."""
    parameters = [kind for kind, _ in FUNCTIONS[name]["parameters"]]
    arguments = [kind for kind in parameters if kind in ARGUMENTS]
    outputs, signature = parameters.count("double *") or 1, None
    if FUNCTIONS[name]["made"] == "gufunc":
        loop, data = "cycles", "cycles_" + name
        inputs = [DOUBLE] * len(arguments)
        axes = ",".join("(n)" if kind == "const double *" else "()" for kind in arguments)
        signature = f"{axes}->{','.join(['()'] * outputs)}".encode()
    elif "double *" in parameters or arguments[0] in OBJECTS:
        loop, data = "points", "points_" + name
        inputs = [ADDRESS if kind in OBJECTS else DOUBLE for kind in arguments]
    else:
        loop, data = "".join(kind[0] for kind in arguments), name
        inputs = [ARGUMENTS[kind] for kind in arguments]
    pointers = _address("loop_" + loop), _address(data)
    texts = bytes([*inputs, *[DOUBLE] * outputs]), name.encode(), FUNCTIONS[name]["doc"].encode()
    _kept.append((pointers, texts, signature))
    (loops, datas), (types, title, doc) = pointers, texts
    return _from_func_and_data(loops, datas, types, 1, len(inputs), outputs, NO_IDENTITY, title, doc, 0, signature)


class Formula:
    """A ufunc that takes its arguments by name too. The ufunc itself is the attribute ``ufunc``, whose methods and attributes
    this one has as well, such as ``outer``."""

    def __init__(self, function: np.ufunc) -> None:
        self.ufunc, self.__name__, self.__doc__, self.__module__ = function, function.__name__, function.__doc__, "rwedge"
        self._names = [name for kind, name in FUNCTIONS[self.__name__]["parameters"] if kind in ARGUMENTS]
        self.__signature__ = inspect.Signature([inspect.Parameter(name, inspect.Parameter.POSITIONAL_OR_KEYWORD)
                                                for name in self._names])

    def __call__(self, *given: Any, **options: Any) -> Any:
        if options:
            given = self._in_order(given, options)
        return self.ufunc(*given, **options)

    def _in_order(self, given: tuple[Any, ...], options: dict[str, Any]) -> tuple[Any, ...]:
        """The arguments that were given by name, out of the options and behind the others."""
        named = [name for name in self._names if name in options]
        if named and named != self._names[len(given):]:
            raise TypeError(f"{self.__name__}() takes {', '.join(self._names)}: {len(given)} given by place, and "
                            f"{', '.join(named)} by name")
        return given + tuple(options.pop(name) for name in named)

    def __getattr__(self, name: str) -> Any:
        if name == "ufunc":  # before it has one: while it is copied or unpickled
            raise AttributeError(name)
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

    def __call__(self, *given: Any) -> Any:
        arguments, labelled = aligned(given)
        try:
            with np.errstate(invalid="raise"):
                results = self.ufunc(*arguments)
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
        given = {argument: np.broadcast_to(value, result.shape) for argument, value in zip(self.arguments, arguments)}
        outside = np.isnan(result)
        for value in given.values():
            outside &= ~np.isnan(value)
        index = np.unravel_index(np.argmax(outside), result.shape)
        place = f"[{', '.join(map(str, index))}]" if index else ""
        values = {argument: float(value[index]) for argument, value in given.items() if argument not in ("contact", "series")}
        check(self.name, EDOMAIN, values, place)
        raise AssertionError("the ufunc refused what it accepts one by one")
