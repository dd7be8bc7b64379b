# SPDX-License-Identifier: GPL-3.0-or-later
"""Criteria of fatigue at the points of a cycle, by the constants of a material."""
from __future__ import annotations

from typing import Any, Mapping, NamedTuple, SupportsFloat

import numpy as np
from numpy.typing import NDArray

from ._library import EDOMAIN, Error, real
from ._ufuncs import UFUNCS, Formula

Material = Mapping[str, SupportsFloat]
CURVES = {"swt": ("smith_watson_topper_damage", ("sf", "b", "ef", "c"), "swt_limit"),
          "fatemi-socie": ("fatemi_socie_damage", ("G", "tf", "b0", "gf", "c0"), "fs_limit")}


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

    def _measured(self, name: str, material: Material, plane_stress: bool, constants: tuple[Any, ...]) -> Any:
        """rwedge_name() at every point; constants are numbers, or names of constants of the material."""
        numbers = [self._constant(material, value) if isinstance(value, str) else value for value in constants]
        if plane_stress and "E" not in constants:
            numbers[0] = 0.0  # nu counts for the stress across the plane alone
        if "E" in constants:
            numbers.insert(2, int(plane_stress))
        errors: Any = {"invalid": "ignore"} if np.isnan(self.stress).any() else {}
        with np.errstate(**errors):
            return Formula(UFUNCS[name])(*np.moveaxis(self.stress, -1, 0), *numbers, axis=0)

    @staticmethod
    def _constant(material: Material, name: str) -> float:
        if name not in material:
            raise Error(f"the material has no {name}", EDOMAIN)
        return real(name, material[name])

    def _k_over_sy(self, material: Material) -> float:
        return real("fs_k", material.get("fs_k", 1)) / self._constant(material, "yield_stress")

    def smith_watson_topper(self, material: Material, plane_stress: bool = False) -> Plane:
        """Smith, Watson and Topper's parameter over all planes, a stress. Its strain is an amplitude. Constants: ``E``, ``nu``.
        Source: ``smith_watson_topper_planes``."""
        return Plane(*self._measured("smith_watson_topper_planes", material, plane_stress, ("E", "nu")))

    def fatemi_socie(self, material: Material, plane_stress: bool = False) -> Plane:
        """Fatemi and Socie's parameter over all planes. Its strain is an amplitude. Constants: ``E``, ``nu``, ``yield_stress``,
        and ``fs_k``, 1 where it is missing. Source: ``fatemi_socie_planes``."""
        constants = "E", "nu", self._k_over_sy(material)
        return Plane(*self._measured("fatemi_socie_planes", material, plane_stress, constants))

    def findley(self, material: Material, plane_stress: bool = False) -> Plane:
        """Findley's parameter, a stress: the largest amplitude of the shear + k times the largest normal stress. Constants:
        ``nu``, ``findley_k``. Source: ``findley``."""
        return Plane(*self._measured("findley", material, plane_stress, ("nu", "findley_k")))

    def modified_wohler(self, material: Material, plane_stress: bool = False) -> Plane:
        """Susmel's modified Wöhler curve, a stress: on the plane of the largest amplitude of the shear. Constants: ``nu``,
        ``kappa``. Source: ``modified_wohler``."""
        return Plane(*self._measured("modified_wohler", material, plane_stress, ("nu", "kappa")))

    def mcdiarmid(self, material: Material, plane_stress: bool = False) -> Plane:
        """McDiarmid's criterion, a ratio that is safe below 1. Constants: ``nu``, ``t_A``, ``su``. Source: ``mcdiarmid``."""
        return Plane(*self._measured("mcdiarmid", material, plane_stress, ("nu", "t_A", "su")))

    def crossland(self, material: Material, plane_stress: bool = False) -> NDArray[np.float64]:
        """Crossland's criterion, a stress: the amplitude of sqrt(J2) + alpha times the largest hydrostatic stress. Constants:
        ``nu``, ``crossland_alpha``. Source: ``crossland``."""
        value: NDArray[np.float64] = self._measured("crossland", material, plane_stress, ("nu", "crossland_alpha"))
        return value

    def dang_van(self, material: Material, plane_stress: bool = False) -> NDArray[np.float64]:
        """Dang Van's criterion, a stress: the largest shear about the centre of the path + alpha times the hydrostatic stress.
        Constants: ``nu``, ``dang_van_alpha``. Source: ``dang_van``."""
        value: NDArray[np.float64] = self._measured("dang_van", material, plane_stress, ("nu", "dang_van_alpha"))
        return value

    def damage(self, material: Material, criterion: str = "swt", plane_stress: bool = False) -> Damage:
        """Damage of a pass of the loads that repeats, by Miner's sum on the plane where it is largest. Cycles are counted by
        rainflow. 1/value passes are the life.

        Parameters
        ----------
        material : mapping
            constants by name, as in the files of ``rwedge fretting --material``: ``E``, ``nu``, and for "swt" ``sf``, ``b``,
            ``ef``, ``c``; for "fatemi-socie" ``yield_stress``, ``fs_k`` (1 where it is missing), ``G``, ``tf``, ``b0``, ``gf``,
            ``c0``. Below ``swt_limit`` and ``fs_limit``, where they are given, a cycle does no damage
        criterion : {"swt", "fatemi-socie"}
            which counts
        plane_stress : bool
            plane stress; plane strain otherwise

        Source: ``smith_watson_topper_damage``, ``fatemi_socie_damage``.

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
        if criterion not in CURVES:
            raise Error(f"criterion = {criterion!r}: must be one of {', '.join(CURVES)}", EDOMAIN)
        name, constants, limit = CURVES[criterion]
        k_over_sy = (self._k_over_sy(material),) if criterion == "fatemi-socie" else ()
        run_out = real(limit, material.get(limit, 0))
        return Damage(*self._measured(name, material, plane_stress, ("E", "nu", *k_over_sy, *constants, run_out)))

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
