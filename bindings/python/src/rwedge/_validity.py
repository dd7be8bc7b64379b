# SPDX-License-Identifier: GPL-3.0-or-later
"""What makes results doubtful, as Python's warnings."""
from __future__ import annotations

import math
import sys
import warnings

from ._library import function

_validity, _text = function("validity"), function("validity_text")


class ValidityWarning(UserWarning):
    """A result is doubtful: a large angle, dissimilar bodies with friction, yield, or units that look mixed. ``validity()`` has
    the limits; ``warnings.simplefilter("ignore", rwedge.ValidityWarning)`` silences it, "error" makes an exception of it.

    See Also
    --------
    validity, validity_text

    Examples
    --------
    >>> import warnings
    >>> import rwedge
    >>> with warnings.catch_warnings(record=True) as told:
    ...     warnings.simplefilter("always")
    ...     steep = rwedge.Contact(theta=0.2, a=2.0, A=1.82e-5, f=0.3)
    >>> print(told[0].message)
    theta is above 0.1 rad: the wedge is hardly a half-plane
    """


def outside() -> int:
    """The level, for who calls this and warnings.warn(), of the line that called the package."""
    level, frame = 0, sys._getframe(1)
    while frame.f_globals.get("__name__", "").startswith("rwedge.") and frame.f_back:
        level, frame = level + 1, frame.f_back
    return level + 1


def warn(theta: float = math.nan, alpha: float = math.nan, beta: float = math.nan, f: float = math.nan,
         safety: float = math.nan) -> None:
    """Says what is doubtful about a contact, to the line that called the package. NaN is not known."""
    doubts, bit = _validity(theta, alpha, beta, f, math.nan, safety), 1
    while doubts >= bit:
        if doubts & bit:
            warnings.warn(_text(bit).decode(), ValidityWarning, stacklevel=outside())
        bit *= 2
