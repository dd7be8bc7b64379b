# SPDX-License-Identifier: GPL-3.0-or-later
"""A ufunc takes hardly longer than C's loop. The bound is twice what is expected, as machines are busy: speed.py prints the
figures."""
import pytest
import speed

pytestmark = pytest.mark.long


@pytest.fixture(scope="module")
def loops():
    return speed.c_loops()


@pytest.mark.parametrize("name", speed.ARGUMENTS)
def test_ufunc_is_as_fast_as_a_loop_in_c(loops, name):
    points = 10_000 if name == "elastic_limit" else 1_000_000
    assert min(speed.ratio(loops, name, points, 5)[0] for _ in range(2)) < 2
