# SPDX-License-Identifier: GPL-3.0-or-later
"""A cycle of loads of a contact."""
from __future__ import annotations

import ctypes
import math
from collections.abc import Mapping
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from ._labels import Numbers, aligned, plain
from ._library import OK, check, function
from ._loads import History, Loads, columns, given_columns, rig_columns
from ._made import CycleMethods
from ._stress_history import StressHistory

if TYPE_CHECKING:
    from ._contact import Contact

_create, _create_driven, _create_guided = function("cycle_create"), function("cycle_create_driven"), function("cycle_create_guided")
_destroy = function("cycle_destroy")


class Friction(NamedTuple):
    """What friction does at places of the surface in a cycle, each in the shape of the places."""

    slip_range: NDArray[np.float64]
    ruiz_f1: NDArray[np.float64]
    ruiz_f2: NDArray[np.float64]
    energy: NDArray[np.float64]


class _Growth(NamedTuple):
    arrest: float
    cycles: float
    least: float
    least_at: float


class Growth(_Growth):
    """How a crack grows: ``arrest`` is the length where it stops, ``cycles`` being infinite then, or breaks; infinite where it
    reaches the final length. ``least`` is the smallest range of K over the threshold, at the length ``least_at``."""

    shear: int
    initial: float
    final: float

    @property
    def verdict(self) -> str:
        """A sentence, with its assumption."""
        said = f"{_ASSUMPTIONS[self.shear]} the crack "
        closest = f"closest to the threshold, {self.least:.3g}, at {self.least_at:.4g}" * math.isfinite(self.least)
        if math.isinf(self.cycles) and self.arrest == self.initial:
            return f"{said}does not grow from {self.initial:.4g}: dK is as small as {self.least:.3g} of the threshold, at {self.least_at:.4g}"
        if math.isinf(self.cycles) and math.isfinite(self.arrest):
            return f"{said}arrests at {self.arrest:.4g}"
        end = f"breaks at {self.arrest:.4g}" if math.isfinite(self.arrest) else f"grows through to {self.final:.4g}"
        return f"{said}{end}, in {self.cycles:.6g} cycles" + f"; {closest}" * bool(closest)


_LAW = ("dK_th", "ds0", "C", "m", "K_c")
_ASSUMPTIONS = ("By mode I", "With K_II while it is open", "With K_II of free faces")


