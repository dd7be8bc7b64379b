# SPDX-License-Identifier: GPL-3.0-or-later
"""A contact with a load history."""
from __future__ import annotations

import contextlib
import copyreg
import ctypes
import math
import os
import threading
import weakref
from typing import Any, NamedTuple, SupportsFloat, TypeVar

import numpy as np
from numpy.typing import NDArray

from ._blocks import FEW, blocks
from ._cycle import Cycle
from ._header import FUNCTIONS
from ._labels import Numbers, aligned, plain
from ._library import EDOMAIN, EPATH, ERANGE, OK, AbsentError, Error, PathError, check, function, real
from ._loads import Columns, History, Loads, columns, given_columns
from ._made import ContactMethods, Pad, _contact_stresses
from ._renamed import now_called
from ._stress_history import StressHistory
from ._ufuncs import Points
from ._validity import warn

_copy, _destroy = function("contact_copy"), function("contact_destroy")
_load, _apply, _obstacle = (function("contact_" + name) for name in ("load", "apply", "obstacle"))
_stress_history = function("contact_stress_history")
_loads, _restore = function("contact_loads"), function("contact_restore")
_kind, _pad = function("contact_kind"), function("contact_pad")
_formula_half_width = function("half_width")


Self = TypeVar("Self", bound="Contact")


class YieldFactor(NamedTuple):
    """How far a state is from first yield, and where that would be."""

    factor: float
    x: float
    y: float


class _Pad(NamedTuple):
    """What a contact is: the numbers that its kind of pad does not have are 0."""

    kind: Pad
    theta: float
    a: float
    R: float
    A: float
    f: float


def _pad_of(handle: ctypes.c_void_p) -> _Pad:
    numbers = [ctypes.c_double() for _ in range(5)]
    check("contact_pad", _pad(handle, *map(ctypes.byref, numbers)))
    return _Pad(Pad(_kind(handle)), *(number.value for number in numbers))


def _restored(kind: type[Contact], state: NDArray[Any]) -> Contact:
    """The pickled contact. It is a function of the module: cloudpickle, which Dask and Ray take, cannot send a bound method."""
    return kind.restore(state)


_contacts: weakref.WeakSet[Any] = weakref.WeakSet()
_adding, _held = threading.RLock(), contextlib.ExitStack()


def _hold_all() -> None:
    """os.fork waits until no contact is in a call: the new process would wait for a thread that it does not have."""
    _held.enter_context(_adding)  # before the locks of contacts: _begin, which takes it too, has none of these
    for contact in _contacts:
        _held.enter_context(contact._lock)


def _let_all_go() -> None:
    _held.pop_all().close()  # of another stack, as the next fork may use this one before the last lock is open


if hasattr(os, "register_at_fork"):
    os.register_at_fork(before=_hold_all, after_in_parent=_let_all_go, after_in_child=_let_all_go)


