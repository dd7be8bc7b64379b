# SPDX-License-Identifier: GPL-3.0-or-later
"""Measured loops, as the tool fits them: friction is found again."""
import math
import os
import shutil

import numpy as np
import pytest

import rwedge

pytestmark = pytest.mark.skipif(not (os.environ.get("RWEDGE_TOOL") or shutil.which("rwedge")), reason="the tool is not here")

F, COMPLIANCE, PAD = 0.6, 1.5e-5, {"E1": 115e3, "nu1": 0.32, "radius": 50}


def measured(way, cycles=2, noise=0.005):
    """A log of a contact that is driven, with noise in Q."""
    contact = rwedge.Contact.cylinder(50, rwedge.compliance(115e3, 0.32, 115e3, 0.32), F)
    contact.load(400)
    displacement = way * np.sin(2 * np.pi * np.arange(100 * cycles + 1) / 100)
    Q = np.array([contact.drive(400, 0, 0, to, COMPLIANCE) for to in displacement])
    return {"P": np.full(Q.size, 400.0), "displacement": displacement, "Q": Q + np.random.default_rng(1).normal(0, noise * 240, Q.size)}


def test_friction_and_compliance_are_found_again():
    log = measured(0.012)
    loop = rwedge.loop(log, **PAD)
    assert loop.regime == "gross slip" and loop.f == pytest.approx(F, rel=1e-3)
    assert abs(loop.compliance - COMPLIANCE) < 4 * loop.uncertainty["compliance"]
    assert (loop.fitted["Q"] == log["Q"]).all() and np.std(loop.fitted["Q_fitted"] - log["Q"]) < 0.006 * 240
    way, shear = log["displacement"][100:], log["Q"][100:]  # the second of two cycles, which begins and ends at 0
    assert loop.energy == pytest.approx(np.sum((shear[1:] + shear[:-1]) / 2 * np.diff(way)), rel=1e-3)
    contact = rwedge.Contact.cylinder(50, rwedge.compliance(115e3, 0.32, 115e3, 0.32), loop.f)
    contact.load(400)
    cycle = rwedge.Cycle.driven(contact, {"P": 400, "displacement": loop.fitted["displacement"] - loop.offset}, loop.compliance)
    assert cycle.loads.Q == pytest.approx(loop.fitted["Q_fitted"], abs=1e-6)


def test_a_loop_for_each_cycle():
    loops = rwedge.loop(measured(0.012, cycles=4), by_cycle=True, **PAD)
    assert len(loops) == 3 and all(loop.f == pytest.approx(F, rel=2e-3) for loop in loops)
    assert all(math.isnan(loop.offset) and loop.fitted == {} for loop in loops)


def test_what_is_wrong_is_said():
    with pytest.raises(rwedge.Error, match="column displacement: missing"):
        rwedge.loop({"P": [400], "Q": [1]}, **PAD)
