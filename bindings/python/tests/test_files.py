# SPDX-License-Identifier: GPL-3.0-or-later
"""Files as the tool reads them: the numbers of a clean file, and the tool's own words where there is something to say."""
import json
import math
import os
import shutil

import numpy as np
import pytest

import rwedge

pytestmark = pytest.mark.skipif(not (os.environ.get("RWEDGE_TOOL") or shutil.which("rwedge")), reason="the tool is not here")


def test_an_older_tool_is_told(tmp_path, monkeypatch):
    older = tmp_path / "rwedge"
    older.write_text("#!/bin/sh\necho \"rwedge: $1: unknown command; allowed: solve, table\" >&2\nexit 2\n")
    older.chmod(0o755)
    monkeypatch.setenv("RWEDGE_TOOL", str(older))
    with pytest.raises(rwedge.Error, match=r"rwedge is the tool of another version: \d+\.\d+\.\d+ is needed"):
        rwedge.read_case("rig.csv")


def file(tmp_path, name, text):
    path = tmp_path / name
    path.write_text(text, "utf-8")
    return path


def test_a_case_makes_its_contact_and_loads(tmp_path):
    path = file(tmp_path, "case.json", json.dumps({
        "rwedge_case": 1, "units": "mm,N,MPa", "bodies": {"E1": "210 GPa", "nu1": 0.3, "f": 0.3},
        "pad": {"theta": 0.01, "radius": 10}, "loads": {"P": 300, "Q": [40, -40]}, "asked": {"command": "history", "options": {}}}))
    case = rwedge.read_case(path)
    own = rwedge.Contact(theta=0.01, a=0.1, A=rwedge.compliance(210000, 0.3, 210000, 0.3), f=0.3)
    contact = case.contact()
    contact.load(case.loads["P"], case.loads["Q"])
    own.load(300, [40, -40])
    assert (contact.state() == own.state()).all()
    assert case.units == "mm,N,MPa" and case.asked["command"] == "history"
    assert rwedge.read_case(path, f=0.4).contact().f == 0.4  # a word replaces what the file has


def test_a_log_has_units_and_names_of_its_own(tmp_path):
    path = file(tmp_path, "rig.csv", "Rig 7\n\nTime;Normal;Fretting\ns;kN;kN\n0;1.2;0\n1;1.2;0.3\n")
    with pytest.warns(UserWarning, match="rig.csv: header in line 3, units in line 4"):
        case = rwedge.read_case(path, units="mm,N,MPa", width=8, column={"P": "Normal", "Q": "Fretting"})
    assert case.loads["P"] == pytest.approx([150, 150], rel=1e-15)
    assert case.loads["Q"] == pytest.approx([0, 37.5], rel=1e-15)
    with pytest.raises(rwedge.Error, match="rig.csv: line 3: column P: missing; .*the names there: 'Time', 'Normal', 'Fretting'"):
        rwedge.read_case(path)


def test_a_profile_is_what_the_tool_makes_of_it(tmp_path):
    x = np.linspace(0, 2, 41)
    path = file(tmp_path, "scan.csv", "x [mm],height [um]\n" + "".join(f"{at:.17g},{(at - 1)**2 * 10:.17g}\n" for at in x))
    case = rwedge.read_case(profile=path, origin="lowest", E1=210000, nu1=0.3, units="mm,N,MPa")
    contact = case.contact()
    contact.load(100)
    assert contact.half_width == pytest.approx(np.sqrt(2 * 100 * 50 * case.A / np.pi), rel=1e-9)  # Hertz, R = 50


def test_a_pad_that_is_held_has_the_moments_of_its_tilts(tmp_path):
    path = file(tmp_path, "rig.csv", "P,Q,tilt\n200,10,0.02\n300,-10,0.01\n")
    case = rwedge.read_case(path, E1=210000, nu1=0.3, radius=100, f=0.5)
    contact = case.contact()
    for P, Q, tilt in zip(*(case.loads[name] for name in ("P", "Q", "tilt"))):
        contact.guide(P, tilt, Q, 0.0)
        assert contact.loads.M == pytest.approx(P * 100 * tilt, rel=1e-12)  # a cylinder that turns is one beside, by R times the tilt
    held = rwedge.read_case(E1=210000, nu1=0.3, radius=100, f=0.5, P=200, tilt=0.02)
    contact = held.contact()
    contact.load(held.loads["P"])
    assert contact.loads.M == pytest.approx(400, rel=1e-12)


def test_what_a_fit_leaves_is_told_of_its_contact(tmp_path):
    x = np.linspace(-1.5, 1.5, 300)
    noise = np.random.default_rng(1).normal(0, 5e-4, x.size)  # 0.5 um, on lobes that rise by less than ten times that
    path = file(tmp_path, "scan.csv", "x,height\n" + "".join(f"{at:.17g},{height:.17g}\n" for at, height in
                zip(x, np.maximum(0, np.abs(x) - 1)**2 / 10 + noise)))
    with pytest.warns(UserWarning, match="arcs"):
        case = rwedge.read_case(profile=path, fit=True, E1=210000, nu1=0.3, P=300)
    said = " ".join(case.remarks())
    residue = float(said.split("residue within the contact is ")[1].split(",")[0])
    assert 5e-4 < residue < 4 * 5e-4  # the largest of some 200 normal numbers
    assert "does not resolve" in said, said


