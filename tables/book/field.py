# SPDX-License-Identifier: GPL-3.0-or-later
"""The stress below the wedge under the Q of the calculator, at places of the right half, of which each is one of the left half too: the
largest J2 of these is the factor on the stress. The potential and its names are those of lib/README.md, "The closed forms", with the
sines and cosines of elliptic coordinates; c stands for the contact of the zone that sticks, which is taken off the shear."""
import math

from book import letters

FIRST_ROW = 380
ELLIPTIC = [(i * math.pi / 2 / 14, w) for i in range(15) for w in (0, 0.06, 0.14, 0.25, 0.38, 0.52, 0.7, 0.95, 1.3)]
TIP = [(x, y) for x in (0.02, 0.18, 0.36, 0.55, 0.75, 0.97, 1.2, 1.5, 2)
       for y in (0, 0.03, 0.08, 0.15, 0.24, 0.35, 0.5, 0.7, 0.95, 1.25, 1.6, 2.1, 2.8, 3.8)]
EDGE = [(share, depth) for share in (-0.02, 0, 0.02, 0.2, 0.45, 0.7, 0.9) for depth in (0, 0.06, 0.2)]


def rounded(value):
    return round(value, 6)


def places():
    """x and y as formulas, in units of length: at the contact's scale, at that of the rounding, and between stick and edge."""
    for v, w in ELLIPTIC:
        yield f"rwt_b*{rounded(math.sin(v) * math.cosh(w))}", f"rwt_b*{rounded(math.cos(v) * math.sinh(w))}"
    for x, y in TIP:
        yield f"rwt_fl_tip*{x}", f"rwt_fl_tip*{y}"
    for share, depth in EDGE:
        yield f"MAX(0,rwt_fl_c+{share}*(rwt_b-rwt_fl_c))", f"{depth}*(rwt_b-rwt_fl_c)"


def potential(suffix, half, alpha, phi, cosine):
    """The steps to G and y G' of a contact of this half-width: their names, and formulas of the names before; {x} and {y} are the
    place."""
    s = suffix
    pairs = [
        ("X", f"{{x}}/{half}"), ("Y", f"{{y}}/{half}"),
        ("ch", "(SQRT(({X}+1)^2+{Y}^2)+SQRT(({X}-1)^2+{Y}^2))/2"),
        ("sv", "MIN(1,{X}/{ch})"), ("sh", "SQRT(MAX(0,({ch}-1)*({ch}+1)))"), ("cv", "SQRT(MAX(0,(1-{sv})*(1+{sv})))"),
        ("pr", f"({{sv}}*{cosine}+{{cv}}*{alpha})*{{ch}}+1E-30"), ("pi", f"({{cv}}*{cosine}-{{sv}}*{alpha})*{{sh}}"),
        ("mr", f"({{sv}}*{cosine}-{{cv}}*{alpha})*{{ch}}+1E-30"), ("mi", f"({{cv}}*{cosine}+{{sv}}*{alpha})*{{sh}}"),
        ("wr", f"{{cv}}*{{ch}}+{cosine}+1E-30"), ("wi", "-{sv}*{sh}"),
        ("Ar", f"-(ATAN2({{mr}},{{mi}})-ATAN2({{pr}},{{pi}})-2*{phi})/2"),
        ("Ai", "LN(({mr}^2+{mi}^2)/({pr}^2+{pi}^2))/4"),
        ("Br", f"PI()/2-{phi}-ATAN2({{pr}},{{pi}})+ATAN2({{wr}},{{wi}})"), ("Bi", "LN(({pr}^2+{pi}^2)/({wr}^2+{wi}^2))/2"),
        ("Rr", "{X}-{sv}*{sh}"), ("Ri", "{Y}-{cv}*{ch}"),
        # R/X = -1 + z/X
        ("q", "({sv}*{sh})^2+({cv}*{ch})^2+1E-30"),
        ("Tr", "({Rr}*{sv}*{sh}+{Ri}*{cv}*{ch})/{q}"), ("Ti", "({Ri}*{sv}*{sh}-{Rr}*{cv}*{ch})/{q}"),
        ("Gr", f"2/PI()*({{Br}}-(({{X}}-{alpha})*{{Ar}}-{{Y}}*{{Ai}})/{alpha}+{phi}/{alpha}*{{Rr}})"),
        ("Gi", f"2/PI()*({{Bi}}-(({{X}}-{alpha})*{{Ai}}+{{Y}}*{{Ar}})/{alpha}+{phi}/{alpha}*{{Ri}})"),
        ("yr", f"-{{Y}}*2/PI()*({{Ar}}+{phi}*{{Tr}})/{alpha}"), ("yi", f"-{{Y}}*2/PI()*({{Ai}}+{phi}*{{Ti}})/{alpha}"),
    ]
    return [(name + s, formula) for name, formula in
            ((name, rename(formula, [each for each, _ in pairs], s)) for name, formula in pairs)]


