/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The sheet for one case: inputs as on a drawing, a verdict, results in groups. */
#include "workbook.h"

#include <math.h>
#include <string.h>

enum { LABEL, NAME, VALUE, UNIT, HINT, SKETCH };
enum { STRENGTH_ROW = 1, BAR_ROW, FIGURES_ROW, STATUS_ROW, INPUT_ROW = 7, RESULT_ROW = 24 };
enum { STRENGTH_LINES = 3, BAR_LINES = 3, STATUS_LINES = 3 };

/* Two steel bodies: a/b = 0.29, and yield at half as much load again. E1, nu1, E2, nu2, theta,
 * theta_deg, a, radius, P, Q, f, k, yield_stress. */
static const double example[INPUT_CELLS] = {210000, 0.3, 210000, 0.3, 0.01, NAN, 0.05,
                                            NAN,    190, 20,     0.2, 400,  NAN};

/* ---- Groups of cells ------------------------------------------------------------------------- */

/* Headings behind a "=", and the columns of Batch. */
static const char *const inputs[] = {
    "=Shape", "theta", "theta_deg",    "a",      "radius", "=Materials", "E1", "nu1", "E2",
    "nu2",    "k",     "yield_stress", "=Loads", "P",      "Q",          "f"};

static const char *const results[] = {"=Safety",
                                      "safety",
                                      "safety_strength",
                                      "=Geometry",
                                      "b",
                                      "a_over_b",
                                      "AP_over_theta_b",
                                      "A",
                                      "dundurs_beta",
                                      "=Pressure",
                                      "p0",
                                      "p_transition",
                                      "p_mean",
                                      "=Partial slip",
                                      "Q_over_fP",
                                      "c",
                                      "c_over_b",
                                      "=Tension at the trailing edge x = -b",
                                      "max_tension",
                                      "max_tension_sliding",
                                      "=First yield, in full sliding",
                                      "P_over_bk",
                                      "load_over_bk",
                                      "P_yield",
                                      "yield_branch",
                                      "yield_x",
                                      "yield_y",
                                      "f_critical",
                                      "von_mises_sliding"};
enum {
    INPUT_LINES = sizeof inputs / sizeof inputs[0],
    LINES = sizeof results / sizeof results[0],
    NOTES = 4
};

/* Writes a heading, or what is beside the value of a cell. The cell; -1 for a heading. */
static int describe(xlsx *book, int row, const char *line)
{
    if (line[0] == '=') {
        xlsx_text(book, row, LABEL, line + 1, XLSX_HEADING);
        return -1;
    }
    const int number = cell_of_column(line);
    const case_cell *cell = &case_cells[number];
    xlsx_text(book, row, LABEL, cell->label, XLSX_PLAIN);
    xlsx_text(book, row, NAME, cell->name, XLSX_NOTE);
    xlsx_text(book, row, UNIT, cell->unit, XLSX_UNIT);
    xlsx_text(book, row, HINT, cell->hint, XLSX_NOTE);
    return number;
}

/* ---- Inputs ---------------------------------------------------------------------------------- */

static void check_typing(xlsx *book, int row, int cell)
{
    const xlsx_rule rule = {formula_named(input_check(cell)), case_cells[cell].label,
                            case_cells[cell].hint, input_message(cell)};
    xlsx_validate(book, (xlsx_area){row, VALUE, 1, 1}, &rule);
}

static void write_inputs(xlsx *book)
{
    for (int i = 0; i < INPUT_LINES; i++) {
        const int row = INPUT_ROW + i, cell = describe(book, row, inputs[i]);
        if (cell < 0)
            continue;
        xlsx_number(book, row, VALUE, example[cell], XLSX_INPUT);
        xlsx_name(book, case_cells[cell].name, row, VALUE);
        check_typing(book, row, cell);
    }
}

/* ---- Verdict --------------------------------------------------------------------------------- */

static void colour_by_status(xlsx *book, xlsx_area area)
{
    static const struct {
        const char *word;
        xlsx_colour colour;
    } words[] = {{"OK", XLSX_GREEN},
                 {"CAUTION", XLSX_AMBER},
                 {"CHECK", XLSX_RED},
                 {"YIELDS", XLSX_RED},
                 {"SLIDES", XLSX_RED}};
    for (size_t i = 0; i < sizeof words / sizeof words[0]; i++)
        xlsx_colour_when(book, area,
                         compose("=LEFT($A$%d,%d)=\"%s\"", STATUS_ROW + 1,
                                 (int)strlen(words[i].word), words[i].word),
                         words[i].colour);
}

