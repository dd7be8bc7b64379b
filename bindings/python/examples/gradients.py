# SPDX-License-Identifier: GPL-3.0-or-later
"""Gradients: the elastic limit as a function that JAX differentiates, and a pad that scipy finds by derivatives.

    python gradients.py gradients.svg

needs jax, scipy and matplotlib. JAX calls the library for the limit and for its gradient, in arrays, also under vmap and jit. The
pad carries P with friction f and yields at 2 P at the earliest. Of all that are at most 0.5 mm wide, which has the least tension
at its trailing edge? The answer is checked by a root that uses no derivative.
"""
import jax
import numpy as np
import shown
from scipy.optimize import brentq, minimize

import rwedge

jax.config.update("jax_enable_x64", True)


def called(function, results, *arguments):
    """The library's function of arrays inside of JAX, with so many results of the arguments' shape."""
    shape = jax.ShapeDtypeStruct(np.broadcast_shapes(*map(np.shape, arguments)), np.float64)
    return jax.pure_callback(function, (shape,) * results, *arguments, vmap_method="broadcast_all")


@jax.custom_jvp
def elastic_limit(alpha, f, nu):
    return called(lambda *a: (np.asarray(rwedge.elastic_limit(*map(np.asarray, a))),), 1, alpha, f, nu)[0]


@elastic_limit.defjvp
def _(point, direction):
    slopes = called(lambda *a: tuple(map(np.asarray, rwedge.elastic_limit_gradient(*map(np.asarray, a))[:3])), 3, *point)
    return elastic_limit(*point), sum(slope * step for slope, step in zip(slopes, direction))


def differ(count):
    """How many of so many gradients under vmap are not the library's own."""
    draw = np.random.default_rng(1)
    alpha, f, nu = draw.uniform(0.01, 0.99, count), draw.uniform(0.01, 0.8, count), draw.uniform(0.1, 0.45, count)
    gradients = jax.jit(jax.vmap(jax.grad(elastic_limit, argnums=(0, 1, 2))))(alpha, f, nu)
    return sum(int((np.asarray(ours) != own).sum()) for ours, own in zip(gradients, rwedge.elastic_limit_gradient(alpha, f, nu)))


P, F, NU, K, WIDEST, SAFETY = 100.0, 0.1, 0.3, 300.0, 0.25, 2.0  # N/mm; k in MPa; half-width in mm
A = rwedge.compliance(200e3, NU, 200e3, NU)


def tension(v):
    """At the trailing edge, over 10 MPa so that scipy's steps fit, and its derivatives by a/b and b."""
    alpha, b = v
    value = F * P * rwedge.max_tension(alpha) / b / 10
    return value, np.array([F * P * rwedge.max_tension_derivative(alpha) / b / 10, -value / b])


def safety(v):
    return rwedge.elastic_limit(v[0], F, NU) * v[1] * K / P - SAFETY


def safety_slope(v):
    d_alpha = rwedge.elastic_limit_gradient(v[0], F, NU)[0]
    return np.array([d_alpha * v[1], rwedge.elastic_limit(v[0], F, NU)]) * K / P


def best_pad(derivatives):
    jac = {"jac": safety_slope} if derivatives else {}
    return minimize(tension if derivatives else lambda v: tension(v)[0], (0.5, 0.2), jac=derivatives or None, method="SLSQP",
                    bounds=[(0.01, 0.99), (0.05, WIDEST)], constraints={"type": "ineq", "fun": safety, **jac},
                    options={"ftol": 1e-12})


def main():
    options = shown.arguments(__file__, __doc__)
    print(f"10000 gradients under vmap: {differ(10000)} of 30000 numbers differ from the library's")

    pad, without = best_pad(True), best_pad(False)
    alpha, b = pad.x
    theta = A * P / (b * rwedge.load(alpha))
    expected = brentq(lambda ratio: safety((ratio, WIDEST)), 0.01, 0.99, xtol=1e-14)
    print(f"a/b {alpha:.6f}, b {b:.4f} mm: theta {theta:.6f}, R {alpha * b / theta:.2f} mm, tension {10 * pad.fun:.3f} MPa")
    print(f"off the root by {abs(alpha - expected):.0e} after {pad.nfev} calls; without derivatives {without.nfev}")

    f = np.linspace(0.002, 0.6, 300)
    figure, axes = shown.plt.subplots(figsize=(7, 4.2))
    columns = {"f": f}
    for ratio in (0.1, 0.25, 0.5, 1.0):
        columns[f"a_over_b_{ratio}"] = slope = rwedge.elastic_limit_gradient(ratio, f, NU)[1]
        axes.plot(f, np.where(abs(np.diff(slope, prepend=slope[0])) < 1, slope, np.nan), label=f"{ratio}")
    axes.set(xlabel="coefficient of friction f", ylabel="derivative of P/(bk) by f", xlim=(0, 0.6),
             title=f"It jumps where yield goes to the surface, nu = {NU}")
    axes.legend(title="a/b")
    shown.save(figure, options.picture, **columns)


if __name__ == "__main__":
    main()
