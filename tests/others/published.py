# SPDX-License-Identifier: GPL-3.0-or-later
"""What programs of others say to the same cases.    published.py LIBRARY contact_mechanics | tamaas | pylife

Lengths in b, stresses in theta/A. Each figure is printed with what it may be: about 1.5 times what was measured."""
import ctypes
import sys

import numpy as np

library = ctypes.CDLL(sys.argv[1])
number = ctypes.c_double
ALPHA, FLAT, F = 0.25, 0.5, 0.3
worst = 0


def call(name, *arguments):
    function = getattr(library, "rwedge_" + name)
    function.restype = number
    return function(*map(number, arguments))


def say(quantity, figure, limit):
    global worst
    print(f"{quantity:62} {figure:8.1e}  (at most {limit:.1e})")
    worst = max(worst, figure / limit)


def profile(x):
    return np.where(np.abs(x) < ALPHA, x * x / (2 * ALPHA), np.abs(x) - ALPHA / 2)


def pressures(x):
    return np.array([-call("pressure", ALPHA, place) if abs(place) < 1 else 0.0 for place in x])


def cells(n, length):
    return (np.arange(n) + 0.5) / n * length - length / 2


# (the library's function that makes it, its arguments, its height over the surface, its load): a contact of b = 1, theta/A = 1
PADS = {
    "wedge": ("contact_create", (0.01, ALPHA, 0.01, F), profile, call("load", ALPHA)),
    "flat pad": ("contact_create_flat", (FLAT, 1, 1, F), lambda x: np.maximum(np.abs(x) - FLAT, 0) ** 2 / 2,
                 np.arccos(FLAT) - FLAT * np.sqrt(1 - FLAT**2)),
}


def under_moment(pad, P, M, x):
    """Edges and pressures of the library."""
    contact, edges, array = ctypes.c_void_p(), (number(), number()), number * len(x)
    make, arguments, *_ = PADS[pad]
    assert getattr(library, "rwedge_" + make)(*map(number, arguments), ctypes.byref(contact)) == 0
    assert library.rwedge_contact_apply(contact, number(P), number(M), number(0), number(0)) == 0
    p, q = array(), array()
    assert library.rwedge_contact_tractions(contact, ctypes.c_size_t(len(x)), array(*x), p, q) == 0
    library.rwedge_contact_edges(contact, *map(ctypes.byref, edges))
    library.rwedge_contact_destroy(contact)
    return [edge.value for edge in edges], -np.array(p)


def contact_mechanics():
    """A strip of 3 b, free in x, periodic in 20 b along the line; E* = 2/A. A tilted profile makes the moment."""
    from ContactMechanics import SemiPeriodicFFTElasticHalfSpace
    from ContactMechanics.Systems import NonSmoothContactSystem
    from SurfaceTopography import Topography

    n, length, along = 4096, 3.0, 20.0
    x = cells(n, length)
    for pad, tilt in ("wedge", 0.0), ("wedge", 0.2), ("flat pad", 0.0), ("flat pad", 0.1):
        height, P = PADS[pad][2:]
        substrate = SemiPeriodicFFTElasticHalfSpace((n, 1), 2.0, (length, along), n_images=100)
        heights = Topography((tilt * x - height(x))[:, None], (length, along))
        solved = NonSmoothContactSystem(substrate, heights).minimize_proxy(external_force=P * along, pentol=1e-10, maxiter=2000)
        assert solved.success
        p = substrate.force[:n, 0] / (length / n * along)
        edges, ours = under_moment(pad, P, np.sum(p * x) * length / n, x)
        inside = (x > edges[0] + 0.05) & (x < edges[1] - 0.05)
        case = f"ContactMechanics: {pad}, tilt {tilt}"
        say(f"{case}: pressure, over the peak", np.max(np.abs(p - ours)[inside]) / np.max(ours), 1e-4)
        touching = x[p > 1e-3 * np.max(p)]
        say(f"{case}: edges, in cells of {length / n:.1e} b",
            np.max(np.abs([touching[0] - edges[0], touching[-1] - edges[1]])) / (length / n), 1.5)


