# SPDX-License-Identifier: GPL-3.0-or-later
"""The pictures: what is drawn has the numbers of the contact; axes, artists and styles are matplotlib's."""
import math

import numpy as np
import pytest

import rwedge

matplotlib = pytest.importorskip("matplotlib")
matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402

from rwedge import plot  # noqa: E402

THETA, F, A = 0.01, 0.6, 1.8e-5


@pytest.fixture
def ax():
    figure, axes = plt.subplots()
    yield axes
    figure.canvas.draw()
    plt.close(figure)


def test_a_loop_encloses_the_dissipated_energy(ax):
    contact = rwedge.Contact(THETA, 0.5, A, F)
    contact.load(2000)
    line = plot.loop(contact, [800, -800, 800], ax=ax, units=("mm", "MPa"))
    assert contact.Q == 0 and line in ax.lines and ax.get_xlabel() == "displacement by slip / mm"
    x, Q = (values[plot.STEPS:] for values in line.get_data())  # without the first loading
    contact.load(2000, 800)
    assert x[-1] == pytest.approx(plot.displacement(contact), rel=1e-9)
    before = contact.dissipated_energy
    contact.load(2000, [-800, 800])
    assert np.sum((Q[1:] + Q[:-1]) / 2 * np.diff(x)) == pytest.approx(contact.dissipated_energy - before, rel=2e-3)  # trapezia
    natural = plot.loop(contact, [0], ax=ax, color="red")
    assert natural.get_color() == "red" and max(natural.get_ydata()) == 800 / (F * 2000)


def test_tractions_are_those_of_the_contact(ax, contact):
    pressure, shear = plot.tractions(contact, ax=ax, units=("mm", "MPa"))
    x, value = shear.get_data()
    assert (value == -contact.tractions(x)[1] / F).all() and pressure.get_linewidth() < shear.get_linewidth()
    assert abs(contact.stick_half_width) in x and {x[0], x[-1]} == {-contact.half_width, contact.half_width}
    assert ax.get_ylabel() == "$-p$, $-q/f$ / MPa" and not ax.spines["top"].get_visible()
    second = plot.tractions(contact, ax=ax)[1]
    assert second.get_color() == plot.BLUE != shear.get_color() and second.get_linestyle() == "--"
    peak = -contact.tractions(0)[0] * math.pi * A / THETA
    assert max(plot.tractions(contact, ax=ax)[0].get_ydata()) == pytest.approx(peak, rel=1e-14)


def test_a_field_has_the_stress_at_its_lines(ax, contact):
    lines = plot.field(contact, 0.3, ax=ax, units=("mm", "MPa"))
    for level, segments in zip(lines.levels, lines.allsegs):
        for segment in segments:
            inner = segment[np.hypot(abs(segment[:, 0]) - contact.half_width, segment[:, 1]) > 0.3 * contact.half_width]
            inner = inner[inner[:, 1] > 0.1 * contact.half_width]
            exact = rwedge.von_mises(*contact.stresses(*inner.T), 0.3) / math.sqrt(3)
            assert np.all(abs(exact - level) < 0.01 * lines.levels[-1])
    assert 5 < len(lines.levels) <= plot.LEVELS and ax.get_title() == r"$\sqrt{J_2}$ in MPa"
    factor = contact.yield_factor(0.3, 1e4)
    (circle,) = [line for line in ax.lines if line.get_marker() == "o"]
    assert circle.get_xdata()[0] == factor.x and circle.get_ydata()[0] == factor.y


def test_the_current_axes_are_used_and_what_cannot_be_drawn_is_refused(ax):
    sharp = rwedge.Contact(THETA, 0, A, 0)
    with pytest.raises(rwedge.Error, match="unloaded: there is nothing to draw"):
        plot.tractions(sharp)
    sharp.load(2000)
    plt.sca(ax)
    (pressure,) = plot.tractions(sharp)
    assert pressure.axes is ax and np.isfinite(pressure.get_ydata()).all()
    assert np.isfinite(plot.field(sharp, 0.3).levels).all()
