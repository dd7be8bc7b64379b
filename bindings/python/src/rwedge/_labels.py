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


def is_labelled(given: Any) -> bool:
    """Whether it has an index or named dimensions. (A list has a method called index.)"""
    return hasattr(given, "dims") or not callable(getattr(given, "index", len))


def refuse_units(given: Any) -> None:
    """Refuses quantities of pint, unyt and astropy: their unit would be lost."""
    if hasattr(type(given), "units") or hasattr(type(given), "unit"):
        raise TypeError(f"{given!r} has a unit, which would be lost: give the number alone, in the units of the other arguments")


def _numbers(given: Any) -> NDArray[Any]:
    """As a plain array; a missing value of pandas is NaN."""
    return given.to_numpy(dtype=float, na_value=np.nan) if hasattr(given, "to_numpy") and hasattr(given, "index") else np.asarray(given)


def aligned(given: tuple[Any, ...]) -> tuple[tuple[Any, ...], Any]:
    """The arguments as plain arrays that belong together place by place; and what labels a result like them, or masks it, or
    None. They are aligned as in a sum of them, which is the labels' own arithmetic."""
    for one in given:
        refuse_units(one)
    if any(isinstance(one, np.ma.MaskedArray) for one in given):
        return _unmasked(given)
    if not any(map(is_labelled, given)):
        return tuple(map(np.asanyarray, given)), None
    placed = [is_labelled(one) or np.ndim(one) > 0 for one in given]
    zeros = functools.reduce(operator.add, [(one != one).astype(float) * 0 for one, has_place in zip(given, placed) if has_place])
    if hasattr(zeros, "compute"):
        zeros = zeros.compute()
    arguments = tuple(_numbers(zeros + one) if has_place else np.asarray(one) for one, has_place in zip(given, placed))
    return arguments, lambda result: zeros + result


def _unmasked(given: tuple[Any, ...]) -> tuple[tuple[Any, ...], Any]:
    """Masked elements as NaN; the results, NaN there, are masked again."""
    mask = functools.reduce(np.logical_or, map(np.ma.getmaskarray, given))
    arguments = tuple(np.ma.filled(np.ma.asarray(one, dtype=float), np.nan) if isinstance(one, np.ma.MaskedArray) else np.asarray(one)
                      for one in given)
    return arguments, lambda result: np.ma.array(result, mask=mask)


def refuse_labels(name: str, given: Any) -> None:
    """Refuses labels in functions that take whole arrays by position."""
    refuse_units(given)
    if is_labelled(given):
        raise TypeError(f"{name} has labels, which would be lost: give the numbers alone, such as {name}.to_numpy()")