def tamaas():
    """Partial slip with a stick zone of b/2, periodic in 64 b; next to each contact stands another."""
    import tamaas as tm

    tm.set_log_level(tm.LogLevel.error)
    # Poisson's ratio is next to 1/2, which parts pressure and shear
    n, length, stick, nu = 4096, 64.0, 0.5, 0.4999999
    x, P = cells(n, length), call("load", ALPHA)
    model = tm.Model(tm.model_type.surface_1d, [length], [n])
    model.E, model.nu = 2 * (1 - nu**2), nu
    solver = tm.PolonskyKeerTan(model, -profile(x), 1e-9, F)
    solver.max_iter = 3000
    solver.solve(np.array([F * P * call("shear_ratio", ALPHA, stick), P]) / length)
    traction = np.array(model.traction)
    q, ours = traction[:, 0], np.array([call("shear", ALPHA, stick, place) if abs(place) < 1 else 0 for place in x])
    inside = np.abs(x) < 0.95
    say("Tamaas: shear in partial slip, over f times the peak", np.max(np.abs(q + F * ours)[inside]) / (F * np.max(pressures(x))), 7e-3)
    stresses_below(tm, traction, x, stick, nu)


def stresses_below(tm, traction, x, stick, nu):
    """From a quarter of b to 2 b below the surface, under the tractions that Tamaas has found."""
    n, layers, along, step = len(x), 9, 2, x[1] - x[0]
    model = tm.Model(tm.model_type.volume_2d, [2.0, n * step, along * step], [layers, n, along])
    model.E, model.nu = 2 * (1 - nu**2), nu
    tm.ModelFactory.registerVolumeOperators(model)
    model.traction[..., 0], model.traction[..., 2] = traction[:, :1], traction[:, 1:]
    gradient, stress = np.zeros((layers, n, along, 6)), np.zeros((layers, n, along, 6))
    model.operators["boussinesq_gradient"](model.traction, gradient)
    model.operators["hooke"](gradient, stress)
    theirs = stress[..., 0, [0, 2, 4]] * (1, 1, 0.5**0.5)  # xx, zz, xz, which stands there times the root of 2
    largest, outputs = 0, [number() for _ in range(3)]
    for layer, depth in enumerate(np.linspace(0, 2, layers)[1:], 1):
        for i in np.flatnonzero(np.abs(x) < 2):
            assert library.rwedge_stress(*map(number, (ALPHA, F, stick, x[i], depth)), *map(ctypes.byref, outputs)) == 0
            largest = max(largest, np.max(np.abs(theirs[layer, i] - [output.value for output in outputs])))
    say("Tamaas: stresses below it, over the peak pressure", largest / np.max(pressures(x)), 1.8e-3)


def counted(ranges, counts):
    """How often each range is counted, ranges rounded to what they are made of."""
    sums = {}
    for size, count in zip(np.round(ranges, 9), counts):
        sums[size] = sums.get(size, 0) + count
    return {size: count for size, count in sums.items() if count and size}


def rainflow(values):
    n = len(values)
    array = number * n
    outputs = array(), array(), array()
    assert library.rwedge_rainflow(ctypes.c_size_t(n), array(*values), ctypes.c_int32(0), *outputs) == 0
    return counted(outputs[0], outputs[2])


def rainflow_by_pylife(values):
    """Its closed cycles, and its residuals half, range by range."""
    from pylife.stress import rainflow as theirs

    recorder = theirs.FullRecorder()
    left = np.abs(np.diff(theirs.FourPointDetector(recorder=recorder).process(values).residuals))
    closed = np.abs(np.subtract(recorder.values_from, recorder.values_to))
    return counted(np.concatenate([closed, left]), np.concatenate([np.ones(len(closed)), np.full(len(left), 0.5)]))


def pylife():
    """Von Mises and Tresca of 100,000 states in plane strain; rainflow of 200 histories."""
    from pylife.stress import equistress

    states, nu = np.random.default_rng(1).normal(size=(100_000, 3)), 0.3
    sxx, syy, txy = states.T
    szz, zero = nu * (sxx + syy), np.zeros_like(sxx)
    theirs = equistress.mises(sxx, syy, szz, txy, zero, zero)
    ours = np.array([call("von_mises", *state, nu) for state in states])
    say("pyLife: von Mises", np.max(np.abs(ours / theirs - 1)), 1e-14)
    theirs = equistress.tresca(sxx, syy, szz, txy, zero, zero)
    ours = 2 * np.array([call("largest_shear", *state, nu) for state in states])
    say("pyLife: Tresca", np.max(np.abs(ours / theirs - 1)), 1e-14)
    histories = [np.random.default_rng(k).integers(-9, 9, size=k % 60 + 2).astype(float) for k in range(200)]
    say("pyLife: rainflow, histories with another count", sum(rainflow(h) != rainflow_by_pylife(h) for h in histories), 0.5)


{"contact_mechanics": contact_mechanics, "tamaas": tamaas, "pylife": pylife}[sys.argv[2]]()
print("ok" if worst <= 1 else "FAILED: a figure is larger than it may be")
sys.exit(int(worst > 1))