class Cycle(CycleMethods):
    """What a contact undergoes in a cycle of loads, which it starts as it is; the contact itself stays as it is.

    For a steady state load the contact with the cycle first: once under constant P and M, twice where they change, some times
    more where loads have no closed form.

    Parameters
    ----------
    contact : Contact
        it may change, or go, while the cycle is there
    loads : mapping, frame, or array_like
        P, M, Q, sigma as ``Contact.stresses_after`` takes them

    Raises
    ------
    ValueError
        (``rwedge.Error``) where ``Contact.apply`` does. The message names the load
    MemoryError

    Notes
    -----
    A cycle goes through the loads once, when it is made; its questions then take the time of their places. It never changes:
    any number of threads may ask it at a time. It cannot be pickled: send the contact and the loads.

    Source: lib/README.md, "Cycles"; new.

    Examples
    --------
    >>> import rwedge
    >>> pad = rwedge.Contact(theta=0.01, a=2.0, A=1.82e-5, f=0.3)
    >>> pad.apply(2000, 0, [0, 300, -300], 0)
    >>> cycle = rwedge.Cycle(pad, {"P": 2000, "Q": [300, -300]})
    >>> cycle
    <rwedge.Cycle of 2 loads>
    >>> left, right = cycle.permanent_stick
    >>> left == -right
    True
    >>> cycle.friction([0.0, 1.9]).slip_range > 0
    array([False,  True])
    """

    def __init__(self, contact: Contact, loads: History) -> None:
        arrays, handle = given_columns(loads), ctypes.c_void_p()
        with contact._lock:
            history = columns(arrays, contact.loads)
            status = _create(contact._address, len(history[0]), *(column.ctypes.data for column in history), ctypes.byref(handle))
            if status != OK:
                nowhere = np.empty(0)
                contact._find_fault(history, nowhere, nowhere)
            check("cycle_create", status, {"loads": len(history[0])})
        self._adopt(handle, _destroy)
        self._loads = Loads(*history)  # type: ignore[arg-type]

    @classmethod
    def guided(cls, contact: Contact, loads: Mapping[str, Any]) -> Cycle:
        arrays, handle, cycle = rig_columns(loads, "tilt", "M"), ctypes.c_void_p(), cls.__new__(cls)
        with contact._lock:
            P, tilt, Q, sigma = columns(arrays, contact.loads)
            status = _create_guided(contact._address, len(P), *(column.ctypes.data for column in (P, tilt, Q, sigma)), ctypes.byref(handle))
            check("cycle_create_guided", status, {"loads": len(P)})
            going = contact.copy()
        cycle._adopt(handle, _destroy)
        M = np.empty_like(P)
        for i, load in enumerate(zip(P, tilt, Q, sigma)):
            going.guide(*map(float, load))
            M[i] = going.loads.M
        cycle._loads = Loads(P, M, Q, sigma)  # type: ignore[arg-type]
        return cycle

    @classmethod
    def driven(cls, contact: Contact, loads: Mapping[str, Any], compliance: float) -> Cycle:
        arrays, handle, cycle = rig_columns(loads, "displacement", "Q"), ctypes.c_void_p(), cls.__new__(cls)
        with contact._lock:
            P, M, displacement, sigma = columns(arrays, contact.loads)
            status = _create_driven(contact._address, len(P), *(column.ctypes.data for column in (P, M, sigma, displacement)),
                                    ctypes.c_double(compliance), ctypes.byref(handle))
            check("cycle_create_driven", status, {"loads": len(P), "compliance": compliance})
        cycle._adopt(handle, _destroy)
        cycle._loads = Loads(P, M, displacement, sigma)  # type: ignore[arg-type]
        cycle._loads = Loads(P, M, cycle.forces, sigma)  # type: ignore[arg-type]
        return cycle

    def __len__(self) -> int:
        return len(self._loads.P)  # type: ignore[arg-type]

    @property
    def loads(self) -> Loads:
        """P, Q force/length, M force, sigma stress: an array of all loads each. Source: new."""
        return self._loads

    def __repr__(self) -> str:
        return f"<rwedge.Cycle of {len(self)} loads>"

    def stresses(self, x: Numbers, y: Numbers) -> StressHistory:
        points, labelled = aligned((x, y))
        x, y = np.broadcast_arrays(*map(plain, points))
        labels = None if labelled is None else labelled(np.zeros(x.shape))
        known = ~(np.isnan(x) | np.isnan(y))
        stress = np.full((3, len(self), *x.shape), math.nan)
        stress[:, :, known] = self._call("cycle_stresses", x[known], y[known])
        return StressHistory(self.loads, x, y, np.moveaxis(stress, 0, -1), labels)

    def growth(self, x: float, angle: float, shear: int, law: Mapping[str, float] | Numbers, initial: float,
               final: float) -> Growth:
        return self._grow("cycle_growth", x, angle, shear, law, initial, final)

    def closing_growth(self, x: float, angle: float, shear: int, law: Mapping[str, float] | Numbers, initial: float,
                       final: float) -> Growth:
        return self._grow("cycle_closing_growth", x, angle, shear, law, initial, final)

    def _grow(self, name: str, x: float, angle: float, shear: int, law: Mapping[str, float] | Numbers, initial: float,
              final: float) -> Growth:
        if isinstance(law, Mapping):
            given = {"ds0": math.inf, "K_c": math.inf, **law}
            if given.keys() != set(_LAW):
                raise TypeError(f"law has {', '.join(given)}: it must have {', '.join(_LAW)}")
            law = [given[name] for name in _LAW]
        growth = Growth(*self._call(name, x, angle, shear, law, initial, final))
        growth.shear, growth.initial, growth.final = int(shear), float(initial), float(final)
        return growth

    def friction(self, x: Numbers) -> Friction:
        points, labelled = aligned((x,))
        x = plain(points[0])
        known, results = ~np.isnan(x), np.full((4, *np.shape(x)), math.nan)
        results[:, known] = self._call("cycle_friction", x[known])
        return Friction(*(results if labelled is None else map(labelled, results)))
