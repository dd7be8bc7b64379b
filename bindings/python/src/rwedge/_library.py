# SPDX-License-Identifier: GPL-3.0-or-later
"""The shared library, through ctypes with the prototypes of its header; its statuses as exceptions."""
from __future__ import annotations

import ctypes
import importlib.util
import math
import operator
import sys
from pathlib import Path
from typing import Any, Mapping, SupportsFloat, SupportsIndex

from ._header import FUNCTIONS

TYPES = {"double": ctypes.c_double, "int32_t": ctypes.c_int32, "size_t": ctypes.c_size_t, "const char *": ctypes.c_char_p,
         "void": None}  # all others are pointers
OK, EDOMAIN, ENULL, ERANGE, ENOMEM, ESLIDING, EABSENT, EPATH = 0, 1, 2, 3, 5, 6, 8, 9
INT32_MAX = 2**31 - 1


def _path() -> str:
    """Where the library is: beside this file; or, of an editable install, where the hook of the import finds it."""
    beside = Path(__file__).with_name("_rwedge" + (".dll" if sys.platform == "win32" else ".so"))
    spec = None if beside.exists() else importlib.util.find_spec("._rwedge", __package__)
    return str(spec.origin if spec and spec.origin else beside)


library = ctypes.CDLL(_path())


class Error(ValueError):
    """An argument is outside its domain, or what is asked for cannot be had; ``status`` is the C library's number for it.

    See Also
    --------
    SlidingError, AbsentError, PathError : which are such errors

    Examples
    --------
    >>> import rwedge
    >>> pad = rwedge.Contact(theta=0.01, a=2.0, A=1.82e-5, f=0.3)
    >>> try:
    ...     pad.load(-1)
    ... except rwedge.Error as error:
    ...     error.status
    1
    """

    def __init__(self, message: str, status: int = EDOMAIN) -> None:
        super().__init__(message)
        self.status = status


class SlidingError(Error):
    """The tangential force exceeds friction times the normal force: there is no equilibrium.

    See Also
    --------
    Contact.load, Contact.apply

    Examples
    --------
    >>> import rwedge
    >>> pad = rwedge.Contact(theta=0.01, a=2.0, A=1.82e-5, f=0.3)
    >>> try:
    ...     pad.load(1000, 301)
    ... except rwedge.SlidingError:
    ...     print("it slides")
    it slides
    """


class AbsentError(Error, AttributeError):
    """What is asked for does not exist, such as the edges of a contact without load: ``hasattr`` then says so.

    See Also
    --------
    Contact.edges, Contact.stick_zone

    Examples
    --------
    >>> import rwedge
    >>> pad = rwedge.Contact(theta=0.01, a=2.0, A=1.82e-5, f=0.3)
    >>> hasattr(pad, "edges")
    False
    """


class PathError(Error):
    """There is no closed form on this path of loads, and the contact may not compute it, because its ``tolerance`` is 0. The
    message says why, and what to do instead.

    See Also
    --------
    Contact.apply, Contact.obstacle : the same text before the loads are applied

    Examples
    --------
    >>> import rwedge
    >>> pad = rwedge.Contact(theta=0.01, a=2.0, A=1.82e-5, f=0.3, tolerance=0)
    >>> pad.apply(2000, 0, 300, 0)
    >>> try:
    ...     pad.apply(2500, 500, 100, 20)
    ... except rwedge.PathError as error:
    ...     print(pad.obstacle(2500, 500, 100, 20) in str(error))
    True
    """


ERRORS = {ESLIDING: SlidingError, EABSENT: AbsentError, EPATH: PathError}


def function(name: str) -> Any:
    """The library's rwedge_name(), with its types."""
    called = getattr(library, "rwedge_" + name)
    if called.argtypes is None:  # ctypes keeps what it was asked for
        called.restype = TYPES[FUNCTIONS[name]["result"]]
        called.argtypes = [TYPES.get(kind, ctypes.c_void_p) for kind, _ in FUNCTIONS[name]["parameters"]]
    return called


_strerror = function("strerror")


def _is_inside(value: Any, low: float, high: float, low_open: bool, high_open: bool, or_zero: bool, smallest: float) -> bool:
    if value == 0 and or_zero:
        return True
    above, below = low < value or value == low and not low_open, value < high or value == high and not high_open
    return bool(above and below and (value == 0 or abs(value) >= smallest))


def check(name: str, status: int, arguments: Mapping[str, object] = {}, place: str = "") -> None:
    """Raises what a status of rwedge_name() other than OK means: for which arguments, those outside their own bounds where there
    are such, and what would be allowed; or else what refuses arguments that are inside."""
    if status == OK:
        return
    reason, domains, bounds = _strerror(status).decode(), FUNCTIONS[name]["domains"], FUNCTIONS[name]["bounds"]
    if status == ENOMEM:
        raise MemoryError(reason)
    outside = {argument: value for argument, value in arguments.items() if argument in bounds and not _is_inside(value, *bounds[argument])}
    if status in (EDOMAIN, ERANGE) and outside:
        arguments = outside
    told = ", ".join(f"{argument}{place} = {value}" for argument, value in arguments.items())
    allowed = "; ".join(f"{argument}: {domains[argument]}" for argument in arguments if argument in domains)
    why = FUNCTIONS[name]["reasons"].get(status, "")
    if status in (EABSENT, EPATH):
        allowed = why
    elif status in (EDOMAIN, ERANGE) and why and not outside:  # each argument by itself may be right
        allowed = "; ".join(filter(None, (allowed, f"refused {why}")))
    message = ": ".join(filter(None, (told, reason))) + (f" ({allowed})" if allowed else "")
    raise ERRORS.get(status, Error)(message, status)


def real(name: str, value: SupportsFloat) -> float:
    """The argument as a double; a string is refused."""
    try:
        math.fabs(value)
    except TypeError as error:
        raise TypeError(f"{name}: {error}") from None
    return float(value)


def integer(name: str, value: SupportsIndex) -> int:
    """The argument as an int32_t."""
    try:
        number = operator.index(value)
    except TypeError as error:
        raise TypeError(f"{name}: {error}") from None
    if abs(number) > INT32_MAX:
        raise Error(f"{name} = {number}: {_strerror(ERANGE).decode()}", ERANGE)
    return number
