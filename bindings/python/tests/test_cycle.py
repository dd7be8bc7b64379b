# SPDX-License-Identifier: GPL-3.0-or-later
"""A cycle of loads as an object, and what old names say."""
import copy
import math
import pickle
import re
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import numpy as np
import pytest

import rwedge
from rwedge._renamed import now_called

LOADS = {"P": 2000, "Q": [300.0, -300.0]}


@pytest.fixture
def pad():
    contact = rwedge.Contact(theta=0.01, a=2.0, A=1.82e-5, f=0.3)
    contact.apply(2000, 0, [0, 300, -300], 0)
    return contact


def test_a_cycle_leaves_its_contact_and_outlives_it(pad):
    before = pad.state()
    cycle = pad.cycle(LOADS)
    assert (pad.state() == before).all()
    sxx, syy, txy = cycle.stresses([-2.0, 0.5], 0.1)
    expected = pad.copy().stresses_after(LOADS, [-2.0, 0.5], 0.1)
    assert (cycle.stresses([-2.0, 0.5], 0.1).stress == expected.stress).all() and sxx.shape == (2, 2)
    pad.load(0)
    del pad
    assert (cycle.stresses([-2.0, 0.5], 0.1).stress == expected.stress).all()
    assert len(cycle) == 2 and (cycle.loads.Q == LOADS["Q"]).all() and (cycle.loads.P == 2000).all()


def test_friction_has_the_shape_of_its_places(pad):
    cycle, b = pad.cycle(LOADS), pad.half_width
    x = np.array([[0, 0.99 * b], [math.nan, 2 * b]])
    friction = cycle.friction(x)
    assert friction.slip_range.shape == (2, 2)
    assert friction.slip_range[0, 0] == friction.energy[0, 0] == 0 < friction.slip_range[0, 1]
    assert math.isnan(friction.ruiz_f1[1, 0]) and friction.energy[1, 1] == 0
    assert cycle.friction(0.99 * b).energy == friction.energy[0, 1]
    pandas = pytest.importorskip("pandas")
    labelled = cycle.friction(pandas.Series([0, 0.99 * b], index=["middle", "edge"]))
    assert labelled.slip_range["edge"] == friction.slip_range[0, 1]


def test_the_zone_that_never_slips_is_that_of_the_closed_form(pad):
    left, right = pad.cycle(LOADS).permanent_stick
    expected = pad.permanent_stick(2000, 0, 300, 0, 2000, 0, -300, 0)
    np.testing.assert_allclose([left, right], expected, rtol=1e-12)


def test_the_displacement_is_that_of_the_contact_after_each_load(pad):
    displacement = pad.cycle(LOADS).displacement(10)
    for Q, expected in zip(LOADS["Q"], displacement):
        pad.load(2000, Q)
        assert pad.displacement(10) == pytest.approx(expected, rel=1e-13)


def test_a_driven_cycle_has_the_forces_of_its_contact_and_slides(pad):
    way, compliance = np.array([0.05, -0.05, 0.05]), 1e-6
    cycle, driven = rwedge.Cycle.driven(pad, {"P": 2000, "displacement": way}, compliance), pad.copy()
    assert (cycle.loads.Q == [driven.drive(2000, 0, 0, to, compliance) for to in way]).all() and (cycle.loads.P == 2000).all()
    assert (np.abs(cycle.loads.Q) == 0.3 * 2000).all()
    assert 0.09 < cycle.friction(0.0).slip_range < 0.1  # of 0.1, what rig and bodies give back is no slip
    for loads in ({"P": 2000}, {"P": 2000, "Q": 1, "displacement": way}):
        with pytest.raises(rwedge.Error, match="displacement in place of Q"):
            rwedge.Cycle.driven(pad, loads, compliance)
    with pytest.raises(rwedge.Error, match="compliance"):
        rwedge.Cycle.driven(pad, {"displacement": way}, -1)


