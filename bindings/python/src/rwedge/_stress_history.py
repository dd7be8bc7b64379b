# SPDX-License-Identifier: GPL-3.0-or-later
"""Stresses at points through a history of loads, and the forms that other packages take them in."""
from __future__ import annotations

from typing import Any, Iterator, SupportsFloat

import numpy as np
from numpy.typing import NDArray

from ._criteria import Criteria
from ._library import real
from ._loads import Loads
from ._optional import need
from ._ufuncs import UFUNCS

NAMES = {"sxx": "stress along the surface", "syy": "stress normal to the surface", "txy": "shear stress",
         "szz": "stress across the plane", "P": "normal load", "M": "moment", "Q": "tangential load", "sigma": "bulk tension",
         "x": "place along the surface", "y": "depth"}


class StressHistory(Criteria):
    """Stresses at points while a contact goes through loads, as ``Contact.stresses_after`` and ``Cycle.stresses`` give them. Tension is positive.

    It unpacks into its components, ``sxx, syy, txy = stresses``, each an array of (load, point), where point stands for all
    dimensions of x and y. So ``rwedge.smith_watson_topper(*stresses, E, nu, axis=0)`` is Smith, Watson and Topper's parameter
    at every point.

    Attributes
    ----------
    stress : ndarray
        (load, point, component), the components being sxx, syy, txy; a stress
    loads : Loads
        P, Q force/length, M force, sigma stress: an array of all loads each
    x, y : ndarray
        the points, length, in their broadcast shape

    Criteria of fatigue, damage and lives at the points are methods. They take ``material``, a mapping with the constants that
    each names, and ``plane_stress``, which is for contacts with such a compliance; otherwise it is plane strain.

    Source: new.

    See Also
    --------
    Contact.stresses_after, Cycle.stresses : which make it

    Examples
    --------
    >>> import rwedge
    >>> pad = rwedge.Contact(theta=0.01, a=2.0, A=1.82e-5, f=0.3)
    >>> pad.load(2000)
    >>> stresses = pad.stresses_after({"P": 2000, "Q": [300, -300, 300]}, x=[-2, -1], y=0)
    >>> stresses
    <rwedge.StressHistory of 3 loads at 2 points>
    >>> stresses.stress.shape, stresses.voigt(nu=0.3).shape
    ((3, 2, 3), (3, 2, 6))
    >>> value, angle = rwedge.smith_watson_topper(*stresses, 205e3, 0.3, axis=0)
    >>> value.shape
    (2,)
    """

    loads: Loads
    x: NDArray[Any]
    y: NDArray[Any]
    stress: NDArray[np.float64]

    def __init__(self, loads: Loads, x: NDArray[Any], y: NDArray[Any], stress: NDArray[np.float64], labels: Any = None) -> None:
        self.loads, self.x, self.y, self.stress, self._labels = loads, x, y, stress, labels

    def __iter__(self) -> Iterator[NDArray[np.float64]]:
        return iter(np.moveaxis(self.stress, -1, 0))

    def __array__(self, dtype: Any = None, copy: Any = None) -> NDArray[Any]:
        if copy is False and dtype not in (None, self.stress.dtype):
            raise ValueError("another type of number needs a copy")
        return np.array(self.stress, dtype=dtype, copy=True) if copy else np.asarray(self.stress, dtype=dtype)

    def __repr__(self) -> str:
        return f"<rwedge.StressHistory of {self.stress.shape[0]} loads at {self.x.size} points>"

    @property
    def sxx(self) -> NDArray[np.float64]:
        """Stress along the surface, (load, point)."""
        return self.stress[..., 0]

    @property
    def syy(self) -> NDArray[np.float64]:
        """Stress normal to the surface, (load, point)."""
        return self.stress[..., 1]

    @property
    def txy(self) -> NDArray[np.float64]:
        """Shear stress, (load, point)."""
        return self.stress[..., 2]

    def szz(self, nu: SupportsFloat) -> NDArray[np.float64]:
        """The stress across the plane, (load, point): nu (sxx+syy) in plane strain; 0 in plane stress, for nu = 0.

        Parameters
        ----------
        nu : float
            Poisson's ratio of the half-plane, 0 <= nu <= 0.5

        Source: ``out_of_plane_stress``.
        """
        result: NDArray[np.float64] = UFUNCS["out_of_plane_stress"](self.sxx, self.syy, real("nu", nu))
        return result

    def voigt(self, nu: SupportsFloat) -> NDArray[np.float64]:
        """The full tensor, (load, point, 6), in Voigt's order xx, yy, zz, yz, xz, xy, as FatPy takes it. x is along the
        surface, y into the half-plane; yz and xz are 0.

        Parameters
        ----------
        nu : float
            Poisson's ratio of the half-plane, 0 <= nu <= 0.5; 0 for plane stress

        Source: ``out_of_plane_stress``; the order of Voigt (1910).
        """
        tensor = np.zeros((*self.stress.shape[:-1], 6))
        for place, component in ((0, self.sxx), (1, self.syy), (2, self.szz(nu)), (5, self.txy)):
            tensor[..., place] = component
        return tensor

    def to_pandas(self, nu: SupportsFloat) -> Any:
        """A frame with a row for each load and point, and the columns S11, S22, S33, S12, S13, S23, as pyLife takes it
        (``frame.equistress.mises()``). 1 is x, along the surface, 2 is y, into the half-plane. The index has the levels load
        and point; points of more dimensions are numbered row by row, those of a labelled Series have its labels. Needs
        pandas.

        Parameters
        ----------
        nu : float
            Poisson's ratio of the half-plane, 0 <= nu <= 0.5; 0 for plane stress
        """
        pandas = need("pandas", "StressHistory.to_pandas()")
        xx, yy, zz, yz, xz, xy = np.moveaxis(self.voigt(nu), -1, 0)
        points = getattr(self._labels, "index", None)
        points = range(self.x.size) if points is None else points
        index = pandas.MultiIndex.from_product([range(self.stress.shape[0]), points], names=["load", "point"])
        return pandas.DataFrame({"S11": xx.ravel(), "S22": yy.ravel(), "S33": zz.ravel(), "S12": xy.ravel(), "S13": xz.ravel(),
                                 "S23": yz.ravel()}, index=index)

    def to_xarray(self, nu: SupportsFloat | None = None, length: str = "mm", stress: str = "MPa") -> Any:
        """A Dataset of sxx, syy, txy, and with nu of szz, over load and the dimensions of the points: those of x and y where
        they have names, point otherwise. P, M, Q, sigma go along load. Each has a long_name and units. Needs xarray.

        Parameters
        ----------
        nu : float, optional
            Poisson's ratio of the half-plane, 0 <= nu <= 0.5; 0 for plane stress
        length, stress : str
            what the units are called; the others are made of them
        """
        xarray = need("xarray", "StressHistory.to_xarray()")
        dims, coordinates = getattr(self._labels, "dims", None), getattr(self._labels, "coords", {})
        if dims is None:
            dims = ["point"] if self.x.ndim == 1 else [f"point_{k}" for k in range(self.x.ndim)]
        force = f"{stress} {length}"
        units = {"P": force, "Q": force, "M": f"{force} {length}", "x": length, "y": length}

        def about(name: str) -> dict[str, str]:
            return {"long_name": NAMES[name], "units": units.get(name, stress)}

        values = {"sxx": self.sxx, "syy": self.syy, "txy": self.txy}
        if nu is not None:
            values["szz"] = self.szz(nu)
        places = {name: (dims, where, about(name)) for name, where in (("x", self.x), ("y", self.y)) if name not in coordinates}
        data = xarray.Dataset({name: (["load", *dims], value, about(name)) for name, value in values.items()},
                              {"load": np.arange(self.stress.shape[0]), **coordinates, **places,
                               **{name: ("load", value, about(name)) for name, value in self.loads._asdict().items()}})
        for name in ("x", "y"):
            data[name].attrs.update(about(name))
        return data
