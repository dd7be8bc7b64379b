# SPDX-License-Identifier: GPL-3.0-or-later
"""The shared library, through ctypes with the prototypes of its header; its statuses as exceptions."""
from __future__ import annotations

import ctypes
import math
import operator
import sys
import weakref
from pathlib import Path
from typing import Any, Mapping, SupportsFloat, SupportsIndex

from ._header import FUNCTIONS

TYPES = {"double": ctypes.c_double, "int32_t": ctypes.c_int32, "size_t": ctypes.c_size_t, "const char *": ctypes.c_char_p,
         "void": None}  # all others are pointers
OK, EDOMAIN, ERANGE, ENOMEM, ESLIDING = 0, 1, 3, 5, 6
INT32_MAX = 2**31 - 1

library = ctypes.CDLL(str(Path(__file__).with_name("_rwedge" + (".dll" if sys.platform == "win32" else ".so"))))


class Error(ValueError):
    """An argument is outside its domain, or what is asked for cannot be had; ``status`` is the C library's number for it."""

    def __init__(self, message: str, status: int = EDOMAIN) -> None:
        super().__init__(message)
        self.status = status


class SlidingError(Error):
    """The tangential force exceeds friction times the normal force: there is no equilibrium."""


def function(name: str) -> Any:
    """The library's rwedge_name(), with its types."""
    found = getattr(library, "rwedge_" + name)
    found.restype = TYPES[FUNCTIONS[name]["result"]]
    found.argtypes = [TYPES.get(kind, ctypes.c_void_p) for kind, _ in FUNCTIONS[name]["parameters"]]
    return found


_strerror = function("strerror")


def check(name: str, status: int, arguments: Mapping[str, object] = {}, place: str = "") -> None:
    """Raises what a status of rwedge_name() other than OK means: for which arguments, and what would be allowed."""
    if status == OK:
        return
    reason, domains = _strerror(status).decode(), FUNCTIONS[name]["domains"]
    if status == ENOMEM:
        raise MemoryError(reason)
    given = ", ".join(f"{argument}{place} = {value}" for argument, value in arguments.items())
    allowed = "; ".join(f"{argument}: {domains[argument]}" for argument in arguments if argument in domains)
    raise (SlidingError if status == ESLIDING else Error)(f"{given}: {reason} ({allowed})", status)


def real(name: str, value: SupportsFloat) -> float:
    """The argument as a double; a string is none."""
    try:
        math.fabs(value)
    except TypeError as error:
        raise TypeError(f"{name}: {error}") from None
    return float(value)


def integer(name: str, value: SupportsIndex) -> int:
    """The argument as an int32_t."""
    number = operator.index(value)
    if abs(number) > INT32_MAX:
        raise Error(f"{name} = {number}: {_strerror(ERANGE).decode()}", ERANGE)
    return number


class Handle:
    """An object of the library, freed when the last reference to it goes."""

    def _adopt(self, handle: ctypes.c_void_p, destroy: Any) -> None:
        self._address = handle.value
        weakref.finalize(self, destroy, handle.value)

    def __reduce__(self) -> Any:
        raise TypeError(f"a {type(self).__name__} cannot be pickled: send what it is made from, and make it there")
