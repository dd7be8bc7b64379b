/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "workbook.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <rwedge.h>

/* ---- About ---- */

static const char *const lines[] = {
    "#What this is",
    "The contact of a wedge with a rounded apex and an elastically similar half-plane: contact "
    "law, pressure, tension, first yield. Plane strain, small angle theta.",
    "Source: M. Ciavarella, D. A. Hills, G. Monno, \"Contact problems for a wedge with rounded "
    "apex\", Int. J. Mech. Sci. 40 (1998) 977-988. Figs. 3, 4 and 6 are that paper's.",
    "#Symbols and units",
    "Any consistent units: with mm, N and MPa, forces per unit length are N/mm, A is 1/MPa. The "
    "tables hold pure numbers.",
    "theta: angle between flank and surface, rad. a: half-width of the rounding, R = a/theta its "
    "radius. b: half-width of the contact. P: normal load per unit length. f: coefficient of "
    "friction, full sliding, q = f p. k: yield stress in pure shear of the half-plane (tensile "
    "yield stress over the square root of 3).",
    "Q: tangential load, grown from 0 under constant P; |Q| cannot exceed f P. c: half-width of "
    "the zone that sticks.",
    "Body 1 is the half-plane, whose yield is looked at (nu1), as in the command \"solve\"; body 2 "
    "is the wedge. A = 2(1-nu1^2)/E1 + 2(1-nu2^2)/E2. The name rw_A would be the name rw_a for a "
    "spreadsheet, which does not tell capitals from small letters: A is rw_compliance.",
    "rw_P_over_bk is the elastic limit at the case's a/b and f, as in the tables; rw_load_over_bk "
    "is that of the load. As the contact grows with the load, P_yield is not P times their ratio: "
    "rw_P_yield is the load at which the two meet.",
    "Two safeties: on load, rw_safety = P_yield/P, and on strength, rw_safety_strength = "
    "rw_P_over_bk/rw_load_over_bk, the factor by which the yield stress may fall. A small change "
    "of strength is a large one of load. \"> 26\" says that the table ends, at a/b = 0.003, "
    "before it yields: the safety is at least that.",
    "Moment M and bulk tension sigma are not here: no plain formula holds them. Nor are other "
    "pads: cylinder, flat and rounded, any convex profile. The commands \"solve\", \"profile\" "
    "and \"field\" have them, and so has the page.",
    "#Batch",
    "A case a row. The first row names the inputs as \"rwedge solve --input\" does, and the "
    "results as it does. Paste values from a file below these names. For more than 200 rows take "
    "the sheet's protection off (there is no password), copy the last row as a whole, and paste "
    "it into the rows below.",
    "#How the sheets compute",
    "a/b, and c: from Hertz' closed form, or five Newton steps on the contact law from a parabola "
    "that is exact at both ends. Pressure, slip and tension: closed forms.",
    "Yield: a table of (A/theta)^2 J2, the largest at and below the surface, for 51 tips, 16 of "
    "Poisson's ratio and 21 of f. The branches are interpolated apart, by parabolas in ln "
    "tan(phi0/2) with sin(phi0) = a/b, in (1-2 nu)^2/3 and in f^2, and the larger is taken, so "
    "that the cusp where they cross costs nothing. Where one of the values is missing, there is "
    "no limit below the surface.",
    "Yield load: the tip at which each branch has J2 = k^2, from the same parabolas, and the load "
    "that makes it. Critical friction: where the two branches cross. Place of first yield: a table "
    "of x/(a f) and y/a for 26 tips, interpolated as J2 is.",
    "#Accuracy",
    "Against the library, for a/b from 0.003 (all above 1 is Hertz), f from 0 to 0.8, nu1 from 0 "
    "to 0.5.",
    "a/b, b, c, pressure, tension: 1e-11 (1e-8 next to a/b = 1). Elastic limit, safety on "
    "strength: 0.05 %. Load at yield, safety on load: 0.15 % where a/b at yield is 0.02 or more, "
    "0.5 % down to 0.01, 2 % down to 0.003, where the stress hardly depends on the load. Critical "
    "friction: 0.001. Place of first yield: 0.02 a (b, where that is smaller); 0.35 a at the "
    "surface with nu1 above 0.4, where J2 is nearly flat; 0.003 b where a/b at yield is below "
    "0.02.",
    "Measured at the centres of all cells of the table and at 10000 random points: 0.047 %, 0.11 "
    "%, "
    "0.41 %, 1.7 %, 0.0008; 0.017 a, 0.33 a, 0.0023 b. The tests compare the cells with the "
    "library.",
    "#Errata of the paper that concern these sheets",
    "Eq. (38) and Fig. 6 have \"a\" where the half-width of the contact, b here, is meant. No "
    "closed form is given there for the maximum tension between the sharp wedge and Hertz: it is b "
    "sigma/(fP) = 2 (a/b)/(phi0 + (a/b) cos(phi0)).",
    "Sec. 5.2: with tension at the trailing edge x = -b, the yield point moves towards the leading "
    "edge, x > 0. In Fig. 3 the depth of the yield point does not go to 0 smoothly: it jumps to "
    "the surface at a finite tip, a/b = 0.0176 for nu = 0.3.",
    "#Files",
    "The sheets hold formulas and numbers only: no macros, no links. The values shown before a "
    "program recalculates are right.",
};

