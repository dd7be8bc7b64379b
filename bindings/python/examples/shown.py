# SPDX-License-Identifier: GPL-3.0-or-later
"""What the examples share: a figure is written with the numbers behind it, in a CSV file beside it. A picture names the script,
the style and the numbers that it was made of, so that the tests find one that is stale."""
import argparse
import csv
import hashlib
import inspect
from pathlib import Path

import numpy as np

from rwedge import plot


def arguments(script, text, **options):
    """The path of the picture, and options of the form name=(default, help)."""
    parser = argparse.ArgumentParser(prog=Path(script).name, description=text.split("\n\n")[0])
    parser.add_argument("picture", help="such as picture.svg or picture.png; the numbers go into a .csv beside it")
    for name, (default, help_text) in options.items():
        parser.add_argument(f"--{name}", type=type(default), default=default, help=f"{help_text} (default: {default})")
    return parser.parse_args()


def fingerprint(script, table):
    """Of the script, the style of the pictures, and the numbers."""
    texts = Path(script).read_text(), inspect.getsource(plot), Path(table).read_text()
    return hashlib.sha256("\n".join(texts).encode()).hexdigest()


def save(figure, script, picture, **columns):
    """The figure, and columns of numbers of one length: nine digits, as the last ones differ between machines."""
    import matplotlib

    table = Path(picture).with_suffix(".csv")
    rows = np.column_stack([np.asarray(column, dtype=float) for column in columns.values()])
    with open(table, "w", newline="") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(columns)
        writer.writerows([f"{value + 0:.9g}" for value in row] for row in rows)
    matplotlib.rcParams["svg.hashsalt"] = "rwedge"
    about = {"Date": None} if str(picture).endswith(".svg") else {}
    figure.savefig(picture, metadata={"Description": fingerprint(script, table), **about})
