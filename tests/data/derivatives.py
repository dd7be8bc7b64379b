# SPDX-License-Identifier: GPL-3.0-or-later
"""Writes the derivatives of this folder: difference quotients of the paper's formulas, in 60 digits with mpmath.

    python3 tests/data/derivatives.py

Points and first guesses of the maxima come from the other tables here. Steps are 1e-16 of the distance to the nearest
singularity, to both sides. At the surface, and where the rounding ends at an edge, they are seven to the smooth side."""
import csv
from pathlib import Path

from mpmath import mp, mpc, mpf

mp.dps = 60
FOLDER = Path(__file__).parent
ONE_SIDED = [mpf(x) / 60 for x in (-147, 360, -450, 400, -225, 72, -10)]  # of a derivative, at 0, h, ... 6 h


def rows(name, every=1):
    with open(FOLDER / name, encoding="ascii") as file:
        return [[mpf(float(x)) for x in row if x[0] != "s"] for row in list(csv.reader(file))[1::every]]


def write(name, arguments, results, table):
    with open(FOLDER / name, "w", encoding="ascii") as file:
        file.write(f"{arguments},{results}\n")
        for given, derivatives in table:
            file.write(",".join([repr(float(x)) for x in given] + [mp.nstr(x if abs(x) > mpf("1e-40") else mpf(0), 20) for x in derivatives]) + "\n")


def quotient(function, at, scale, side=0):
    if side:
        h = side * scale * mpf("1e-7")
        return sum(weight * function(at + i * h) for i, weight in enumerate(ONE_SIDED)) / h
    h = scale * mpf("1e-16")
    return (function(at + h) - function(at - h)) / (2 * h)


def load(alpha):
    return (mp.asin(alpha) + alpha * mp.sqrt(1 - alpha**2)) / alpha if alpha < 1 else mp.pi / 2 / alpha


def root(z, half):
    return mp.sqrt(z - half) * mp.sqrt(z + half)


def potentials(a, half, z):
    """G, G' and G'' of the wedge pressed to that half-width; z above the surface."""
    X = root(z, half)
    if a >= half:
        return (z - X) / a, (1 - z / X) / a, half**2 / X**3 / a
    if a == 0:
        return 2 / mp.pi * mp.atan(half / X), -2 / mp.pi * half / (z * X), None
    phi, c0 = mp.asin(a / half), mp.sqrt(half**2 - a**2)
    turn = mp.atan(a / c0 * X / z)
    return (2 / mp.pi * (mp.atan(c0 / X) + z / a * turn - phi * X / a), 2 / (mp.pi * a) * (turn - phi * z / X),
            2 / (mp.pi * a) * (a * c0 / (X * (z**2 - a**2)) + phi * half**2 / X**3))


def stresses(alpha, f, c, x, y):
    z = mpc(x, y + mpf("1e-55"))
    G, slope, _ = potentials(alpha, mpf(1), z)
    shear, shear_slope = f * G, f * slope
    if c > 0:
        stick = potentials(alpha, c, z)
        shear, shear_slope = f * (G - stick[0]), f * (slope - stick[1])
    D = z.imag * (1j * shear_slope - slope) + shear
    s = G.imag - shear.real
    return mp.matrix([s - D.real, s + D.real, D.imag])


def of_stresses(alpha, f, c, x, y):
    from_edge = min(mp.hypot(abs(x) - edge, y) for edge in (alpha, 1) + (c,) * (c > 0))
    derivative = [quotient(lambda v: stresses(alpha, f, c, v, y), x, from_edge),
                  quotient(lambda v: stresses(alpha, f, c, x, v), y, min(y or 1, from_edge), y == 0),
                  quotient(lambda v: stresses(v, f, c, x, y), alpha, min(alpha, from_edge, abs(alpha - c) or 1, abs(alpha - 1) or 1), alpha in (c, 1)),
                  stresses(alpha, 1, c, x, y) - stresses(alpha, 0, c, x, y),
                  quotient(lambda v: stresses(alpha, f, v, x, y), c, min(c, from_edge, abs(alpha - c) or 1), -(alpha == c))]
    return [component for d in derivative for component in d]


