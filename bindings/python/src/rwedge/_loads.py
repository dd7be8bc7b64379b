# SPDX-License-Identifier: GPL-3.0-or-later
"""The loads of a contact, one or many."""
from __future__ import annotations

import re
import unicodedata
import warnings
from typing import Any, Mapping, NamedTuple, Union

import numpy as np
from numpy.typing import NDArray

from ._header import LABEL_NAMES
from ._labels import Numbers, SupportsArray, is_labelled, plain, refuse_units, same_labels
from ._library import EDOMAIN, ERANGE, Error
from ._validity import outside


class Loads(NamedTuple):
    """Normal load and tangential load, force/length; moment about x = 0, force; bulk tension, stress."""

    P: float
    M: float
    Q: float
    sigma: float


# the name of a load with spaces around it, or with a unit behind it: after a bracket, a slash, a space, or "_"
SPACE = r"[\s\u200b\ufeff]"
NEARLY = re.compile(rf"(?i){SPACE}*(p|m|q|sigma)({SPACE}.*|[\[({{</,;:|].*|_[kmg]?(n|pa|lbf?|psi|ksi)m{{0,2}}([\W_].*)?)?")
KNOWN = {name.replace("_", "") for name in LABEL_NAMES}  # of labels of rows
Columns = tuple[NDArray[np.float64], ...]
History = Union[Mapping[str, Any], SupportsArray, Numbers]


def _numbers(name: str, column: Any) -> NDArray[np.float64]:
    refuse_units(column)
    try:
        array = plain(column)
    except (TypeError, ValueError):  # as a frame has it whose file has decimal commas
        raise TypeError(f"{name} must be numbers, not {getattr(column, 'dtype', type(column).__name__)}") from None
    if array.ndim > 1:
        raise Error(f"{name} has the shape {array.shape}: a history has one dimension", ERANGE)
    if np.isnan(array).any():
        raise Error(f"{name}[{int(np.argmax(np.isnan(array)))}] is not a number", EDOMAIN)
    return array


def _is_label(name: str) -> bool:
    """Whether a column says which row it is, as the tool has it: "time", "Load [-]", "time_s"; "T" may be a force."""
    words = re.findall(r"[^\W_]+", unicodedata.normalize("NFKC", re.split(r"[\[({<]", name)[0]))
    for count in range(1, len(words) + 1):  # words behind it are a unit
        first = "".join(words[:count])
        if all(len(word) <= 3 for word in words[count:]) and (first == "t" or first.lower() in KNOWN):
            return True
    return False


def _has_numbers(column: Any) -> bool:
    try:
        return (column if hasattr(column, "dtype") else np.asarray(column)).dtype.kind in "iuf"
    except ValueError:  # no array
        return False


def _warn_of_unused(loads: Any, names: list[str]) -> None:
    """A column of numbers that is no load may have been meant for one."""
    unused = [name for name in names if not _is_label(name) and _has_numbers(loads[name])]
    if unused:
        warnings.warn(f"loads has columns with numbers that are not used: {', '.join(map(repr, unused))}; the names of loads are P, M, "
                      "Q and sigma", UserWarning, stacklevel=outside())


def _named(loads: Any) -> dict[str, Any]:
    """The columns that are named as loads are. Others, such as a time, are left alone; but not "q", " Q" or "Q [N/mm]"."""
    names = [name for name in loads.keys() if isinstance(name, str)]
    taken = {name: loads[name] for name in names if name in Loads._fields}
    wrong = [name for name in names if name not in taken and NEARLY.fullmatch(unicodedata.normalize("NFKC", name))]
    if wrong or not taken:
        raise Error(f"loads has the columns {', '.join(map(repr, loads.keys()))}: the names of loads are P, M, Q and sigma, without "
                    "a unit", EDOMAIN)
    _warn_of_unused(loads, [name for name in names if name not in taken])
    return taken


def _by_place(loads: Any) -> dict[str, Any]:
    array = plain(loads)
    if array.ndim != 2 or array.shape[1] not in (2, 4):
        raise Error(f"loads has the shape {array.shape}: a row for each load, of P, Q or of P, M, Q, sigma", ERANGE)
    return dict(zip(("P", "Q") if array.shape[1] == 2 else Loads._fields, array.T))


def _refuse_other_labels(by_name: dict[str, Any]) -> None:
    """Refuses columns whose labels differ. Loads follow one another by their place: which belong together would be a guess."""
    labelled = {name: column for name, column in by_name.items() if np.ndim(column) > 0 and is_labelled(column)}
    first = next(iter(labelled), "")
    for name, column in labelled.items():
        if not same_labels(column, labelled[first]):
            raise Error(f"{first} and {name} have different indexes: give loads of one index, or numbers alone, such as "
                        f"{name}.to_numpy()", EDOMAIN)


def given_columns(loads: History) -> dict[str, NDArray[np.float64]]:
    """The given ones of P, M, Q, sigma, from a mapping or frame with these names, or from rows."""
    by_name: dict[str, Any] = _named(loads) if hasattr(loads, "keys") else _by_place(loads)
    _refuse_other_labels(by_name)
    return {name: _numbers(name, values) for name, values in by_name.items()}


def rig_columns(loads: Mapping[str, Any], prescribed: str, load: str) -> dict[str, NDArray[np.float64]]:
    """The given ones of the other loads, and what a rig prescribes in the place of one, from a mapping or frame with these names."""
    names = list(loads.keys()) if hasattr(loads, "keys") else []
    if prescribed not in names or load in names:
        raise Error(f"loads of a rig have {prescribed} in place of {load}, by name", EDOMAIN)
    others = {name: loads[name] for name in names if name != prescribed}
    by_name = {**(_named(others) if others else {}), prescribed: loads[prescribed]}
    _refuse_other_labels(by_name)
    arrays = {name: _numbers(name, values) for name, values in by_name.items()}
    return {**arrays, load: arrays.pop(prescribed)}


def columns(arrays: dict[str, NDArray[np.float64]], present: Loads) -> Columns:
    """P, M, Q, sigma of all loads. A load that is not given keeps its value, but where P is 0 the moment becomes and stays 0."""
    try:
        P, M, Q, sigma = np.broadcast_arrays(*(arrays.get(name, getattr(present, name)) for name in Loads._fields))
    except ValueError:
        shapes = ", ".join(f"{name} {array.shape}" for name, array in arrays.items())
        raise Error(f"the loads differ in number: {shapes}", ERANGE) from None
    if "M" not in arrays:
        M = np.where(np.logical_or.accumulate(np.atleast_1d(P == 0)), 0.0, M)
    return tuple(np.atleast_1d(np.ascontiguousarray(array, dtype=float)) for array in (P, M, Q, sigma))
