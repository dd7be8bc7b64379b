/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Figs. 3, 4 and 6 of the paper, beside the calculator. They also show the calculator's case. */
#include "charts.h"

#include "formula.h"
#include "table_sheets.h"
#include "working.h"

#include <stdio.h>
#include <string.h>

enum { CHART_WIDTH = 620, CHART_HEIGHT = 20 * CHART_ROWS - 10, FAMILY = 10 };

/* Ranges of the calculator's cells by row and column, "='Calculator'!$A$1:$A$9". */
static const char *range_of(char text[], const char *sheet, int column, int first_row, int rows)
{
    char letters[4] = "";
    if (column >= 26)
        snprintf(letters, sizeof letters, "%c%c", 'A' + column / 26 - 1, 'A' + column % 26);
    else
        snprintf(letters, sizeof letters, "%c", 'A' + column);
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

static const char *working(ranges *kept, int column, int rows)
{
    return store(kept, "Calculator", column, WORKING_ROW, rows);
}

/* The last four steps are the coordinates of the marks. */
static const char *mark(ranges *kept, int which)
{
    return store(kept, "Calculator", WORKING_COLUMN + 2, WORKING_ROW + WORKING_STEPS - 4 + which,
                 1);
}

static void draw_normal_load(xlsx *book, int row, int column)
{
    ranges kept = {.used = 0};
    const char *tips = "='Elastic limit'!$M$5:$M$65";
    const xlsx_chart chart = {
        .title = "Fig. 3: elastic limit against a/b",
        .x_title = "a/b",
        .y_title = "P/(bk); y/b",
        .x_max = 1,
        .x_step = 0.2,
        .y_max = 7,
        .width = CHART_WIDTH,
        .height = CHART_HEIGHT,
        .series = {{"P/(bk), f = 0, nu = 0.3", tips, "='Elastic limit'!$N$5:$N$65", XLSX_LINE},
                   {"its depth y/b", tips, "='Elastic limit'!$O$5:$O$65", XLSX_DASHED_LINE},
                   {"P/(bk), your f and nu1", working(&kept, TIPS_COLUMN, TIPS),
                    working(&kept, TIPS_COLUMN + 9, TIPS), XLSX_THICK_LINE},
                   {"your case", mark(&kept, 0), mark(&kept, 2), XLSX_MARK}},
        .series_count = 4,
    };
    xlsx_draw(book, row, column, &chart);
}

static void draw_friction(xlsx *book, int row, int column)
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
        .width = CHART_WIDTH,
        .height = CHART_HEIGHT,
        .series_count = FAMILY + 2,
    };
    const char *f = store(&kept, "Elastic limit", 0, 4, 65);
    for (int i = 0; i < FAMILY; i++)
        chart.series[i] =
            (xlsx_series){names[i], f, store(&kept, "Elastic limit", FAMILY - i, 4, 65), XLSX_LINE};
    chart.series[FAMILY] =
        (xlsx_series){"your a/b, nu1", working(&kept, FRICTIONS_COLUMN, FRICTIONS),
                      working(&kept, FRICTIONS_COLUMN + 7, FRICTIONS), XLSX_THICK_LINE};
    chart.series[FAMILY + 1] =
        (xlsx_series){"your case", mark(&kept, 1), mark(&kept, 2), XLSX_MARK};
    xlsx_draw(book, row, column, &chart);
}

static void draw_tension(xlsx *book, int row, int column)
{
    ranges kept = {.used = 0};
    const xlsx_chart chart = {
        .title = "Fig. 6: maximum tension at the trailing edge",
        .x_title = "a/b",
        .y_title = "b sigma/(fP)",
        .x_max = 1,
        .x_step = 0.2,
        .y_min = 0.95,
        .y_max = 1.3,
        .width = CHART_WIDTH,
        .height = CHART_HEIGHT,
        .series = {{"b sigma/(fP)", TENSION_TIPS, TENSION_VALUES, XLSX_LINE},
                   {"your case", mark(&kept, 0), mark(&kept, 3), XLSX_MARK}},
        .series_count = 2,
    };
    xlsx_draw(book, row, column, &chart);
}

void sheet_charts(xlsx *book, int row, int column)
{
    draw_normal_load(book, row, column);
    draw_friction(book, row + CHART_ROWS, column);
    draw_tension(book, row + 2 * CHART_ROWS, column);
}
