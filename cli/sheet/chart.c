/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "parts.h"

#include <string.h>

/* Curves of a family differ in dashes as well as in shade: they stay apart in print and for
 * every eye. */
static lxw_chart_line line_of_family(int index)
{
    static const lxw_color_t shades[] = {LXW_COLOR_BLACK, 0x0072B2, 0x009E73, 0xD55E00, 0x8A5A83};
    static const uint8_t dashes[] = {LXW_CHART_LINE_DASH_SOLID, LXW_CHART_LINE_DASH_DASH};
    return (lxw_chart_line){
        .color = shades[index % 5], .width = 1.25F, .dash_type = dashes[(index / 5) % 2]};
}

static const struct {
    const char *name;
    lxw_chart_line line;
} drawings[] = {
    {"line", {0}}, /* of a family */
    {"thick", {.color = 0xE69F00, .width = 3}},
    {"dashed", {.color = 0x707070, .width = 1.5F, .dash_type = LXW_CHART_LINE_DASH_DASH}},
    {"outline", {.color = LXW_COLOR_BLACK, .width = 1.5F}},
    {"bar_ground", {.color = 0xE0E0E0, .width = 14}},
    {"bar_good", {.color = 0x2E8B57, .width = 14}},
    {"bar_bad", {.color = 0xC0392B, .width = 14}},
    {"mark", {.none = LXW_TRUE}},
    {"label", {.none = LXW_TRUE}},
};

static void draw_label(xlsx *book, lxw_chart_series *curve, const char *text)
{
    lxw_chart_font font = {.size = 10};
    lxw_chart_data_label label = {.value = (char *)text}, *labels[] = {&label, NULL};
    chart_series_set_labels(curve);
    chart_series_set_labels_position(curve, LXW_CHART_LABEL_POSITION_CENTER);
    chart_series_set_labels_font(curve, &font);
    xlsx_keep(book, chart_series_set_labels_custom(curve, labels));
}

void xlsx_curve(xlsx *book, const char *const text[])
{
    enum { DRAWING, NAME, X, Y };
    const xlsx_area corner = book->chart_cell;
    lxw_chart_fill mark = {.color = 0xD00000};
    if (book->chart == NULL) /* for lack of memory, which is noted */
        return;
    int kind = 0;
    while (strcmp(drawings[kind].name, text[DRAWING]) != 0)
        kind++;
    const bool is_label = strcmp(text[DRAWING], "label") == 0;
    lxw_chart_series *curve = chart_add_series(book->chart, text[X], text[Y]);
    lxw_chart_line line = kind == 0 ? line_of_family(book->curves) : drawings[kind].line;
    if (book->curves++ == 0) /* the library takes no chart without a curve */
        xlsx_keep(book,
                  worksheet_insert_chart_opt(book->current, CELL_AT(corner.row, corner.column),
                                             book->chart, &book->chart_place));
    if (text[NAME][0] != '\0' && !is_label)
        chart_series_set_name(curve, text[NAME]);
    chart_series_set_line(curve, &line);
    chart_series_set_marker_type(curve, LXW_CHART_MARKER_NONE);
    if (strcmp(text[DRAWING], "mark") == 0) {
        chart_series_set_marker_type(curve, LXW_CHART_MARKER_DIAMOND);
        chart_series_set_marker_size(curve, 11);
        chart_series_set_marker_fill(curve, &mark);
    }
    if (is_label)
        draw_label(book, curve, text[NAME]);
}

/* Its numbers show where it has a title or a format. */
static void draw_axis(lxw_chart_axis *axis, const char *numbers, const char *title,
                      const char *format, const char *usual_format)
{
    lxw_chart_font font = {.size = 10, .bold = LXW_FALSE};
    lxw_chart_line grid = {.color = 0xE0E0E0, .width = 0.5F};
    double value[3] = {0};
    number_read_list(numbers, strlen(numbers), ':', 3, value);
    if (title[0] != '\0') {
        chart_axis_set_name(axis, title);
        chart_axis_set_name_font(axis, &font);
    }
    chart_axis_set_min(axis, value[0]);
    chart_axis_set_max(axis, value[1]);
    if (value[2] > 0)
        chart_axis_set_major_unit(axis, value[2]);
    chart_axis_set_num_format(axis, format[0] != '\0' ? format : usual_format);
    chart_axis_major_gridlines_set_visible(axis, title[0] != '\0');
    if (title[0] != '\0')
        chart_axis_major_gridlines_set_line(axis, &grid);
    else if (format[0] == '\0')
        chart_axis_off(axis);
}

static void draw_title(lxw_chart *chart, const char *title)
{
    lxw_chart_font font = {.size = 11, .bold = LXW_TRUE}, small = {.size = 8};
    if (title[0] != '\0') {
        chart_title_set_name(chart, title);
        chart_title_set_name_font(chart, &font);
    } else
        chart_title_off(chart);
    chart_legend_set_position(chart,
                              title[0] != '\0' ? LXW_CHART_LEGEND_BOTTOM : LXW_CHART_LEGEND_NONE);
    chart_legend_set_font(chart, &small);
}

void xlsx_chart(xlsx *book, xlsx_area at, const char *const text[])
{
    enum { PIXELS = 1, TITLE, X, Y, X_TITLE, Y_TITLE, X_FORMAT };
    double pixel[4] = {0};
    lxw_chart *drawn = workbook_add_chart(book->workbook, LXW_CHART_SCATTER_STRAIGHT);
    book->chart = drawn;
    if (drawn == NULL) {
        xlsx_keep(book, LXW_ERROR_MEMORY_MALLOC_FAILED);
        return;
    }
    number_read_list(text[PIXELS], strlen(text[PIXELS]), ',', 4, pixel);
    book->curves = 0;
    book->chart_cell = at;
    book->chart_place = (lxw_chart_options){.x_scale = pixel[0] / 480,
                                            .y_scale = pixel[1] / 288,
                                            .x_offset = (int32_t)pixel[2],
                                            .y_offset = (int32_t)pixel[3]};
    draw_axis(drawn->x_axis, text[X], text[X_TITLE], text[X_FORMAT], "0.0");
    draw_axis(drawn->y_axis, text[Y], text[Y_TITLE], "", "General");
    draw_title(drawn, text[TITLE]);
}
