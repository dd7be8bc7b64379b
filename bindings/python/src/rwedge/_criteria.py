# SPDX-License-Identifier: GPL-3.0-or-later
"""Criteria of fatigue at the points of a cycle, by the constants of a material."""
from __future__ import annotations

import ctypes
import difflib
import math
from typing import Any, Mapping, NamedTuple, NoReturn, SupportsFloat

import numpy as np
from numpy.typing import NDArray

from ._library import EDOMAIN, Error, real
from ._library import function as library_function
from ._ufuncs import UFUNCS, Formula

Material = Mapping[str, SupportsFloat]
SMALLEST = 1e-60  # but for 0, nothing that has a size is smaller


def _constants(number: int, count: int) -> tuple[str, ...]:
    return tuple(library_function("constant_name")(number, j).decode() for j in range(count))


# As the library has them: a measure by its name; the constants of each by its number, and those of its damage.
NUMBERS = {library_function("criterion_name")(i).decode(): i for i in range(library_function("criterion_count")())}
OWN = {i: _constants(i, library_function("criterion_constants")(i)) for i in NUMBERS.values()}
OF_DAMAGE = {i: _constants(i, library_function("damage_constants")(i)) for i in NUMBERS.values()}
LIMITS = {library_function("criterion_limit")(i).decode() for i in NUMBERS.values()}
# What else the material of a file may have.
KNOWN = {"name", "source", "units", "nu", "dK_th", "ds0", "paris_C", "paris_m", "K_c", *LIMITS, *(name for names in (*OWN.values(), *OF_DAMAGE.values()) for name in names)}


def _numbered(criterion: str, among: Mapping[str, int]) -> int:
    """The number of a name, also as the tool's options have it: "fatemi-socie"."""
    name = str(criterion).replace("-", "_")
    if name not in among:
        raise Error(f"criterion = {criterion!r}: must be one of {', '.join(among)}", EDOMAIN)
    return among[name]


def _mind_units(number: int, constants: Mapping[str, float]) -> None:
    """E is a hundred times such a stress or more in metals: below ten times it is in another unit. The tool refuses it too."""
    for j, (name, value) in enumerate(constants.items()):
        if name not in ("E", "G") and library_function("constant_unit")(number, j) == b"stress" and value * 10 > constants.get("E", math.inf):
            raise Error(f"the material has E = {constants['E']:g}, less than ten times {name} = {value:g}: is it in GPa? One unit for both is "
                        "needed", EDOMAIN)


class Plane(NamedTuple):
    """A criterion and the plane where it is largest, at each point. The plane's normal is (cos(o) sin(a), cos(o) cos(a), sin(o))
    with a = angle, o = out_of_plane, rad."""

    value: NDArray[np.float64]
    angle: NDArray[np.float64]
    out_of_plane: NDArray[np.float64]


class Damage(NamedTuple):
    """Miner's sum of a pass of the loads on the plane where it is largest, how many cycles that plane has, and its angles as
    in Plane, at each point."""

    value: NDArray[np.float64]
    cycles: NDArray[np.float64]
    angle: NDArray[np.float64]
    out_of_plane: NDArray[np.float64]


