/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The workbook's tables. Each sheet has the title in the first row, a note in the second, and the
 * header in the fourth. */
#include "workbook.h"

#include "table/table.h"

#include <math.h>

#include <rwedge.h>

enum { HEADER_ROW = 3, FIRST_ROW = HEADER_ROW + 1 };

static void head(xlsx *book, const char *title, const char *note)
{
    xlsx_text(book, 0, 0, title, XLSX_TITLE);
    xlsx_text(book, 1, 0, note, XLSX_NOTE);
}

/* ---- Elastic limit --------------------------------------------------------------------------- */

/* The paper's grid on the left, f down; then f = 0; then the two branches, to be looked up. */
enum {
    GRID_TIPS = 10,
    GRID_FRICTIONS = 65,
    NORMAL_COLUMN = GRID_TIPS + 2,
    NORMAL_TIPS = 100,
    SURFACE_COLUMN = NORMAL_COLUMN + 5,
    BELOW_COLUMN = SURFACE_COLUMN + BRANCH_TIPS + 2
};

static const double PAPER_NU = 0.3;

static void write_grid(xlsx *book)
{
    xlsx_text(book, HEADER_ROW - 1, 1, "a/b across, f down: P/(bk), nu = 0.3", XLSX_HEADING);
    xlsx_text(book, HEADER_ROW, 0, "f", XLSX_HEADER);
    for (int j = 0; j < GRID_TIPS; j++)
        xlsx_number(book, HEADER_ROW, j + 1, (j + 1) / 10.0, XLSX_HEADER);
    for (int i = 0; i < GRID_FRICTIONS; i++) {
        const double f = i / 80.0;
        xlsx_number(book, FIRST_ROW + i, 0, f, XLSX_PLAIN);
        for (int j = 0; j < GRID_TIPS; j++) {
            const double limit = rwedge_elastic_limit((j + 1) / 10.0, f, PAPER_NU);
            xlsx_number(book, FIRST_ROW + i, j + 1, workbook_computed(limit), XLSX_FIXED_4);
        }
    }
}

static void write_normal_load(xlsx *book)
{
    static const char *const names[] = {"a/b", "P/(bk)", "depth y/b"};
    xlsx_text(book, HEADER_ROW - 1, NORMAL_COLUMN, "f = 0, nu = 0.3", XLSX_HEADING);
    for (int i = 0; i < 3; i++)
        xlsx_text(book, HEADER_ROW, NORMAL_COLUMN + i, names[i], XLSX_HEADER);
    for (int i = 0; i < NORMAL_TIPS; i++) {
        double limit = NAN, x, y = NAN;
        const double tip = (i + 1) / (double)NORMAL_TIPS;
        rwedge_yield_point(tip, 0, PAPER_NU, &limit, &x, &y);
        xlsx_number(book, FIRST_ROW + i, NORMAL_COLUMN, tip, XLSX_PLAIN);
        xlsx_number(book, FIRST_ROW + i, NORMAL_COLUMN + 1, workbook_computed(limit), XLSX_FIXED_4);
        xlsx_number(book, FIRST_ROW + i, NORMAL_COLUMN + 2, workbook_computed(y), XLSX_FIXED_4);
    }
}

/* Closer where the tip is small: straight lines between these err as little as is said. */
static const double branch_tips[BRANCH_TIPS] = {
    0.01,  0.012, 0.015, 0.018, 0.022, 0.027, 0.033, 0.04,  0.05, 0.06,
    0.075, 0.09,  0.11,  0.135, 0.165, 0.2,   0.25,  0.3,   0.36, 0.43,
    0.51,  0.6,   0.7,   0.8,   0.87,  0.92,  0.96,  0.985, 1};

static void write_branch(xlsx *book, int column, const char *title, const char *name,
                         double limit_of(double, double))
{
    xlsx_text(book, HEADER_ROW - 1, column, title, XLSX_HEADING);
    for (int j = 0; j < BRANCH_TIPS; j++)
        xlsx_number(book, HEADER_ROW, column + j, branch_tips[j], XLSX_HEADER);
    for (int i = 0; i < GRID_FRICTIONS; i++)
        for (int j = 0; j < BRANCH_TIPS; j++) {
            const double limit = limit_of(branch_tips[j], i / 80.0);
            if (!isinf(limit))
                xlsx_number(book, FIRST_ROW + i, column + j, workbook_computed(limit),
                            XLSX_FIXED_4);
        }
    xlsx_name_range(book, name, FIRST_ROW, column, GRID_FRICTIONS, BRANCH_TIPS);
}

/* Infinite where there is no such branch, NAN where it cannot be computed. */
static double limit_if(int32_t status, double limit)
{
    return status == RWEDGE_OK ? limit : status == RWEDGE_EABSENT ? INFINITY : NAN;
}

static double surface_limit(double tip, double f)
{
    double limit = NAN, x;
    const int32_t status = rwedge_surface_yield(tip, f, PAPER_NU, &limit, &x);
    return limit_if(status, limit);
}

