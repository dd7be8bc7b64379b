# SPDX-License-Identifier: GPL-3.0-or-later
"""The sheet Pads: a cylinder, and a flat pad with rounded edges, under the loads of the calculator and between its bodies. The pressure
of a flat pad is that of a cylinder less that of a wedge of the angle a/R: so are its load and its slope beside the contact."""
from dataclasses import dataclass

from cells import three
from formulas import at_row, if_row, lagrange, limit_at, listed, not_above_0, when
from source import rounded

LABEL, NAME, CYLINDER, FLAT, UNIT, HINT, WORKING = range(7)
EXAMPLE = dict(radius=10, flat=0.2, M=0, sigma=0)
INPUTS = [
    ("radius", "Radius R of the cylinder, or of the edges", "mm", "in place of the wedge's", "a number above 0"),
    ("flat", "Half-width a of the flat", "mm", "empty: no flat pad", "a number above 0"),
    ("M", "Moment M, on the cylinder", "N", "N mm per mm; empty: 0. It rolls the cylinder", "a number"),
    ("sigma", "Bulk tension sigma, beside the cylinder", "MPa", "empty: 0. It grows with Q", "a number"),
]
FIRST_INPUT, FIRST_RESULT = 5, 11


@dataclass
class Row:
    name: str
    label: str
    unit: str
    hint: str
    cylinder: str  # formulas; "" where the pad has no such result
    flat: str
    column: str = ""  # of "rwedge solve"
    style: str = "result"


def when_cylinder(value):
    return f'IF(rwt_cyl_ok=1,{value},"")'


def when_flat(value):
    return f'IF(rwt_flat_ok=1,{value},"")'


def sticks(pad, value):
    return f'IF(AND(rwt_{pad}_ok=1,rwt_fr>0,rwt_slides=0,rwt_{pad}_closed=1),{value},"")'


def strong(pad, value):
    return f'IF(AND(rwt_{pad}_ok=1,rwt_has_k=1,rwt_slides=0,ISNUMBER({value.partition("*")[0]})),{value},"")'


def table_of(pad, table, tip, weights, node):
    return f'IF(AND(rwt_{pad}_ok=1,rwt_ok_f=1,rwt_ok_nu=1,{tip}<=0.99),{limit_at(table, weights, node)},"")'


def limits_of(name, label, hint, table, cylinder=""):
    return Row(name, label, "-", hint, cylinder or table_of("cyl", table, "0", "rwt_lz", "1"),
               table_of("flat", table, "rwt_flat_tip", "rwt_lp", "rwt_flat_node"))


def of_wedge_table():
    """A cylinder is the last row of the wedge's own table of yield, which has all nu."""
    largest = f"MAX({at_row('rwt_surface', 51)},{if_row('51', at_row('rwt_below', 51))})"
    return f'IF(AND(rwt_cyl_ok=1,rwt_ok_f=1),PI()/2/SQRT({largest}),"")'


TENSION = "2*rwt_fr/(rwt_comp*rwt_pad_R)"
SIDE = "IF(N(rw_Q)<0,-1,1)"
# slope of the zone that sticks, at the edge of the contact, over 1/R
FLAT_BESIDE = ("(rwt_flat_b-SQRT(MAX(0,(rwt_flat_b-rwt_flat_c)*(rwt_flat_b+rwt_flat_c)))"
               "-rwt_pad_a*2/PI()*(ATAN2(rwt_flat_root,rwt_flat_cosc)+rwt_flat_b/rwt_pad_a*ATAN(rwt_pad_a/rwt_flat_c/rwt_flat_cosc"
               "*rwt_flat_root*rwt_flat_c/rwt_flat_b)-ASIN(MIN(1,rwt_pad_a/rwt_flat_c))*rwt_flat_root*rwt_flat_c/rwt_pad_a))")
