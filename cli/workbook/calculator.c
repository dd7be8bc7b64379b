/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The sheet for one case: inputs as on a drawing, a verdict, results in groups. */
#include "workbook.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

enum { LABEL, NAME, VALUE, UNIT, HINT, SKETCH };
enum { STRENGTH_ROW = 1, BAR_ROW, FIGURES_ROW, STATUS_ROW, INPUT_ROW = 7, RESULT_ROW = 24 };
enum { STRENGTH_LINES = 3, BAR_LINES = 3, STATUS_LINES = 3 };

/* Two steel bodies: a/b = 0.29, and yield at half as much load again. */
static const double example[INPUT_CELLS] = {
    [CELL_E1] = 210000,       [CELL_NU1] = 0.3,       [CELL_E2] = 210000,     [CELL_NU2] = 0.3,
    [CELL_THETA] = 0.01,      [CELL_THETA_DEG] = NAN, [CELL_ROUNDING] = 0.05, [CELL_RADIUS] = NAN,
    [CELL_LOAD] = 190,        [CELL_Q] = 20,          [CELL_F] = 0.2,         [CELL_K] = 400,
    [CELL_YIELD_STRESS] = NAN};

/* ---- Groups of cells ------------------------------------------------------------------------- */

typedef struct {
    int cell; /* or RESULTS_END: a heading */
    const char *text;
} line;

static const line inputs[] = {
    {RESULTS_END, "Shape"}, {CELL_THETA, NULL},  {CELL_THETA_DEG, NULL},
    {CELL_ROUNDING, NULL},  {CELL_RADIUS, NULL}, {RESULTS_END, "Materials"},
    {CELL_E1, NULL},        {CELL_NU1, NULL},    {CELL_E2, NULL},
    {CELL_NU2, NULL},       {CELL_K, NULL},      {CELL_YIELD_STRESS, NULL},
    {RESULTS_END, "Loads"}, {CELL_LOAD, NULL},   {CELL_Q, NULL},
    {CELL_F, NULL},
};

static const line results[] = {
    {RESULTS_END, "Safety"},
    {CELL_SAFETY, "P may grow by this factor: the contact grows with it"},
    {CELL_SAFETY_STRENGTH, "k or Y may fall by this factor under this P"},
    {RESULTS_END, "Geometry"},
    {CELL_B, "the contact is |x| < b"},
    {CELL_A_OVER_B, "1 and more: Hertz' contact; 0: sharp"},
    {CELL_LOAD_NUMBER, "2 for a sharp wedge"},
    {CELL_COMPLIANCE, "2(1-nu1^2)/E1 + 2(1-nu2^2)/E2"},
    {CELL_BETA, "0 for elastically similar bodies"},
    {RESULTS_END, "Pressure"},
    {CELL_P0, "infinite, so empty, for a sharp wedge"},
    {CELL_P_TRANSITION, "where rounding meets flank; 0 beyond b"},
    {CELL_P_MEAN, ""},
    {RESULTS_END, "Partial slip"},
    {CELL_Q_OVER_FP, "1 and more: it slides"},
    {CELL_C, "sticks in |x| < c, slips in c < |x| < b"},
    {CELL_C_OVER_B, ""},
    {RESULTS_END, "Tension at the trailing edge x = -b"},
    {CELL_TENSION, "Q grown from 0 under constant P"},
    {CELL_TENSION_SLIDING, "Q = f P"},
    {RESULTS_END, "First yield, in full sliding"},
    {CELL_P_OVER_BK, "at this a/b: it yields above"},
    {CELL_LOAD_OVER_BK, "of the load given"},
    {CELL_P_YIELD, "with the contact that it makes"},
    {CELL_BRANCH, "where, at that load"},
    {CELL_YIELD_X, "from the middle, towards the leading edge for Q > 0"},
    {CELL_YIELD_Y, "0: at the surface"},
    {CELL_F_CRITICAL, "above it, yield starts at the surface"},
    {CELL_VON_MISES, "under this P"},
};
enum {
    INPUT_LINES = sizeof inputs / sizeof inputs[0],
    LINES = sizeof results / sizeof results[0],
    NOTES = 4
};

static bool is_heading(xlsx *book, int row, const line *entry)
{
    if (entry->cell == RESULTS_END)
        xlsx_text(book, row, LABEL, entry->text, XLSX_HEADING);
    return entry->cell == RESULTS_END;
}

