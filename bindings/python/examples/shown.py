# SPDX-License-Identifier: GPL-3.0-or-later
"""What the examples share: a figure is written with the numbers behind it, in a CSV file beside it."""
import argparse
import csv
from pathlib import Path

import numpy as np


def arguments(script, text, **options):
    """The path of the picture, and options of the form name=(default, help)."""
    parser = argparse.ArgumentParser(prog=Path(script).name, description=text.split("\n\n")[0])
    parser.add_argument("picture", help="such as picture.svg or picture.png; the numbers go into a .csv beside it")
    for name, (default, help_text) in options.items():
        parser.add_argument(f"--{name}", type=type(default), default=default, help=f"{help_text} (default: {default})")
    return parser.parse_args()


def save(figure, picture, **columns):
    """The figure, and columns of numbers of one length: nine digits, as the last ones differ between machines."""
    import matplotlib

    table = Path(picture).with_suffix(".csv")
    rows = np.column_stack([np.asarray(column, dtype=float) for column in columns.values()])
    with open(table, "w", newline="") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(columns)
        writer.writerows([f"{value + 0:.9g}" for value in row] for row in rows)
    matplotlib.rcParams["svg.hashsalt"] = "rwedge"
    figure.savefig(picture, metadata={"Date": None} if str(picture).endswith(".svg") else {})
