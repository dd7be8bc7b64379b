# SPDX-License-Identifier: GPL-3.0-or-later
"""What numbers may be given as; of arrays with labels (pandas, xarray) the labels, not the positions, say which belong together."""
from __future__ import annotations

import functools
import operator
from typing import Any, Protocol, Sequence, SupportsFloat, Union

import numpy as np
from numpy.typing import NDArray


class SupportsArray(Protocol):
    """Arrays of NumPy, pandas, xarray, Dask and so on."""

    def __array__(self) -> Any: ...


# NumPy's own ArrayLike has strings and complex numbers too.
Scalar = Union[float, "np.floating[Any]", "np.integer[Any]"]
Numbers = Union[SupportsFloat, SupportsArray, Sequence[SupportsFloat], Sequence[Sequence[SupportsFloat]],
                Sequence[Sequence[Sequence[SupportsFloat]]]]


def is_labelled(value: Any) -> bool:
    """Whether it has an index or named dimensions. (A list has a method called index.)"""
    return hasattr(value, "dims") or not callable(getattr(value, "index", len))


def same_labels(one: Any, other: Any) -> bool:
    """Whether two columns with labels have the same ones, in one order."""

    def indexes(column: Any) -> list[Any]:
        return [column.get_index(dimension) for dimension in column.dims] if hasattr(column, "dims") else [column.index]

    pairs = list(zip(indexes(one), indexes(other)))
    return getattr(one, "dims", None) == getattr(other, "dims", None) and all(a.equals(b) for a, b in pairs)


def refuse_units(value: Any) -> None:
    """Refuses quantities of pint, unyt and astropy: their unit would be lost."""
    if hasattr(type(value), "units") or hasattr(type(value), "unit"):
        raise TypeError(f"{value!r} has a unit, which would be lost: give the number alone, in the units of the other arguments")


def plain(value: Any) -> NDArray[np.float64]:
    """A copy, which a Cycle may keep, of numbers as the ufuncs accept them: a TypeError for strings, objects and complex."""
    return np.asarray(value).astype(float, order="C", casting="safe")


def _numbers(value: Any) -> NDArray[Any]:
    """As a plain array; a missing value of pandas is NaN."""
    return value.to_numpy(dtype=float, na_value=np.nan) if hasattr(value, "to_numpy") and hasattr(value, "index") else np.asarray(value)


def aligned(values: tuple[Any, ...]) -> tuple[tuple[Any, ...], Any]:
    """The arguments as plain arrays that belong together place by place; and what labels a result like them, or masks it, or
    None. They are aligned as in a sum of them, which is the labels' own arithmetic."""
    for value in values:
        refuse_units(value)
    if any(isinstance(value, np.ma.MaskedArray) for value in values):
        return _unmasked(values)
    if not any(map(is_labelled, values)):
        return tuple(map(np.asanyarray, values)), None
    placed = [is_labelled(value) or np.ndim(value) > 0 for value in values]
    zeros = functools.reduce(operator.add, [(value != value).astype(float) * 0 for value, has_place in zip(values, placed) if has_place])
    if hasattr(zeros, "compute"):
        zeros = zeros.compute()
    arguments = tuple(_numbers(zeros + value) if has_place else np.asarray(value) for value, has_place in zip(values, placed))
    return arguments, lambda result: zeros + result


def _unmasked(values: tuple[Any, ...]) -> tuple[tuple[Any, ...], Any]:
    """Masked elements as NaN; the results, NaN there, are masked again."""
    mask = functools.reduce(np.logical_or, map(np.ma.getmaskarray, values))
    arguments = tuple(np.ma.filled(np.ma.asarray(value, dtype=float), np.nan) if isinstance(value, np.ma.MaskedArray) else np.asarray(value)
                      for value in values)
    return arguments, lambda result: np.ma.array(result, mask=mask)


def refuse_labels(name: str, value: Any) -> None:
    """Refuses labels in functions that take whole arrays by position."""
    refuse_units(value)
    if is_labelled(value):
        raise TypeError(f"{name} has labels, which would be lost: give the numbers alone, such as {name}.to_numpy()")