def test_a_guided_cycle_has_the_moments_of_its_contact_and_slips(pad):
    pad.set_rotation(1)
    loads = {"P": 2000, "tilt": np.array([1e-3, -1e-3, 1e-3]), "Q": [300, -300, 300]}
    for _ in range(3):
        for tilt, Q in zip(loads["tilt"], loads["Q"]):
            pad.guide(2000, float(tilt), Q, 0)
    cycle, guided = rwedge.Cycle.guided(pad, loads), pad.copy()
    for i, (tilt, Q) in enumerate(zip(loads["tilt"], loads["Q"])):
        guided.guide(2000, float(tilt), Q, 0)
        assert cycle.loads.M[i] == guided.loads.M != 0
    assert len(cycle) == 3 and cycle.friction(0.95 * guided.edges[1]).slip_range > 0
    for wrong in ({"P": 2000}, {"P": 2000, "M": 1, "tilt": [0.0]}):
        with pytest.raises(rwedge.Error, match="tilt in place of M"):
            rwedge.Cycle.guided(pad, wrong)
    with pytest.raises(rwedge.Error):
        rwedge.Cycle.guided(pad, {"tilt": [0.5]})


def test_a_load_that_is_refused_is_named(pad):
    with pytest.raises(rwedge.SlidingError, match=r"Q\[1\] = 900"):
        pad.cycle({"P": 2000, "Q": [300, 900]})
    with pytest.raises(rwedge.Error, match="loads"):
        pad.cycle({"P": []})
    strict = rwedge.Contact(theta=0.01, a=2.0, A=1.82e-5, f=0.3, tolerance=0)
    with pytest.raises(rwedge.PathError, match=r"P\[1\] = 2000"):
        strict.cycle(np.array([[2000, 0, 0, 0], [2000, 0, 300, 900]]))


def test_slip_without_a_closed_form_is_an_error_of_its_own():
    strict = rwedge.Contact(theta=0.01, a=2.0, A=1.82e-5, f=0.3, tolerance=0)
    strict.apply(2000, 100, 0, 0)
    cycle = strict.cycle({"P": 2000, "M": 100, "Q": [600, 0]})  # it slides
    assert cycle.stresses(0, 1).sxx.shape == (2,)
    with pytest.raises(rwedge.PathError, match="no closed form"):
        cycle.friction(0.1)


def test_threads_ask_one_cycle(pad):
    cycle, x = pad.cycle(LOADS), np.linspace(-2, 2, 400)
    expected = cycle.friction(x).energy
    with ThreadPoolExecutor(4) as pool:
        assert all((energy == expected).all() for energy in pool.map(lambda _: cycle.friction(x).energy, range(16)))


def test_a_cycle_is_not_sent_elsewhere(pad):
    with pytest.raises(TypeError, match="send what it is made from"):
        pickle.dumps(pad.cycle(LOADS))
    with pytest.raises(TypeError):
        copy.copy(pad.cycle(LOADS))


# ---- Old names ----

def test_an_old_name_says_the_new_one(pad):
    with pytest.raises(AttributeError, match=r"since version 2.0: Contact.permanent_stick\(\)"):
        rwedge.permanent_stick  # noqa: B018
    with pytest.raises(AttributeError, match=r"since version 2.0: .*cycle\(loads\).friction"):
        pad.cycle_friction  # noqa: B018
    with pytest.raises(AttributeError, match="has no attribute 'no_such'"):
        rwedge.no_such  # noqa: B018
    with pytest.raises(AttributeError, match="has no attribute 'no_such'"):
        pad.no_such  # noqa: B018
    with pytest.raises(rwedge.AbsentError, match="exist"):
        rwedge.Contact(0.01, 2.0, 1.82e-5, 0.3).edges  # noqa: B018
    with pytest.raises(TypeError, match="stresses_after"):
        pad.cycle(LOADS, [0.0], 1.0)


def test_the_table_of_old_names_is_pythons():
    readme = Path(__file__).resolve().parents[2] / "README.md"
    if not readme.exists():
        pytest.skip("the bindings' README is not here")
    table = readme.read_text(encoding="utf-8").partition("## Old names and new names")[2].partition("\n## ")[0]
    rows = [[cell.strip() for cell in line.split("|")[1:-1]] for line in table.splitlines() if line.startswith("| `")]
    for old, new in ((row[2], row[3]) for row in rows if len(row) == 4 and row[2].strip("`")):
        name = re.sub(r"\(.*", "", old.strip("`")).removeprefix("rwedge.")
        assert now_called(name).endswith(new.replace("`", "")), (old, new)


