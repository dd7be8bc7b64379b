# SPDX-License-Identifier: GPL-3.0-or-later
"""What a contact and a series have in common: an object of the library, and how its methods in _made.py call it."""
from __future__ import annotations

import contextlib
import ctypes
import weakref
from typing import Any

from ._general import call
from ._library import ENULL, Error
from ._ufuncs import Points


def _free(cell: list[int | None], destroy: Any) -> None:
    address, cell[0] = cell[0], None
    destroy(address)


class Object:
    """An object of the library, freed when the last reference to it goes; at the end of the process, with its memory.

    In a cycle of references that is collected, another object's __del__ may still use this one after it has been freed. The
    cell, which is shared with the finalizer, shows that."""

    _lock: Any = contextlib.nullcontext()  # where any number of threads may use it

    def __init_subclass__(cls) -> None:
        """A method without a text has that of the method it stands for."""
        for name, member in vars(cls).items():
            method = getattr(member, "__func__", member)
            if callable(method) and not method.__doc__:
                method.__doc__ = getattr(getattr(super(cls, cls), name, None), "__doc__", None)

    def _adopt(self, handle: ctypes.c_void_p, destroy: Any) -> None:
        self._cell = [handle.value]
        weakref.finalize(self, _free, self._cell, destroy).atexit = False

    @property
    def _address(self) -> int:
        address = self._cell[0]
        if address is None:
            raise Error(f"this {type(self).__name__} has been freed: it is used after the end of its life", ENULL)
        return address

    def _call(self, name: str, *arguments: Any) -> Any:
        with self._lock:
            return call(name, self._address, *arguments)

    def _read(self, read: Any) -> Any:
        with self._lock:
            return read(self._address)

    def _at(self, points: Points, *arguments: Any) -> Any:
        with self._lock:
            return points(self._address, *arguments)

    def __reduce__(self) -> Any:
        raise TypeError(f"a {type(self).__name__} cannot be pickled: send what it is made from, and make it there")