static double limit_below(double tip, double f)
{
    double limit = NAN, x, y;
    const int32_t status = rwedge_subsurface_yield(tip, f, PAPER_NU, &limit, &x, &y);
    return limit_if(status, limit);
}

static void write_branches(xlsx *book)
{
    xlsx_text(book, HEADER_ROW, SURFACE_COLUMN - 1, "f", XLSX_HEADER);
    for (int i = 0; i < GRID_FRICTIONS; i++)
        xlsx_number(book, FIRST_ROW + i, SURFACE_COLUMN - 1, i / 80.0, XLSX_PLAIN);
    xlsx_name_range(book, "rw_table_tips", HEADER_ROW, SURFACE_COLUMN, 1, BRANCH_TIPS);
    xlsx_name_range(book, "rw_table_f", FIRST_ROW, SURFACE_COLUMN - 1, GRID_FRICTIONS, 1);
    write_branch(book, SURFACE_COLUMN, "P/(bk) at the surface: a/b across, f down, nu = 0.3",
                 "rw_table_surface", surface_limit);
    write_branch(book, BELOW_COLUMN, "P/(bk) below the surface; empty: there is no maximum there",
                 "rw_table_below", limit_below);
}

void sheet_elastic_limit(xlsx *book)
{
    head(book, "Elastic limit P/(bk)",
         "Load at first yield (von Mises, plane strain) in full sliding, k the yield stress in "
         "pure shear. a/b = 1 holds for all a/b above 1. To the right: the two branches, for the "
         "sheet Look up.");
    xlsx_width(book, 0, BELOW_COLUMN + BRANCH_TIPS, 8);
    xlsx_width(book, NORMAL_COLUMN - 1, NORMAL_COLUMN - 1, 3);
    write_grid(book);
    write_normal_load(book);
    write_branches(book);
    xlsx_freeze(book, FIRST_ROW, 0);
    xlsx_print(book, (xlsx_page){FIRST_ROW + NORMAL_TIPS - 1, NORMAL_COLUMN + 2, -1, false, NULL});
}

/* ---- The other tables ------------------------------------------------------------------------ */

void sheet_max_tension(xlsx *book)
{
    head(book, "Maximum tension",
         "At the trailing edge in full sliding. a/b = 1 holds for all a/b above 1.");
    xlsx_text(book, HEADER_ROW - 1, 2, "b sigma/P, f across", XLSX_HEADING);
    xlsx_text(book, HEADER_ROW, 0, "a/b", XLSX_HEADER);
    xlsx_text(book, HEADER_ROW, 1, "b sigma/(fP)", XLSX_HEADER);
    for (int j = 1; j <= 8; j++)
        xlsx_number(book, HEADER_ROW, j + 1, j / 10.0, XLSX_HEADER);
    for (int i = 0; i <= 100; i++) {
        const double tension = rwedge_max_tension(i / 100.0);
        xlsx_number(book, FIRST_ROW + i, 0, i / 100.0, XLSX_PLAIN);
        xlsx_number(book, FIRST_ROW + i, 1, workbook_rounded(tension), XLSX_FIXED_6);
        for (int j = 1; j <= 8; j++)
            xlsx_number(book, FIRST_ROW + i, j + 1, workbook_rounded(tension * j / 10),
                        XLSX_FIXED_6);
    }
    xlsx_width(book, 0, 0, 8);
    xlsx_width(book, 1, 1, 13);
    xlsx_width(book, 2, 9, 10);
    xlsx_freeze(book, FIRST_ROW, 1);
    xlsx_print(book, (xlsx_page){FIRST_ROW + 100, 9, HEADER_ROW, false, NULL});
}

void sheet_contact_law(xlsx *book)
{
    static const char *const names[] = {"a/b", "AP/(theta b)", "AP/(theta a)", "A p0/theta",
                                        "A p(a)/theta"};
    const table *law = table_named("contact-law");
    head(book, "Contact law",
         "Load, pressure at x = 0 and where the rounding ends, x = a (0 where the contact ends "
         "before).");
    for (int j = 0; j < 5; j++)
        xlsx_text(book, HEADER_ROW, j, names[j], XLSX_HEADER);
    for (int i = 0; i < 200; i++) {
        double value[VARIABLE_COUNT] = {0};
        cell row[COLUMNS_MAX];
        value[A_OVER_B] = (i + 1) / 100.0;
        law->row(value, row);
        xlsx_number(book, FIRST_ROW + i, 0, workbook_rounded(value[A_OVER_B]), XLSX_PLAIN);
        for (int j = 0; j < 4; j++)
            xlsx_number(book, FIRST_ROW + i, j + 1, workbook_rounded(row[j].number), XLSX_FIXED_6);
    }
    xlsx_width(book, 0, 0, 8);
    xlsx_width(book, 1, 4, 15);
    xlsx_freeze(book, FIRST_ROW, 1);
    xlsx_print(book, (xlsx_page){FIRST_ROW + 199, 5, HEADER_ROW, false, NULL});
}

