# SPDX-License-Identifier: GPL-3.0-or-later
"""What makes results doubtful, as Python's warnings."""
from __future__ import annotations

import math
import warnings

from ._library import function

_validity, _text = function("validity"), function("validity_text")


class ValidityWarning(UserWarning):
    """A result is doubtful: a large angle, dissimilar bodies with friction, yield, or units that look mixed. ``validity()`` has
    the limits; ``warnings.simplefilter("ignore", rwedge.ValidityWarning)`` silences it, "error" makes an exception of it."""


def warn(theta: float = math.nan, alpha: float = math.nan, beta: float = math.nan, f: float = math.nan,
         safety: float = math.nan, level: int = 3) -> None:
    """Says what is doubtful about a contact, to who called the function that calls this one, or that of the level. NaN is not
    known."""
    doubts, bit = _validity(theta, alpha, beta, f, math.nan, safety), 1
    while doubts >= bit:
        if doubts & bit:
            warnings.warn(_text(bit).decode(), ValidityWarning, stacklevel=level)
        bit *= 2
