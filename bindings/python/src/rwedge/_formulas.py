# SPDX-License-Identifier: GPL-3.0-or-later
"""The ufuncs of all functions of the header that take and return nothing but numbers, and those of a cycle. They are attributes of
this module, because pickle looks for a ufunc by its name in every module.
"""
import numpy as np

from ._header import FUNCTIONS
from ._ufuncs import ufunc

UFUNCS = {name: ufunc(name) for name, about in FUNCTIONS.items() if about["made"] in ("ufunc", "gufunc")}


def __getattr__(name: str) -> np.ufunc:
    if name not in UFUNCS:
        raise AttributeError(f"module {__name__} has no attribute {name}")
    return UFUNCS[name]
