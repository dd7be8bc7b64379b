# SPDX-License-Identifier: GPL-3.0-or-later
"""A table of pads and their logs, by the processes of a Dask cluster: a CSV file in, Parquet out; histories by a bag; a contact that
is sent to the workers.                                           many.py PICTURE --pads 200 --workers 2

--workers 0 computes in this process. Parquet is read and written by the same calls: dd.read_parquet(), frame.to_parquet().
Spark takes the same function of a frame, in three lines:

    schema = "R double, f double, half_width double, safety double"
    table = spark.read.csv("pads.csv", header=True, inferSchema=True)
    table.mapInPandas(lambda frames: map(sizes, frames), schema).write.parquet("pads.parquet")

Units are N and mm, so that stresses are MPa and forces are per mm of thickness.
"""
from pathlib import Path

import dask
import dask.bag as db
import dask.dataframe as dd
import numpy as np
import pandas as pd
import shown
from design import workers

import rwedge
from rwedge import plot

P, NU = 300.0, 0.3
A = rwedge.compliance(200e3, NU, 200e3, NU)
K = 1500 / 3**0.5  # yield stress in shear of a hard steel
METAL = {"E": 200e3, "nu": NU, "sf": 827, "b": -0.11, "ef": 0.95, "c": -0.64}


def write_table(file, pads):
    """A table as a laboratory has it: a row for each pad."""
    generator = np.random.default_rng(1)
    pd.DataFrame({"R": generator.uniform(50, 400, pads), "f": generator.uniform(0.2, 0.8, pads)}).to_csv(file, index=False)


def sizes(frame):
    """A part of the table with its results: formulas take columns."""
    cylinder = [rwedge.Contact.cylinder(R, A, f) for R, f in zip(frame.R, frame.f)]
    for contact, f in zip(cylinder, frame.f):
        contact.load(P, [0, 0.999999 * f * P])
    return frame.assign(half_width=[contact.half_width for contact in cylinder],
                        safety=[contact.yield_factor(NU, K).factor for contact in cylinder])


def life(pad):
    """Passes of a log that the trailing edge lasts: one history, one task."""
    contact = rwedge.Contact.cylinder(pad["R"], A, pad["f"])
    contact.load(P)
    log = 0.7 * pad["f"] * P * np.array([1, -1, 0.5, -0.2, 1, -1])
    return float(contact.stresses_after({"P": P, "Q": log}, -contact.half_width, 0).life(METAL))


def further(contact, Q):
    """What a worker does with a contact that has been loaded elsewhere. It takes a copy: two tasks of a process share what they are
    given."""
    contact = contact.copy()
    contact.load(P, Q)
    return contact.loads.Q, contact.dissipated_energy


def compute(table, pads, count):
    """All results, by `count` processes, or by this one for 0."""
    with workers(count):
        rows = dd.read_csv(table).repartition(npartitions=4)
        rows.map_partitions(sizes, meta=sizes(pads.head(1))).to_parquet(table.with_suffix(".parquet"))
        lives = db.from_sequence(pads.to_dict("records"), npartitions=4).map(life).compute()
        pressed = rwedge.Contact.cylinder(50.0, A, 0.5)
        pressed.load(P)
        sent = dask.compute(*(dask.delayed(further)(pressed, Q) for Q in (50.0, 100.0)))
    return dd.read_parquet(table.with_suffix(".parquet")).compute(), np.array(lives), sent


def main():
    options = shown.arguments(__file__, __doc__, pads=(200, "rows of the table"), workers=(2, "processes; 0 for this one"))
    table = Path(options.picture).with_suffix(".table.csv")
    write_table(table, options.pads)
    pads = pd.read_csv(table)
    stored, lives, sent = compute(table, pads, options.workers)
    here = sizes(pads)
    differ = (stored.reset_index(drop=True) != here).to_numpy().sum() + sum(one != life(pad) for one, pad in zip(lives, pads.to_dict("records")))
    print(f"{len(stored)} pads and logs, {differ} numbers differ from the serial result")
    print("the contact that was sent:", ", ".join(f"Q = {Q:g}: {energy:.4g} N dissipated" for Q, energy in sent))
    figure, axes = shown.plt.subplots()
    axes.scatter(stored.f, lives, s=4 + stored.R / 10, color=plot.COLOURS[0])
    axes.set(xlabel="f (larger dots: larger radius)", ylabel="passes of the log", yscale="log")
    shown.save(figure, options.picture, R=stored.R, f=stored.f, half_width=stored.half_width, safety=stored.safety, life=lives)


if __name__ == "__main__":
    main()
