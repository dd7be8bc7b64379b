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


def _inputs(about: dict[str, Any], given: tuple[Any, ...]) -> dict[str, Any]:
    """The numbers and arrays by their names."""
    inputs = [(*parameter, role) for parameter, role in zip(about["parameters"], about["roles"]) if role in ("in", "in array")]
    return {name: _numbers(name, value, len(about["sizes"][name])) if role == "in array" else _TYPES[kind](name, value)
            for (kind, name, role), value in zip(inputs, given)}


def _sizes(about: dict[str, Any], address: Any, values: dict[str, Any]) -> dict[str, int]:
    """The sizes, which a function tells or the arrays have: they must agree."""
    sizes: dict[str, int] = {size: function(teller)(*(values.get(name, address) for _, name in FUNCTIONS[teller]["parameters"]))
                             for size, teller in about["given by"].items()}
    for size, (fixed, teller, argument) in about["implied"].items():
        if told := fixed or function(teller)(values[argument]):  # 0 is told where any number will do, or the call is refused
            sizes[size] = told
    for name, value in values.items():
        for size, count in zip(about["sizes"].get(name, ()), np.shape(value)):
            if sizes.setdefault(size, count) != count:
                raise Error(f"{name} has the shape {value.shape}, where others have {sizes[size]} in place of {count}", ERANGE)
    return sizes


def call(name: str, address: Any, *arguments: Any) -> Any:
    """The results of rwedge_name(): a number, an array, or a tuple of them."""
    about = FUNCTIONS[name]
    values = _inputs(about, arguments)
    sizes = _sizes(about, address, values)
    outputs = {output: np.empty([sizes[n] for n in about["sizes"].get(output, ())])
               for (_, output), role in zip(about["parameters"], about["roles"]) if role in ("out", "out array")}
    own = {**values, **sizes, **outputs}
    passed = [own.get(parameter, address) for _, parameter in about["parameters"]]
    result = function(name)(*(value.ctypes.data if isinstance(value, np.ndarray) else value for value in passed))
    if about["result"] == "const char *":
        return (result.decode(), *map(float, outputs.values())) if outputs else result.decode()
    if not outputs and not about["status"]:
        return result
    check(name, result, {n: v for n, v in values.items() if not isinstance(v, np.ndarray)})
    results = tuple(array if array.ndim else float(array) for array in outputs.values())
    return results if len(results) > 1 else results[0] if results else None
