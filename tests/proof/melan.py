#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The shakedown of a cycle that stays in place, by mathematical programming: the values of ../data/cycle_shakedown.csv.

    melan.py LIBRARY a/b f Q_a/(fP)

Melan's theorem over residual stresses of an Airy function, which are in equilibrium and leave the surface free: products of
splines in x and y, and functions of the depth alone. rho_zz is free at each place. The peak of sqrt(J2) that is left is the
least of a linear program: planes that touch the cone of each place and load are added until its value is known to 1.2 %. Needs numpy
and scipy; LIBRARY is librwedge.so, of which it takes the elastic stresses alone."""
import ctypes
import sys

import numpy as np
from scipy.interpolate import BSpline
from scipy.optimize import linprog
from scipy.sparse import coo_matrix, csr_matrix, hstack

LOADS, NU = 8, 0.3


def library(path):
    lib = ctypes.CDLL(path)
    lib.rwedge_normal_load.restype = lib.rwedge_load.restype = ctypes.c_double
    lib.rwedge_normal_load.argtypes = [ctypes.c_double] * 4
    lib.rwedge_contact_create.argtypes = [ctypes.c_double] * 4 + [ctypes.c_void_p]
    lib.rwedge_contact_load.argtypes = [ctypes.c_void_p, ctypes.c_double, ctypes.c_double]
    lib.rwedge_contact_stresses.argtypes = [ctypes.c_void_p, ctypes.c_size_t] + [ctypes.c_void_p] * 5
    return lib


def elastic(lib, alpha, f, share, x, y):
    """The deviators after each load of Q = Q_a cos(2 pi i/LOADS), for theta = A = b = 1; and P."""
    contact = ctypes.c_void_p()
    assert lib.rwedge_contact_create(1.0, alpha, 1.0, f, ctypes.byref(contact)) == 0
    P = lib.rwedge_normal_load(1.0, alpha, 1.0, 1.0)
    s = [np.empty_like(x) for _ in range(3)]
    pointer = lambda a: a.ctypes.data_as(ctypes.c_void_p)
    paths = []
    assert lib.rwedge_contact_load(contact, P, 0.0) == 0
    for i in range(2 * LOADS):
        assert lib.rwedge_contact_load(contact, P, share * f * P * np.cos(2 * np.pi * i / LOADS)) == 0
        if i >= LOADS:
            assert lib.rwedge_contact_stresses(contact, len(x), *map(pointer, (x, y, *s))) == 0
            paths.append(np.column_stack([(s[1] - s[0]) / 2, (1 - 2 * NU) / np.sqrt(12) * (s[0] + s[1]), s[2]]))
    return np.array(paths), P


def splines(knots, at, derivative, drop):
    """Values at places of the cubic splines with these knots, but for `drop` at each end."""
    t = np.concatenate([[knots[0]] * 3, knots, [knots[-1]] * 3])
    n = len(t) - 4
    return np.column_stack([np.nan_to_num(BSpline(t, np.eye(n)[i], 3, extrapolate=False).derivative(derivative)(at)
                                          if derivative else BSpline(t, np.eye(n)[i], 3, extrapolate=False)(at))
                            for i in range(drop[0], n - drop[1])])


def residual(x, y, columns, rows):
    """Re D and txy of each function, at each place: ((rho_yy - rho_xx)/2, rho_xy)."""
    kx = np.sinh(np.linspace(-2, 2, columns)) / np.sinh(2) * 1.8
    ky = np.linspace(0, 1, rows) ** 1.7 * 1.6
    X = [splines(kx, x, d, (2, 2)) for d in range(3)]
    Y = [splines(ky, y, d, (2, 2)) for d in range(3)]
    X[0], X[1], X[2] = (np.column_stack([X[d], np.full_like(x, d == 0)]) for d in range(3))
    product = lambda a, b: (a[:, :, None] * b[:, None, :]).reshape(len(x), -1)
    return (product(X[2], Y[0]) - product(X[0], Y[2])) / 2, -product(X[1], Y[1])


def least_peak(paths, D, T):
    loads, n, _ = paths.shape
    m = D.shape[1]
    which, place, directions = [], [], []

    def add(load, at, unit):
        which.append(load), place.append(at), directions.append(unit)

    for load in range(loads):
        for at in range(n):
            for axis in (0, 2):
                for sign in (1, -1):
                    add(load, at, np.eye(3)[axis] * sign)
            add(load, at, paths[load, at] / max(np.linalg.norm(paths[load, at]), 1e-12))
    high = np.inf
    for _ in range(60):
        i, p, u = np.array(which), np.array(place), np.array(directions)
        A = u[:, :1] * D[p] + u[:, 2:] * T[p]
        z = coo_matrix((u[:, 1], (np.arange(len(p)), p)), shape=(len(p), n))
        rows = hstack([csr_matrix(A), z, csr_matrix(-np.ones((len(p), 1)))]).tocsr()
        b = -(u * paths[i, p]).sum(1)
        cost = np.zeros(m + n + 1)
        cost[-1] = 1
        answer = linprog(cost, A_ub=rows, b_ub=b, bounds=[(-3, 3)] * (m + n) + [(0, None)], method="highs")
        low = answer.fun
        v = paths + np.stack([np.broadcast_to(D @ answer.x[:m], (loads, n)),
                              np.broadcast_to(answer.x[m:m + n], (loads, n)),
                              np.broadcast_to(T @ answer.x[:m], (loads, n))], axis=2)
        size = np.linalg.norm(v, axis=2)
        high = min(high, size.max())
        print("peak between %.5f and %.5f, %d planes" % (low, high, len(p)), file=sys.stderr, flush=True)
        if high < low * 1.012:
            break
        for at in np.where(size.max(0) > low * 1.001)[0]:
            load = size[:, at].argmax()
            add(load, at, v[load, at] / size[load, at])
    return high


def main():
    lib, (alpha, f, share) = library(sys.argv[1]), map(float, sys.argv[2:5])
    xs = np.concatenate([-1.5 + 0.5 * np.linspace(0, 1, 5)[:-1], np.sin(np.linspace(-np.pi / 2, np.pi / 2, 29)), 1.5 - 0.5 * np.linspace(0, 1, 5)[:-1]])
    ys = np.concatenate([[0], np.geomspace(0.03, 1.2, 10)])
    x, y = (g.ravel().copy() for g in np.meshgrid(xs, ys))
    paths, P = elastic(lib, alpha, f, share, x, y)
    D, T = residual(x, y, 13, 9)
    high = least_peak(paths, D, T)
    print("%g,%g,%g,%g,%d,%.5g" % (alpha, f, share, NU, LOADS, P / high))


main()
