# SPDX-License-Identifier: GPL-3.0-or-later
"""A cylinder and a flat pad with rounded edges under the same loads: P and M stay, Q and a bulk tension go to and fro in phase.
The flat pad's edges have the radius with which K_N is that of the cylinder, at the trailing edge. Prints Smith, Watson and
Topper's parameter of both.                                                                             pads.py PICTURE

K_N is what the pressure rises with from the edge: at the distance r, |p| ~ K_N sqrt(r). Pads of one K_N and one K_T are alike at
their edges. These have one Q and one tension instead: the wider pad turns them into another K_T, (Q/pi + sigma b/4)/sqrt(2 b).

Units are N and mm, so that stresses are MPa and forces are per mm of thickness.
"""
import math

import numpy as np
import shown

import rwedge
from rwedge import plot

E, NU, F = 72.1e3, 0.33, 0.5  # an aluminium alloy
A = rwedge.compliance(E, NU, E, NU)
P, M, Q, SIGMA = 200, 2, 40, 40
R, FLAT = 25, 0.5


def pressed(contact):
    contact.apply(P, M, 0, 0)
    return contact


def flat_pad(K_N):
    """Its edges have the radius that gives K_N at the left edge: a larger radius gives less."""
    return shown.bisected(0.1, 1e3, lambda R: pressed(rwedge.Contact.flat(FLAT, R, A, F)).edge_asymptotes[0] > K_N)


def after_a_cycle(contact, x):
    """Tractions at Q and sigma to the right, after a first cycle, and Smith, Watson and Topper's parameter of the next."""
    contact.apply(P, M, [Q, -Q, Q], [SIGMA, -SIGMA, SIGMA])
    p, q = contact.tractions(x)
    phase = np.cos(np.linspace(0, 2 * math.pi, 25))
    cycle = contact.stresses_after({"P": P, "M": M, "Q": Q * phase, "sigma": SIGMA * phase}, x, 0)
    return {"p": -p, "q": -q, "swt": rwedge.smith_watson_topper(*cycle, E, NU, axis=0)[0]}


def places(contact):
    """Dense at both edges, and beyond them."""
    left, right = contact.edges
    middle, half = (left + right) / 2, (right - left) / 2
    inside = middle + half * np.sin(np.linspace(-math.pi / 2, math.pi / 2, 161))
    beyond = half * np.linspace(0.02, 0.7, 35) ** 2
    return np.concatenate([left - beyond[::-1], inside, right + beyond])


def main():
    picture = shown.arguments(__file__, __doc__).picture
    pads = {"cylinder": pressed(rwedge.Contact.cylinder(R, A, F))}
    K_N = pads["cylinder"].edge_asymptotes[0]
    radius = flat_pad(K_N)
    pads["flat pad"] = pressed(rwedge.Contact.flat(FLAT, radius, A, F))
    x = {name: places(contact) for name, contact in pads.items()}
    results = {name: after_a_cycle(contact, x[name]) for name, contact in pads.items()}

    print(f"P = {P} N/mm, M = {M} N, Q = {Q} N/mm and sigma = {SIGMA} MPa to and fro; K_N = {K_N:.1f} MPa/mm^0.5")
    shown.table(pads, {
        "flat, mm": lambda name: {"cylinder": 0, "flat pad": 2 * FLAT}[name],
        "radius, mm": lambda name: {"cylinder": R, "flat pad": radius}[name],
        "contact, mm": lambda name: 2 * pads[name].half_width, "K_N, MPa/mm^0.5": lambda name: pads[name].edge_asymptotes[0],
        "K_T, MPa mm^0.5": lambda name: pads[name].edge_asymptotes[2], "largest pressure, MPa": lambda name: results[name]["p"].max(),
        "sticks over, mm": lambda name: np.diff(pads[name].stick_zone)[0],
        "worst Smith-Watson-Topper, MPa": lambda name: results[name]["swt"].max(),
        "at x, mm": lambda name: x[name][results[name]["swt"].argmax()]})
    ratio = results["flat pad"]["swt"].max() / results["cylinder"]["swt"].max()
    print(f"the flat pad has {ratio:.2f} times the cylinder's worst parameter")

    figure, (top, bottom) = shown.plt.subplots(2, sharex=True, figsize=(5.5, 6))
    for number, (name, value) in enumerate(results.items()):
        style = shown.style(number)
        top.plot(x[name], value["p"], linewidth=plot.THIN, **style)
        top.plot(x[name], value["q"] / F, label=name, **style)
        bottom.plot(x[name], value["swt"], **style)
        worst = value["swt"].argmax()
        bottom.plot(x[name][worst], value["swt"][worst], "o", color=style["color"], fillstyle="none")
        aside = -8 if number else 8
        bottom.annotate(f"{value['swt'][worst]:.3f} MPa", (x[name][worst], value["swt"][worst]), textcoords="offset points",
                        xytext=(aside, -4), ha="right" if number else "left")
    top.set_ylabel("$-p$ (thin), $-q/f$ / MPa")
    bottom.set(xlabel="$x$ / mm", ylabel="Smith–Watson–Topper / MPa")
    top.legend()
    shown.save(figure, picture, **{f"{quantity}_{name.replace(' ', '_')}": column for name, value in results.items()
                                   for quantity, column in {"x_mm": x[name], **value}.items()})


if __name__ == "__main__":
    main()