/* A text over the columns, so many lines high, under its name. */
static void write_wide(xlsx *book, int row, int lines, const char *formula, const char *shown,
                       xlsx_style style)
{
    const xlsx_area area = {row, LABEL, 1, HINT + 1 - LABEL};
    xlsx_lines(book, row, lines);
    xlsx_merge(book, area, style);
    xlsx_text_formula(book, row, LABEL, formula_named(formula), shown, style);
    colour_by_status(book, area);
}

static void write_verdict(xlsx *book, const case_values *values)
{
    write_wide(book, STRENGTH_ROW, STRENGTH_LINES, "strength()", values->strength, XLSX_VERDICT);
    xlsx_lines(book, BAR_ROW, BAR_LINES);
    draw_bar(book, BAR_ROW, LABEL);
    write_wide(book, FIGURES_ROW, 1, "figures()", values->figures, XLSX_VERDICT);
    write_wide(book, STATUS_ROW, STATUS_LINES, "status()", "OK", XLSX_WRAPPED);
    xlsx_name(book, "rw_verdict", STRENGTH_ROW, LABEL);
    xlsx_name(book, "rw_status", STATUS_ROW, LABEL);
    xlsx_text(book, STATUS_ROW + 1, LABEL,
              "rw_verdict, rw_status. The factor is of full sliding, Q = f P; for this Q itself "
              "\"rwedge solve --yield-factor\" has one on the stress.",
              XLSX_NOTE);
}

/* ---- Results --------------------------------------------------------------------------------- */

static void write_results(xlsx *book, const case_values *values)
{
    for (int i = 0; i < LINES; i++) {
        const int row = RESULT_ROW + i, cell = describe(book, row, results[i]);
        if (cell >= 0)
            named_cell(book, row, VALUE, cell, values,
                       strncmp(results[i], "safety", 6) == 0 ? XLSX_STRONG
                       : case_cells[cell].sign[0] != '\0'    ? XLSX_SIGNED
                                                             : XLSX_RESULT);
    }
}

static void write_notes(xlsx *book)
{
    static const char *const lines[] = {
        "Accuracy: geometry, pressure, slip and tension as exact as the spreadsheet computes; "
        "elastic limit within 0.05 %; load at yield and safety on load within",
        "0.15 % (0.5 % where a/b at yield is 0.01 to 0.02, 2 % down to 0.003); critical friction "
        "within 0.001;",
        "place of yield within 0.02 a or b (0.35 a at the surface with nu1 above 0.4; 0.003 b "
        "where a/b at yield is below 0.02). For a/b from 0.003, f up to 0.8, nu1 from 0 to 0.5.",
        "Moment M and bulk tension sigma: not here, as no plain formula holds them; the command "
        "\"rwedge solve\" has them. Plane strain; see \"About\".",
    };
    for (int i = 0; i < NOTES; i++)
        xlsx_text(book, RESULT_ROW + LINES + i, LABEL, lines[i], XLSX_NOTE);
}

void sheet_calculator(xlsx *book, case_values *values)
{
    shown_values(example, values);
    xlsx_text(book, 0, LABEL, "Contact of a wedge with a rounded apex and a half-plane",
              XLSX_TITLE);
    xlsx_text(book, INPUT_ROW - 1, LABEL,
              "Type into the yellow cells. Any consistent units do; those shown are mm, N, MPa.",
              XLSX_NOTE);
    write_inputs(book);
    write_verdict(book, values);
    write_results(book, values);
    write_notes(book);
    xlsx_width(book, LABEL, LABEL, 34);
    xlsx_width(book, NAME, NAME, 16);
    xlsx_width(book, VALUE, VALUE, 15);
    xlsx_width(book, UNIT, UNIT, 7);
    xlsx_width(book, HINT, HINT, 40);
    draw_sketch(book, INPUT_ROW - 1, SKETCH);
    draw_figures(book, RESULT_ROW + LINES + NOTES + 1);
    xlsx_freeze(book, STATUS_ROW, 0);
    xlsx_protect(book);
    xlsx_print(book, (xlsx_page){RESULT_ROW + LINES + NOTES + 1 + FIGURE_ROWS, SKETCH + 6, -1,
                                 false, NULL});
}