enum { COLUMN_WIDTH = 80, LINE_LENGTH = 88 };

/* How many lines a paragraph takes; letters are narrower on average than the digits that widths
 * count. */
static int lines_of(const char *text)
{
    return 1 + (int)strlen(text) / LINE_LENGTH;
}

static void sheet_about(xlsx *book)
{
    char text[1200];
    int row = 0;
    xlsx_width(book, 0, 0, COLUMN_WIDTH);
    xlsx_text(book, row++, 0, "About this workbook", XLSX_TITLE);
    snprintf(text, sizeof text, "Written by rwedge %s with the command:  %s", rwedge_version(),
             invocation());
    xlsx_lines(book, row, lines_of(text));
    xlsx_text(book, row++, 0, text, XLSX_WRAPPED);
    for (size_t i = 0; i < sizeof lines / sizeof lines[0]; i++) {
        const bool heading = lines[i][0] == '#';
        row += heading;
        xlsx_lines(book, row, heading ? 1 : lines_of(lines[i]));
        xlsx_text(book, row++, 0, lines[i] + heading, heading ? XLSX_HEADING : XLSX_WRAPPED);
    }
    xlsx_print(book, (xlsx_page){row - 1, 0, -1, false, NULL});
}

/* ---- The book ---- */

/* The sheets, in their order. */
enum {
    SHEET_CALCULATOR,
    SHEET_BATCH,
    SHEET_LOOK_UP,
    SHEET_ELASTIC_LIMIT,
    SHEET_MAX_TENSION,
    SHEET_CONTACT_LAW,
    SHEET_CRITICAL_FRICTION,
    SHEET_ABOUT,
    SHEET_WORKING,
    SHEETS
};

static void fill_tables(xlsx *book)
{
    xlsx_turn_to(book, SHEET_ELASTIC_LIMIT);
    sheet_elastic_limit(book);
    xlsx_turn_to(book, SHEET_MAX_TENSION);
    sheet_max_tension(book);
    xlsx_turn_to(book, SHEET_CONTACT_LAW);
    sheet_contact_law(book);
    xlsx_turn_to(book, SHEET_CRITICAL_FRICTION);
    sheet_critical_friction(book);
}

static void fill(xlsx *book, const yield_table *table)
{
    static const char *const names[SHEETS] = {
        "Calculator",        "Batch",           "Look up",
        "Elastic limit",     "Maximum tension", "Contact law",
        "Critical friction", "About",           WORKING_SHEET};
    case_values values;
    for (int i = 0; i < SHEETS; i++)
        xlsx_sheet(book, names[i]);
    xlsx_turn_to(book, SHEET_ABOUT);
    sheet_about(book);
    xlsx_turn_to(book, SHEET_CALCULATOR);
    sheet_calculator(book, &values);
    xlsx_turn_to(book, SHEET_WORKING);
    sheet_working(book, table, &values);
    xlsx_hide_sheet(book);
    xlsx_turn_to(book, SHEET_BATCH);
    sheet_batch(book);
    xlsx_turn_to(book, SHEET_LOOK_UP);
    sheet_look_up(book);
    xlsx_hide_names(book, "rwt_");
    fill_tables(book);
}

void book_write(output *out)
{
    yield_table *table = memory_zeroed(1, sizeof *table);
    yield_table_fill(table);
    const char *problem;
    xlsx *book = xlsx_begin("rwedge: contact of a rounded wedge", false, &problem);
    if (book != NULL) {
        fill(book, table);
        problem = xlsx_finish(book, out);
    }
    if (problem != NULL)
        failure("%s: %s", out->name, problem);
}
