# SPDX-License-Identifier: GPL-3.0-or-later
"""Files of instruments and cases, as the tool reads them: ``rwedge read`` is asked, so that there is one reader, one table of units,
and one set of messages."""
from __future__ import annotations

import json
import math
import os
import shutil
import subprocess
import sys
import warnings
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, Iterable, Mapping

import numpy as np

from ._contact import Contact
from ._library import Error, function
from ._ufuncs import UFUNCS


def _tool() -> str:
    """RWEDGE_TOOL names it; or it is in the package; or on PATH."""
    beside = Path(__file__).with_name("rwedge.exe" if sys.platform == "win32" else "rwedge")
    found = os.environ.get("RWEDGE_TOOL") or (str(beside) if beside.exists() else shutil.which("rwedge"))
    if found is None:
        raise FileNotFoundError("reading files needs the tool rwedge, on PATH or named by the environment variable RWEDGE_TOOL")
    return found


def _text(value: Any) -> str:
    """A value as an option has it; a quantity of pint with its unit."""
    if hasattr(value, "magnitude") and hasattr(value, "units"):
        return f"{_text(float(value.magnitude))} {value.units:~C}".replace("**", "^").strip()
    return repr(float(value)) if isinstance(value, (float, np.floating)) else str(value)


def _words(name: str, value: Any) -> list[str]:
    option = "--" + name.replace("_", "-")
    if value is None or value is False:
        return []
    if value is True:
        return [option]
    if isinstance(value, Mapping):  # column={"P": "Normal Force"}, material={"su": 900}
        if name == "material":
            return [option, json.dumps({key: each if isinstance(each, (int, float)) else _text(each) for key, each in value.items()})]
        return [word for key, theirs in value.items() for word in (option, f"{key}={theirs}")]
    if isinstance(value, (list, tuple)):  # load=[(100, 10), (100, -10)]
        return [word for each in value for word in (option, ",".join(_text(number) for number in each))]
    return [option, _text(value)]


def _run(command: str, line: Iterable[str]) -> tuple[str, list[str]]:
    """What a command of the tool writes, and its remarks; what is wrong is an error."""
    done = subprocess.run([_tool(), command, *line], capture_output=True, text=True, encoding="utf-8")
    said = [text.removeprefix(f"rwedge {command}: ") for text in done.stderr.splitlines()]
    if any(text.startswith(f"rwedge: {command}: unknown command") for text in said):
        raise Error(f"{_tool()} is the tool of another version: {function('version')().decode()} is needed")
    if done.returncode != 0:
        raise Error("; ".join(said) or f"rwedge {command} ended with {done.returncode}")
    return done.stdout, said


