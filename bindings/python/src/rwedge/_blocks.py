# SPDX-License-Identifier: GPL-3.0-or-later
"""Long calls of the library in blocks: Python reacts to Ctrl-C between blocks, never while the library computes."""
from __future__ import annotations

import math
import re
import threading
import time
from typing import Any, Callable, Iterator

import numpy as np

FEW = 4096  # points that no function needs a second for
SECONDS = 0.25  # what a block aims at


def blocks(total: int, first: int) -> Iterator[slice]:
    """Slices of 0 <= i < total: the first of the given size, the others of a size that takes the intended time."""
    start, count = 0, max(1, first)
    while start < total:
        began = time.monotonic()
        yield slice(start, min(start + count, total))
        start += count
        count = max(1, int(count * min(8, SECONDS / (time.monotonic() - began + 1e-6))))


def _own_shapes(ufunc: np.ufunc) -> list[tuple[int, ...]]:
    """The last dimensions of each result, which a signature such as (n)->(),(2) tells."""
    outputs = (ufunc.signature or "").partition("->")[2].split("),(")
    return [tuple(map(int, re.findall(r"\d+", output))) for output in outputs] if ufunc.signature else [()] * ufunc.nout


def in_blocks(ufunc: np.ufunc, arguments: tuple[Any, ...], core: tuple[int, ...]) -> Any:
    """ufunc(*arguments) for numbers and plain arrays. core: how many last dimensions of each argument go into one call."""
    shapes = [np.shape(value)[:np.ndim(value) - own] for value, own in zip(arguments, core)]
    shape = np.broadcast_shapes(*shapes)
    size = math.prod(shape)
    if size <= FEW or len({type(value) for value in arguments} - {np.ndarray, np.float64, float, int}):
        return ufunc(*arguments)
    axis = int(np.argmax(shape))
    arrays = [np.moveaxis(np.broadcast_to(value, shape + np.shape(value)[np.ndim(value) - own:]), axis, 0) if own_shape else value
              for value, own, own_shape in zip(arguments, core, shapes)]
    results = tuple(np.empty(shape + own_shape) for own_shape in _own_shapes(ufunc))
    views = [np.moveaxis(result, axis, 0) for result in results]
    for part in blocks(shape[axis], FEW * shape[axis] // size):
        ufunc(*(value[part] if own_shape else value for value, own_shape in zip(arrays, shapes)), out=tuple(v[part] for v in views))
    return results if len(results) > 1 else results[0]


def beside(function: Callable[[], Any]) -> Any:
    """function() in a thread, for calls without blocks: Python reacts to Ctrl-C at once, and the result is then lost."""
    results: list[Any] = []
    worker = threading.Thread(target=lambda: results.append(function()), daemon=True)
    worker.start()
    while worker.is_alive():
        worker.join(SECONDS)
    return results[0]