class Criteria:
    """Methods of a class that has stresses, (load, point, component)."""

    stress: NDArray[np.float64]

    def _measured(self, function: str, number: int, material: Material, plane_stress: bool, names: tuple[str, ...]) -> Any:
        """rwedge_criterion() or rwedge_damage() at every point, by the constants of these names."""
        if isinstance(material, str):
            raise TypeError(f"material is the text {material!r}: it must be a dict of constants, such as that of read_case(material=...)")
        unknown = sorted(set(material) - KNOWN)
        if unknown:
            near = difflib.get_close_matches(unknown[0], KNOWN, 1)
            hint = f": did you mean {near[0]}?" if near else f"; known are {', '.join(sorted(KNOWN - {'1', ''}))}"
            raise Error(f"the material has {unknown[0]}, which is no constant that is known{hint}", EDOMAIN)
        constants = [self._constant(material, number, j, name) for j, name in enumerate(names)]
        _mind_units(number, dict(zip(names, constants)))
        nu = real("nu", material["nu"]) if "nu" in material else self._missing("nu")
        errors: Any = {"invalid": "ignore"} if np.isnan(self.stress).any() else {}
        with np.errstate(**errors):
            return Formula(UFUNCS[function])(number, constants, *np.moveaxis(self.stress, -1, 0), nu, int(plane_stress), axis=0)

    @staticmethod
    def _missing(name: str) -> NoReturn:
        raise Error(f"the material has no {name}", EDOMAIN)

    def _constant(self, material: Material, number: int, j: int, name: str) -> float:
        """One that the material has, or the usual one; in its range."""
        value = real(name, material[name] if name in material else library_function("constant_usual")(number, j))
        if name not in material and math.isnan(value):
            self._missing(name)
        low, high = ctypes.c_double(), ctypes.c_double()
        library_function("constant_range")(number, j, ctypes.byref(low), ctypes.byref(high))
        if not (low.value <= value <= high.value and (value == 0 or abs(value) >= SMALLEST)):
            zero = "0, or 1e-60" if low.value == 0 else f"{low.value:g}"
            raise Error(f"the material has {name} = {value:g}: allowed is {zero} to {high.value:g}", EDOMAIN)
        return value

    def criterion(self, material: Material, criterion: str, plane_stress: bool = False) -> Plane:
        """A criterion by its name, such as "findley", over all planes. Constants: ``nu``, and those of the criterion, by the names
        that ``constant_name`` tells.

        Parameters
        ----------
        material : mapping
            constants by name, as in the files of ``rwedge fretting --material``; others than the criterion's are left alone, others
            than the known ones refused
        criterion : str
            its name, as ``criterion_name`` tells it
        plane_stress : bool
            plane stress; plane strain otherwise

        Source: ``criterion``.
        """
        number = _numbered(criterion, {name: i for name, i in NUMBERS.items() if library_function("criterion_unit")(i) in (b"stress", b"none")})
        return Plane(*self._measured("criterion", number, material, plane_stress, OWN[number]))

    def smith_watson_topper(self, material: Material, plane_stress: bool = False) -> Plane:
        """Smith, Watson and Topper's parameter over all planes, a stress. Its strain is an amplitude. Constants: ``E``, ``nu``.
        Source: ``criterion``."""
        return self.criterion(material, "swt", plane_stress)

    def fatemi_socie(self, material: Material, plane_stress: bool = False) -> Plane:
        """Fatemi and Socie's parameter over all planes. Its strain is an amplitude. Constants: ``E``, ``nu``, ``yield_stress``,
        and ``fs_k``, 1 where it is missing. Source: ``criterion``."""
        return self.criterion(material, "fatemi_socie", plane_stress)

    def findley(self, material: Material, plane_stress: bool = False) -> Plane:
        """Findley's parameter, a stress: the largest amplitude of the shear + k times the largest normal stress. Constants:
        ``nu``, ``findley_k``. Source: ``criterion``."""
        return self.criterion(material, "findley", plane_stress)

    def modified_wohler(self, material: Material, plane_stress: bool = False) -> Plane:
        """Susmel's modified Wöhler curve, a stress: on the plane of the largest amplitude of the shear. Constants: ``nu``,
        ``kappa``, ``lambda``, and ``rho_lim``, lambda/(2 kappa) where it is missing. Source: ``criterion``."""
        return self.criterion(material, "modified_wohler", plane_stress)

    def mcdiarmid(self, material: Material, plane_stress: bool = False) -> Plane:
        """McDiarmid's criterion, a ratio that is safe below 1. Constants: ``nu``, ``t_A``, ``su``. Source: ``criterion``."""
        return self.criterion(material, "mcdiarmid", plane_stress)

    def crossland(self, material: Material, plane_stress: bool = False) -> NDArray[np.float64]:
        """Crossland's criterion, a stress: the amplitude of sqrt(J2) + alpha times the largest hydrostatic stress. Constants:
        ``nu``, ``crossland_alpha``. Source: ``criterion``."""
        return self.criterion(material, "crossland", plane_stress).value

    def dang_van(self, material: Material, plane_stress: bool = False) -> NDArray[np.float64]:
        """Dang Van's criterion, a stress: the largest shear about the centre of the path + alpha times the hydrostatic stress.
        Constants: ``nu``, ``dang_van_alpha``. Source: ``criterion``."""
        return self.criterion(material, "dang_van", plane_stress).value

    def damage(self, material: Material, criterion: str = "swt", plane_stress: bool = False) -> Damage:
        """Damage of a pass of the loads that repeats, by Miner's sum on the plane where it is largest. Cycles are counted by
        rainflow. 1/value passes are the life.

        Parameters
        ----------
        material : mapping
            constants by name, as in the files of ``rwedge fretting --material``: ``E``, ``nu``, and for "swt" ``sf``, ``b``,
            ``ef``, ``c``; for "fatemi_socie" ``yield_stress``, ``fs_k`` (1 where it is missing), ``G``, ``tf``, ``b0``, ``gf``,
            ``c0``. Below ``swt_limit`` and ``fs_limit``, where they are given, a cycle does no damage
        criterion : {"swt", "fatemi_socie"}
            which counts
        plane_stress : bool
            plane stress; plane strain otherwise

        Source: ``damage``.

        Examples
        --------
        >>> import rwedge
        >>> metal = {"E": 162e3, "nu": 0.3, "sf": 475.4, "b": -0.078, "ef": 0.612, "c": -0.62}
        >>> pad = rwedge.Contact(theta=0.01, a=2.0, A=1.82e-5, f=0.6)
        >>> pad.load(2000)
        >>> stresses = pad.stresses_after({"P": 2000, "Q": [900, -900, 300, -300]}, x=-pad.half_width, y=0)
        >>> float(stresses.damage(metal).cycles)
        2.0
        """
        laws = {name: number for name, number in NUMBERS.items() if OF_DAMAGE[number]}
        number = _numbered(criterion, laws)
        value, cycles, plane = self._measured("damage", number, material, plane_stress, OF_DAMAGE[number])
        return Damage(value, cycles, plane[..., 0], plane[..., 1])

    def life(self, material: Material, criterion: str = "swt", plane_stress: bool = False) -> NDArray[np.float64]:
        """How many passes of the loads until failure: one over ``damage``, infinite where there is none.

        Parameters
        ----------
        material, criterion, plane_stress
            as in ``damage``

        Source: ``damage``.
        """
        with np.errstate(divide="ignore"):
            return np.divide(1.0, self.damage(material, criterion, plane_stress).value)
