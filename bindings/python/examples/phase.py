# SPDX-License-Identifier: GPL-3.0-or-later
"""Loads without a closed form: a bulk tension that lags behind Q, and a log with noise. Prints Smith, Watson and Topper's parameter
over the lag, and which loads of the log are exact and which are computed, with the error that is told.       phase.py PICTURE

The test is that of fretting.py, after D. Nowell and D. A. Hills, Int. J. Mech. Sci. 29 (1987) 355-365, where Q and the tension are
in phase. Units are N and mm, so that stresses are MPa and forces are per mm of thickness.
"""
import math

import numpy as np
import shown

import rwedge
from rwedge import plot

E, NU, F, THETA, R = 72.1e3, 0.33, 0.3, 0.05, 10
P, Q, SIGMA = 543 / 4, 155 / 4, 100
LAGS = range(0, 91, 15)  # degrees
TURN = 2 * math.pi


def pressed(tolerance=1e-4):
    contact = rwedge.Contact(THETA, rwedge.rounding(THETA, R), rwedge.compliance(E, NU, E, NU), F, tolerance=tolerance)
    contact.load(P)
    return contact


def lagging(lag, loads=24):
    """A cycle that ends where it begins."""
    turn = np.linspace(0, TURN, loads + 1)
    return {"P": P, "M": 0, "Q": Q * np.sin(turn), "sigma": SIGMA * np.sin(turn - math.radians(lag))}


def worst_of(lag, b):
    """Smith, Watson and Topper's parameter of a second cycle, the largest at the left edge and at the right one; error of q."""
    contact, x = pressed(), b * np.linspace(0.9, 1.1, 41)
    contact.apply(**lagging(lag))
    cycle = contact.stresses_after(lagging(lag), [-x, x], 0)
    value, _ = rwedge.smith_watson_topper(*cycle, E, NU, axis=0)
    return *value.max(axis=1), contact.error


def measured(cycles=4, loads=24, noise=0.01):
    """A log of Q and the tension, in phase but for its noise: at first the rig runs smoothly; in the last cycle it overshoots."""
    turn = np.arange(1, cycles * loads + 1) * TURN / loads
    scatter = np.random.default_rng(2026).normal(0, noise, (2, turn.size)) * (turn > TURN)
    wave = 0.6 * np.sin(turn) + scatter
    wave[0, -1 - 3 * loads // 4] = F * P / Q  # slides
    return wave[0] * Q, wave[1] * SIGMA


def follow(contact, log, x):
    """The error that is told after each load, and sxx at x."""
    told, stress = [], []
    for load, tension in zip(*log):
        contact.apply(P, 0, load, tension)
        told.append(contact.error)
        stress.append(contact.stresses(x, 0)[0])
    return np.array(told), np.array(stress)


def main():
    picture = shown.arguments(__file__, __doc__).picture
    b = pressed().half_width
    worst = np.array([worst_of(lag, b) for lag in LAGS])
    print("Smith-Watson-Topper, MPa\ntension behind Q    left edge   right edge   error of q over f p0")
    for lag, (left, right, error) in zip(LAGS, worst):
        print(f"{lag:15}°{left:13.4f}{right:13.4f}{error:16.0e}")

    log = measured()
    error, stress = follow(pressed(1e-3), log, -b)
    exact = error == 0
    print(f"the log: {exact.sum()} of {exact.size} loads exact, the others to {error.max():.0e} of f p0 at most")

    figure, (top, middle, bottom) = shown.plt.subplots(3, figsize=(5.5, 7.5))
    for edge, name in enumerate(("left edge", "right edge")):
        top.plot(LAGS, worst[:, edge], label=name, **shown.style(edge))
    top.legend()
    top.set(xlabel="tension behind $Q$ / degrees", ylabel="Smith–Watson–Topper / MPa", ylim=(0, None), xticks=LAGS)
    number = np.arange(1, exact.size + 1)
    for ax, values, name in ((middle, log[0], "$Q$ / (N/mm)"), (bottom, stress, "$\\sigma_{xx}$ at $x = -b$ / MPa")):
        ax.plot(number, values, color=plot.BLACK, linewidth=plot.THIN)
        ax.plot(number[exact], values[exact], "o", color=plot.BLUE, markersize=4, label="exact")
        ax.plot(number[~exact], values[~exact], "o", color=plot.VERMILLION, fillstyle="none", markersize=4, label="computed")
        ax.set_ylabel(name)
    middle.legend(ncols=2, loc="lower left", bbox_to_anchor=(0, 1))
    bottom.set_xlabel("load of the log")
    shown.save(figure, picture, load=number, Q_N_per_mm=log[0], sigma_MPa=log[1], sxx_MPa=stress, error=error)


if __name__ == "__main__":
    main()
