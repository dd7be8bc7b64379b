/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The workbook's tables. Each sheet has the title in the first row, a note in the second, and the
 * header in the fourth. */
#include "table_sheets.h"

#include "table/tables.h"

#include <math.h>
#include <stdio.h>

#include <rwedge.h>

enum { HEADER_ROW = 3, FIRST_ROW = HEADER_ROW + 1 };

static void head(xlsx *book, const char *title, const char *note)
{
    xlsx_text(book, 0, 0, title, XLSX_TITLE);
    xlsx_text(book, 1, 0, note, XLSX_NOTE);
}

/* ---- Elastic limit --------------------------------------------------------------------------- */

/* The paper's grid on the left, f down, for the reader and the charts; then f = 0; then what the
 * calculator uses. */
enum {
    GRID_TIPS = 10,
    GRID_FRICTIONS = 65,
    NORMAL_COLUMN = GRID_TIPS + 2,
    TABLE_COLUMN = NORMAL_COLUMN + 4,
    SURFACE_COLUMN = TABLE_COLUMN + 2,
    BELOW_COLUMN = SURFACE_COLUMN + FRICTIONS + 1
};

static const double PAPER_NU = 0.3;

static bool write_grid(xlsx *book)
{
    bool done = true;
    xlsx_text(book, HEADER_ROW - 1, 1, "a/b across, f down: P/(bk), nu = 0.3", XLSX_HEADING);
    xlsx_text(book, HEADER_ROW, 0, "f", XLSX_HEADER);
    for (int j = 0; j < GRID_TIPS; j++)
        xlsx_number(book, HEADER_ROW, j + 1, (j + 1) / 10.0, XLSX_HEADER);
    for (int i = 0; i < GRID_FRICTIONS; i++) {
        const double f = i / 80.0;
        xlsx_number(book, FIRST_ROW + i, 0, f, XLSX_PLAIN);
        for (int j = 0; j < GRID_TIPS; j++) {
            const double limit = rwedge_elastic_limit((j + 1) / 10.0, f, PAPER_NU);
            done = done && isfinite(limit);
            xlsx_number(book, FIRST_ROW + i, j + 1, workbook_rounded(limit), XLSX_FIXED_4);
        }
    }
    return done;
}

static bool write_normal_load(xlsx *book, const limit_table *limits)
{
    static const char *const names[] = {"a/b", "P/(bk)", "depth y/b"};
    bool done = true;
    xlsx_text(book, HEADER_ROW - 1, NORMAL_COLUMN, "f = 0, nu = 0.3", XLSX_HEADING);
    for (int i = 0; i < 3; i++)
        xlsx_text(book, HEADER_ROW, NORMAL_COLUMN + i, names[i], XLSX_HEADER);
    for (int i = 0; i < TIPS; i++) {
        double limit = NAN, x, y = NAN;
        done = rwedge_yield_point(limits->tip[i], 0, PAPER_NU, &limit, &x, &y) == RWEDGE_OK && done;
        xlsx_number(book, FIRST_ROW + i, NORMAL_COLUMN, limits->tip[i], XLSX_PLAIN);
        xlsx_number(book, FIRST_ROW + i, NORMAL_COLUMN + 1, workbook_rounded(limit), XLSX_FIXED_4);
        xlsx_number(book, FIRST_ROW + i, NORMAL_COLUMN + 2, workbook_rounded(y), XLSX_FIXED_4);
    }
    return done;
}

