/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "parts.h"

#include <stdio.h>

/* Curves of a family differ in dashes as well as in shade: they stay apart in print and for
 * every eye. */
static lxw_chart_line line_of_family(int index)
{
    static const lxw_color_t shades[] = {LXW_COLOR_BLACK, 0x0072B2, 0x009E73, 0xD55E00, 0x8A5A83};
    static const uint8_t dashes[] = {LXW_CHART_LINE_DASH_SOLID, LXW_CHART_LINE_DASH_DASH};
    return (lxw_chart_line){
        .color = shades[index % 5], .width = 1.25F, .dash_type = dashes[(index / 5) % 2]};
}

static void draw_line(lxw_chart_series *series, int index, xlsx_drawing drawing)
{
    static const lxw_chart_line lines[] = {
        [XLSX_THICK_LINE] = {.color = 0xE69F00, .width = 3},
        [XLSX_DASHED_LINE] = {.color = 0x707070,
                              .width = 1.5F,
                              .dash_type = LXW_CHART_LINE_DASH_DASH},
        [XLSX_MARK] = {.none = LXW_TRUE},
        [XLSX_OUTLINE] = {.color = LXW_COLOR_BLACK, .width = 1.5F},
        [XLSX_BAR_GROUND] = {.color = 0xE0E0E0, .width = 14},
        [XLSX_BAR_GOOD] = {.color = 0x2E8B57, .width = 14},
        [XLSX_BAR_BAD] = {.color = 0xC0392B, .width = 14},
        [XLSX_LABEL] = {.none = LXW_TRUE},
    };
    lxw_chart_line line = drawing == XLSX_LINE ? line_of_family(index) : lines[drawing];
    chart_series_set_line(series, &line);
}

static void draw_mark(lxw_chart_series *series, xlsx_drawing drawing)
{
    if (drawing != XLSX_MARK) {
        chart_series_set_marker_type(series, LXW_CHART_MARKER_NONE);
        return;
    }
    lxw_chart_fill fill = {.color = 0xD00000};
    chart_series_set_marker_type(series, LXW_CHART_MARKER_DIAMOND);
    chart_series_set_marker_size(series, 11);
    chart_series_set_marker_fill(series, &fill);
}

static void draw_series(xlsx *book, lxw_chart *drawn, const xlsx_series *from, int index)
{
    lxw_chart_series *series = chart_add_series(drawn, from->x, from->y);
    if (from->name != NULL && from->drawing != XLSX_LABEL)
        chart_series_set_name(series, from->name);
    draw_line(series, index, from->drawing);
    draw_mark(series, from->drawing);
    if (from->drawing == XLSX_LABEL) {
        lxw_chart_font font = {.size = 10};
        char name[60];
        snprintf(name, sizeof name, "%s", from->name);
        lxw_chart_data_label text = {.value = name}, *texts[] = {&text, NULL};
        chart_series_set_labels(series);
        chart_series_set_labels_position(series, LXW_CHART_LABEL_POSITION_CENTER);
        chart_series_set_labels_font(series, &font);
        xlsx_keep(book, chart_series_set_labels_custom(series, texts));
    }
}

static void draw_axes(lxw_chart *drawn, const xlsx_chart *chart)
{
    lxw_chart_font font = {.size = 10, .bold = LXW_FALSE};
    lxw_chart_line grid = {.color = 0xE0E0E0, .width = 0.5F};
    if (chart->x_title != NULL) {
        chart_axis_set_name(drawn->x_axis, chart->x_title);
        chart_axis_set_name(drawn->y_axis, chart->y_title);
        chart_axis_set_name_font(drawn->x_axis, &font);
        chart_axis_set_name_font(drawn->y_axis, &font);
    }
    chart_axis_set_min(drawn->x_axis, chart->x_min);
    chart_axis_set_max(drawn->x_axis, chart->x_max);
    chart_axis_set_major_unit(drawn->x_axis, chart->x_step);
    chart_axis_set_min(drawn->y_axis, chart->y_min);
    chart_axis_set_max(drawn->y_axis, chart->y_max);
    chart_axis_set_num_format(drawn->x_axis, chart->x_format != NULL ? chart->x_format : "0.0");
    chart_axis_set_num_format(drawn->y_axis, "General");
    if (chart->bare) {
        if (chart->x_format == NULL)
            chart_axis_off(drawn->x_axis);
        chart_axis_major_gridlines_set_visible(drawn->x_axis, LXW_FALSE);
        chart_axis_off(drawn->y_axis);
        chart_axis_major_gridlines_set_visible(drawn->y_axis, LXW_FALSE);
        return;
    }
    chart_axis_major_gridlines_set_visible(drawn->x_axis, LXW_TRUE);
    chart_axis_major_gridlines_set_line(drawn->x_axis, &grid);
    chart_axis_major_gridlines_set_line(drawn->y_axis, &grid);
}

void xlsx_draw(xlsx *book, int row, int column, const xlsx_chart *chart)
{
    lxw_chart *drawn = workbook_add_chart(book->workbook, LXW_CHART_SCATTER_STRAIGHT);
    if (drawn == NULL) {
        xlsx_keep(book, LXW_ERROR_MEMORY_MALLOC_FAILED);
        return;
    }
    lxw_chart_font font = {.size = 11, .bold = LXW_TRUE}, small = {.size = 8};
    for (int i = 0; i < chart->series_count; i++)
        draw_series(book, drawn, &chart->series[i], i);
    draw_axes(drawn, chart);
    if (chart->title != NULL) {
        chart_title_set_name(drawn, chart->title);
        chart_title_set_name_font(drawn, &font);
    } else
        chart_title_off(drawn);
    chart_legend_set_position(drawn, chart->bare ? LXW_CHART_LEGEND_NONE : LXW_CHART_LEGEND_BOTTOM);
    chart_legend_set_font(drawn, &small);
    lxw_chart_options place = {.x_scale = chart->width / 480.0,
                               .y_scale = chart->height / 288.0,
                               .x_offset = chart->right,
                               .y_offset = chart->down};
    xlsx_keep(book, worksheet_insert_chart_opt(book->current, (lxw_row_t)row, (lxw_col_t)column,
                                               drawn, &place));
}
