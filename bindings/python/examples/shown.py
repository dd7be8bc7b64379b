# SPDX-License-Identifier: GPL-3.0-or-later
"""What the examples share: matplotlib in one style, without a screen; a figure is written with the numbers behind it, in a CSV file
beside it; tables of two contacts, and a search."""
import argparse
import csv
from pathlib import Path

import matplotlib
import numpy as np

from rwedge import plot

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402

plt.rcParams.update({"axes.spines.top": False, "axes.spines.right": False, "legend.frameon": False, "svg.hashsalt": "rwedge",
                     "figure.constrained_layout.use": True, "lines.linewidth": plot.WIDTH})


def style(number):
    """Of the line of that number: it differs in print without colour."""
    return {"color": plot.COLOURS[number], "linestyle": plot.DASHES[number]}


def arguments(script, text, **options):
    """The path of the picture, and options of the form name=(default, help)."""
    parser = argparse.ArgumentParser(prog=Path(script).name, description=text.split("\n\n")[0])
    parser.add_argument("picture", help="such as picture.svg or picture.png; the numbers go into a .csv beside it")
    for name, (default, help_text) in options.items():
        parser.add_argument(f"--{name}", type=type(default), default=default, help=f"{help_text} (default: {default})")
    return parser.parse_args()


def table(names, rows):
    """Prints a column for each name, and the rows {title: value of a name}."""
    print(" " * 32 + "".join(f"{name:>12}" for name in names))
    for title, value in rows.items():
        print(f"{title:32}" + "".join(f"{value(name):12.5g}" for name in names))


def bisected(low, high, is_below):
    """The place between two positive numbers, or arrays of them, up to which is_below(place) holds."""
    for _ in range(60):
        place = np.sqrt(low * high)
        below = is_below(place)
        low, high = np.where(below, place, low), np.where(below, high, place)
    return high


def save(figure, picture, **columns):
    """The figure, and columns of numbers of one length: nine digits, as the last ones differ between machines."""
    rows = np.column_stack([np.asarray(column, dtype=float) for column in columns.values()])
    with open(Path(picture).with_suffix(".csv"), "w", newline="") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(columns)
        writer.writerows([f"{value + 0:.9g}" for value in row] for row in rows)
    figure.savefig(picture, metadata={"Date": None} if str(picture).endswith(".svg") else {})
