/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "workbook.h"

enum { FIGURE_WIDTH = 400, FAMILY = 10 };

/* A column of a sheet, "='Working'!$A$1:$A$9". */
static const char *range_of(const char *sheet, int column, int first_row, int rows)
{
    const char *letters = column_letters(column);
    return compose("='%s'!$%s$%d:$%s$%d", sheet, letters, first_row + 1, letters, first_row + rows);
}

static const char *curve(int column, int rows)
{
    return range_of(WORKING_SHEET, column, CURVE_ROW, rows);
}

static const char *mark(int column)
{
    return curve(column, 1);
}

static const char *legend(int place)
{
    return compose("='%s'!$%s$%d", WORKING_SHEET, column_letters(LEGEND_COLUMN),
                   CURVE_ROW + place + 1);
}

static void place(xlsx_chart *chart, int position)
{
    chart->width = FIGURE_WIDTH;
    chart->height = 20 * FIGURE_ROWS;
    chart->right = position * (FIGURE_WIDTH + 8);
}

static void draw_normal_load(xlsx *book, int row)
{
    const char *tips = "='Elastic limit'!$M$5:$M$104";
    xlsx_chart chart = {
        .title = "Fig. 3: elastic limit against a/b",
        .x_title = "a/b",
        .y_title = "P/(bk); y/b",
        .x_max = 1,
        .x_step = 0.2,
        .y_max = 7,
        .series = {{legend(LEGEND_NORMAL), tips, "='Elastic limit'!$N$5:$N$104", XLSX_LINE},
                   {legend(LEGEND_DEPTH), tips, "='Elastic limit'!$O$5:$O$104", XLSX_DASHED_LINE},
                   {legend(LEGEND_TIP_CURVE), curve(CURVE_TIP, TIPS), curve(CURVE_TIP_LIMIT, TIPS),
                    XLSX_THICK_LINE},
                   {legend(LEGEND_CASE), mark(CURVE_MARK_TIP), mark(CURVE_MARK_LIMIT), XLSX_MARK}},
        .series_count = 4,
    };
    place(&chart, 0);
    xlsx_draw(book, row, 0, &chart);
}

static void draw_friction(xlsx *book, int row)
{
    xlsx_chart chart = {
        .title = "Fig. 4: elastic limit against friction (nu = 0.3)",
        .x_title = "f",
        .y_title = "P/(bk)",
        .x_max = 0.8,
        .x_step = 0.1,
        .y_max = 6,
        .series_count = FAMILY + 2,
    };
    const char *f = range_of("Elastic limit", 0, 4, 65);
    for (int i = 0; i < FAMILY; i++)
        chart.series[i] = (xlsx_series){legend(LEGEND_FAMILY + i), f,
                                        range_of("Elastic limit", FAMILY - i, 4, 65), XLSX_LINE};
    chart.series[FAMILY] =
        (xlsx_series){legend(LEGEND_FRICTION_CURVE), curve(CURVE_FRICTION, FRICTIONS),
                      curve(CURVE_FRICTION_LIMIT, FRICTIONS), XLSX_THICK_LINE};
    chart.series[FAMILY + 1] = (xlsx_series){legend(LEGEND_CASE), mark(CURVE_MARK_FRICTION),
                                             mark(CURVE_MARK_LIMIT), XLSX_MARK};
    place(&chart, 1);
    xlsx_draw(book, row, 0, &chart);
}

static void draw_tension(xlsx *book, int row)
{
    xlsx_chart chart = {
        .title = "Fig. 6: maximum tension at the trailing edge",
        .x_title = "a/b",
        .y_title = "b sigma/(fP)",
        .x_max = 1,
        .x_step = 0.2,
        .y_min = 0.95,
        .y_max = 1.3,
        .series = {{legend(LEGEND_TENSION), TENSION_TIPS, TENSION_VALUES, XLSX_LINE},
                   {legend(LEGEND_CASE), mark(CURVE_MARK_TIP), mark(CURVE_MARK_TENSION),
                    XLSX_MARK}},
        .series_count = 2,
    };
    place(&chart, 2);
    xlsx_draw(book, row, 0, &chart);
}

void draw_sketch(xlsx *book, int row, int column)
{
    xlsx_chart chart = {
        .title = NULL,
        .x_min = -5,
        .x_max = 5,
        .x_step = 1,
        .y_min = -2.6,
        .y_max = 3.3,
        .width = 440,
        .height = 330,
        .right = 8,
        .bare = true,
        .series_count = SKETCH_PARTS,
    };
    for (int i = 0; i < SKETCH_PARTS; i++) {
        const int x = CURVES_END + 2 * i, points = sketch[i].points;
        chart.series[i] =
            (xlsx_series){points > 1 ? NULL : sketch[i].name, curve(x, points),
                          curve(x + 1, points), points > 1 ? XLSX_OUTLINE : XLSX_LABEL};
    }
    xlsx_draw(book, row, column, &chart);
}

/* Two points of the bar, at the heights of a column. */
static xlsx_series bar_part(int first, int heights, xlsx_drawing drawing)
{
    const int row = CURVE_ROW + first;
    return (xlsx_series){NULL, range_of(WORKING_SHEET, BAR_COLUMN, row, 2),
                         range_of(WORKING_SHEET, BAR_COLUMN + heights, row, 2), drawing};
}

void draw_bar(xlsx *book, int row, int column)
{
    const xlsx_chart chart = {
        .x_max = BAR_MOST,
        .x_step = 1,
        .x_format = "[=1]\"1: yields\";[=3]\"3 and more\";0",
        .y_min = -0.6,
        .y_max = 0.6,
        .width = 800,
        .height = 58,
        .right = 4,
        .down = 1,
        .bare = true,
        .series = {bar_part(BAR_FROM_FACTOR, 3, XLSX_BAR_GROUND),
                   bar_part(BAR_FROM_0, 1, XLSX_BAR_GOOD), bar_part(BAR_FROM_0, 2, XLSX_BAR_BAD),
                   bar_part(BAR_LIMIT, 3, XLSX_OUTLINE)},
        .series_count = 4,
    };
    xlsx_draw(book, row, column, &chart);
}

void draw_figures(xlsx *book, int row)
{
    draw_normal_load(book, row);
    draw_friction(book, row);
    draw_tension(book, row);
}
