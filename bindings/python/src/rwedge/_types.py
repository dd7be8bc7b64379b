# SPDX-License-Identifier: GPL-3.0-or-later
"""The types of arguments: NumPy's own ArrayLike has strings and complex numbers too."""
from __future__ import annotations

from typing import Any, Protocol, Sequence, SupportsFloat, Union

import numpy as np


class SupportsArray(Protocol):
    """Arrays of NumPy, pandas, xarray, Dask and so on."""

    def __array__(self) -> Any: ...


Scalar = Union[float, "np.floating[Any]", "np.integer[Any]"]
Numbers = Union[SupportsFloat, SupportsArray, Sequence[SupportsFloat], Sequence[Sequence[SupportsFloat]],
                Sequence[Sequence[Sequence[SupportsFloat]]]]
