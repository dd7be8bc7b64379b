# SPDX-License-Identifier: GPL-3.0-or-later
"""The main formulas as an afternoon with mpmath and scipy would have them, against the library.    by_hand.py LIBRARY

Natural units: lengths in b, stresses in theta/A; compression is negative. Nothing of the library is used but its answers."""
import ctypes
import sys

import numpy as np
from mpmath import mp, mpf
from scipy import integrate, optimize

library = ctypes.CDLL(sys.argv[1])
mp.dps = 25
worst = 0


def call(name, *arguments, results=0):
    """A function of numbers: its value, or the results that it writes."""
    function = getattr(library, "rwedge_" + name)
    function.argtypes = [ctypes.c_double] * len(arguments) + [ctypes.POINTER(ctypes.c_double)] * results
    function.restype = ctypes.c_int32 if results else ctypes.c_double
    written = [ctypes.c_double() for _ in range(results)]
    value = function(*map(float, arguments), *map(ctypes.byref, written))
    assert not results or value == 0, f"{name} returns the status {value}"
    return [result.value for result in written] if results else value


def compare(quantity, by_hand, ours, tolerance, norm=None):
    global worst
    error = float(abs(by_hand - ours) / (norm or abs(by_hand)))
    print(f"{quantity:52} {float(by_hand):20.15f} {ours:20.15f} {error:8.1e}")
    worst = max(worst, error / tolerance)


def integral(function, *places):
    """Over -1 to 1, split where the integrand has a corner; x = sin v takes the roots at the edges away."""
    angles = sorted({mp.asin(place) for place in (-1, *places, 1)})
    return mp.quad(lambda v: function(mp.sin(v)) * mp.cos(v), angles)


for alpha in mpf(1) / 4, mpf(3) / 5:
    phi, case = mp.asin(alpha), f", a/b = {float(alpha)}"

    def pressure(x):  # Eq. (8)
        v = mp.asin(x)
        logs = mp.log(abs(mp.tan((v + phi) / 2) * mp.tan((v - phi) / 2))), mp.log(abs(mp.sin(v - phi) / mp.sin(v + phi)))
        return (logs[0] - 2 * phi * mp.cos(v) / alpha - x / alpha * logs[1]) / mp.pi

    x = mpf("0.45")
    compare("pressure at 0.45 b" + case, pressure(x), call("pressure", alpha, x), 1e-14)
    # The pressure bends the surface to the profile, Eq. (3): the slope at x is x/alpha, or 1 beyond the rounding.
    regular = integral(lambda t: (pressure(t) - pressure(x)) / (t - x) if t != x else 0, -alpha, x, alpha)
    slope = (regular + pressure(x) * mp.log((1 - x) / (1 + x))) / mp.pi
    compare("slope under that pressure", slope, float(min(x / alpha, 1)), 1e-12)
    load = -integral(pressure, -alpha, 0, alpha)
    compare("load A P/(theta b)", load, call("load", alpha), 1e-14)
    compare("peak pressure", -pressure(mpf("1e-20")), call("peak_pressure", alpha), 1e-14)
    compare("a/b of that load", alpha, call("a_over_b", load / alpha), 1e-14)

    # Partial slip: f p less f times the pressure of the same wedge pressed to the half-width c.
    c, f = mpf("0.4"), mpf("0.3")
    closed_load = lambda r: (mp.asin(r) + r * mp.sqrt(1 - r**2)) / r if r < 1 else mp.pi / 2 / r  # Eq. (7), (13)
    compare("Q/(f P) where 0.4 b sticks", 1 - c * closed_load(alpha / c) / load, call("shear_ratio", alpha, c), 1e-14)

    # Stresses: Flamant's lines of force, added up over the contact that slides.
    x, y = mpf("0.35"), mpf("0.3")
    def force(power_x, power_y):
        return -2 / mp.pi * integral(
            lambda t: -pressure(t) * (x - t) ** power_x * y**power_y / ((x - t) ** 2 + y**2) ** 2, -alpha, 0, x, alpha)
    flamant = force(2, 1) + f * force(3, 0), force(0, 3) + f * force(1, 2), force(1, 2) + f * force(2, 1)
    ours = call("stress", alpha, f, 0, x, y, results=3)
    norm = mp.norm(flamant)
    for name, by_hand, answer in zip(("sxx", "syy", "txy"), flamant, ours):
        compare(name + " in sliding, f = 0.3, at (0.35, 0.3) b", by_hand, answer, 1e-13, norm)

    # Elastic limit: the largest J2 of all points, by scipy. The integral of Flamant's forces in closed form is G.
    a, phi0, nu = float(alpha), float(phi), 0.3
    def root_j2(point, f):
        z = complex(point[0], max(point[1], 1e-13))
        root = np.sqrt(z - 1) * np.sqrt(z + 1)
        turn = np.arctan(np.tan(phi0) * root / z)
        G = 2 / np.pi * (np.arctan(np.sqrt(1 - a * a) / root) + z / a * turn - phi0 * root / a)
        dG = 2 / (np.pi * a) * (turn - phi0 * z / root)
        difference = -z.imag * dG + 1j * z.imag * f * dG + f * G
        return np.hypot(abs(difference), (1 - 2 * nu) / np.sqrt(3) * (G.imag - f * G.real))
    for f in 0.0, 0.1, 0.4:
        top = optimize.differential_evolution(lambda point: -root_j2(point, f), [(-1.1, 1.1), (0, 1.5)], seed=1, tol=1e-12)
        compare(f"elastic limit P/(b k), f = {f}" + case, float(load) / -top.fun, call("elastic_limit", alpha, f, nu), 1e-8)
    # At the trailing edge p is 0 and sxx is 2 f times the slope, which is 1 there.
    compare("maximum tension b s1/(f P)", 2 / load, call("max_tension", alpha), 1e-14)

# A moment: equilibrium of a patch [m - s, m + s], P = 2 and M = 0.6, lengths in a. Slope g, tilt d, t = m + s sin v.
slope = lambda t: np.clip(t, -1, 1)
def equilibrium(patch):
    m, s = patch
    over = lambda function: integrate.quad(function, -np.pi / 2, np.pi / 2, epsabs=1e-14, limit=500,
        points=[np.arcsin((corner - m) / s) for corner in (-1, 1) if abs(corner - m) < s])[0]
    tilt = over(lambda v: slope(m + s * np.sin(v))) / np.pi
    P = over(lambda v: slope(m + s * np.sin(v)) * s * np.sin(v))
    return P - 2, m * P + s * s * over(lambda v: (slope(m + s * np.sin(v)) - tilt) * np.sin(v) ** 2) - 0.6
m, s = optimize.fsolve(equilibrium, (0.2, 1.2), xtol=1e-14)
contact = ctypes.c_void_p()
number, place = ctypes.c_double, [ctypes.c_double(), ctypes.c_double()]
library.rwedge_contact_create(number(0.01), number(1), number(0.01), number(0.3), ctypes.byref(contact))
assert library.rwedge_contact_apply(contact, number(2), number(0.6), number(0), number(0)) == 0
assert library.rwedge_contact_edges(contact, *map(ctypes.byref, place)) == 0
library.rwedge_contact_destroy(contact)
for name, by_hand, answer in zip(("left", "right"), (m - s, m + s), place):
    compare(f"{name} edge under P and M, in a", by_hand, answer.value, 1e-11)
print("ok" if worst <= 1 else "FAILED: a difference is larger than it may be")
sys.exit(int(worst > 1))
