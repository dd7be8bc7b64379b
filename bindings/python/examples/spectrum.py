# SPDX-License-Identifier: GPL-3.0-or-later
"""A dovetail under a spectrum: each flight starts and stops the engine, and the blade vibrates meanwhile. Counts the cycles of the
flank's stresses by rainflow, sums their damage on the worst plane of each place, and says what the vibration costs.
                                                                                                          spectrum.py PICTURE

Elastic stresses, and constants of a steel as an example (tables/materials/sae-1045-500-hb.json). Units are N and mm, so that
stresses are MPa and forces are per mm of thickness.
"""
import math

import numpy as np
import shown

import rwedge

STEEL = {"E": 206.8e3, "nu": 0.3, "sf": 2275, "b": -0.08, "ef": 0.25, "c": -0.68}
F, THETA = 0.5, 0.02
SPEEDS = (1500, 900, 1400, 700)  # the flank's normal load in N/mm at take-off, taxi, climb, idle
BEATS = 12  # of the vibration, at each speed


def flight(vibration):
    """P and Q of a flight: Q follows P, as the flank is inclined, and swings by `vibration` f P; then all but standstill."""
    loads = [(400, 0)]
    for P in SPEEDS:
        loads += [(P, 0.4 * F * P)]
        loads += [(P, (0.4 + sign * vibration) * F * P) for _ in range(BEATS) for sign in (1, -1)] if vibration else []
    return np.array(loads, dtype=float)


def steady(loads):
    """A pad on a flank that has gone through the flight twice."""
    contact = rwedge.Contact(THETA, rwedge.rounding(THETA, 20), rwedge.compliance(STEEL["E"], 0.3, STEEL["E"], 0.3), F)
    for _ in range(2):
        contact.load(loads[:, 0], loads[:, 1])
    return contact


def damage(vibration, x):
    loads = flight(vibration)
    return steady(loads).stresses_after(loads, x, 0).damage(STEEL)


def main():
    picture = shown.arguments(__file__, __doc__).picture
    loads = flight(0)
    contact = steady(loads)
    contact.load(loads[:, 0], loads[:, 1])
    contact.load(*loads[1])
    b = contact.half_width
    x = np.union1d(-b * np.linspace(0.3, 1.3, 101), [-b])
    results = {name: damage(vibration, x) for name, vibration in (("start and stop", 0), ("with vibration", 0.1))}
    print(f"{'':16}{'cycles':>8}{'damage of a flight':>20}{'flights':>12}{'x/b':>9}{'plane':>8}")
    for name, result in results.items():
        worst = result.value.argmax()
        print(f"{name:16}{result.cycles[worst]:8.0f}{result.value[worst]:20.3e}{1 / result.value[worst]:12.4g}"
              f"{x[worst] / b:9.3f}{math.degrees(result.angle[worst]):7.1f}°")
    still, shaken = (result.value.max() for result in results.values())
    print(f"the vibration does {100 * (1 - still / shaken):.0f} % of the damage")

    figure, ax = shown.plt.subplots(figsize=(6, 4))
    for number, (name, result) in enumerate(results.items()):
        ax.semilogy(x / b, np.maximum(result.value, 1e-30), label=name, **shown.style(number))
    ax.set(xlabel="$x/b$", ylabel="damage of a flight (Smith–Watson–Topper, Miner)", ylim=(1e-3 * still, 3 * shaken))
    ax.legend()
    shown.save(figure, picture, x_mm=x, **{f"damage_{name.replace(' ', '_')}": result.value for name, result in results.items()},
               **{f"cycles_{name.replace(' ', '_')}": result.cycles for name, result in results.items()})


if __name__ == "__main__":
    main()