RESULTS = [
    Row("b", "Half-width of the contact b", "mm", "", when_cylinder("rwt_cyl_b"), when_flat("rwt_flat_b"), "b"),
    Row("left", "its left edge", "mm", "", when_cylinder("rwt_cyl_m-rwt_cyl_b"), when_flat("-rwt_flat_b"), "left", "signed"),
    Row("right", "its right edge", "mm", "", when_cylinder("rwt_cyl_m+rwt_cyl_b"), when_flat("rwt_flat_b"), "right", "signed"),
    Row("tilt", "Angle by which M tilts", "rad", "", when_cylinder("rwt_cyl_m/rwt_pad_R"), "", "tilt", "signed"),
    Row("p0", "Largest pressure", "MPa", "of a flat pad near its edges, within 0.1 %", when_cylinder("rwt_cyl_b/(rwt_comp*rwt_pad_R)"),
        'IF(AND(rwt_flat_ok=1,rwt_flat_tip<=0.99),rwt_flat_b/(rwt_comp*rwt_pad_R)*SUMPRODUCT(INDEX(rwt_flat_peaks,rwt_flat_pn)'
        ':INDEX(rwt_flat_peaks,rwt_flat_pn+2)*rwt_pw),"")', "p0"),
    Row("p_middle", "Pressure in the middle", "MPa", "", when_cylinder("rwt_cyl_b/(rwt_comp*rwt_pad_R)"),
        when_flat("rwt_flat_b/(rwt_comp*rwt_pad_R)*(1-2/PI()*(ASIN(rwt_flat_tip)+rwt_flat_tip*LN((1+SIN(rwt_psi7))/rwt_flat_tip)))")),
    Row("c", "Half-width of the stick zone c", "mm", "Q grown under constant P and M", sticks("cyl", "rwt_cyl_c"),
        sticks("flat", "rwt_flat_c"), "c"),
    Row("stick_left", "its left edge", "mm", "sigma moves it off the centre", sticks("cyl", f"rwt_cyl_m+{SIDE}*rwt_cyl_e-rwt_cyl_c"),
        sticks("flat", "-rwt_flat_c"), "stick_left", "signed"),
    Row("stick_right", "its right edge", "mm", "", sticks("cyl", f"rwt_cyl_m+{SIDE}*rwt_cyl_e+rwt_cyl_c"), sticks("flat", "rwt_flat_c"),
        "stick_right", "signed"),
    Row("tension", "Tension at the trailing edge", "MPa", "under this Q, with sigma",
        f'IF(AND(rwt_cyl_ok=1,rwt_slides=0,rwt_cyl_closed=1),IF(rwt_q=0,N(rw_sigma),N(rw_sigma)+{TENSION}*(-rwt_cyl_e'
        f'+SQRT(MAX(0,(rwt_cyl_b+rwt_cyl_e)^2-rwt_cyl_c^2)))),"")',
        f'IF(AND(rwt_flat_ok=1,rwt_slides=0),IF(rwt_q=0,0,{TENSION}*(rwt_flat_over-IF(rwt_flat_c>rwt_pad_a*(1+1E-12),{FLAT_BESIDE},0))),"")',
        "max_tension", "signed"),
    Row("max_tension", "Tension in full sliding", "MPa", "Q = f P, without sigma", when_cylinder(f"{TENSION}*rwt_cyl_b"),
        when_flat(f"{TENSION}*rwt_flat_over"), "max_tension_sliding"),
    Row("load_over_bk", "Load P/(bk)", "-", "", 'IF(AND(rwt_cyl_ok=1,rwt_has_k=1),rwt_load/(rwt_cyl_b*rwt_k),"")',
        'IF(AND(rwt_flat_ok=1,rwt_has_k=1),rwt_load/(rwt_flat_b*rwt_k),"")', "load_over_bk"),
    limits_of("P_over_bk", "Elastic limit P/(bk)", "in full sliding, without M and sigma; of a flat pad within 2 %", "rwt_flat_limit", of_wedge_table()),
    Row("safety_strength", "Safety on strength, of k or Y", "-", "if it slid, the factor on the stress",
        strong("cyl", "rw_cylinder_P_over_bk*rwt_cyl_b*rwt_k/rwt_load"), strong("flat", "rw_flat_P_over_bk*rwt_flat_b*rwt_k/rwt_load"),
        style="strong"),
    Row("safety", "Safety on load P_yield/P", "-", "the contact of a cylinder grows with the root of P",
        strong("cyl", "rw_cylinder_safety_strength*rw_cylinder_safety_strength"), "", "safety", "strong"),
    limits_of("P_over_bk_shakedown", "Shakedown limit P/(bk)", "carried in sliding, pass after pass; within 1 %", "rwt_flat_shakedown"),
    Row("safety_shakedown", "Safety on strength, pass after pass", "-", "perfect plasticity, small strains; below 1 it goes on yielding",
        strong("cyl", "rw_cylinder_P_over_bk_shakedown*rwt_cyl_b*rwt_k/rwt_load"),
        strong("flat", "rw_flat_P_over_bk_shakedown*rwt_flat_b*rwt_k/rwt_load"), style="strong"),
]


