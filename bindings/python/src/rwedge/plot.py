# SPDX-License-Identifier: GPL-3.0-or-later
"""Pictures of a contact with matplotlib, in the style of ``rwedge figure``.

Each function draws on ``ax``, or on matplotlib's current axes, and returns what it has drawn. Lengths are over the half-width
b of the contact and stresses over theta/A; with ``units=("mm", "MPa")`` they are those of the contact, with these names. Needs
matplotlib. Other settings, such as fonts and sizes, are matplotlib's own.
"""
from __future__ import annotations

import math
from typing import Any, SupportsFloat

import numpy as np
from numpy.typing import NDArray

from ._contact import Contact
from ._labels import Numbers
from ._library import Error
from ._made import Pad
from ._optional import need
from ._ufuncs import UFUNCS

# Okabe and Ito's colours, which the colour-blind can tell apart.
BLACK, BLUE, VERMILLION, GREEN, PURPLE = "#000000", "#0072b2", "#d55e00", "#009e73", "#cc79a7"
COLOURS = BLACK, BLUE, VERMILLION, GREEN, PURPLE
DASHES: tuple[Any, ...] = "solid", (0, (9, 4)), (0, (3, 3)), (0, (9, 3, 2, 3))  # lines differ in print without colour
WIDTH, THIN = 1.4, 0.6  # of lines, points
SURFACE_POINTS, COLUMNS, ROWS = 801, 241, 97
LEVELS = 12  # of contours, at most
STEPS = 32  # of a line between two turning points of a loop

Units = tuple[str, str]


def _axes(ax: Any) -> Any:
    ax = need("matplotlib.pyplot", "rwedge.plot").gca() if ax is None else ax
    ax.spines[["top", "right"]].set_visible(False)
    return ax


def _style(ax: Any, line: dict[str, Any]) -> dict[str, Any]:
    """The style of the next curve of a family, with the settings of the caller."""
    number = sum(drawn.get_gid() == "rwedge" for drawn in ax.lines)
    own = {"color": COLOURS[number % len(COLOURS)], "linestyle": DASHES[number % len(DASHES)], "linewidth": WIDTH}
    short = {"c": "color", "ls": "linestyle", "lw": "linewidth"}
    return {**own, **{short.get(name, name): value for name, value in line.items()}, "gid": "rwedge"}


def _loaded(contact: Contact) -> float:
    b = contact.half_width
    if b == 0:
        raise Error("this contact is unloaded: there is nothing to draw")
    return b


def _scales(contact: Contact, units: Units | None) -> tuple[float, float]:
    """The units in which lengths and stresses are drawn."""
    return (contact.half_width, _angle(contact) / contact.A) if units is None else (1.0, 1.0)


def _angle(contact: Contact) -> float:
    """That of the flanks; of any pad, half of the change of its slope."""
    _, slope = contact.places
    return contact.theta or float(slope[-1] - slope[0]) / 2


def _is_sharp(contact: Contact) -> bool:
    return contact.kind == Pad.WEDGE and contact.a == 0


def tractions(contact: Contact, ax: Any = None, units: Units | None = None, **line: Any) -> tuple[Any, ...]:
    """Draws the shear traction over the surface, as -q/f, with -p, the limit of friction, as a thin line.

    Parameters
    ----------
    contact : Contact
        loaded
    ax : matplotlib.axes.Axes, optional
        the current axes where it is None
    units : (str, str), optional
        the names of length and stress; without them, x/b and multiples of theta/A, times pi as in the paper
    **line
        of the shear traction, as in ``Axes.plot``

    Returns
    -------
    pressure, shear : matplotlib.lines.Line2D
        the pressure alone without friction

    Source: ``Contact.tractions``.

    See Also
    --------
    rwedge.Contact.tractions

    Examples
    --------
    >>> import rwedge.plot
    >>> pad = rwedge.Contact(theta=0.01, a=2.0, A=1.82e-5, f=0.3)
    >>> pad.load([2000, 2000], [0, 300])
    >>> pressure, shear = rwedge.plot.tractions(pad, units=("mm", "MPa"))
    >>> pressure.axes.get_xlabel()
    '$x$ / mm'
    """
    _loaded(contact)
    ax, (length, stress) = _axes(ax), _scales(contact, units)
    left, right = contact.edges
    angles = np.linspace(-math.pi / 2, math.pi / 2, SURFACE_POINTS)
    x = np.union1d((left + right) / 2 + (right - left) / 2 * np.sin(angles), np.concatenate(contact.zones[:2]))
    x = x[x != 0] if _is_sharp(contact) else x
    p, q = contact.tractions(x)
    factor = stress if units else stress / math.pi
    drawn = [ax.plot(x / length, -p / factor, color=BLACK, linewidth=THIN)[0]]
    if contact.f > 0:
        drawn += ax.plot(x / length, -q / contact.f / factor, **_style(ax, line))
    both = contact.f > 0
    ax.set_xlabel(rf"$x$ / {units[0]}" if units else r"$x/b$")
    ax.set_ylabel(("$-p$" + r", $-q/f$" * both + f" / {units[1]}") if units else
                  r"$-pA\pi/\theta$" + r", $-qA\pi/(f\theta)$" * both)
    return tuple(drawn)


