# SPDX-License-Identifier: GPL-3.0-or-later
"""Which radius keeps the safety against yield above 2, whatever the friction? A million pads, radius by friction, by two processes
under Dask into a Zarr store, chunk by chunk.                      design.py PICTURE --rows 1000 --columns 1000 --workers 2

The ufuncs take Dask's arrays as they take NumPy's. No process ever holds more than some chunks, however large the sweep. With
--workers 0 this process computes alone; --check compares what is stored with the same computed here, bit by bit.

Units are N and mm, so that stresses are MPa and forces are per mm of thickness.
"""
import contextlib
import time
from pathlib import Path

import dask
import dask.array as da
import numpy as np
import shown
import zarr

import rwedge
from rwedge import plot

THETA, P, NU = 0.01, 300.0, 0.3
A = rwedge.compliance(200e3, NU, 200e3, NU)
K = 800 / 3**0.5  # yield stress in shear of a steel of 800 MPa
SAFETY = 2
RADII, FRICTIONS = (1, 1000), (0, 0.8)
CHUNK_ROWS = 50


def axes(rows, columns):
    """Radii and frictions."""
    return np.geomspace(*RADII, rows), np.linspace(*FRICTIONS, columns)


def safety(R, f):
    """The load of first yield in full sliding, over the load: the contact grows with the load."""
    return rwedge.yield_load(THETA, rwedge.rounding(THETA, R), A, f, NU, K) / P


def sweep(store, rows, columns):
    """Stores the safety of rows x columns pads: a recipe, which the workers carry out."""
    R, f = axes(rows, columns)
    da.to_zarr(safety(da.from_array(R, chunks=CHUNK_ROWS)[:, None], f[None, :]), store, overwrite=True)


def differs(store, rows, columns):
    """How many stored numbers are not the bits of the serial result, chunk by chunk."""
    R, f = axes(rows, columns)
    stored, wrong = zarr.open_array(store, mode="r"), 0
    for start in range(0, rows, CHUNK_ROWS):
        chunk = slice(start, start + CHUNK_ROWS)
        wrong += np.count_nonzero(stored[chunk].view(np.uint64) != safety(R[chunk, None], f).view(np.uint64))
    return wrong


def smallest_radius(f):
    """The radius at which the safety is 2: it grows with the radius."""
    return shown.bisected(1e-3, 1e6, lambda R: safety(R, f) < SAFETY)


def workers(count):
    """That many processes for what Dask computes here; or this one."""
    if count == 0:
        return dask.config.set(scheduler="synchronous")
    from distributed import Client, LocalCluster

    stack = contextlib.ExitStack()
    cluster = stack.enter_context(LocalCluster(n_workers=count, threads_per_worker=1, processes=True, dashboard_address=None))
    stack.enter_context(Client(cluster))
    return stack


def main():
    options = shown.arguments(__file__, __doc__, rows=(1000, "radii"), columns=(1000, "frictions"),
                            workers=(2, "processes"), check=(0, "1: compare with the serial result"))
    store = Path(options.picture).with_suffix(".zarr")
    with workers(options.workers):
        sweep(store, 2 * CHUNK_ROWS, 2)  # everything is loaded then
        start = time.perf_counter()
        sweep(store, options.rows, options.columns)
        print(f"{options.rows * options.columns} pads in {time.perf_counter() - start:.2f} s")
    wrong = 0
    if options.check:
        start = time.perf_counter()
        wrong = differs(store, options.rows, options.columns)
        print(f"{wrong} differ from the serial result, which took {time.perf_counter() - start:.2f} s")
    f = np.linspace(*FRICTIONS, 41)
    R = smallest_radius(f)
    for at in (0, 15, 30):
        print(f"friction up to {f[at]:.1f}: R of at least {R[:at + 1].max():.1f} mm")

    figure, ax = shown.plt.subplots(figsize=(5.5, 4))
    rows, columns = axes(options.rows, options.columns)
    some = (slice(None, None, -(-options.rows // 200)), slice(None, None, -(-options.columns // 200)))
    lines = ax.contour(columns[some[1]], rows[some[0]], zarr.open_array(store, mode="r")[some], [0.1, 0.5, 1, 4, 8, 16, 64],
                       colors=plot.BLACK, linewidths=plot.THIN)
    ax.clabel(lines, fontsize="small")
    ax.plot(f, R, color=plot.VERMILLION, label=f"safety {SAFETY}")
    ax.set(yscale="log", ylim=RADII, xlim=FRICTIONS, xlabel="friction $f$", ylabel="radius $R$ / mm",
           title=f"yield load over $P$ = {P:g} N/mm")
    ax.legend(loc="upper left")
    shown.save(figure, options.picture, f=f, smallest_R_mm=R)
    return int(wrong > 0)


if __name__ == "__main__":
    raise SystemExit(main())
