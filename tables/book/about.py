# SPDX-License-Identifier: GPL-3.0-or-later
"""The sheet About."""
from book import LINE_HEIGHT

SECTIONS = [
    ("What this is", [
        "The contact of a wedge with a rounded apex and an elastically similar half-plane: contact law, pressure, "
        "tension, first yield. Plane strain, small angle theta.",
        'Source: M. Ciavarella, D. A. Hills, G. Monno, "Contact problems for a wedge with rounded apex", Int. J. Mech. '
        "Sci. 40 (1998) 977-988. Figs. 3, 4 and 6 are that paper's.",
    ]),
    ("Symbols and units", [
        "Any consistent units: with mm, N and MPa, forces per unit length are N/mm, A is 1/MPa. The tables hold pure "
        "numbers.",
        "theta: angle between flank and surface, rad. a: half-width of the rounding, R = a/theta its radius. b: half-"
        "width of the contact. P: normal load per unit length. f: coefficient of friction, full sliding, q = f p. k: "
        "yield stress in pure shear of the half-plane (tensile yield stress over the square root of 3).",
        "Q: tangential load, grown from 0 under constant P; |Q| cannot exceed f P. c: half-width of the zone that sticks.",
        'Body 1 is the half-plane, whose yield is looked at (nu1), as in the command "solve"; body 2 is the wedge. A = '
        "2(1-nu1^2)/E1 + 2(1-nu2^2)/E2. The name rw_A would be the name rw_a for a spreadsheet, which does not tell "
        "capitals from small letters: A is rw_compliance.",
        "rw_P_over_bk is the elastic limit at the case's a/b and f, as in the tables; rw_load_over_bk is that of the "
        "load. As the contact grows with the load, P_yield is not P times their ratio: rw_P_yield is the load at which "
        "the two meet.",
        "Two safeties: on load, rw_safety = P_yield/P, and on strength, rw_safety_strength = "
        "rw_P_over_bk/rw_load_over_bk, the factor by which the yield stress may fall. A small change of strength is a "
        'large one of load. "> 26" says that the table ends, at a/b = 0.003, before it yields: the safety is at least '
        "that.",
        "The sheet Pads has a cylinder and a flat pad with rounded edges, the cylinder also with a moment M and a bulk tension sigma. "
        "Of a wedge and a flat pad no plain formula holds M and sigma, nor is there one for any other profile. The commands "
        '"solve", "profile" and "field" have them, and so has the page.',
        "rw_yield_factor is the factor on the stress under the Q that is given: from the closed forms of the stress at some 600 places, of "
        "which the largest is taken. It is up to 2 % too high, where the largest stress lies between them.",
        "rw_material: a name of the sheet Materials in place of E1, nu1 and the yield stress, where the material has them.",
        "Shakedown: the limit P/(bk) of repeated sliding passes. Up to it the half-plane may yield at first and is elastic afterwards, as "
        "residual stresses stay. Perfect plasticity, small strains, passes from far to far under the same P and f. rw_safety_shakedown "
        "is the factor on the stress.",
    ]),
    ("Batch", [
        'A case a row. The first row names the inputs as "rwedge solve --input" does, and the results as it does. Paste '
        "values from a file below these names. For more than 200 rows take the sheet's protection off (there is no "
        "password), copy the last row as a whole, and paste it into the rows below.",
    ]),
    ("How the sheets compute", [
        "a/b, and c: from Hertz' closed form, or five Newton steps on the contact law from a parabola that is exact at "
        "both ends. Pressure, slip and tension: closed forms.",
        "Yield: a table of (A/theta)^2 J2, the largest at and below the surface, for 51 tips, 16 of Poisson's ratio and "
        "21 of f. The branches are interpolated apart, by parabolas in ln tan(phi0/2) with sin(phi0) = a/b, in (1-2 "
        "nu)^2/3 and in f^2, and the larger is taken, so that the cusp where they cross costs nothing. Where one of the "
        "values is missing, there is no limit below the surface.",
        "Yield load: the tip at which each branch has J2 = k^2, from the same parabolas, and the load that makes it. "
        "Critical friction: where the two branches cross. Place of first yield: a table of x/(a f) and y/a for 26 tips, "
        "interpolated as J2 is.",
        "Shakedown, and the limits of a flat pad: the shipped tables of P/(bk), by parabolas in (1-2 nu)^2/3, in f^2, and in ln(a/b), of a "
        "flat pad in acos(a/b). The pressure of a flat pad is that of a cylinder less that of a wedge of the angle a/R.",
    ]),
    ("Accuracy", [
        "Against the library, for a/b from 0.003 (all above 1 is Hertz), f from 0 to 0.8, nu1 from 0 to 0.5.",
        "a/b, b, c, pressure, tension: 1e-11 (1e-8 next to a/b = 1). Elastic limit, safety on strength: 0.05 %. Load at "
        "yield, safety on load: 0.15 % where a/b at yield is 0.02 or more, 0.5 % down to 0.01, 2 % down to 0.003, where "
        "the stress hardly depends on the load. Critical friction: 0.001. Place of first yield: 0.02 a (b, where that is "
        "smaller); 0.35 a at the surface with nu1 above 0.4, where J2 is nearly flat; 0.003 b where a/b at yield is below"
        " 0.02.",
        "Shakedown limit: 1 %, for a/b from 0.1 and nu1 from 0.25 to 0.35. Sheet Pads: 1e-9; largest pressure of a flat pad 0.1 %, elastic "
        "limit of a cylinder 0.05 %, of a flat pad 2 %, shakedown 1 %; a/b up to 0.99, nu1 from 0.25 to 0.35.",
        "Measured at the centres of all cells of the table and at 10000 random points: 0.047 %, 0.11 %, 0.41 %, 1.7 %, "
        "0.0008; 0.017 a, 0.33 a, 0.0023 b. The tests compare the cells with the library.",
    ]),
    ("Errata of the paper that concern these sheets", [
        'Eq. (38) and Fig. 6 have "a" where the half-width of the contact, b here, is meant. No closed form is given '
        "there for the maximum tension between the sharp wedge and Hertz: it is b sigma/(fP) = 2 (a/b)/(phi0 + (a/b) "
        "cos(phi0)).",
        "Sec. 5.2: with tension at the trailing edge x = -b, the yield point moves towards the leading edge, x > 0. In "
        "Fig. 3 the depth of the yield point does not go to 0 smoothly: it jumps to the surface at a finite tip, a/b = "
        "0.0176 for nu = 0.3.",
    ]),
    ("Files", [
        "The sheets hold formulas and numbers only: no macros, no links. The values shown before a program recalculates "
        "are right.",
    ]),
]
LINE_LENGTH = 88  # letters are narrower on average than the digits that widths count


def write(sheet):
    """A column of headings and paragraphs, each as high as it is long."""
    row = 0

    def add(text, style):
        nonlocal row
        if style == "wrapped":
            sheet.sheet.set_row(row, LINE_HEIGHT * (1 + len(text) // LINE_LENGTH))
        sheet.text(row, 0, text, style)
        row += 1

    sheet.widths(A=80)
    add("About this workbook", "title")
    add(f"Written by tables/workbook.py with the numbers of rwedge {sheet.book.version}.", "wrapped")
    for heading, paragraphs in SECTIONS:
        row += 1
        add(heading, "heading")
        for paragraph in paragraphs:
            add(paragraph, "wrapped")
    sheet.print(f"A1:A{row}")
