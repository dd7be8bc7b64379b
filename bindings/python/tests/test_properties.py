# SPDX-License-Identifier: GPL-3.0-or-later
"""Properties over random arguments, edges and shapes (hypothesis)."""
import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from hypothesis.extra import numpy as arrays

import rwedge

ANY = st.floats(allow_nan=True, allow_infinity=True)
pytestmark = pytest.mark.filterwarnings("ignore:invalid value")


@given(ANY, ANY)
def test_pressure_is_a_pressure_or_nan_whatever_comes(alpha, x):
    p = rwedge.pressure(alpha, x)
    allowed = [v == 0 or 1e-60 <= v <= 1e60 for v in (alpha, abs(x))]
    valid = all(allowed) and not alpha == x == 0
    assert p <= 0 if valid else np.isnan(p)


@settings(max_examples=50)
@given(arrays.mutually_broadcastable_shapes(num_shapes=5, max_dims=3, max_side=4), st.randoms(use_true_random=False))
def test_stresses_of_any_shapes_are_those_point_by_point(shapes, random):
    draw = [lambda: random.uniform(0, 2), lambda: random.uniform(0, 1), lambda: random.uniform(0, 1),
            lambda: random.uniform(-3, 3), lambda: random.choice([0.0, random.uniform(0, 3), float("nan"), -1.0])]
    arguments = [np.array([value() for _ in range(int(np.prod(shape)))]).reshape(shape)
                 for value, shape in zip(draw, shapes.input_shapes)]
    together, spread = rwedge.stress(*arguments), np.broadcast_arrays(*arguments)
    assert together[0].shape == shapes.result_shape if shapes.result_shape else np.ndim(together[0]) == 0
    for index in np.ndindex(shapes.result_shape):
        alone = rwedge.stress(*(a[index] for a in spread))
        np.testing.assert_array_equal([s[index] for s in together], alone)