void sheet_critical_friction(xlsx *book)
{
    head(book, "Critical friction",
         "The f at which first yield jumps from below to the surface; 0: it is at the surface "
         "without friction.");
    xlsx_text(book, HEADER_ROW - 1, 1, "nu across", XLSX_HEADING);
    xlsx_text(book, HEADER_ROW, 0, "a/b", XLSX_HEADER);
    for (int j = 0; j <= 12; j++)
        xlsx_number(book, HEADER_ROW, j + 1, (200 + 25 * j) / 1000.0, XLSX_HEADER);
    for (int i = 0; i < 100; i++) {
        const double tip = (i + 1) / 100.0;
        xlsx_number(book, FIRST_ROW + i, 0, tip, XLSX_PLAIN);
        for (int j = 0; j <= 12; j++) {
            const double f = rwedge_critical_friction(tip, (200 + 25 * j) / 1000.0);
            xlsx_number(book, FIRST_ROW + i, j + 1, workbook_computed(f), XLSX_FIXED_4);
        }
    }
    xlsx_width(book, 0, 13, 8);
    xlsx_freeze(book, FIRST_ROW, 1);
    xlsx_print(book, (xlsx_page){FIRST_ROW + 99, 13, HEADER_ROW, false, NULL});
}

/* ---- Look up ---- */

enum { AT_TIP, AT_F, AT_LIMIT, AT_NOTE, ASKED_HEADER = 9, ASKED_FIRST, ASKED_ROWS = 20 };

/* Entries of the table, of which the formula gives back the value. */
static const double examples[][2] = {{0.3, 0.1}, {0.11, 0.3}, {1, 0}};
enum { EXAMPLES = sizeof examples / sizeof examples[0] };

static void write_row(xlsx *book, int row, double tip, double f)
{
    xlsx_number(book, row, AT_TIP, tip, XLSX_INPUT);
    xlsx_number(book, row, AT_F, f, XLSX_INPUT);
    formula_cell(book, row, AT_LIMIT, formula_named(compose("look_up(A%d,B%d)", row + 1, row + 1)),
                 isnan(tip) ? NAN : rwedge_elastic_limit(tip, f, 0.3), XLSX_RESULT);
}

static void check_typing(xlsx *book)
{
    const xlsx_rule of_tip = {
        compose("=AND(A%d>=0.01,A%d<1E+60)", ASKED_FIRST + 1, ASKED_FIRST + 1), "a/b",
        "0.01 and above", "a/b must be a number, 0.01 or above."};
    xlsx_validate(book, (xlsx_area){ASKED_FIRST, AT_TIP, ASKED_ROWS, 1}, &of_tip);
    const xlsx_rule of_f = {compose("=AND(B%d>=0,B%d<=0.8)", ASKED_FIRST + 1, ASKED_FIRST + 1), "f",
                            "0 to 0.8", "f must be a number, 0 to 0.8."};
    xlsx_validate(book, (xlsx_area){ASKED_FIRST, AT_F, ASKED_ROWS, 1}, &of_f);
}

void sheet_look_up(xlsx *book)
{
    static const char *const lines[] = {
        "Type a/b and f, or copy a blue cell to the right of your own two columns, on any sheet of "
        "this workbook.",
        "a/b from 0.01 (from 1 on, all are Hertz' contact), f from 0 to 0.8; nu = 0.3. For other "
        "nu take the sheet Batch.",
        "Its table is on the right of the sheet Elastic limit: the two branches, at the surface "
        "and below it.",
        "The formula interpolates each branch by itself, linearly, and takes the smaller. The "
        "limit has a kink where they cross;",
        "the branches have none. Where one of the four entries below the surface is missing, the "
        "surface decides.",
        "Error: 0.12 % at most, over the middles of all cells of the table.",
    };
    static const char *const header[] = {"a/b", "f", "P/(bk)"};
    xlsx_text(book, 0, AT_TIP, "Look up: the elastic limit between the entries of the table",
              XLSX_TITLE);
    for (int i = 0; i < (int)(sizeof lines / sizeof lines[0]); i++)
        xlsx_text(book, 2 + i, AT_TIP, lines[i], XLSX_PLAIN);
    for (int i = 0; i < 3; i++)
        xlsx_text(book, ASKED_HEADER, i, header[i], XLSX_HEADER);
    for (int i = 0; i < ASKED_ROWS; i++)
        write_row(book, ASKED_FIRST + i, i < EXAMPLES ? examples[i][0] : NAN,
                  i < EXAMPLES ? examples[i][1] : NAN);
    check_typing(book);
    xlsx_width(book, AT_TIP, AT_LIMIT, 16);
    xlsx_width(book, AT_NOTE, AT_NOTE, 60);
    xlsx_freeze(book, ASKED_FIRST, 0);
    xlsx_protect(book);
    xlsx_print(book, (xlsx_page){ASKED_FIRST + ASKED_ROWS - 1, AT_NOTE, -1, true, NULL});
}
