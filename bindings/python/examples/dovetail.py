# SPDX-License-Identifier: GPL-3.0-or-later
"""A pad for the laboratory that is matched to the flank of a dovetail: its loads are such that, at the trailing edge, pressure
and shear traction have the dovetail's K_N and K_T. Prints both edges side by side.                     dovetail.py PICTURE

Near an edge, at the distance r, |p| ~ K_N sqrt(r); while slip is short, q ~ K_T/sqrt(r), which slips over 2 K_T/(f K_N). Two
contacts that agree in both are alike there, however they differ elsewhere: so a small pad tests the edge of a large joint. Of a
real dovetail K_N and K_T come from finite elements; here it is a contact with a moment, so that the whole of it is known.

Units are N and mm, so that stresses are MPa and forces are per mm of thickness.
"""
import math

import numpy as np
import shown

import rwedge
from rwedge import plot

E, NU, F = 115e3, 0.32, 0.5  # a titanium alloy
A = rwedge.compliance(E, NU, E, NU)
THETA = 0.02


def dovetail():
    """The flank of a blade's root under its centrifugal load, with a moment that presses the trailing edge less."""
    contact = rwedge.Contact(THETA, rwedge.rounding(THETA, 20), A, F)
    contact.apply(P=1500, M=150, Q=0, sigma=0)
    return contact


def stress_intensities(contact):
    """K_N and K_T at the trailing edge, x < 0, where Q > 0 makes the half-plane's surface slip outwards."""
    normal, _, shear, _ = contact.edge_asymptotes
    return normal, shear


def pad(R, K_N):
    """A cylinder of radius R, pressed until it has K_N. That grows with P as long as only the rounding touches."""
    a = rwedge.rounding(THETA, R)

    def pressed(P):
        contact = rwedge.Contact(THETA, a, A, F)
        contact.load(P)
        return contact

    P = shown.bisected(1e-3, rwedge.normal_load(THETA, a, A, a), lambda P: stress_intensities(pressed(P))[0] < K_N)
    return pressed(P)


def shear_for(contact, K_T):
    """The Q of K_T: that is in proportion to Q."""
    trial = contact.copy()
    trial.load(contact.P, 1e-3 * F * contact.P)
    return trial.Q * K_T / stress_intensities(trial)[1]


def at_the_edge(contact, Q, r):
    """After a cycle of Q: tractions at the distances r inside the trailing edge, the length that slips, and Smith, Watson and
    Topper's parameter at r inside and outside of it."""
    P, M = contact.P, contact.M
    contact.apply(P, M, [Q, -Q, Q], 0)
    edge = contact.edges[0]
    p, q = contact.tractions(edge + r)
    places = edge + np.concatenate([-r[::-1], [0], r])
    cycle = contact.stresses_after({"P": P, "M": M, "Q": Q * np.cos(np.linspace(0, 2 * math.pi, 25))}, places, 0)
    return {"p": -p, "q": -q, "slips": contact.stick_zone[0] - edge, "x": places - edge,
            "swt": rwedge.smith_watson_topper(*cycle, E, NU, axis=0)[0]}


def main():
    picture = shown.arguments(__file__, __doc__).picture
    joint = dovetail()
    Q = 0.06 * F * joint.P
    sheared = joint.copy()
    sheared.apply(joint.P, joint.M, Q, 0)
    K_N, K_T = stress_intensities(sheared)
    small = pad(50, K_N)
    Q_small = shear_for(small, K_T)
    r = 0.12 * np.linspace(0.01, 1, 161) ** 2  # dense at the edge
    edges = {"dovetail": at_the_edge(joint, Q, r), "pad": at_the_edge(small, Q_small, r)}

    print(f"K_N = {K_N:.1f} MPa/mm^0.5, K_T = {K_T:.3f} MPa mm^0.5, slip over {2 * abs(K_T) / (F * K_N):.5f} mm")
    peaks = {"dovetail": joint, "pad": small}
    shown.table(peaks, {
        "radius, mm": lambda name: peaks[name].a / THETA, "P, N/mm": lambda name: peaks[name].P,
        "Q, N/mm": lambda name: abs(peaks[name].Q), "half-width, mm": lambda name: peaks[name].half_width,
        "slip at the trailing edge, mm": lambda name: edges[name]["slips"],
        "worst Smith-Watson-Topper, MPa": lambda name: edges[name]["swt"].max()})
    ratio = edges["pad"]["swt"].max() / edges["dovetail"]["swt"].max()
    print(f"the pad tests the dovetail's edge to {100 * abs(ratio - 1):.1f} %")

    figure, (left, right) = shown.plt.subplots(1, 2, figsize=(9, 4))
    for number, (name, edge) in enumerate(edges.items()):
        style = shown.style(number)
        left.plot(r, edge["p"], linewidth=plot.THIN, **style)
        left.plot(r, edge["q"] / F, label=f"{name}, $b$ = {peaks[name].half_width:.2f} mm", **style)
        right.plot(edge["x"], edge["swt"], label=name, **style)
    left.plot(r, K_N * np.sqrt(r), color=plot.VERMILLION, linestyle=(0, (1, 2)), linewidth=1, label=r"$K_N\sqrt{r}$")
    left.set(xlim=(0, 0.12), ylim=(0, 1.1 * K_N * math.sqrt(0.12)), xlabel="distance from the trailing edge $r$ / mm",
             ylabel="$-p$ (thin), $-q/f$ / MPa")
    right.set(xlim=(-0.12, 0.12), xlabel="place beside the trailing edge / mm", ylabel="Smith–Watson–Topper / MPa")
    left.legend()
    shown.save(figure, picture, r_mm=r, **{f"{quantity}_{name}_MPa": edge[quantity] for name, edge in edges.items()
                                                     for quantity in ("p", "q")},
               **{f"swt_{name}_{side}_MPa": edge["swt"][len(r) + 1:] if side == "inside" else edge["swt"][len(r) - 1::-1]
                  for name, edge in edges.items() for side in ("inside", "outside")})


if __name__ == "__main__":
    main()