def _step(top: float) -> float:
    """A round distance of levels below top."""
    decade = 10 ** math.floor(math.log10(top / LEVELS))
    return next(decade * k for k in (1, 2, 5, 10) if decade * k * LEVELS >= top * (1 - 1e-12))


def field(contact: Contact, nu: SupportsFloat, ax: Any = None, units: Units | None = None, reach: float = 1.5) -> Any:
    """Draws contours of sqrt(J2), which is von Mises' stress over the root of 3, below the contact: lines on greys. The empty
    bar above is the contact, its filled part sticks; the circle is where it would yield first.

    Parameters
    ----------
    contact : Contact
        loaded
    nu : float
        Poisson's ratio of the half-plane, 0 <= nu <= 0.5; 0 for plane stress
    ax, units
        as in ``tractions``
    reach : float
        how far to the sides and down, in b

    Returns
    -------
    lines : matplotlib.contour.QuadContourSet

    Source: ``Contact.stresses``, ``von_mises``, ``Contact.yield_factor``.

    See Also
    --------
    rwedge.Contact.stresses, rwedge.Contact.yield_factor

    Examples
    --------
    >>> import rwedge.plot
    >>> pad = rwedge.Contact(theta=0.01, a=2.0, A=1.82e-5, f=0.3)
    >>> pad.load([2000, 2000], [0, 300])
    >>> rwedge.plot.field(pad, nu=0.3, reach=2).axes.get_xlabel()
    '$x/b$'
    """
    b = _loaded(contact)
    ax, (length, stress) = _axes(ax), _scales(contact, units)
    left, right = contact.edges
    middle = (left + right) / 2
    x, y = middle + reach * b * np.linspace(-1, 1, COLUMNS), reach * b * np.linspace(0, 1, ROWS)[:, None] ** 1.5
    if _is_sharp(contact):
        x = np.where(x == 0, np.nan, x)  # the apex
    sqrt_J2 = UFUNCS["von_mises"](*contact.stresses(x, y), float(nu)) / math.sqrt(3) / stress
    step = _step(float(np.nanmax(sqrt_J2)))
    levels = step * np.arange(1, math.ceil(np.nanmax(sqrt_J2) / step))
    greys = [str(1 - 0.55 * k / (len(levels) + 1)) for k in range(len(levels) + 1)]
    grid = np.broadcast_to(x / length, sqrt_J2.shape), np.broadcast_to(y / length, sqrt_J2.shape)
    ax.contourf(*grid, sqrt_J2, [0, *levels, np.inf], colors=greys)
    lines = ax.contour(*grid, sqrt_J2, levels, colors=BLACK, linewidths=THIN)
    ax.clabel(lines, fontsize="small", fmt=lambda level: f"{level:.6g}")
    _zones(contact, ax, length)
    if not _is_sharp(contact):
        first = contact.yield_factor(nu, 10 * stress * float(sqrt_J2.max()))  # of so strong a body that none yields
        ax.plot(first.x / length, first.y / length, "o", color=VERMILLION, fillstyle="none", clip_on=False)
    ax.set_aspect("equal")
    ax.set_xlim((middle - reach * b) / length, (middle + reach * b) / length)
    ax.set_ylim(reach * b / length, -0.16 * b / length)
    ax.set_xlabel(f"$x$ / {units[0]}" if units else "$x/b$")
    ax.set_ylabel(f"$y$ / {units[0]}" if units else "$y/b$")
    ax.set_title(r"$\sqrt{J_2}$ in " + (units[1] if units else r"$\theta/A$"))
    return lines