def angle_steps(name, load):
    """cos(psi) = a/b is the root of psi - sin(psi) cos(psi) = (A P R/a^2) cos(psi)^2; the guess is right at both ends."""
    steps = [(name + "0", f"ATAN(SQRT((1.5*{load})^(2/3)+2/PI()*{load}))")]
    for i in range(1, 8):
        psi = f"{name}{i - 1}"
        step = (f"({psi}-SIN({psi})*COS({psi})-{load}*COS({psi})^2)/(2*SIN({psi})*(SIN({psi})+{load}*COS({psi})))")
        steps.append((f"{name}{i}", f"MAX(1E-9,{psi}-{step})"))
    return steps


def lagrange_of(name, x, node):
    """Three weights, with a name together."""
    return [(cell.name, cell.formula) for cell in
            three(name, "", *(lagrange(x, *(node((i + step) % 3) for step in range(3))) for i in range(3)))]


WORKING_CELLS = [
    ("rwt_pad_wrong", listed(when(f'OR(rw_radius_of_pad="",{not_above_0("rw_radius_of_pad")})', "radius must be a number above 0"),
                             when(f'AND(rw_flat_of_pad<>"",{not_above_0("rw_flat_of_pad")})', "a must be a number above 0, or empty"),
                             when('OR(ISTEXT(rw_M),ISTEXT(rw_sigma))', "M and sigma must be numbers"))),
    ("rwt_cyl_ok", 'IF(AND(rwt_ok=1,rwt_pad_wrong=""),1,0)'),
    ("rwt_flat_ok", 'IF(AND(rwt_cyl_ok=1,N(rw_flat_of_pad)>0,N(rw_M)=0,N(rw_sigma)=0),1,0)'),
    ("rwt_pad_R", "IF(rwt_cyl_ok=1,rw_radius_of_pad,1)"),
    ("rwt_pad_a", "IF(rwt_flat_ok=1,rw_flat_of_pad,1)"),
    ("rwt_pad_q", "IF(rwt_fr>0,MIN(1,rwt_q/MAX(1E-90,rwt_fr*rwt_load)),0)"),
    # the cylinder: M rolls it, sigma moves the zone that sticks
    ("rwt_cyl_b", "SQRT(2/PI()*rwt_comp*rwt_load*rwt_pad_R)"),
    ("rwt_cyl_m", "IF(rwt_cyl_ok=1,N(rw_M)/rwt_load,0)"),
    ("rwt_cyl_c", "rwt_cyl_b*SQRT(1-rwt_pad_q)"),
    ("rwt_cyl_e", "IF(AND(rwt_cyl_ok=1,rwt_fr>0),rwt_pad_R*(1-rwt_nu1^2)/rwt_E1*N(rw_sigma)/MAX(1E-90,rwt_fr),0)"),
    ("rwt_cyl_closed", "IF(OR(rwt_fr=0,ABS(rwt_cyl_e)+rwt_cyl_c<=rwt_cyl_b*(1+1E-12)),1,0)"),
    # the flat pad
    ("rwt_flat_closed", "1"),
    ("rwt_flat_K", "rwt_comp*rwt_load*rwt_pad_R/rwt_pad_a^2"),
    *angle_steps("rwt_psi", "rwt_flat_K"),
    ("rwt_flat_tip", "COS(rwt_psi7)"),
    ("rwt_flat_b", "rwt_pad_a/rwt_flat_tip"),
    ("rwt_flat_over", "rwt_flat_b*2*SIN(rwt_psi7/2)^2"),  # b - a
    ("rwt_flat_Kc", "MAX(1E-30,rwt_flat_K*(1-rwt_pad_q))"),
    *angle_steps("rwt_psc", "rwt_flat_Kc"),
    ("rwt_flat_c", "IF(rwt_pad_q=1,rwt_pad_a,rwt_pad_a/COS(rwt_psc7))"),
    ("rwt_flat_cosc", "MAX(1E-30,SIN(rwt_psc7))"),
    ("rwt_flat_root", "SQRT(MAX(0,(rwt_flat_b/rwt_flat_c-1)*(rwt_flat_b/rwt_flat_c+1)))"),
    # weights in the tables: of the first row, a/b = 0; in acos(a/b); in a/b of the largest pressure
    ("rwt_lz1", "1"), ("rwt_lz2", "0"), ("rwt_lz3", "0"),
    ("rwt_flat_node", "MIN(MATCH(MIN(0.99,rwt_flat_tip),rwt_flat_limit_tips,1),8)"),
    *lagrange_of("rwt_lp", "MAX(ACOS(0.99),rwt_psi7)", lambda step: f"ACOS(INDEX(rwt_flat_limit_tips,rwt_flat_node+{step}))"),
    ("rwt_flat_pn", "MIN(ROUNDDOWN(MIN(0.99,rwt_flat_tip)*100+1E-9,0)+1,98)"),
    *lagrange_of("rwt_pw", "MIN(0.99,rwt_flat_tip)", lambda step: f"(rwt_flat_pn-1+{step})/100"),
]
TRIPLES = ("rwt_lz", "rwt_lp")

