# SPDX-License-Identifier: GPL-3.0-or-later
"""Arrays with labels (pandas, xarray): which number belongs to which is said by the labels, not by the place."""
from __future__ import annotations

import functools
import operator
from typing import Any

import numpy as np


def is_labelled(given: Any) -> bool:
    """Has it an index or named dimensions? A list has a method of that name."""
    return hasattr(given, "dims") or not callable(getattr(given, "index", len))


def aligned(given: tuple[Any, ...]) -> tuple[tuple[Any, ...], Any]:
    """The arguments as plain arrays that belong together place by place; and what labels a result like them, or None where
    nothing had labels. They are aligned as in a sum of them, which is the labels' own arithmetic."""
    if not any(map(is_labelled, given)):
        return tuple(map(np.asanyarray, given)), None
    placed = [is_labelled(one) or np.ndim(one) > 0 for one in given]
    zeros = functools.reduce(operator.add, [(one != one) * 0.0 for one, has_place in zip(given, placed) if has_place])
    if hasattr(zeros, "compute"):
        zeros = zeros.compute()
    arguments = tuple(np.asarray(zeros + one if has_place else one) for one, has_place in zip(given, placed))
    return arguments, lambda result: zeros + result


def refuse_labels(name: str, given: Any) -> None:
    """For what takes whole arrays by place."""
    if is_labelled(given):
        raise TypeError(f"{name} has labels, which would be lost: give the numbers alone, such as {name}.to_numpy()")