def _zones(contact: Contact, ax: Any, length: float) -> None:
    """The surface, and above it the contact as an empty bar, its stick zones filled if it slips too."""
    b = contact.half_width / length
    patch = need("matplotlib.patches", "rwedge.plot").Rectangle
    slips = bool(contact.zones[2].any())
    for start, end, slip in zip(*contact.zones):
        if slips and slip == 0:
            ax.add_patch(patch((start / length, -0.09 * b), (end - start) / length, 0.06 * b, color=BLACK, linewidth=0))
    left, right = contact.edges
    ax.add_patch(patch((left / length, -0.09 * b), (right - left) / length, 0.06 * b, fill=False, linewidth=0.8))
    ax.axhline(0, color=BLACK, linewidth=1)


def displacement(contact: Contact) -> float:
    """How far remote points of the half-plane have moved along the surface, relative to the wedge's, more than if the contact
    were bonded over abs(x) < b, a length. It is what the slip adds: its loop over Q encloses the dissipated energy.

    Parameters
    ----------
    contact : Contact
        loaded

    Source: ``Contact.displacement``.

    See Also
    --------
    rwedge.plot.loop, rwedge.Contact.displacement

    Examples
    --------
    >>> import rwedge.plot
    >>> pad = rwedge.Contact(theta=0.01, a=2.0, A=1.82e-5, f=0.3)
    >>> pad.load([2000, 2000], [0, 300])
    >>> rwedge.plot.displacement(pad) == pad.displacement(pad.half_width)
    True
    """
    return float(contact.displacement(_loaded(contact)))


def loop(contact: Contact, Q: Numbers, ax: Any = None, units: Units | None = None, **line: Any) -> Any:
    """Draws Q over the displacement by slip while Q goes from one of its values to the next under constant P.

    Parameters
    ----------
    contact : Contact
        loaded; it stays as it is
    Q : array_like
        force/length, the turning points, abs(Q) <= f P
    ax, units
        as in ``tractions``; without units, Q/(f P) and lengths over f theta b
    **line
        as in ``Axes.plot``

    Returns
    -------
    line : matplotlib.lines.Line2D

    Source: ``displacement``.

    See Also
    --------
    rwedge.plot.displacement, rwedge.Contact.dissipated_energy

    Examples
    --------
    >>> import rwedge.plot
    >>> pad = rwedge.Contact(theta=0.01, a=2.0, A=1.82e-5, f=0.3)
    >>> pad.load([2000, 2000], [0, 300])
    >>> line = rwedge.plot.loop(pad, [-300, 300])
    >>> len(line.get_xdata())
    65
    """
    b = _loaded(contact)
    ax, moving = _axes(ax), contact.copy()
    turns = np.concatenate([[contact.Q], np.ravel(np.asarray(Q, dtype=float))])
    parts = np.sin(np.linspace(0, np.pi / 2, STEPS + 1)[1:])
    path = np.concatenate([turns[:1], *(start + (end - start) * parts for start, end in zip(turns[:-1], turns[1:]))])
    moved = np.empty_like(path)
    for i, force in enumerate(path):
        moving.load(contact.P, force)
        moved[i] = displacement(moving)
    width, force = (1.0, 1.0) if units else (contact.f * _angle(contact) * b, contact.f * contact.P)
    drawn: NDArray[Any] = ax.plot(moved / width, path / force, **_style(ax, line))
    ax.set_xlabel(f"displacement by slip / {units[0]}" if units else r"displacement by slip / $(f\theta b)$")
    ax.set_ylabel(f"$Q$ / ({units[1]} {units[0]})" if units else "$Q/(fP)$")
    return drawn[0]