def J2_and_slopes(alpha, f, kappa, x, y):
    """J2 and its derivatives by x and y."""
    z = mpc(x, y)
    G, d, dd = potentials(alpha, mpf(1), z)
    mu, sigma = mpc(-1, f), mpc(-f, -1)
    D, Dx = f * G + mu * y * d, f * d + mu * y * dd
    Dy, s, sx, sy = 1j * Dx + mu * d, (sigma * G).real, (sigma * d).real, (1j * sigma * d).real
    dot = lambda a, b: (a * mp.conj(b)).real
    return dot(D, D) + kappa * s**2, dot(D, Dx) + kappa * s * sx, dot(D, Dy) + kappa * s * sy


def surface_J2(alpha, f, kappa, x):
    v, phi = mp.asin(x), mp.asin(alpha)
    logs = mp.log(abs(mp.tan((v + phi) / 2) * mp.tan((v - phi) / 2))), mp.log(abs(mp.sin(v - phi) / mp.sin(v + phi)))
    p = (logs[0] - 2 * phi * mp.cos(v) / alpha - x / alpha * logs[1]) / mp.pi
    if alpha >= 1:
        p = -mp.sqrt(1 - x**2) / alpha
    return f**2 * ((x / alpha) ** 2 + p**2) + kappa * (p - f * x / alpha) ** 2


def limit(alpha, f, nu, x, y):
    """Of the maximum next to (x, y)."""
    kappa = (1 - 2 * nu) ** 2 / 3
    if y == 0:
        if f != 0 and kappa != 0 or alpha < 1 and x != 0:
            x = mp.findroot(lambda t: mp.diff(lambda v: surface_J2(alpha, f, kappa, v), t), (x, x * (1 + mpf("1e-12"))), tol=1e-70)
        return load(alpha) / mp.sqrt(surface_J2(alpha, f, kappa, x))
    place = mp.findroot(lambda u, v: J2_and_slopes(alpha, f, kappa, u, v)[1:], (x, y), tol=1e-80) if x else \
        (x, mp.findroot(lambda v: J2_and_slopes(alpha, f, kappa, x, v)[2], (y, y * (1 + mpf("1e-12"))), tol=1e-80))
    return load(alpha) / mp.sqrt(J2_and_slopes(alpha, f, kappa, *place)[0])


def of_limit(alpha, f, nu, x, y):
    d_alpha = quotient(lambda v: limit(v, f, nu, x, y), alpha, min(alpha, 1 - alpha)) if alpha < 1 else mpf(0)
    tip = min(alpha, mpf(1))  # beyond, the limit is that of 1
    d_f = quotient(lambda v: limit(tip, v, nu, x, y), f, f) if f else mpf(0)
    return d_alpha, d_f, quotient(lambda v: limit(tip, f, v, x, y), nu, mpf(1))


if __name__ == "__main__":
    write("contact_law_derivatives.csv", "a_over_b", "load,max_tension",
          [([a], [quotient(load, a, min(a, abs(1 - a))), quotient(lambda v: 2 / load(v), a, min(a, 1 - a)) if a < 1 else 0])
           for a in (row[0] for row in rows("contact_law.csv", 7)) if a != 1])
    write("limit_gradient.csv", "a_over_b,f,nu", "d_alpha,d_f,d_nu,y_over_b",
          [(row[:3], [*of_limit(*row[:3], *row[4:6]), row[5]]) for row in rows("elastic_limit.csv", 2)
           if row[0] >= mpf("1e-3") and not (row[2] == 0.5 and row[5] == 0)])
    write("stress_gradient.csv", "a_over_b,f,c_over_b,x_over_b,y_over_b",
          "sxx_x,syy_x,txy_x,sxx_y,syy_y,txy_y,sxx_alpha,syy_alpha,txy_alpha,sxx_f,syy_f,txy_f,sxx_c,syy_c,txy_c",
          [(row[:5], of_stresses(*row[:5])) for row in rows("stress_partial_slip.csv", 9)
           if row[4] > 0 or abs(row[3]) not in (1, row[0], row[2])])
