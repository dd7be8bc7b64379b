# SPDX-License-Identifier: GPL-3.0-or-later
"""Fig. 4 of the paper: the elastic limit over friction, for a/b from 0.1 to 1.     python figure4.py FIGURE.png

needs matplotlib. The cusps are where yield jumps from below to the surface: at the critical friction.
"""
import argparse

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np

import rwedge

NU = 0.3


def draw(path):
    alpha = np.linspace(0.1, 1, 10)
    f = np.linspace(0, 0.8, 801)
    limit = rwedge.elastic_limit(alpha[:, None], f, NU)  # a row for each a/b
    jump = rwedge.critical_friction(alpha, NU)

    figure, axes = plt.subplots(figsize=(7, 5), layout="constrained")
    for ratio, row in zip(alpha, limit):
        axes.plot(f, row, color=plt.cm.viridis(1 - ratio), label=f"{ratio:.1f}")
    axes.plot(jump, rwedge.elastic_limit(alpha, jump, NU), "k.", label="yield jumps\nto the surface")
    axes.set(xlabel="coefficient of friction f", ylabel="elastic limit P/(bk)", xlim=(0, 0.8), ylim=(0, None),
             title=f"Elastic limit in full sliding, nu = {NU}")
    axes.legend(title="a/b", reverse=True, fontsize="small", ncols=2, loc="lower left")
    figure.savefig(path, dpi=110)


def main():
    options = argparse.ArgumentParser()
    options.add_argument("figure")
    draw(options.parse_args().figure)


if __name__ == "__main__":
    main()
