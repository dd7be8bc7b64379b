# SPDX-License-Identifier: GPL-3.0-or-later
"""The elastic limit over a/b and friction, a million points, by two processes, chunk by chunk into a Zarr store.

    python sweep.py STORE.zarr [--rows 1000] [--columns 1000] [--check]

needs dask[array], distributed and zarr. The ufuncs take Dask's arrays as they take NumPy's. No process ever holds more than
some chunks, however large the sweep. --check compares what is stored with the same computed here, bit by bit.
"""
import argparse
import resource
import time

import dask.array as da
import numpy as np
import zarr
from distributed import Client, LocalCluster

import rwedge

NU = 0.3
CHUNK_ROWS = 50


def axes(rows, columns):
    """a/b and friction."""
    return np.geomspace(1e-3, 1, rows), np.linspace(0, 0.8, columns)


def sweep(store, rows, columns):
    """Stores the elastic limit at rows x columns points: a recipe, which the workers carry out."""
    alpha, f = axes(rows, columns)
    alpha = da.from_array(alpha, chunks=CHUNK_ROWS)[:, None]
    limit = rwedge.elastic_limit(alpha, f[None, :], NU)
    da.to_zarr(limit, store, overwrite=True)


def differs(store, rows, columns):
    """How many stored numbers are not the bits of the serial result, chunk by chunk."""
    alpha, f = axes(rows, columns)
    stored, wrong = zarr.open_array(store, mode="r"), 0
    for start in range(0, rows, CHUNK_ROWS):
        chunk = slice(start, start + CHUNK_ROWS)
        serial = rwedge.elastic_limit(alpha[chunk, None], f, NU)
        wrong += np.count_nonzero(stored[chunk].view(np.uint64) != serial.view(np.uint64))
    return wrong


def peak_memory():
    """Of this process so far, MB."""
    return resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024


def main():
    options = argparse.ArgumentParser()
    options.add_argument("store")
    options.add_argument("--rows", type=int, default=1000)
    options.add_argument("--columns", type=int, default=1000)
    options.add_argument("--check", action="store_true")
    given = options.parse_args()
    cluster = LocalCluster(n_workers=2, threads_per_worker=1, processes=True, dashboard_address=None)
    with cluster, Client(cluster) as client:
        sweep(given.store, 2 * CHUNK_ROWS, 10)  # everything is loaded then
        before, start = client.run(peak_memory), time.perf_counter()
        sweep(given.store, given.rows, given.columns)
        seconds, after = time.perf_counter() - start, client.run(peak_memory)
    grown = max(after[worker] - before[worker] for worker in after)
    print(f"{given.rows * given.columns} points in {seconds:.2f} s; "
          f"peak memory of a worker {max(after.values()):.0f} MB, grown by {grown:.1f} MB")
    if given.check:
        start = time.perf_counter()
        wrong = differs(given.store, given.rows, given.columns)
        print(f"{wrong} differ from the serial result, which took {time.perf_counter() - start:.2f} s")
        return int(wrong > 0)
    return 0


if __name__ == "__main__":
    raise SystemExit(main())