STATUS = {
    "cylinder": ('IF(rwt_ok=0,"CHECK THE INPUTS of the sheet Calculator",IF(rwt_pad_wrong<>"","CHECK THE INPUTS: "&rwt_pad_wrong,'
                 'IF(rwt_slides=1,"SLIDES: Q is above f P, there is no equilibrium.",IF(rwt_cyl_closed=0,"CAUTION: beside this Q there is '
                 'no closed form for so large a sigma; rwedge solve computes it",{strength}))))'),
    "flat": ('IF(rwt_ok=0,"CHECK THE INPUTS of the sheet Calculator",IF(rwt_pad_wrong<>"","CHECK THE INPUTS: "&rwt_pad_wrong,'
             'IF(rw_flat_of_pad="","No flat: a is empty",IF(rwt_flat_ok=0,"CAUTION: M and sigma on a flat pad are not here; rwedge solve '
             'computes them",IF(rwt_slides=1,"SLIDES: Q is above f P, there is no equilibrium.",{strength})))))'),
}
STRENGTH = ('IF(rwt_has_k=0,"CAUTION: no yield stress is given, so there is no safety",IF({0}="","CAUTION: strength is outside the tables: '
            'f up to 0.8, nu1 from 0.25 to 0.35, a/b up to 0.99",IF({0}<1,"YIELDS: if it slid",IF(AND(ABS(rw_beta)>1E-12,rwt_fr>0),'
            '"CAUTION: Dundurs\' beta is not 0: with friction its coupling is neglected",'
            'IF({1}>0.1,"CAUTION: the pad rises by more than 0.1 rad in the contact: it is hardly a half-plane","OK")))))')
RISE = {"cylinder": "(rwt_cyl_b+ABS(rwt_cyl_m))/rwt_pad_R", "flat": "rwt_flat_over/rwt_pad_R"}


def values_of(source, case):
    """Of the example, by the tool: of the cylinder and of the flat pad."""
    common = {name: case[name] for name in ("E1", "nu1", "E2", "nu2", "P", "Q", "f", "k")}
    found = {}
    for pad, shape in (("cylinder", {}), ("flat", {"flat": EXAMPLE["flat"]})):
        solved = source.solve(dict(common, radius=EXAMPLE["radius"], M=0, **shape))
        tip = EXAMPLE["flat"] / solved["b"] if shape else 0
        values = {row.name: solved.get(row.column) for row in RESULTS if row.column}
        for name, table in (("P_over_bk", "elastic-limit"), ("P_over_bk_shakedown", "shakedown-limit")):
            values[name] = source.table(table, pad="flat", a_over_b=tip, friction=case["f"], nu=case["nu1"])[0]["P_over_bk"]
        for name, limit in (("safety_strength", "P_over_bk"), ("safety_shakedown", "P_over_bk_shakedown")):
            values[name] = values[limit] / solved["load_over_bk"]
        found[pad] = values
    found["cylinder"]["safety"] = found["cylinder"]["safety_strength"] ** 2
    found["flat"].update(safety=None, tilt=None)
    return found


