# SPDX-License-Identifier: GPL-3.0-or-later
"""The life of a fretting specimen without an assumed crack: the cycles that start a crack of a length, by Smith, Watson and
Topper's parameter at that depth, and the cycles in which it grows through. Their sum is least at one length
(initiation and propagation apart, as C. Navarro, M. Garcia and J. Dominguez, ASTM STP10755S, 2003). Prints both for each length,
and the least sum.                                                                                total_life.py PICTURE

Normalized steel SAE 1015 under a cylinder. Its life is by the constants in tables/materials/. Growth is by an assumed law of the
size that steels have, 6.9e-12 m (dK in MPa sqrt(m))^3 a cycle: take the constants of your own material.
Units are N and mm, so that K is in MPa sqrt(mm).
"""
import math

import numpy as np
import shown

import rwedge

E, NU, STEEL = 206800, 0.3, {"sf": 827, "b": -0.11, "ef": 0.95, "c": -0.64, "limit": 0}
LAW = {"dK_th": 0, "C": 6.9e-12 * 1000 / math.sqrt(1000)**3, "m": 3}
R, F, P, Q, SIGMA, END = 50, 0.75, 300, 130, 160, 10
LENGTHS = np.geomspace(0.01, 2, 41)


def steady_cycle():
    """Q and the tension to and fro in phase, in 8 steps; and the place of the trailing edge."""
    contact, share = rwedge.Contact.flat(0, R, rwedge.compliance(E, NU, E, NU), F), np.cos(np.arange(1, 9) * math.pi / 4)
    contact.load(P)
    loads = {"P": P, "M": 0, "Q": Q * share, "sigma": SIGMA * share}
    contact.apply(P, 0, Q, SIGMA)
    contact.apply(**loads)
    return contact.cycle(loads), contact.edges[0]


def initiation(cycle, edge, length):
    """Cycles to a crack as deep as that: by the stresses there, on the worst plane."""
    swt, _ = rwedge.smith_watson_topper(*cycle.below(edge, 0, 2 * length, 0), E, NU)
    return rwedge.smith_watson_topper_life(swt, E, *STEEL.values())


def main():
    picture = shown.arguments(__file__, __doc__).picture
    cycle, edge = steady_cycle()
    begins = np.array([initiation(cycle, edge, length) for length in LENGTHS])
    grows = np.array([cycle.growth(edge, 0, rwedge.Faces.MODE_I, LAW, length, END).cycles for length in LENGTHS])
    least = np.argmin(begins + grows)
    print("length, mm      cycles to start it      cycles to grow through")
    for row in zip(LENGTHS[::5], begins[::5], grows[::5]):
        print("{:10.4f}{:24.4g}{:28.4g}".format(*row))
    print(f"life {begins[least] + grows[least]:.3g} cycles, of which {begins[least]:.3g} start a crack of {LENGTHS[least]:.3g} mm")

    figure, axes = shown.plt.subplots(figsize=(6, 4))
    for i, (name, cycles) in enumerate({"start": begins, "growth": grows, "both": begins + grows}.items()):
        axes.loglog(LENGTHS, cycles, label=name, **shown.style(i))
    axes.set(xlabel="length of the crack, mm", ylabel="cycles")
    axes.legend()
    shown.save(figure, picture, length=LENGTHS, start=begins, growth=grows, both=begins + grows)


if __name__ == "__main__":
    main()
