# SPDX-License-Identifier: GPL-3.0-or-later
"""The paper's series, analytic or fitted."""
from __future__ import annotations

import ctypes
from typing import Any, SupportsFloat, SupportsIndex

import numpy as np
from numpy.typing import NDArray

from ._blocks import beside
from ._labels import Numbers, aligned, plain
from ._library import EDOMAIN, Error, check, function, integer, real
from ._made import SeriesMethods
from ._ufuncs import Points

_create, _fit, _destroy = (function("series_" + name) for name in ("create", "fit", "destroy"))
_coefficient, _potential = Points("series_coefficient"), Points("series_potential")


class Series(SeriesMethods):
    """A pressure p = -sqrt(1-x^2) sum_k a_k U_k(x), k = 0 ... terms-1, and its stresses.

    ``Series(alpha, terms)`` is the rounded wedge's own, cut after the first terms coefficients (the paper's b_n is a_(2n));
    ``Series.fit(x, p, terms)`` takes any pressure. It serves pressures that have no closed form, and checks those that have.
    Natural units: lengths in b, stresses in theta/A.

    Parameters
    ----------
    alpha : float
        a/b, finite, >= 0; 0 is the sharp wedge, >= 1 is Hertz' contact
    terms : int
        1 <= terms <= 2^24

    Raises
    ------
    ValueError
        (``rwedge.Error``) outside the domain
    TypeError, MemoryError

    Notes
    -----
    A series never changes: any number of threads may use it, and ``copy.copy`` and ``copy.deepcopy`` give the series itself. It
    cannot be pickled.

    Source: Eq. (29), (31) with E1; new.
    """

    def __init__(self, alpha: SupportsFloat, terms: SupportsIndex) -> None:
        alpha, terms, handle = real("alpha", alpha), integer("terms", terms), ctypes.c_void_p()
        check("series_create", _create(alpha, terms, ctypes.byref(handle)), {"alpha": alpha, "terms": terms})
        self._adopt(handle, _destroy)

    @classmethod
    def fit(cls, x: Numbers, p: Numbers, terms: SupportsIndex) -> Series:
        terms = integer("terms", terms)
        places, pressures = (np.atleast_1d(plain(samples)) for samples in aligned((x, p))[0])
        if places.ndim != 1 or places.shape != pressures.shape:
            raise Error(f"x has the shape {places.shape}, p {pressures.shape}: they must be of one dimension and the same length")
        series, handle = cls.__new__(cls), ctypes.c_void_p()
        status = beside(lambda: _fit(places.size, places.ctypes.data, pressures.ctypes.data, terms, ctypes.byref(handle)))
        if status == EDOMAIN:
            first = np.argmin((abs(places) < 1) & np.isfinite(pressures))
            check("series_fit", status, {"x": places[first], "p": pressures[first]}, f"[{first}]")
        check("series_fit", status, {"samples": places.size, "terms": terms})
        series._adopt(handle, _destroy)
        return series

    def __copy__(self) -> Series:
        return self

    def __deepcopy__(self, memo: dict[int, Any]) -> Series:
        return self

    def __repr__(self) -> str:
        return f"<rwedge.Series of {self.terms} terms, residual {self.residual}>"

    @property
    def coefficients(self) -> NDArray[Any]:
        """The coefficients a_k, k = 0 ... terms-1."""
        return _coefficient(self._address, np.arange(self.terms))

    def potential(self, f: Numbers, x: Numbers, y: Numbers) -> NDArray[Any]:
        real_part, imaginary_part = _potential(self._address, f, x, y)
        return real_part + 1j * imaginary_part