def write(sheet, source, case):
    values = values_of(source, case)
    sheet.text(0, 0, "Cylinder, and flat pad with rounded edges", "title")
    sheet.text(1, 0, "Bodies, P, Q, f and yield stress are those of the sheet Calculator. Type the pad into the yellow cells. Names of "
                     "results: rw_cylinder_b, rw_flat_b, and so on.", "note")
    write_inputs(sheet)
    write_status(sheet)
    for column, header in ((CYLINDER, "cylinder"), (FLAT, "flat pad")):
        sheet.text(FIRST_RESULT - 1, column, header, "header")
    for row, result in enumerate(RESULTS, FIRST_RESULT):
        sheet.text(row, LABEL, result.label)
        sheet.text(row, NAME, result.name, "note")
        sheet.text(row, UNIT, result.unit, "unit")
        sheet.text(row, HINT, result.hint, "note")
        for column, pad, formula in ((CYLINDER, "cylinder", result.cylinder), (FLAT, "flat", result.flat)):
            sheet.formula(row, column, formula or '""', values[pad].get(result.name), result.style)
            sheet.name(f"rw_{pad}_{result.name}", row, column)
    write_working(sheet, source)
    sheet.widths(A=38, B=20, C_D=13, E=8, F=46)
    sheet.print(f"A1:F{FIRST_RESULT + len(RESULTS)}", landscape=True)
    sheet.protect()


def write_inputs(sheet):
    for row, (name, label, unit, hint, must) in enumerate(INPUTS, FIRST_INPUT):
        cell = {"radius": "rw_radius_of_pad", "flat": "rw_flat_of_pad"}.get(name, "rw_" + name)
        sheet.text(row, LABEL, label)
        sheet.text(row, NAME, cell, "note")
        sheet.number(row, CYLINDER, EXAMPLE[name] or None, "input")
        sheet.name(cell, row, CYLINDER)
        sheet.text(row, UNIT, unit, "unit")
        sheet.text(row, HINT, hint, "note")
        condition = f"NOT({not_above_0(cell)})" if must.endswith("above 0") else f"ISNUMBER({cell})"
        sheet.rule(f"C{row + 1}", condition, label, hint, f"This must be {must}.")


def write_status(sheet):
    for row, pad in enumerate(STATUS, 2):
        strength = STRENGTH.format(f"rw_{pad}_safety_strength", RISE[pad])
        sheet.sheet.merge_range(row, 0, row, 5, "", sheet.book.styles["verdict"])
        sheet.formula(row, 0, f'"{"Cylinder" if pad == "cylinder" else "Flat pad"}: "&' + STATUS[pad].format(strength=strength),
                      f"{'Cylinder' if pad == 'cylinder' else 'Flat pad'}: OK", "verdict")
        sheet.name(f"rw_{pad}_status", row, 0)
        for word, colour in (("OK", "green"), ("CAUTION", "amber"), ("CHECK", "red"), ("YIELDS", "red"), ("SLIDES", "red")):
            sheet.colour(f"A{row + 1}:F{row + 1}", colour, f'ISNUMBER(SEARCH(": {word}",$A${row + 1}))')


def write_working(sheet, source):
    """Hidden: a column of working cells, and the largest pressures of the flat pads of a/b = 0, 0.01 to 0.99."""
    for row, (name, formula) in enumerate(WORKING_CELLS):
        sheet.text(row, WORKING, name, "note")
        sheet.formula(row, WORKING + 1, formula, None)
        sheet.name(name, row, WORKING + 1)
    write_triples(sheet)
    peaks = [row["largest_pressure"] for row in source.table("contact-law", pad="flat", a_over_b="0:0.99:0.01")]
    sheet.down(0, WORKING + 3, list(map(rounded, peaks)), name="rwt_flat_peaks")
    sheet.sheet.set_column(WORKING, WORKING + 6, 12, None, dict(hidden=True))


def write_triples(sheet):
    """Three weights side by side, as MMULT takes them; those of the pressure stand below each other, as its table does."""
    names = [name for name, _ in WORKING_CELLS]
    for row, name in enumerate(TRIPLES):
        for i in range(3):
            sheet.formula(row, WORKING + 4 + i, f"{name}{i + 1}", None)
        sheet.name(name, row, WORKING + 4, columns=3)
    sheet.name("rwt_pw", names.index("rwt_pw1"), WORKING + 1, rows=3)
