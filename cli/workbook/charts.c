/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "charts.h"

#include "formula.h"
#include "table_sheets.h"
#include "working.h"

#include <stdio.h>
#include <string.h>

enum { FIGURE_WIDTH = 400, FAMILY = 10 };

/* A column of a sheet, "='Working'!$A$1:$A$9". */
static const char *range_of(char text[], const char *sheet, int column, int first_row, int rows)
{
    char letters[4];
    column_letters(column, letters);
    return compose(text, "='%s'!$%s$%d:$%s$%d", sheet, letters, first_row + 1, letters,
                   first_row + rows);
}

typedef struct {
    char text[2 * XLSX_SERIES_MAX][60];
    int used;
} ranges;

static const char *store(ranges *kept, const char *sheet, int column, int first_row, int rows)
{
    char text[FORMULA_SIZE];
    char *place = kept->text[kept->used++];
    range_of(text, sheet, column, first_row, rows);
    snprintf(place, sizeof kept->text[0], "%.59s", text);
    return place;
}

static const char *curve(ranges *kept, int column, int rows)
{
    return store(kept, WORKING_SHEET, column, CURVE_ROW, rows);
}

static const char *mark(ranges *kept, int column)
{
    return curve(kept, column, 1);
}

static void place(xlsx_chart *chart, int which)
{
    chart->width = FIGURE_WIDTH;
    chart->height = 20 * FIGURE_ROWS;
    chart->right = which * (FIGURE_WIDTH + 8);
}

static void draw_normal_load(xlsx *book, int row)
{
    ranges kept = {.used = 0};
    const char *tips = "='Elastic limit'!$M$5:$M$104";
    xlsx_chart chart = {
        .title = "Fig. 3: elastic limit against a/b",
        .x_title = "a/b",
        .y_title = "P/(bk); y/b",
        .x_max = 1,
        .x_step = 0.2,
        .y_max = 7,
        .series = {{"P/(bk), f = 0, nu = 0.3", tips, "='Elastic limit'!$N$5:$N$104", XLSX_LINE},
                   {"its depth y/b", tips, "='Elastic limit'!$O$5:$O$104", XLSX_DASHED_LINE},
                   {"P/(bk), your f and nu1", curve(&kept, CURVE_TIP, TIPS),
                    curve(&kept, CURVE_TIP_LIMIT, TIPS), XLSX_THICK_LINE},
                   {"your case", mark(&kept, CURVE_MARK_TIP), mark(&kept, CURVE_MARK_LIMIT),
                    XLSX_MARK}},
        .series_count = 4,
    };
    place(&chart, 0);
    xlsx_draw(book, row, 0, &chart);
}

static void draw_friction(xlsx *book, int row)
{
    static const char *const names[FAMILY] = {"a/b = 1.0", "0.9", "0.8", "0.7", "0.6",
                                              "0.5",       "0.4", "0.3", "0.2", "0.1"};
    ranges kept = {.used = 0};
    xlsx_chart chart = {
        .title = "Fig. 4: elastic limit against friction (nu = 0.3)",
        .x_title = "f",
        .y_title = "P/(bk)",
        .x_max = 0.8,
        .x_step = 0.1,
        .y_max = 6,
        .series_count = FAMILY + 2,
    };
    const char *f = store(&kept, "Elastic limit", 0, 4, 65);
    for (int i = 0; i < FAMILY; i++)
        chart.series[i] =
            (xlsx_series){names[i], f, store(&kept, "Elastic limit", FAMILY - i, 4, 65), XLSX_LINE};
    chart.series[FAMILY] =
        (xlsx_series){"your a/b, nu1", curve(&kept, CURVE_FRICTION, FRICTIONS),
                      curve(&kept, CURVE_FRICTION_LIMIT, FRICTIONS), XLSX_THICK_LINE};
    chart.series[FAMILY + 1] = (xlsx_series){"your case", mark(&kept, CURVE_MARK_FRICTION),
                                             mark(&kept, CURVE_MARK_LIMIT), XLSX_MARK};
    place(&chart, 1);
    xlsx_draw(book, row, 0, &chart);
}

static void draw_tension(xlsx *book, int row)
{
    ranges kept = {.used = 0};
    xlsx_chart chart = {
        .title = "Fig. 6: maximum tension at the trailing edge",
        .x_title = "a/b",
        .y_title = "b sigma/(fP)",
        .x_max = 1,
        .x_step = 0.2,
        .y_min = 0.95,
        .y_max = 1.3,
        .series = {{"b sigma/(fP)", TENSION_TIPS, TENSION_VALUES, XLSX_LINE},
                   {"your case", mark(&kept, CURVE_MARK_TIP), mark(&kept, CURVE_MARK_TENSION),
                    XLSX_MARK}},
        .series_count = 2,
    };
    place(&chart, 2);
    xlsx_draw(book, row, 0, &chart);
}

void draw_figures(xlsx *book, int row)
{
    draw_normal_load(book, row);
    draw_friction(book, row);
    draw_tension(book, row);
}
