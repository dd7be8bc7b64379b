# SPDX-License-Identifier: GPL-3.0-or-later
"""The call of any function by the description of the header, for the functions and methods of _made.py, which has what no other
module defines. Scalars are floats, arrays of one size have one dimension, results of two sizes have two."""
from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from ._header import FUNCTIONS
from ._labels import plain, refuse_labels
from ._library import EDOMAIN, ERANGE, Error, check, function, integer, real

_TYPES: dict[str, Any] = {"double": real, "int32_t": integer}


def _numbers(name: str, value: Any, dimensions: int) -> NDArray[Any]:
    refuse_labels(name, value)
    array = np.atleast_1d(plain(value))
    if array.ndim != dimensions:
        raise Error(f"{name} has the shape {array.shape}: the number of its dimensions must be {dimensions}", ERANGE)
    for place in np.argwhere(np.isnan(array)):
        raise Error(f"{name}{place.tolist()} = nan: it must be a number", EDOMAIN)
    return array


class _Call:
    """One call: the arguments of C, from those of Python."""

    def __init__(self, name: str, address: Any, arguments: tuple[Any, ...]) -> None:
        self.name, self.about, self.address = name, FUNCTIONS[name], address
        inputs = [n for (_, n), role in zip(self.about["parameters"], self.about["roles"]) if role in ("in", "in array")]
        self.values, self.sizes = dict(zip(inputs, arguments)), self._told_sizes()
        self.outputs: dict[str, NDArray[Any]] = {}

    def _told_sizes(self) -> dict[str, int]:
        return {size: function(teller)(self.address) for size, teller in self.about["given by"].items()}

    def _measure(self, name: str, array: NDArray[Any]) -> None:
        for size, count in zip(self.about["sizes"][name], array.shape):
            if self.sizes.setdefault(size, count) != count:
                raise Error(f"{name} has the shape {array.shape}, where others have {self.sizes[size]} in place of {count}", ERANGE)

    def arguments(self) -> list[Any]:
        for (kind, name), role in zip(self.about["parameters"], self.about["roles"]):
            if role == "in array":
                self.values[name] = _numbers(name, self.values[name], len(self.about["sizes"][name]))
                self._measure(name, self.values[name])
            elif role == "in":
                self.values[name] = _TYPES[kind](name, self.values[name])
        return [self._argument(name, role) for (_, name), role in zip(self.about["parameters"], self.about["roles"])]

    def _argument(self, name: str, role: str) -> Any:
        if role in ("in", "in array"):
            value = self.values[name]
            return value if role == "in" else value.ctypes.data
        if role == "size":
            return self.sizes[name]
        if role in ("handle", "changed"):
            return self.address
        self.outputs[name] = np.empty([self.sizes[n] for n in self.about["sizes"].get(name, ())])
        return self.outputs[name].ctypes.data

    def results(self) -> Any:
        result = function(self.name)(*self.arguments())
        if self.about["result"] == "const char *":
            return (result.decode(), *map(float, self.outputs.values())) if self.outputs else result.decode()
        if not self.outputs and not self.about["status"]:
            return result
        check(self.name, result, {n: v for n, v in self.values.items() if not isinstance(v, np.ndarray)})
        results = tuple(array if array.ndim else float(array) for array in self.outputs.values())
        return results if len(results) > 1 else results[0] if results else None


def call(name: str, address: Any, *arguments: Any) -> Any:
    """The results of rwedge_name(): a number, an array, or a tuple of them."""
    return _Call(name, address, arguments).results()
