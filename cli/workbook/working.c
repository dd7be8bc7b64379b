/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The names of this sheet begin with rwt_, and are hidden. */
#include "workbook.h"

#include <math.h>

#include <rwedge.h>

enum { LABEL_ROW = 2, NAME_ROW, VALUE_ROW };
enum { NODE_NU, NODE_M, NODE_F, NODE_T, NODE_END };
enum {
    SURFACE_ROW = CURVE_ROW + TIPS + 3,
    BELOW_ROW = SURFACE_ROW + TIPS + 2,
    PLACE_ROW = BELOW_ROW + TIPS + 2
};

/* ---- The calculator's cells ------------------------------------------------------------------ */

static int column_of(int cell)
{
    return cell - FIRST_REMARK;
}

static void write_case(xlsx *book, const case_values *values)
{
    for (int cell = FIRST_REMARK; cell < case_cell_count; cell++) {
        xlsx_text(book, LABEL_ROW, column_of(cell), case_cells[cell].label, XLSX_NOTE);
        xlsx_text(book, NAME_ROW, column_of(cell), case_cells[cell].name, XLSX_NOTE);
        named_cell(book, VALUE_ROW, column_of(cell), cell, values, XLSX_PLAIN);
    }
    name_triples(book, VALUE_ROW, column_of);
}

/* ---- Nodes and tables ------------------------------------------------------------------------ */

static void write_list(xlsx *book, int column, const char *name, const double *value, int count)
{
    xlsx_text(book, CURVE_ROW - 1, column, name, XLSX_NOTE);
    xlsx_name_range(book, name, CURVE_ROW, column, count, 1);
    for (int i = 0; i < count; i++)
        xlsx_number(book, CURVE_ROW + i, column, value[i], XLSX_PLAIN);
}

static void write_nodes(xlsx *book, const yield_table *table)
{
    double m[NUS];
    const double end = workbook_end_of_table();
    for (int i = 0; i < NUS; i++)
        m[i] = (1 - 2 * table->nu[i]) * (1 - 2 * table->nu[i]) / 3;
    write_list(book, NODE_NU, "rwt_nu", table->nu, NUS);
    write_list(book, NODE_M, "rwt_ms", m, NUS);
    write_list(book, NODE_F, "rwt_f", table->f, FRICTIONS);
    write_list(book, NODE_T, "rwt_ts", table->t, TIPS);
    write_list(book, NODE_END, "rwt_end", &end, 1);
    for (int i = 0; i < 3; i++)
        xlsx_number(book, CURVE_ROW + 2, NODE_END + i, 1, XLSX_PLAIN);
    xlsx_name_range(book, "rwt_ones", CURVE_ROW + 2, NODE_END, 1, 3);
}

static void write_table(xlsx *book, int row, int tips, const double values[][NUS][FRICTIONS])
{
    for (int i = 0; i < tips; i++)
        for (int j = 0; j < NUS; j++)
            for (int k = 0; k < FRICTIONS; k++)
                if (values[i][j][k] != 0)
                    xlsx_number(book, row + i, j * FRICTIONS + k, values[i][j][k], XLSX_PLAIN);
}

static void write_branch(xlsx *book, int row, const char *name, const char *title,
                         const double values[TIPS][NUS][FRICTIONS])
{
    xlsx_text(book, row - 1, 0, title, XLSX_NOTE);
    write_table(book, row, TIPS, values);
    xlsx_name_range(book, name, row, 0, TIPS, TABLE_COLUMNS);
}

static void write_places(xlsx *book, const yield_table *table)
{
    xlsx_text(book, PLACE_ROW - 1, 0,
              "the place, every other t: x/(a f) on the surface; x/(a f), then y/a, below it",
              XLSX_NOTE);
    for (int i = 0; i < PLACES; i++)
        write_table(book, PLACE_ROW + i * PLACE_TIPS, PLACE_TIPS, table->place[i]);
    xlsx_name_range(book, "rwt_place", PLACE_ROW, 0, PLACES * PLACE_TIPS, TABLE_COLUMNS);
}

/* ---- Curves of the charts -------------------------------------------------------------------- */

static void write_column(xlsx *book, int column, const char *formula, int count,
                         const double limit[])
{
    for (int i = 0; i < count; i++)
        formula_cell(book, CURVE_ROW + i, column, formula_at(formula, i + 1), limit[i], XLSX_PLAIN);
}