static void describe(xlsx *book, int row, int cell, const char *hint)
{
    xlsx_text(book, row, LABEL, case_cells[cell].label, XLSX_PLAIN);
    xlsx_text(book, row, NAME, case_cells[cell].name, XLSX_NOTE);
    xlsx_text(book, row, UNIT, case_cells[cell].unit, XLSX_UNIT);
    xlsx_text(book, row, HINT, hint, XLSX_NOTE);
}

/* ---- Inputs ---------------------------------------------------------------------------------- */

static void check_typing(xlsx *book, int row, int cell)
{
    const xlsx_rule rule = {formula_named(input_check(cell)), case_cells[cell].label,
                            input_rules[cell].hint, input_message(cell)};
    xlsx_validate(book, (xlsx_area){row, VALUE, 1, 1}, &rule);
}

static void write_inputs(xlsx *book)
{
    for (int i = 0; i < INPUT_LINES; i++) {
        const int row = INPUT_ROW + i, cell = inputs[i].cell;
        if (is_heading(book, row, &inputs[i]))
            continue;
        describe(book, row, cell, input_rules[cell].hint);
        xlsx_number(book, row, VALUE, example[cell], XLSX_INPUT);
        xlsx_name(book, case_cells[cell].name, row, VALUE);
        check_typing(book, row, cell);
    }
}

/* ---- Verdict --------------------------------------------------------------------------------- */

/* The sentence of the model's verdict, where full sliding decides. */
static const char strength[] =
    "IF(OR(rwt_ok=0,rwt_slides=1),\"No results: the status says why.\","
    "IF(rwt_has_k=0,\"No yield stress is given, so nothing is known of its strength.\","
    "IF(rwt_a=0,\"It yields: the stress at a sharp apex has no bound.\","
    "IF(rw_safety=\"\",\"Its strength is outside the tables of this workbook.\","
    "IF(ISNUMBER(rw_safety),IF(rw_safety<1,\"If it slid, it would yield: the factor on P is "
    "\"&short(rw_safety,4),\"If it slid, it would be elastic with a factor of "
    "\"&short(rw_safety,4)&\" on P\")&\"; it yields first at x = \"&short(rw_yield_x,2)&\", y = "
    "\"&short(rw_yield_y,2)&\" mm, \"&IF(rw_yield_y>0,\"below\",\"at\")&\" the surface.\","
    "\"If it slid, it would be elastic with a factor of \"&rw_safety&\" on P.\")))))";

static const char figures[] =
    "IF(rwt_ok=0,\"\",\"b = \"&short(rw_b,4)&\" mm, half-width of the contact\"&"
    "IF(rwt_a>0,\";  p0 = \"&short(rw_p0,4)&\" MPa, peak pressure\",\"\")&"
    "IF(ISNUMBER(rw_c_over_b),\";  c/b = \"&short(rw_c_over_b,4)&\" of the contact sticks\",\"\"))";

/* What yields, then what is doubtful, as the model has it for full sliding. */
static const char status[] =
    "IF(rwt_any=0,\"Type into the yellow cells.\",IF(rwt_bad<>\"\",\"CHECK THE INPUTS: \"&rwt_bad,"
    "IF(rwt_slides=1,\"SLIDES: Q is above f P, there is no equilibrium.\","
    "IF(AND(ISNUMBER(rw_safety),N(rw_safety)<1),\"YIELDS: P is above the load at first yield in "
    "full sliding. "
    "\",\"\")&IF(rw_remarks<>\"\",\"CAUTION: \"&rw_remarks,"
    "IF(rwt_has_k=0,\"CAUTION: no yield stress is given, so there is no safety\",\"OK\")))))";

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
    write_wide(book, STRENGTH_ROW, STRENGTH_LINES, strength, values->strength, XLSX_VERDICT);
    xlsx_lines(book, BAR_ROW, BAR_LINES);
    draw_bar(book, BAR_ROW, LABEL);
    write_wide(book, FIGURES_ROW, 1, figures, values->figures, XLSX_VERDICT);
    write_wide(book, STATUS_ROW, STATUS_LINES, status, "OK", XLSX_WRAPPED);
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
        const int row = RESULT_ROW + i, cell = results[i].cell;
        if (is_heading(book, row, &results[i]))
            continue;
        describe(book, row, cell, results[i].text);
        named_cell(book, row, VALUE, cell, values,
                   cell == CELL_SAFETY || cell == CELL_SAFETY_STRENGTH ? XLSX_STRONG
                                                                       : case_cells[cell].style);
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