@dataclass(frozen=True)
class Case:
    """What a case file, or files and words, give: all numbers in the working units, forces per unit length.

    Attributes
    ----------
    units : str
        The working units, as "mm,N,MPa"; "" where none are said.
    bodies : dict
        E1, nu1, E2, nu2, f, k or yield_stress, plane_stress, similar: those that are given. E2 is infinite where body 2 is rigid.
    pad : dict
        theta or theta_deg, a, radius, flat; of a profile x and slope, as arrays; tilt, in radians, where it is held; rotation,
        "held" or "free".
    loads : dict
        P, M, Q, sigma: numbers, or arrays of the same size, one load after the other; tilt in place of M for ``Contact.guide()``.
    material : dict
        Its constants by name.
    asked : dict
        What the file asks of a command of the tool.

    See Also
    --------
    read_case : reads one
    """

    units: str = ""
    bodies: dict[str, Any] = field(default_factory=dict)
    pad: dict[str, Any] = field(default_factory=dict)
    loads: dict[str, Any] = field(default_factory=dict)
    material: dict[str, float] = field(default_factory=dict)
    asked: dict[str, Any] = field(default_factory=dict)
    _options: tuple[str, ...] = field(default=(), repr=False)

    @property
    def A(self) -> float:
        """The composite compliance; in plane stress that of Poisson's ratio 0."""
        E1, nu1 = self._of_body("E1", "E"), self._of_body("nu1", "nu")
        E2, nu2 = self.bodies.get("E2", E1), self.bodies.get("nu2", nu1)
        if self.bodies.get("plane_stress"):
            nu1 = nu2 = 0
        return float(UFUNCS["compliance"](E1, nu1, E2, nu2))

    def _of_body(self, name: str, of_material: str) -> float:
        value = self.bodies.get(name, self.material.get(of_material))
        if value is None:
            raise Error(f"the case has no {name}")
        return float(value)

    @property
    def beta(self) -> float:
        """Dundurs' beta of half-plane and pad."""
        E1, nu1 = self._of_body("E1", "E"), self._of_body("nu1", "nu")
        name = "dundurs_beta_plane_stress" if self.bodies.get("plane_stress") else "dundurs_beta"
        return float(UFUNCS[name](E1, nu1, self.bodies.get("E2", E1), self.bodies.get("nu2", nu1)))

    def _is_coupled(self) -> bool:
        """Whether friction changes the pressure; then the rotation of the pad must be said."""
        doubts = function("validity")(math.nan, math.nan, self.beta, self.bodies.get("f", 0.0), math.nan, math.nan)
        if doubts == 0 or self.bodies.get("similar"):
            return False
        if not {"rotation", "tilt"} & (self.pad.keys() | self.loads.keys()):
            raise Error(f"unlike bodies with friction, Dundurs' beta {self.beta:.3g}: rotation='held' or 'free' must be said; "
                        "similar=True neglects their coupling")
        return True

    def contact(self, tolerance: float | None = None) -> Contact:
        """The contact of the bodies and the pad, without loads. Friction that is not given is 0. It is held where a tilt is given, at
        the first one of a list, and where the rotation is held. The tolerance is 1e-4 unless it is given, and 1e-3 for unlike bodies with
        friction, which are coupled."""
        pad, A, f, is_coupled = self.pad, self.A, self.bodies.get("f", 0.0), self._is_coupled()
        tolerance = (1e-3 if is_coupled else 1e-4) if tolerance is None else tolerance
        radius = pad.get("radius")
        theta = pad.get("theta", math.radians(pad["theta_deg"]) if "theta_deg" in pad else None)
        if "x" in pad:
            contact = Contact.profile(pad["x"], pad["slope"], A, f, tolerance)
        elif "flat" in pad:
            contact = Contact.flat(pad["flat"], pad["radius"], A, f, tolerance)
        elif theta is None and radius is not None:
            contact = Contact.cylinder(radius, A, f, tolerance)
        elif theta is None:
            raise Error("the case has no pad")
        else:
            contact = Contact(theta, pad["a"] if "a" in pad else theta * radius, A, f, tolerance=tolerance)
        E2, nu2 = self.bodies.get("E2"), self.bodies.get("nu2")
        if E2 is not None and (E2, nu2) != (self.bodies.get("E1"), self.bodies.get("nu1")):
            nu1 = 0.0 if self.bodies.get("plane_stress") else self._of_body("nu1", "nu")
            contact.set_strain((1 - nu1**2) / self._of_body("E1", "E"))
        if is_coupled:
            contact.set_beta(self.beta)
        tilt = np.ravel(self.loads.get("tilt", pad.get("tilt", [0.0] if pad.get("rotation") == "held" else [])))
        if tilt.size > 0:
            contact.set_rotation(1)
            contact.guide(0.0, float(tilt[0]), 0.0, 0.0)
        return contact

    def remarks(self) -> list[str]:
        """What the tool remarks on the contact under the loads of the case, as ``rwedge solve`` says it: of a fit the largest residue
        within the contact, how the largest pressure changes with one arc fewer and one more, and edges that the noise does not
        resolve; of a hull how much it changes; a pad whose x = 0 is not its lowest place; what makes results doubtful."""
        return _run("solve", self._options)[1]

    def report(self, file: str | os.PathLike[str] | None = None, *, pictures: bool = True, equations: bool = False, **words: Any) -> str:
        """The case on one page of HTML, as ``rwedge report`` writes it: pad, loads, verdict, results, three pictures, what was assumed and
        which errors are told.

        Parameters
        ----------
        file : path, optional
            The page is written there, whole or not at all.
        pictures : bool
            With the pictures, which gnuplot draws; it must be on PATH.
        equations : bool
            With the formulas of the results, and the numbers put in.
        **words
            What a cycle of loads is asked beside: cycles=6, criteria="swt,findley", findley_k=0.3.

        Returns
        -------
        str
            The page.
        """
        line = [*self._options, *(word for name, value in words.items() for word in _words(name, value))]
        line += [*(["--equations"] if equations else []), *([] if pictures else ["--no-pictures"])]
        if file is None:
            return _run("report", line)[0]
        _run("report", [*line, "--output", os.fspath(file)])
        return Path(file).read_text("utf-8")


def _arrays(group: Mapping[str, Any]) -> dict[str, Any]:
    return {name: np.array(value) if isinstance(value, list) else math.inf if value == "inf" else value for name, value in group.items()}


def read_case(file: str | os.PathLike[str] | None = None, **words: Any) -> Case:
    """A case from its file, from files of a rig, or from words: the options of the tool with ``_`` for ``-``.

    The tool reads: ``rwedge``, which the wheels for Linux (x86-64) and Windows have inside; else that of the same version on PATH, or
    named by the environment variable RWEDGE_TOOL. Its remarks are warnings; what is wrong is an ``Error`` with its message, which names file, line and column.

    Parameters
    ----------
    file : path, optional
        A case file (JSON), or a log of loads (any other ending).
    **words
        Inputs, E1="210 GPa" or a number, or a quantity of pint, beside units="mm,N,MPa"; width, section; profile="scan.csv" with fit,
        hull, heights="down", origin="lowest"; rotation="held" or "free" of unlike bodies with friction, or similar=True; column={"P": "Normal Force"}; drop=True; encoding; decimal_comma=True;
        material="sae-1015-normalized"; load=[(P, Q), ...]. A word replaces what the file has.

    Returns
    -------
    Case

    Examples
    --------
    >>> case = rwedge.read_case("case.json")                                               # doctest: +SKIP
    >>> log = rwedge.read_case("rig.csv", units="mm,N,MPa", width=8, column={"P": "Normal", "Q": "Fretting"})  # doctest: +SKIP
    >>> contact = case.contact()                                                           # doctest: +SKIP
    """
    is_case = file is not None and os.fspath(file).lower().endswith(".json")
    options = [word for name, value in words.items() for word in _words(name, value)]
    if file is not None:
        options = ["--case" if is_case else "--history", os.fspath(file), *options]
    written, said = _run("read", options)
    for remark in said:
        warnings.warn(remark, stacklevel=2)
    read: dict[str, Any] = json.loads(written)
    asked = json.loads(Path(file).read_text("utf-8-sig")).get("asked", {}) if is_case and file is not None else {}
    groups = {name: _arrays(read.get(name, {})) for name in ("bodies", "pad", "loads", "material")}
    return Case(units=read.get("units", ""), asked=asked, _options=tuple(options), **groups)