/* The elastic limit over a/b, and over f. */
static void write_limits(xlsx *book, const yield_table *table, const case_values *values)
{
    const double f = shown_number(values, "f"), nu = shown_number(values, "nu1"),
                 tip = shown_number(values, "a_over_b");
    double at_tip[TIPS], at_friction[FRICTIONS];
    for (int i = 0; i < TIPS; i++)
        at_tip[i] = rwedge_elastic_limit(1 / cosh(table->t[i]), f, nu);
    for (int i = 0; i < FRICTIONS; i++)
        at_friction[i] = rwedge_elastic_limit(tip, table->f[i], nu);
    write_column(book, CURVE_TIP_LIMIT, "limit_at_tip()", TIPS, at_tip);
    write_column(book, CURVE_FRICTION_LIMIT, "limit_at_friction()", FRICTIONS, at_friction);
}

/* The charts leave out what is #N/A. */
static void write_marks(xlsx *book, const case_values *values)
{
    const double tip = shown_number(values, "a_over_b");
    formula_cell(book, CURVE_ROW, CURVE_MARK_TIP, "=IF(rwt_ok=1,rwt_n5,0)", fmin(tip, 1),
                 XLSX_PLAIN);
    formula_cell(book, CURVE_ROW, CURVE_MARK_FRICTION, "=rwt_fr", shown_number(values, "f"),
                 XLSX_PLAIN);
    formula_cell(book, CURVE_ROW, CURVE_MARK_LIMIT, "=IF(ISNUMBER(rw_P_over_bk),rw_P_over_bk,NA())",
                 shown_number(values, "P_over_bk"), XLSX_PLAIN);
    formula_cell(book, CURVE_ROW, CURVE_MARK_TENSION,
                 "=IF(rwt_ok=1,2*rwt_n5/(ASIN(rwt_n5)+rwt_n5*rwt_cos),NA())",
                 rwedge_max_tension(tip), XLSX_PLAIN);
}

static void write_curves(xlsx *book, const yield_table *table, const case_values *values)
{
    static const char *const header[] = {"a/b", "P/(bk)", "f",      "P/(bk)",
                                         "a/b", "f",      "P/(bk)", "b sigma/(fP)"};
    for (int i = CURVE_TIP; i < CURVES_END; i++)
        xlsx_text(book, CURVE_ROW - 1, i, header[i - CURVE_TIP], XLSX_NOTE);
    for (int i = 0; i < TIPS; i++)
        xlsx_number(book, CURVE_ROW + i, CURVE_TIP, workbook_rounded(1 / cosh(table->t[i])),
                    XLSX_PLAIN);
    xlsx_name_range(book, "rwt_tips", CURVE_ROW, CURVE_TIP, TIPS, 1);
    for (int i = 0; i < FRICTIONS; i++)
        xlsx_number(book, CURVE_ROW + i, CURVE_FRICTION, table->f[i], XLSX_PLAIN);
    write_limits(book, table, values);
    write_marks(book, values);
}

/* ---- The sketch ------------------------------------------------------------------------------ */

/* Lines, one after another, and letters where they stand: x, y in units of the picture. */
const sketch_part sketch[SKETCH_PARTS] = {
    {"half-plane", 2, {-5, 5}, {0, 0}},
    {"wedge",
     9,
     {-4.6, -1, -0.75, -0.5, 0, 0.5, 0.75, 1, 4.6},
     {1.74, 0.3, 0.209, 0.145, 0.11, 0.145, 0.209, 0.3, 1.74}},
    {"top", 2, {-4.6, 4.6}, {1.74, 1.74}},
    {"angle", 5, {3.6, 3.58, 3.5, 3.4, 3.28}, {0.0, 0.35, 0.7, 0.98, 1.2}},
    {"a", 4, {0, 0, 1, 1}, {-0.55, -0.45, -0.45, 0.3}},
    {"b", 4, {0, 0, 1.9, 1.9}, {-1.2, -1.1, -1.1, 0}},
    {"P", 5, {0, 0, -0.16, 0, 0.16}, {3.1, 2.0, 2.25, 2.0, 2.25}},
    {"Q", 5, {-1.9, -0.5, -0.75, -0.5, -0.75}, {-1.9, -1.9, -1.8, -1.9, -2.0}},
    {"tension", 5, {-1.9, -2.9, -2.65, -2.9, -2.65}, {-0.4, -0.4, -0.3, -0.4, -0.5}},
    {"theta", 1, {4.05}, {0.62}},
    {"a", 1, {0.5}, {-0.68}},
    {"b", 1, {0.95}, {-1.33}},
    {"P", 1, {0.35}, {2.75}},
    {"Q (f)", 1, {-0.05}, {-1.9}},
    {"R = a/theta", 1, {0}, {0.75}},
    {"2: wedge, E2, nu2", 1, {0}, {1.4}},
    {"1: half-plane, E1, nu1, k", 1, {2.9}, {-2.35}},
    {"tension, x = -b", 1, {-3.3}, {-0.75}},
};