def test_unlike_bodies_with_friction_have_a_rotation():
    words = {"E1": 72000, "nu1": 0.33, "E2": 210000, "nu2": 0.3, "radius": 10, "P": 300, "Q": 150, "f": 0.5}
    P, Q = words["P"], words["Q"]
    beta = rwedge.dundurs_beta(72000, 0.33, 210000, 0.3)
    lam = math.atan(-beta * 0.5) / math.pi
    middles = {}
    for rotation in "held", "free":
        case = rwedge.read_case(**words, rotation=rotation)
        assert case.pad["rotation"] == rotation and case.beta == beta
        contact = case.contact()
        assert contact.beta == beta and contact.tolerance == 1e-3
        contact.load(P, Q)
        middles[rotation] = sum(contact.edges) / 2 / contact.half_width
    assert middles["held"] == pytest.approx(-2 * lam, rel=1e-10)  # Hertz' contact that slides
    assert middles["free"] == pytest.approx(2 * lam / 3, rel=1e-10)
    assert rwedge.read_case(**words, rotation="free").contact(1e-4).tolerance == 1e-4
    alike = rwedge.read_case(**words, similar=True).contact()
    assert alike.beta == 0 and alike.tolerance == 1e-4
    with pytest.raises(rwedge.Error, match="rotation='held' or 'free' must be said"):
        rwedge.read_case(**words).contact()
    assert rwedge.read_case(**{**words, "f": 0}).contact().beta == 0
    plate = rwedge.read_case(**words, rotation="free", plane_stress=True)
    assert plate.beta == rwedge.dundurs_beta_plane_stress(72000, 0.33, 210000, 0.3)


def test_bodies_pads_and_materials(tmp_path):
    two = rwedge.read_case(E1=30000, nu1=0.25, E2=29120, nu2=0.3, radius1=10, radius2=13)
    contact = two.contact()
    contact.load(3200)
    assert contact.half_width == pytest.approx(1.19971, rel=1e-5)
    plate = rwedge.read_case(E1=200000, nu1=0.3, radius=1, plane_stress=True)
    assert pytest.approx(4 / 200000, rel=1e-15) == plate.A
    assert rwedge.read_case(E1=1, nu1=0.3, E2="inf", radius=1).A == pytest.approx(2 * 0.91, rel=1e-15)
    flat = rwedge.read_case(E1=1e5, nu1=0.3, flat=1, radius=5, f=0.2, units="mm,N,MPa",
                            material={"su": 900, "K_c": "1 MPa sqrt(mm)"})
    assert flat.material == {"su": 900, "K_c": 1}
    flat.contact().load(1)
    with pytest.warns(UserWarning, match="its numbers are in mm,N,MPa"):
        steel = rwedge.read_case(material="sae-1015-normalized", radius=1)
    assert steel.material["sf"] == 827 and steel.A == rwedge.compliance(206800, 0.3, 206800, 0.3)


class Quantity:
    """What a quantity of pint has."""

    class units(str):
        def __format__(self, form):
            assert form == "~C"
            return str(self)

    def __init__(self, magnitude, units):
        self.magnitude, self.units = magnitude, self.units(units)


def test_quantities_are_converted():
    case = rwedge.read_case(E1=Quantity(210, "GPa"), nu1=0.3, radius=Quantity(0.05, "m"), P=Quantity(500, "kN/m"), units="mm,N,MPa",
                            material={"K_c": Quantity(1, "MPa*m**0.5")})
    assert case.bodies["E1"] == pytest.approx(210000, rel=1e-15)
    assert case.pad["radius"] == pytest.approx(50, rel=1e-15)
    assert case.loads["P"] == pytest.approx(500, rel=1e-15)
    assert case.material["K_c"] == pytest.approx(1000**0.5, rel=1e-15)
    pint = pytest.importorskip("pint")
    unit = pint.UnitRegistry()
    own = rwedge.read_case(E1=210 * unit.GPa, nu1=0.3, P=500 * unit.kN / unit.m, units="mm,N,MPa")
    assert own.bodies["E1"] == pytest.approx(210000, rel=1e-15) and own.loads["P"] == pytest.approx(500, rel=1e-15)


def test_what_is_wrong_is_an_error(tmp_path):
    with pytest.raises(rwedge.Error, match="E1 -1: Young's modulus of body 1 must be a number above 0"):
        rwedge.read_case(E1=-1)
    with pytest.raises(rwedge.Error, match="case.json: bodies: E: unknown; the nearest is E1"):
        rwedge.read_case(file(tmp_path, "case.json", '{"rwedge_case": 1, "bodies": {"E": 1}}'))
    with pytest.raises(rwedge.Error, match="the case has no pad"):
        rwedge.read_case(E1=1, nu1=0.3).contact()
    with pytest.raises(rwedge.Error, match="--radus: unknown option; the nearest is --radius"):
        rwedge.read_case(radus=1)


def test_a_report_is_that_of_the_tool(tmp_path):
    path = file(tmp_path, "case.json", json.dumps({
        "rwedge_case": 1, "name": "Pad <7>", "units": "mm,N,MPa", "bodies": {"E1": 210000, "nu1": 0.3, "f": 0.3},
        "pad": {"radius": 50}, "loads": {"P": 300, "Q": 40}}))
    case = rwedge.read_case(path)
    page = case.report(tmp_path / "page.html", pictures=False, equations=True)
    assert (tmp_path / "page.html").read_text("utf-8") == page
    assert sorted(os.listdir(tmp_path)) == ["case.json", "page.html"]
    b = np.sqrt(2 * 300 * 50 * case.A / np.pi)  # Hertz
    assert "<h1>Pad &lt;7></h1>" in page and f"<b>{b:.4g}</b><i>mm</i>" in page and f"= <b>{b:.6g}</b> mm" in page
    assert "the last of 5 passes" in rwedge.read_case(path, load=[(300, 0), (300, 40)], P=None, Q=None).report(pictures=False, cycles=5)
    with pytest.raises(rwedge.Error, match="missing: --P"):
        rwedge.read_case(E1=1, nu1=0.3, radius=1).report(pictures=False)
