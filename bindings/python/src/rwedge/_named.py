# SPDX-License-Identifier: GPL-3.0-or-later
"""The criteria, lives and damages of the library by names of their own: thin forms of criterion(), life() and damage(), whose
constants are arguments, one by one. What they share with formulas is that of rwedge._ufuncs."""
from __future__ import annotations

import inspect
from typing import Any

import numpy as np

from ._made import Measure
from ._ufuncs import UFUNCS, Formula

CYCLE = "sxx syy txy "
# name: the function, the measure, the arguments in their order, the constants in the library's, how many results
NAMED: dict[str, tuple[str, Measure, str, tuple[Any, ...], int]] = {
    "smith_watson_topper": ("criterion", Measure.SWT_IN_PLANE, CYCLE + "E nu", ("E",), 2),
    "fatemi_socie": ("criterion", Measure.FATEMI_SOCIE_IN_PLANE, CYCLE + "E nu k_over_sy", ("E", "k_over_sy", 1), 2),
    "smith_watson_topper_planes": ("criterion", Measure.SWT, CYCLE + "E nu plane_stress", ("E",), 3),
    "fatemi_socie_planes": ("criterion", Measure.FATEMI_SOCIE, CYCLE + "E nu plane_stress k_over_sy", ("E", "k_over_sy", 1), 3),
    "findley": ("criterion", Measure.FINDLEY, CYCLE + "nu k", ("k",), 3),
    "modified_wohler": ("criterion", Measure.MODIFIED_WOHLER, CYCLE + "nu kappa lambda_ rho_lim", ("kappa", "lambda_", "rho_lim"), 3),
    "mcdiarmid": ("criterion", Measure.MCDIARMID, CYCLE + "nu t_A su", ("t_A", "su"), 3),
    "crossland": ("criterion", Measure.CROSSLAND, CYCLE + "nu alpha", ("alpha",), 1),
    "dang_van": ("criterion", Measure.DANG_VAN, CYCLE + "nu alpha", ("alpha",), 1),
    "smith_watson_topper_life": ("life", Measure.SWT, "swt E sf b ef c limit", ("E", "sf", "b", "ef", "c", "limit"), 1),
    "fatemi_socie_life": ("life", Measure.FATEMI_SOCIE, "fatemi_socie G tf b gf c limit", (1, 1, 1, "G", "tf", "b", "gf", "c", "limit"), 1),
    "smith_watson_topper_damage": ("damage", Measure.SWT, CYCLE + "E nu plane_stress sf b ef c limit",
                                   ("E", "sf", "b", "ef", "c", "limit"), 4),
    "fatemi_socie_damage": ("damage", Measure.FATEMI_SOCIE, CYCLE + "E nu plane_stress k_over_sy G tf b gf c limit",
                            ("E", "k_over_sy", 1, "G", "tf", "b", "gf", "c", "limit"), 4),
}
USUAL = {"rho_lim": 0.0}


class Named(Formula):
    """One of NAMED."""

    def __init__(self, name: str) -> None:
        function, self._measure, names, self._constants, self._results = NAMED[name]
        super().__init__(UFUNCS[function])
        self._function, self.__name__, self._own = function, name, names.split()
        self.__signature__ = inspect.Signature(
            [inspect.Parameter(each, inspect.Parameter.POSITIONAL_OR_KEYWORD, default=USUAL.get(each, inspect.Parameter.empty))
             for each in self._own])
        numbers = ", ".join(map(str, self._constants))
        self.__doc__ = f"""{name}({", ".join(self._own)})

The same as ``{function}(Measure.{self._measure.name}, [{numbers}], ...)``, which says what it is.

Source: ``{function}``."""

    def __call__(self, *values: Any, **options: Any) -> Any:
        own = self._bound(values, options)
        constants = np.stack(np.broadcast_arrays(*(own.get(each, each) for each in self._constants)), axis=-1)
        given = {"criterion": int(self._measure), "constants": constants, "plane_stress": 0, **own}
        if self._function == "life":
            given["parameter"] = own[self._own[0]]
        if isinstance(options.get("out"), tuple):
            options["out"] += (None,) * (self.ufunc.nout - len(options["out"]))
        results = self._evaluated(tuple(given[name] for name in self._names), options)
        if self._function == "life":
            return results
        if self._function == "damage":
            value, cycles, plane = results
            return value, cycles, plane[..., 0], plane[..., 1]
        return results[:self._results] if self._results > 1 else results[0]

    def _bound(self, values: tuple[Any, ...], options: dict[str, Any]) -> dict[str, Any]:
        """The arguments by their names, out of the options too."""
        by_name = {name: options.pop(name) for name in list(options) if name in self._own[len(values):]}
        own = {**USUAL, **dict(zip(self._own, values)), **by_name}
        missing = [name for name in self._own if name not in own]
        if missing or len(values) > len(self._own):
            raise TypeError(f"{self.__name__}() takes {', '.join(self._own)}: {len(values)} given by place, and "
                            f"{', '.join([*by_name, *options]) or 'none'} by name")
        return own
