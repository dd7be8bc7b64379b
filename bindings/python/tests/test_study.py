# SPDX-License-Identifier: GPL-3.0-or-later
"""A study of many contacts, pads by loads, under Dask: the bits of the serial result, and on two workers faster.

    python bindings/python/tests/test_study.py        prints how much faster
"""
import math
import time

import numpy as np
import pytest

import rwedge

E, NU, P = 72e3, 0.33, 60.0
PHASE = np.cos(np.linspace(0, 2 * math.pi, 25))


def worst(R, f, ratio):
    """Smith, Watson and Topper's parameter at the worst place of each contact: one radius, friction and Q/(f P) each."""
    found = np.empty(np.broadcast_shapes(R.shape, f.shape, ratio.shape))
    for index, (radius, friction, part) in enumerate(zip(*(a.ravel() for a in np.broadcast_arrays(R, f, ratio)))):
        pad = rwedge.Contact(0.005, rwedge.rounding(0.005, radius), rwedge.compliance(E, NU, E, NU), friction)
        pad.load(P, [0, part * friction * P])
        x = pad.half_width * np.append(np.linspace(-1.2, 1.2, 40), -1)
        cycle = pad.cycle({"Q": part * friction * P * PHASE}, x, 0)
        found.flat[index] = rwedge.smith_watson_topper(*cycle, E, NU, axis=0)[0].max()
    return found


def study(pads, loads, chunk):
    """Recipe and arguments: pads of all radii and frictions, by ratios of Q/(f P)."""
    da = pytest.importorskip("dask.array")
    R, f = (a.reshape(-1, 1) for a in np.meshgrid(np.geomspace(5, 200, pads), np.linspace(0.2, 0.8, 10)))
    ratio = np.linspace(0.1, 0.95, loads)[None, :]
    lazy = [da.from_array(a, chunks=(chunk if a.shape[0] > 1 else 1, -1)) for a in (R, f, ratio)]
    return da.map_blocks(worst, *lazy, dtype=float), (R, f, ratio)


def on_two_workers(pads, loads, chunk):
    """Seconds here and there; the results must have the same bits."""
    distributed = pytest.importorskip("distributed")
    warm, _ = study(1, 2, 5)
    recipe, arguments = study(pads, loads, chunk)
    with distributed.LocalCluster(n_workers=2, threads_per_worker=1, processes=True, dashboard_address=None) as cluster, \
            distributed.Client(cluster):
        warm.compute()
        start = time.perf_counter()
        parallel = recipe.compute()
        there = time.perf_counter() - start
    start = time.perf_counter()
    serial = worst(*arguments)
    here = time.perf_counter() - start
    assert parallel.shape == (10 * pads, loads) and (parallel.view(np.uint64) == serial.view(np.uint64)).all()
    return here, there


def test_a_study_under_dask_has_the_bits_of_the_serial_one():
    recipe, arguments = study(3, 4, 10)
    assert (recipe.compute(scheduler="threads") == worst(*arguments)).all()


@pytest.mark.long
def test_ten_thousand_contacts_on_two_workers_are_the_same_and_faster():
    for _ in range(3):  # others may use this machine for a while
        here, there = on_two_workers(50, 20, 25)
        if there < here:
            break
    assert there < here


if __name__ == "__main__":
    seconds = on_two_workers(50, 20, 25)
    print(f"10000 contacts: {seconds[0]:.1f} s here, {seconds[1]:.1f} s on two workers")