class Contact(ContactMethods):
    """One contact and what it remembers of its loads: exact where there is a closed form, computed where there is none.

    Any consistent set of units: x, y are lengths in the unit of a, stresses in that of 1/A, loads are forces per unit length;
    0 is the centre of the contact. Pressure is negative in compression.

    Parameters
    ----------
    theta : float
        angle between flank and surface, rad, 0 < theta < pi/2; the theory is that of small angles
    a : float
        half-width of the rounding, length, finite, >= 0; 0 is the sharp wedge: ``rounding(theta, R)``
    A : float
        composite compliance, 1/stress, finite, > 0: ``compliance(E1, nu1, E2, nu2)``
    f : float
        coefficient of friction, 0 <= f <= 1e6
    beta : float, optional
        ``dundurs_beta(E1, nu1, E2, nu2)``, to be warned where dissimilar bodies have friction, as that coupling is neglected;
        left out where ``set_bodies()`` or ``set_beta()`` follows, which take it into account
    tolerance : float, optional
        of q over f times the peak pressure, 1e-6 to 1e-2: how exactly loads without a closed form are computed (``error``); 0
        refuses them with ``PathError``. ``allow_error()`` changes it, and a copy and a restored contact have it too

    Raises
    ------
    ValueError
        (``rwedge.Error``) outside the domain; the message names the arguments and what is allowed
    TypeError, MemoryError

    Warns
    -----
    ValidityWarning
        where the angle is too large for a half-plane, bodies are dissimilar, a/b looks as if units were mixed (``load``), or the
        contact yields (``yield_factor``)

    Notes
    -----
    A contact is created without load, separated, and freed with its last reference. ``copy()``, ``copy.copy`` and
    ``copy.deepcopy`` give an independent one, history and all, with the attributes of a subclass. A pickled contact goes on to
    the same bits, by ``state()``.

    Threads: different contacts are independent, and their methods release the GIL. Calls for one contact from several
    threads are safe, and wait for each other; to read one at the same time, give each thread a copy. ``os.fork`` waits for
    the calls that other threads are in.

    Bodies of two materials under a bulk tension: before the first load ``set_strain((1 - nu1**2) / E1)``, E1 and nu1 of the
    half-plane. ``set_bodies(E1, nu1, E2, nu2)`` sets that and their coupling: exact in full sliding, else computed to the
    tolerance. Press such a contact along P first. ``set_thickness(t, P)`` takes a layer for the half-plane, under a constant P.

    Source: Sec. 3.2 for Q growing under constant P; all other histories are new, lib/README.md "Load histories".

    Examples
    --------
    >>> contact = Contact(theta=0.01, a=2.0, A=1.82e-5, f=0.3)
    >>> contact.load(P=2000)
    >>> contact.load(P=2000, Q=300)
    >>> p, q = contact.tractions([0.0, 1.0])
    >>> contact.error
    0.0
    """

    def __init__(self, theta: SupportsFloat, a: SupportsFloat, A: SupportsFloat, f: SupportsFloat,
                 beta: SupportsFloat = math.nan, tolerance: SupportsFloat = 1e-4) -> None:
        self._make("contact_create", tolerance, theta=theta, a=a, A=A, f=f)
        warn(theta=self.theta, f=self.f, beta=real("beta", beta))

    @classmethod
    def cylinder(cls: type[Self], R: SupportsFloat, A: SupportsFloat, f: SupportsFloat, tolerance: SupportsFloat = 1e-4) -> Self:
        """A contact of a cylinder of the radius R: ``flat`` with a = 0. Source: new."""
        return cls.flat(0.0, R, A, f, tolerance)

    @classmethod
    def flat(cls: type[Self], a: SupportsFloat, R: SupportsFloat, A: SupportsFloat, f: SupportsFloat,
             tolerance: SupportsFloat = 1e-4) -> Self:
        return cls.__new__(cls)._make("contact_create_flat", tolerance, a=a, R=R, A=A, f=f)

    @classmethod
    def profile(cls: type[Self], x: Numbers, slope: Numbers, A: SupportsFloat, f: SupportsFloat,
                tolerance: SupportsFloat = 1e-4) -> Self:
        places, slopes = (plain(column).ravel() for column in (x, slope))
        if places.size != slopes.size:
            raise Error(f"x has {places.size} places, and slope {slopes.size}", EDOMAIN)
        if not 2 <= places.size <= 1000 or slopes[0] == slopes[-1]:
            raise Error(f"{places.size} places, slopes from {slopes[:1]} to {slopes[-1:]}: 2 to 1000 places, not all of one slope", EDOMAIN)
        grows = (np.diff(places) >= 0) & (np.diff(slopes) >= 0)
        if not grows.all():
            i = int(np.argmin(grows)) + 1
            raise Error(f"x[{i}] = {places[i]}, slope[{i}] = {slopes[i]}: a place or a slope is less than the one before", EDOMAIN)
        arrays = places.size, places.ctypes.data, slopes.ctypes.data
        return cls.__new__(cls)._make("contact_create_profile", tolerance, *arrays, A=A, f=f)

    def _make(self: Self, name: str, tolerance: SupportsFloat, *arrays: Any, **numbers: SupportsFloat) -> Self:
        """Takes an object by the library's function of that name, which has the arrays first."""
        values, handle = {key: real(key, value) for key, value in numbers.items()}, ctypes.c_void_p()
        check(name, function(name)(*arrays, *values.values(), ctypes.byref(handle)), values)
        self._begin(handle)
        self.allow_error(tolerance)
        return self

    def _begin(self, handle: ctypes.c_void_p) -> None:
        self._lock = threading.RLock()
        self._adopt(handle, _destroy)
        self._pad = _pad_of(handle)
        with _adding:
            _contacts.add(self)

    def copy(self: Self) -> Self:
        """An independent copy, history and all: to try a load and go back. The attributes of a subclass are shared."""
        twin = type(self).__new__(type(self))
        with self._lock:
            twin.__dict__.update(self.__dict__)
            for name, value in self._slots().items():
                setattr(twin, name, value)
            handle = self._copied()
        twin._begin(handle)
        return twin

    def _copied(self) -> ctypes.c_void_p:
        handle = ctypes.c_void_p()
        check("contact_copy", _copy(self._address, ctypes.byref(handle)))
        return handle

    def _slots(self) -> dict[str, Any]:
        """The attributes that a subclass keeps in __slots__."""
        names: list[str] = getattr(copyreg, "_slotnames")(type(self))  # which copy and pickle ask, too
        return {name: getattr(self, name) for name in names if hasattr(self, name)}

    __copy__ = copy  # deepcopy and pickle go by __reduce__

    def __repr__(self) -> str:
        pad = self._pad
        maker, own = {Pad.WEDGE: ("", "theta a"), Pad.CYLINDER: (".cylinder", "R"), Pad.FLAT: (".flat", "a R"),
                      Pad.PROFILE: (".profile", "")}[pad.kind]
        parameters = ", ".join(f"{name}={getattr(pad, name)}" for name in [*own.split(), "A", "f"])
        return f"<rwedge.Contact{maker} {parameters}, at P={self.P}, Q={self.Q}>"

    def load(self, P: Numbers, Q: Numbers = 0.0) -> None:
        if np.ndim(P) or np.ndim(Q):  # type: ignore[arg-type]
            return self._load_all({"P": P, "Q": Q})
        P, Q = real("P", P), real("Q", Q)  # type: ignore[arg-type]
        warn(alpha=self._alpha(P))
        with self._lock:
            check("contact_load", _load(self._address, P, Q), {"P": P, "Q": Q})

    def apply(self, P: Numbers, M: Numbers, Q: Numbers, sigma: Numbers) -> None:
        if any(map(np.ndim, (P, M, Q, sigma))):  # type: ignore[arg-type]
            return self._load_all({"P": P, "M": M, "Q": Q, "sigma": sigma})
        loads = Loads(*map(real, Loads._fields, (P, M, Q, sigma)))  # type: ignore[arg-type]
        warn(alpha=self._alpha(loads.P))
        with self._lock:
            self._check_loads(self._address, loads)

    def _alpha(self, P: float) -> float:
        kind, theta, a, _, A, _ = self._pad
        b = _formula_half_width(theta, a, A, P) if kind == Pad.WEDGE else 0
        return a / b if b > 0 else math.nan

    def _check_loads(self, address: Any, loads: Loads, place: str = "") -> None:
        """Loads the contact, this one or a copy, or raises an error that says which load is refused, and why."""
        status = _apply(address, *loads)
        if status == EPATH:
            refused = ", ".join(f"{name}{place} = {value}" for name, value in loads._asdict().items())
            computed = "or have it computed: Contact(..., tolerance=1e-4)"
            raise PathError(f"{refused}: no closed form: {_obstacle(address, *loads).decode()}; {computed}", status)
        check("contact_apply", status, loads._asdict(), place)

    def _load_all(self, loads: dict[str, Any]) -> None:
        arrays = given_columns(loads)
        with self._lock:
            history = columns(arrays, self.loads)
            self._warn_of(history)
            nowhere = np.empty(0)
            self._through(history, nowhere, nowhere, np.empty((3, len(history[0]), 0)))

    def _warn_of(self, history: Columns) -> None:
        """Warns of doubts about the smallest and the largest contact."""
        loaded = history[0][history[0] > 0]
        for P in {float(loaded.min()), float(loaded.max())} if loaded.size else ():
            warn(alpha=self._alpha(P))

    def _through(self, history: Columns, x: NDArray[Any], y: NDArray[Any], stress: NDArray[Any]) -> None:
        """Through all loads, by a copy that takes the contact's place at the end; or says at which load and point it ends, and
        why."""
        places, trial = (x.size, x.ctypes.data, y.ctypes.data), self._copied()
        try:
            for some in blocks(len(history[0]), FEW // (1 + x.size)):
                status = _stress_history(trial, some.stop - some.start, *(column[some].ctypes.data for column in history), *places,
                                         *(component[some].ctypes.data for component in stress))
                if status != OK:
                    self._find_fault(history, x, y)
                check("contact_stress_history", status)
            self._cell[0], trial.value = trial.value, self._cell[0]
        finally:
            _destroy(trial)

    def _find_fault(self, history: Columns, x: Any, y: Any) -> None:
        trial = self._copied()
        try:
            for i, loads in enumerate(zip(*history)):
                self._check_loads(trial, Loads(*map(float, loads)), f"[{i}]")
                _contact_stresses(trial.value, x, y)
        finally:
            _destroy(trial)

    def cycle(self, loads: History, *places: Numbers) -> Cycle:
        """What the contact undergoes in a cycle of loads, without changing it: ``Cycle(contact, loads)``. Source: new."""
        if places:  # as it was before version 2.0
            raise TypeError(f"Contact.cycle() takes the loads alone: {now_called('Contact.cycle')}")
        return Cycle(self, loads)

    def stresses_after(self, loads: History, x: Numbers, y: Numbers) -> StressHistory:
        """Stresses at points (x, y) of the half-plane while the contact goes through loads, in one call to the library: as
        ``apply`` and ``stresses`` after each, to the same bits, and faster. The contact then has the last of the loads.

        Parameters
        ----------
        loads : mapping, frame, or array_like
            P, M, Q, sigma by name, each a number or all of its values: a dict, or a frame of pandas, in which other columns
            are left alone; numbers there that label no rows give a warning. A load without a name keeps its value. Or rows of
            P, Q, or of P, M, Q, sigma. Domains as in ``apply``
        x, y : array_like
            length, finite, y >= 0; they broadcast, and keep their labels; NaN gives NaN

        Returns
        -------
        stresses : StressHistory
            with the array ``stress`` (load, point, component); ``sxx, syy, txy = stresses``

        Raises
        ------
        ValueError
            where ``apply`` or ``stresses`` does. The message names the load, and the contact is as before

        Error as that of ``stresses``. Source: Eq. (28), (32), (33); new.

        See Also
        --------
        StressHistory : what it gives
        Cycle.stresses : the same of loads that the contact does not keep
        smith_watson_topper, fatemi_socie : fatigue parameters at these points

        Examples
        --------
        >>> import rwedge
        >>> pad = rwedge.Contact(theta=0.01, a=2.0, A=1.82e-5, f=0.3)
        >>> pad.load(2000)
        >>> sxx, syy, txy = pad.stresses_after({"P": 2000, "Q": [300, -300, 300]}, x=[-2, -1], y=0)
        >>> sxx.shape
        (3, 2)
        """
        points, labelled = aligned((x, y))
        x, y = np.broadcast_arrays(*map(plain, points))
        labels = None if labelled is None else labelled(np.zeros(x.shape))
        known, arrays = ~(np.isnan(x) | np.isnan(y)), given_columns(loads)
        with self._lock:
            history = columns(arrays, self.loads)
            self._warn_of(history)
            stress = np.empty((3, len(history[0]), np.count_nonzero(known)))
            self._through(history, x[known], y[known], stress)
        if not known.all():
            some, stress = stress, np.full((3, len(history[0]), x.size), math.nan)
            stress[:, :, known.ravel()] = some
        shape = 3, len(history[0]), *x.shape
        return StressHistory(Loads(*history), x, y, np.moveaxis(stress.reshape(shape), 0, -1), labels)  # type: ignore[arg-type]

    def __getattr__(self, name: str) -> Any:
        if message := now_called(f"Contact.{name}"):
            raise AttributeError(message)
        return object.__getattribute__(self, name)  # which says what is wrong

    def state(self) -> NDArray[np.float64]:
        numbers: NDArray[np.float64] = self._call("contact_state")
        return numbers

    @classmethod
    def restore(cls: type[Self], state: Numbers) -> Self:
        numbers = plain(state).ravel()
        handle = ctypes.c_void_p()
        status = _restore(numbers.size, numbers.ctypes.data, ctypes.byref(handle))
        if status == EDOMAIN:
            raise Error(f"state, of {numbers.size} numbers: they are not those that Contact.state() gives", status)
        check("contact_restore", status)
        contact = cls.__new__(cls)
        contact._begin(handle)
        return contact

    def __reduce__(self) -> tuple[Any, ...]:
        own = {name: value for name, value in self.__dict__.items() if name not in ("_cell", "_lock", "_pad")}
        return _restored, (type(self), self.state()), (own, self._slots())

    @property
    def loads(self) -> Loads:
        """The present loads. Source: new."""
        loads = [ctypes.c_double() for _ in range(4)]
        with self._lock:
            check("contact_loads", _loads(self._address, *map(ctypes.byref, loads)))
        return Loads(*(load.value for load in loads))

    def _at(self, points: Points, *arguments: Any) -> Any:
        with self._lock:
            if EPATH in FUNCTIONS[points.name]["reasons"]:  # of the contact, not of a point: it is asked first
                check(points.name, function(points.name)(self._address, 0, *[None] * (len(FUNCTIONS[points.name]["roles"]) - 2)))
            return super()._at(points, *arguments)

    def _call(self, name: str, *arguments: Any) -> Any:
        with self._lock:
            try:
                return super()._call(name, *arguments)
            except Error as error:
                if name == "contact_stress_history" and error.status != ERANGE:  # arrays of one size
                    self._find_fault(tuple(map(np.asarray, arguments[:4])), arguments[4], arguments[5])
                raise

    @property
    def theta(self) -> float:
        """Angle between flank and surface, rad; 0 of another pad than the wedge."""
        return self._pad.theta

    @property
    def a(self) -> float:
        """Half-width of the rounding of the wedge, or of the flat of a flat pad, length; 0 of another pad."""
        return self._pad.a

    @property
    def R(self) -> float:
        """Radius of a cylinder, or of the edges of a flat pad, length; 0 of another pad."""
        return self._pad.R

    @property
    def A(self) -> float:
        """Composite compliance, 1/stress."""
        return self._pad.A

    @property
    def f(self) -> float:
        """Coefficient of friction."""
        return self._pad.f

    @property
    def P(self) -> float:
        """The present normal load, force/length."""
        return self.loads.P

    @property
    def M(self) -> float:
        """The present moment, force."""
        return self.loads.M

    @property
    def Q(self) -> float:
        """The present tangential load, force/length."""
        return self.loads.Q

    @property
    def sigma(self) -> float:
        """The present bulk tension, stress."""
        return self.loads.sigma

    def yield_factor(self, nu: SupportsFloat, k: SupportsFloat) -> YieldFactor:
        try:
            found = YieldFactor(*self._call("contact_yield_factor", nu, k))
        except AbsentError as error:
            raise AbsentError("this contact is unloaded: there is no stress to yield under", error.status) from None
        warn(safety=found.factor)
        return found