static void write_branch_headers(xlsx *book, const limit_table *limits)
{
    xlsx_text(book, HEADER_ROW - 1, TABLE_COLUMN, "The calculator's table", XLSX_HEADING);
    xlsx_text(book, HEADER_ROW - 1, SURFACE_COLUMN + 3, "P/(bk) at the surface, f across",
              XLSX_HEADING);
    xlsx_text(book, HEADER_ROW - 1, BELOW_COLUMN,
              "P/(bk) below the surface, f across; empty: no maximum there", XLSX_HEADING);
    xlsx_text(book, HEADER_ROW, TABLE_COLUMN, "a/b", XLSX_HEADER);
    xlsx_text(book, HEADER_ROW, TABLE_COLUMN + 1, "nu", XLSX_HEADER);
    for (int f = 0; f < FRICTIONS; f++) {
        xlsx_number(book, HEADER_ROW, SURFACE_COLUMN + f, limits->f[f], XLSX_HEADER);
        if (f < FRICTIONS_BELOW)
            xlsx_number(book, HEADER_ROW, BELOW_COLUMN + f, limits->f[f], XLSX_HEADER);
    }
}

static void write_branches(xlsx *book, const limit_table *limits)
{
    write_branch_headers(book, limits);
    for (int row = 0; row < TIPS * NUS; row++) {
        const int tip = row / NUS, nu = row % NUS;
        xlsx_number(book, FIRST_ROW + row, TABLE_COLUMN, limits->tip[tip], XLSX_PLAIN);
        xlsx_number(book, FIRST_ROW + row, TABLE_COLUMN + 1, limits->nu[nu], XLSX_PLAIN);
        for (int f = 0; f < FRICTIONS; f++)
            xlsx_number(book, FIRST_ROW + row, SURFACE_COLUMN + f, limits->surface[tip][nu][f],
                        XLSX_LIMIT);
        for (int f = 0; f < FRICTIONS_BELOW; f++)
            if (!isnan(limits->below[tip][nu][f]))
                xlsx_number(book, FIRST_ROW + row, BELOW_COLUMN + f, limits->below[tip][nu][f],
                            XLSX_FIXED_4);
    }
    xlsx_name_range(book, NAME_SURFACE, FIRST_ROW, SURFACE_COLUMN, TIPS * NUS, FRICTIONS);
    xlsx_name_range(book, NAME_BELOW, FIRST_ROW, BELOW_COLUMN, TIPS * NUS, FRICTIONS_BELOW);
}

bool sheet_elastic_limit(xlsx *book, const limit_table *limits)
{
    head(book, "Elastic limit P/(bk)",
         "Load at first yield (von Mises, plane strain) in full sliding, k the yield stress in "
         "pure shear. a/b = 1 holds for all a/b above 1. To the right: the two branches that the "
         "calculator interpolates.");
    xlsx_width(book, 0, BELOW_COLUMN + FRICTIONS_BELOW, 8);
    xlsx_width(book, NORMAL_COLUMN - 1, NORMAL_COLUMN - 1, 3);
    const bool done = write_grid(book) && write_normal_load(book, limits);
    write_branches(book, limits);
    xlsx_freeze(book, FIRST_ROW, 0);
    xlsx_print(book, (xlsx_page){FIRST_ROW + GRID_FRICTIONS - 1, NORMAL_COLUMN + 2, -1, false});
    return done;
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
    xlsx_print(book, (xlsx_page){FIRST_ROW + 100, 9, HEADER_ROW, false});
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
        for (int j = 0; j < 5; j++)
            xlsx_number(book, FIRST_ROW + i, j, workbook_rounded(row[j].number),
                        j == 0 ? XLSX_PLAIN : XLSX_FIXED_6);
    }
    xlsx_width(book, 0, 0, 8);
    xlsx_width(book, 1, 4, 15);
    xlsx_freeze(book, FIRST_ROW, 1);
    xlsx_print(book, (xlsx_page){FIRST_ROW + 199, 5, HEADER_ROW, false});
}

bool sheet_critical_friction(xlsx *book)
{
    bool done = true;
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
            done = done && isfinite(f);
            xlsx_number(book, FIRST_ROW + i, j + 1, workbook_rounded(f), XLSX_FIXED_4);
        }
    }
    xlsx_width(book, 0, 13, 8);
    xlsx_freeze(book, FIRST_ROW, 1);
    xlsx_print(book, (xlsx_page){FIRST_ROW + 99, 13, HEADER_ROW, false});
    return done;
}