static void write_sketch(xlsx *book)
{
    for (int i = 0; i < SKETCH_PARTS; i++) {
        xlsx_text(book, CURVE_ROW - 1, CURVES_END + 2 * i, sketch[i].name, XLSX_NOTE);
        for (int j = 0; j < sketch[i].points; j++) {
            xlsx_number(book, CURVE_ROW + j, CURVES_END + 2 * i, sketch[i].x[j], XLSX_PLAIN);
            xlsx_number(book, CURVE_ROW + j, CURVES_END + 2 * i + 1, sketch[i].y[j], XLSX_PLAIN);
        }
    }
}

/* From 0 to the factor, and from there to the end; then the line at 1. One column of heights is for
 * a factor that is good, one for a bad one: what is not to be seen is above the picture. */
static void write_bar(xlsx *book, const case_values *values)
{
    static const char *const height[] = {"=IF(rwt_factor<1,9,0)", "=IF(rwt_factor<1,0,9)"};
    static const double place[] = {0, NAN, BAR_MOST, 1, 1}, of_limit[] = {0, 0, 0, -0.45, 0.45};
    const double factor = fmin(BAR_MOST, shown_number(values, "safety"));
    for (int i = 0; i < 5; i++) {
        xlsx_number(book, CURVE_ROW + i, BAR_COLUMN, place[i], XLSX_PLAIN);
        xlsx_number(book, CURVE_ROW + i, BAR_COLUMN + 3, of_limit[i], XLSX_PLAIN);
    }
    formula_cell(book, CURVE_ROW + BAR_FROM_FACTOR, BAR_COLUMN,
                 "=IF(rw_safety=\"\",0,IF(ISNUMBER(rw_safety),MIN(3,rw_safety),3))", factor,
                 XLSX_PLAIN);
    xlsx_name(book, "rwt_factor", CURVE_ROW + BAR_FROM_FACTOR, BAR_COLUMN);
    for (int i = 0; i < 2; i++)
        for (int j = 0; j < 2; j++)
            formula_cell(book, CURVE_ROW + j, BAR_COLUMN + 1 + i, height[i],
                         (i == 0) == (factor < 1) ? 9 : 0, XLSX_PLAIN);
}

static void write_legend(xlsx *book)
{
    static const char *const legend[LEGEND_FAMILY] = {
        [LEGEND_NORMAL] = "P/(bk), f = 0, nu = 0.3",   [LEGEND_DEPTH] = "its depth y/b",
        [LEGEND_TIP_CURVE] = "P/(bk), your f and nu1", [LEGEND_CASE] = "your case",
        [LEGEND_FRICTION_CURVE] = "your a/b, nu1",     [LEGEND_TENSION] = "b sigma/(fP)"};
    for (int i = 0; i < LEGEND_END; i++)
        xlsx_text(book, CURVE_ROW + i, LEGEND_COLUMN,
                  i < LEGEND_FAMILY ? legend[i]
                                    : compose("%s%.1f", i == LEGEND_FAMILY ? "a/b = " : "",
                                              (LEGEND_END - i) / 10.0),
                  XLSX_NOTE);
}

void sheet_working(xlsx *book, const yield_table *table, const case_values *values)
{
    xlsx_text(book, 0, 0, "Working cells: please do not edit", XLSX_HEADING);
    write_case(book, values);
    write_nodes(book, table);
    write_curves(book, table, values);
    write_sketch(book);
    write_bar(book, values);
    write_legend(book);
    write_branch(book, SURFACE_ROW, "rwt_surface",
                 "(A sqrt(J2)/theta)^2 on the surface: a row for each t, 16 blocks of nu, f across",
                 table->surface);
    write_branch(book, BELOW_ROW, "rwt_below", "the same below the surface; empty: none there",
                 table->below);
    write_places(book, table);
}