def rename(formula, names, suffix):
    for name in names:
        formula = formula.replace("{" + name + "}", "{" + name + suffix + "}")
    return formula


def measure(side):
    """J2 on the right (1) or the left (-1): G(-z*) = -G(z)*. T is the potential of the shear."""
    tr, ti = f"({side}*rwt_fr*({{Grb}}*rwt_fl_kb-{{Grc}}*rwt_fl_kc))", "(rwt_fr*({Gib}*rwt_fl_kb-{Gic}*rwt_fl_kc))"
    ur, ui = "(rwt_fr*({yrb}*rwt_fl_kb-{yrc}*rwt_fl_kc))", f"({side}*rwt_fr*({{yib}}*rwt_fl_kb-{{yic}}*rwt_fl_kc))"
    mean = f"({{Gib}}*rwt_fl_kb-{tr})"
    real, imaginary = f"(-{{yrb}}*rwt_fl_kb-{ui}+{tr})", f"(-{side}*{{yib}}*rwt_fl_kb+{ur}+{ti})"
    return f"{real}^2+{imaginary}^2+rwt_m*{mean}^2"


# Of the contact b and of the zone c that sticks: the tip over the half-width, its angle, its cosine; the factor of Hertz' contact.
HEADS = [
    ("rwt_fl_c", "IF(rwt_cc>0,rwt_cc,rwt_b/2)"), ("rwt_fl_tip", "MIN(rwt_a,rwt_b)"),
    ("rwt_fl_ab", "MIN(1,MAX(1E-6,rwt_a/rwt_b))"), ("rwt_fl_pb", "ASIN(rwt_fl_ab)"), ("rwt_fl_cb", "SQRT((1-rwt_fl_ab)*(1+rwt_fl_ab))"),
    ("rwt_fl_ac", "MIN(1,MAX(1E-6,rwt_a/rwt_fl_c))"), ("rwt_fl_pc", "ASIN(rwt_fl_ac)"),
    ("rwt_fl_cc", "SQRT((1-rwt_fl_ac)*(1+rwt_fl_ac))"),
    ("rwt_fl_kb", "1/MAX(1,rwt_a/rwt_b)"), ("rwt_fl_kc", "IF(rwt_cc>0,1/MAX(1,rwt_a/rwt_fl_c),0)"),
]


def write(sheet):
    """A row for each place; the largest J2 is rwt_fl_J2."""
    sheet.text(FIRST_ROW - 3, 0, "The stress under the Q of the calculator, at places of the right half and their images", "note")
    for column, (name, formula) in enumerate(HEADS):
        sheet.text(FIRST_ROW - 2, column, name, "note")
        sheet.formula(FIRST_ROW - 1, column, formula, None)
        sheet.name(name, FIRST_ROW - 1, column)
    steps = [("x", ""), ("y", ""), *potential("b", "rwt_b", "rwt_fl_ab", "rwt_fl_pb", "rwt_fl_cb"),
             *potential("c", "rwt_fl_c", "rwt_fl_ac", "rwt_fl_pc", "rwt_fl_cc"), ("right", measure(1)), ("left", measure(-1))]
    column_of = {name: column for column, (name, _) in enumerate(steps)}
    count = 0
    for count, (x, y) in enumerate(places(), 1):
        row = FIRST_ROW + count
        cells = {name: letters(column) + str(row + 1) for name, column in column_of.items()}
        for name, formula in steps:
            formula = {"x": x, "y": y}.get(name) or formula.format(**cells)
            sheet.formula(row, column_of[name], formula, None)
    sheet.name("rwt_fl_all", FIRST_ROW + 1, column_of["right"], count, 2)
    sheet.formula(FIRST_ROW - 1, len(HEADS), "IF(rwt_ok=1,MAX(rwt_fl_all),1)", None)
    sheet.name("rwt_fl_J2", FIRST_ROW - 1, len(HEADS))


