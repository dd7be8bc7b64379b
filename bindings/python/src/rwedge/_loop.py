# SPDX-License-Identifier: GPL-3.0-or-later
"""A measured loop, as the tool fits it: ``rwedge loop`` is asked, so that both give the same numbers."""
from __future__ import annotations

import json
import math
import os
import tempfile
import warnings
from dataclasses import dataclass, field
from typing import Any, Mapping

import numpy as np

from ._files import _run, _words
from ._tests import _path_of


@dataclass(frozen=True)
class Loop:
    """What a loop of Q over the displacement of a rig says, of a log or of one of its cycles. A number that the loop does not tell is
    NaN.

    Attributes
    ----------
    f : float
        Coefficient of friction.
    compliance : float
        How far the rig gives way under Q = 1 per unit length, as ``Contact.drive`` takes it.
    offset : float
        The displacement at which there is no shear.
    energy : float
        Dissipated per cycle, the area of the measured loop.
    regime : str
        "stick", "partial slip" or "gross slip".
    uncertainty : dict
        Standard deviations of f, compliance, offset and energy, by the noise of Q.
    fitted : dict
        Of a log its P, displacement, Q and Q_fitted, as arrays; empty of a cycle.

    See Also
    --------
    loop : fits one
    """

    f: float
    compliance: float
    offset: float
    energy: float
    regime: str
    uncertainty: dict[str, float] = field(repr=False)
    fitted: dict[str, Any] = field(default_factory=dict, repr=False)


_NUMBERS = ("f", "compliance", "offset", "energy")


def _number(value: Any) -> float:
    return math.nan if value is None or value == "" else float(value)


def _of_rows(rows: list[dict[str, Any]], fitted: dict[str, Any]) -> Loop:
    by_name = {row["quantity"]: row for row in rows}
    return Loop(*(_number(by_name[name]["value"]) for name in _NUMBERS), regime=by_name["regime"]["value"],
                uncertainty={name: _number(by_name[name]["uncertainty"]) for name in _NUMBERS}, fitted=fitted)


def loop(log: str | os.PathLike[str] | Mapping[str, Any], by_cycle: bool = False, **words: Any) -> Any:
    """Friction, the rig's compliance and the offset of its displacement from a measured loop, as ``rwedge loop`` has it.

    Parameters
    ----------
    log : path or mapping
        A file, or its columns by name, as a dict or a DataFrame has them: P, Q, displacement, and M and sigma if there are any.
    by_cycle : bool
        A fit for each whole cycle, as a steady one.
    **words
        The options of the tool with ``_`` for ``-``: E1=210e3, nu1=0.3, radius=50, units="mm,N,MPa", width=10,
        column={"displacement": "LVDT 1"}.

    Returns
    -------
    Loop
        or a list of them, one for each cycle

    Examples
    --------
    >>> measured = rwedge.loop("log.csv", E1=115e3, nu1=0.32, radius=50)                   # doctest: +SKIP
    >>> measured.f, measured.uncertainty["f"], measured.regime                             # doctest: +SKIP
    """
    with tempfile.TemporaryDirectory() as folder:
        path = _path_of(log, folder)
        line = [os.fspath(path), *(word for name, value in words.items() for word in _words(name, value)), "--format", "json"]
        written, said = _run("loop", [*line, *["--by-cycle"] * by_cycle])
        points = [] if by_cycle else json.loads(_run("loop", [*line, "--fitted"])[0])
    for remark in said:
        if ": left of Q: " not in remark:
            warnings.warn(remark, stacklevel=2)
    rows: list[dict[str, Any]] = json.loads(written)
    if by_cycle:
        cycles = sorted({row["cycle"] for row in rows})
        return [_of_rows([row for row in rows if row["cycle"] == cycle], {}) for cycle in cycles]
    return _of_rows(rows, {name: np.array([point[name] for point in points]) for name in points[0]})