# ---- Cracks ----

LAW = {"dK_th": 66.4, "ds0": 248, "C": 1e-7 / 1000**1.5, "m": 3}


@pytest.fixture
def steady():
    """The cycle of tests/data/crack_growth.csv with a tension of 60, under a cylinder."""
    contact = rwedge.Contact.flat(a=0, R=60, A=3e-5, f=0.6)
    share = np.cos(np.arange(1, 25) * math.pi / 12)
    contact.load(120)
    contact.apply(120, 0, 50, 60)
    contact.apply(120, 0, 50 * share, 60 * share)
    return contact.cycle({"P": 120, "Q": 50 * share, "sigma": 60 * share}), contact.edges[0]


def test_a_crack_stops_or_grows_as_the_faces_have_it(steady):
    cycle, edge = steady
    stops = cycle.growth(edge, 0, rwedge.Faces.MODE_I, LAW, 0.03708, 2.967)
    assert stops.arrest == pytest.approx(0.148526816, rel=1e-8) and math.isinf(stops.cycles)
    assert stops.verdict == "By mode I the crack arrests at 0.1485"
    grows = cycle.growth(edge, 0, rwedge.Faces.FREE, [*LAW.values(), math.inf], 0.03708, 2.967)
    assert grows.cycles == pytest.approx(1034075.23, rel=1e-6) and math.isinf(grows.arrest)
    assert grows.verdict.startswith("With K_II of free faces the crack grows through to 2.967, in 1.03408e+06 cycles; closest")
    none = cycle.growth(edge, math.radians(-20), 0, LAW, 0.03708, 2.967)
    assert none.arrest == 0.03708 and none.verdict.startswith("By mode I the crack does not grow from 0.03708")
    breaks = cycle.growth(edge, 0, 2, {**LAW, "K_c": 150}, 0.03708, 2.967)
    assert re.match("With K_II of free faces the crack breaks at .*, in .* cycles", breaks.verdict)
    with pytest.raises(TypeError, match="law has ds0, K_c, C: it must have dK_th, ds0, C, m, K_c"):
        cycle.growth(edge, 0, 2, {"C": 1}, 1, 2)


def test_a_crack_under_the_contact_is_held_open_by_its_faces(steady):
    cycle, edge = steady
    angle = math.radians(30)
    I, II, overlap = cycle.crack(edge, angle, [0.741646])
    closing_I, closing_II, closed = cycle.closing_crack(edge, angle, [0.741646])
    assert (closing_I >= 0).all() and (closing_I[overlap == 0] == I[overlap == 0]).all()
    assert 0 < closed.max() <= 1 and not np.array_equal(II, closing_II)
    range_I, range_II, _, R = cycle.closing_ranges(edge, angle, rwedge.Faces.FREE, [0.741646])
    assert range_I[0] == np.ptp(closing_I) and range_II[0] == np.ptp(closing_II) and R[0] >= 0
    normal = cycle.closing_growth(edge, 0, rwedge.Faces.MODE_I, LAW, 0.03708, 2.967)
    assert normal.arrest == pytest.approx(0.148526816, rel=1e-8) and normal.verdict == "By mode I the crack arrests at 0.1485"


def test_weights_give_the_k_of_a_cycle(steady):
    cycle, edge = steady
    angle, length = -0.3, 0.2
    place, normal_I, shear_I, normal_II, shear_II = rwedge.crack_weights(angle)
    c, s = math.cos(angle), math.sin(angle)
    sxx, syy, txy = cycle.stresses(edge + length * place * s, length * place * c)
    normal, shear = c * c * sxx - 2 * c * s * txy + s * s * syy, c * s * (sxx - syy) + (c * c - s * s) * txy
    K_I, K_II, overlap = cycle.crack(edge, angle, [length])
    np.testing.assert_allclose(K_I[:, 0], length**0.5 * (normal @ normal_I + shear @ shear_I), rtol=0, atol=1e-9)
    np.testing.assert_allclose(K_II[:, 0], length**0.5 * (normal @ normal_II + shear @ shear_II), rtol=0, atol=1e-9)
    assert len(place) == rwedge.crack_points(angle) and overlap.shape == (24, 1)
