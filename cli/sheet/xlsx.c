/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "xlsx.h"

#include "system/streams.h"
#include "text/number.h"
#include "text/utf8.h"

#include <errno.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include <rwedge.h>
#include <xlsxwriter.h>

enum { SHEETS_MAX = 12, NAME_MAX_LENGTH = 40 };

struct xlsx {
    lxw_workbook *workbook;
    lxw_worksheet *sheet[SHEETS_MAX], *current;
    char sheet_name[SHEETS_MAX][NAME_MAX_LENGTH];
    int sheet_count, current_index;
    lxw_format *style[XLSX_STYLE_COUNT], *colour[XLSX_COLOUR_COUNT];
    /* libxlsxwriter writes to a path, and seeks in the file. So it first writes a temporary
     * file. */
    spool spool;
    lxw_error error;
};

const char *xlsx_missing(void)
{
    return NULL;
}

/* Where memory is short, or its temporary folder is full, the library leaves things out. Not all of
 * its functions say so, but errno is set. */
static void keep(xlsx *book, lxw_error error)
{
    if (error == LXW_NO_ERROR &&
        (errno == ENOMEM || errno == ENOSPC || errno == EIO || errno == EINTR || errno == EFBIG))
        error = errno == ENOMEM ? LXW_ERROR_MEMORY_MALLOC_FAILED : LXW_ERROR_CREATING_TMPFILE;
    if (book->error == LXW_NO_ERROR)
        book->error = error;
}

static lxw_row_t row_of(int row)
{
    return (lxw_row_t)row;
}

static lxw_col_t column_of(int column)
{
    return (lxw_col_t)column;
}

/* ---- Styles ---------------------------------------------------------------------------------- */

static void frame(lxw_format *style, lxw_color_t background)
{
    format_set_border(style, LXW_BORDER_THIN);
    format_set_border_color(style, 0x808080);
    format_set_bg_color(style, background);
}

static void style_texts(lxw_format *const style[])
{
    format_set_bold(style[XLSX_TITLE]);
    format_set_font_size(style[XLSX_TITLE], 16);
    format_set_bold(style[XLSX_HEADING]);
    format_set_font_size(style[XLSX_HEADING], 12);
    format_set_bold(style[XLSX_HEADER]);
    format_set_bottom(style[XLSX_HEADER], LXW_BORDER_THIN);
    format_set_text_wrap(style[XLSX_HEADER]);
    format_set_align(style[XLSX_HEADER], LXW_ALIGN_RIGHT);
    format_set_align(style[XLSX_HEADER], LXW_ALIGN_VERTICAL_BOTTOM);
    format_set_font_size(style[XLSX_NOTE], 9);
    format_set_font_color(style[XLSX_NOTE], 0x505050);
    format_set_text_wrap(style[XLSX_WRAPPED]);
    format_set_align(style[XLSX_WRAPPED], LXW_ALIGN_VERTICAL_TOP);
    format_set_font_color(style[XLSX_CHECK], 0xB00000);
}

/* Four to six digits; zero is 0. LibreOffice writes no minus in such parts. */
#define RESULT_FORMAT "[=0]0;[<0.001]0.0000E+00;0.00###"

static void style_cells(lxw_format *const style[])
{
    frame(style[XLSX_INPUT], 0xFFF8D0);
    format_set_unlocked(style[XLSX_INPUT]);
    format_set_align(style[XLSX_INPUT], LXW_ALIGN_RIGHT);
    frame(style[XLSX_RESULT], 0xE8F0F8);
    format_set_num_format(style[XLSX_RESULT], RESULT_FORMAT);
    format_set_align(style[XLSX_RESULT], LXW_ALIGN_RIGHT);
    frame(style[XLSX_SIGNED], 0xE8F0F8);
    format_set_align(style[XLSX_SIGNED], LXW_ALIGN_RIGHT);
    frame(style[XLSX_STRONG], 0xE8F0F8);
    format_set_num_format(style[XLSX_STRONG], "0.00");
    format_set_align(style[XLSX_STRONG], LXW_ALIGN_RIGHT);
    format_set_bold(style[XLSX_STRONG]);
    format_set_font_size(style[XLSX_STRONG], 14);
    frame(style[XLSX_VERDICT], 0xFFFFFF);
    format_set_bold(style[XLSX_VERDICT]);
    format_set_text_wrap(style[XLSX_VERDICT]);
    format_set_align(style[XLSX_VERDICT], LXW_ALIGN_VERTICAL_CENTER);
    format_set_bold(style[XLSX_STATUS]);
    format_set_indent(style[XLSX_UNIT], 1);
    format_set_num_format(style[XLSX_NUMBER], "0.0#####");
    format_set_num_format(style[XLSX_SMALL], "0.0#######");
    format_set_num_format(style[XLSX_LARGE], "0.0##");
    format_set_num_format(style[XLSX_FIXED_4], "0.0000");
    format_set_num_format(style[XLSX_FIXED_6], "0.000000");
    format_set_num_format(style[XLSX_LIMIT], "[>=1000000]\"infinite\";0.0000");
    format_set_align(style[XLSX_LIMIT], LXW_ALIGN_RIGHT);
    format_set_num_format(style[XLSX_POWER], "0.00000E+00");
}

static bool make_colours(xlsx *book)
{
    static const lxw_color_t shade[] = {0xC6EFCE, 0xFFEB9C, 0xFFC7CE},
                             text[] = {0x006100, 0x7F4F00, 0x9C0006};
    for (int i = 0; i < XLSX_COLOUR_COUNT; i++) {
        book->colour[i] = workbook_add_format(book->workbook);
        if (book->colour[i] == NULL)
            return false;
        format_set_bg_color(book->colour[i], shade[i]);
        format_set_font_color(book->colour[i], text[i]);
    }
    return true;
}

static bool make_styles(xlsx *book)
{
    for (int i = 1; i < XLSX_STYLE_COUNT; i++) {
        book->style[i] = workbook_add_format(book->workbook);
        if (book->style[i] == NULL)
            return false;
    }
    style_texts(book->style);
    style_cells(book->style);
    return make_colours(book);
}

/* ---- The file -------------------------------------------------------------------------------- */

/* The same file again for the same command: a date that SOURCE_DATE_EPOCH sets, as it does for
 * other tools, or a fixed one, never the clock's. */
static bool creation_date(time_t *date)
{
    static const time_t fixed = 1767225600; /* 2026-01-01 */
    const char *text = getenv("SOURCE_DATE_EPOCH");
    int64_t seconds = fixed;
    const bool sound = text == NULL || text[0] == '\0' ||
                       number_read_whole(text, 0, INT64_C(253402300799), &seconds);
    *date = seconds != 0 ? (time_t)seconds : fixed; /* 0 is the clock for the library */
    return sound && (*date == seconds || seconds == 0);
}

static void set_properties(xlsx *book, const char *title, time_t date)
{
    char heading[120], version[] = "rwedge " RWEDGE_VERSION;
    snprintf(heading, sizeof heading, "%s", title);
    lxw_doc_properties properties = {.title = heading, .author = version, .created = date};
    keep(book, workbook_set_properties(book->workbook, &properties));
}

static bool open_workbook(xlsx *book, bool in_order)
{
    if (!spool_begin(&book->spool))
        return false;
    lxw_workbook_options options = {.constant_memory = in_order};
    book->workbook = workbook_new_opt(book->spool.name, &options);
    return book->workbook != NULL && make_styles(book);
}

static void release(xlsx *book)
{
    spool_end(&book->spool);
    free(book);
}

xlsx *xlsx_begin(const char *title, bool in_order, const char **problem)
{
    time_t date;
    *problem =
        "the variable SOURCE_DATE_EPOCH: must be a whole number of seconds, 0 to 253402300799, "
        "the end of the year 9999";
    if (!creation_date(&date))
        return NULL;
    *problem = "a temporary file for the spreadsheet cannot be made";
    errno = 0;
    xlsx *book = calloc(1, sizeof *book);
    if (book != NULL && open_workbook(book, in_order)) {
        *problem = NULL;
        set_properties(book, title, date);
        return book;
    }
    if (book != NULL)
        release(book);
    return NULL;
}

void xlsx_sheet(xlsx *book, const char *name)
{
    lxw_worksheet *sheet =
        book->sheet_count < SHEETS_MAX ? workbook_add_worksheet(book->workbook, name) : NULL;
    if (sheet == NULL) {
        keep(book, LXW_ERROR_MEMORY_MALLOC_FAILED);
        return;
    }
    snprintf(book->sheet_name[book->sheet_count], NAME_MAX_LENGTH, "%s", name);
    book->sheet[book->sheet_count] = sheet;
    xlsx_turn_to(book, book->sheet_count++);
    worksheet_set_paper(sheet, 9); /* A4 */
}

void xlsx_turn_to(xlsx *book, int sheet)
{
    book->current = book->sheet[sheet];
    book->current_index = sheet;
}

static bool copy(FILE *from, output *out)
{
    char buffer[1 << 14];
    if (from == NULL)
        return false;
    for (size_t count; (count = fread(buffer, 1, sizeof buffer, from)) > 0;)
        output_write(out, buffer, count);
    return !ferror(from);
}

const char *xlsx_finish(xlsx *book, output *out)
{
    errno = 0;
    keep(book, workbook_close(book->workbook));
    const char *problem = book->error != LXW_NO_ERROR ? lxw_strerror(book->error) : NULL;
    if (problem == NULL && !copy(spool_read(&book->spool), out))
        problem = strerror(errno);
    release(book);
    return problem;
}

void xlsx_discard(xlsx *book)
{
    if (book == NULL)
        return;
    lxw_workbook_free(book->workbook);
    release(book);
}

/* ---- Cells ----------------------------------------------------------------------------------- */

void xlsx_number(xlsx *book, int row, int column, double value, xlsx_style style)
{
    if (isfinite(value))
        keep(book, worksheet_write_number(book->current, row_of(row), column_of(column), value,
                                          book->style[style]));
    else
        keep(book, worksheet_write_blank(book->current, row_of(row), column_of(column),
                                         book->style[style]));
}

void xlsx_text(xlsx *book, int row, int column, const char *text, xlsx_style style)
{
    if (!utf8_is_whole(text))
        keep(book, LXW_ERROR_PARAMETER_VALIDATION);
    else
        keep(book, worksheet_write_string(book->current, row_of(row), column_of(column), text,
                                          book->style[style]));
}

void xlsx_formula(xlsx *book, int row, int column, const char *formula, double value,
                  xlsx_style style)
{
    keep(book, worksheet_write_formula_num(book->current, row_of(row), column_of(column), formula,
                                           book->style[style], value));
}

void xlsx_text_formula(xlsx *book, int row, int column, const char *formula, const char *value,
                       xlsx_style style)
{
    keep(book, worksheet_write_formula_str(book->current, row_of(row), column_of(column), formula,
                                           book->style[style], value));
}

void xlsx_name_range(xlsx *book, const char *name, int row, int column, int rows, int columns)
{
    char place[NAME_MAX_LENGTH + LXW_MAX_CELL_RANGE_LENGTH + 4], cells[LXW_MAX_CELL_RANGE_LENGTH];
    lxw_rowcol_to_range_abs(cells, row_of(row), column_of(column), row_of(row + rows - 1),
                            column_of(column + columns - 1));
    snprintf(place, sizeof place, "='%s'!%s", book->sheet_name[book->current_index], cells);
    keep(book, workbook_define_name(book->workbook, name, place));
}

void xlsx_name(xlsx *book, const char *name, int row, int column)
{
    xlsx_name_range(book, name, row, column, 1, 1);
}

/* ---- Sheets ---------------------------------------------------------------------------------- */

void xlsx_width(xlsx *book, int first_column, int last_column, double characters)
{
    keep(book, worksheet_set_column(book->current, column_of(first_column), column_of(last_column),
                                    characters, NULL));
}

void xlsx_lines(xlsx *book, int row, int lines)
{
    keep(book, worksheet_set_row(book->current, row_of(row), lines * LXW_DEF_ROW_HEIGHT, NULL));
}

void xlsx_freeze(xlsx *book, int rows, int columns)
{
    worksheet_freeze_panes(book->current, row_of(rows), column_of(columns));
}

void xlsx_hide_sheet(xlsx *book)
{
    worksheet_hide(book->current);
}

void xlsx_hide_columns(xlsx *book, int first_column, int last_column)
{
    lxw_row_col_options options = {.hidden = LXW_TRUE};
    keep(book, worksheet_set_column_opt(book->current, column_of(first_column),
                                        column_of(last_column), 12, NULL, &options));
}

void xlsx_protect(xlsx *book)
{
    lxw_protection may = {.format_columns = LXW_TRUE, .format_rows = LXW_TRUE};
    worksheet_protect(book->current, NULL, &may);
}

void xlsx_hide_names(xlsx *book, const char *beginning)
{
    struct lxw_defined_name *name;
    TAILQ_FOREACH(name, book->workbook->defined_names, list_pointers)
    if (strncmp(name->name, beginning, strlen(beginning)) == 0)
        name->hidden = LXW_TRUE;
}

void xlsx_merge(xlsx *book, xlsx_area area, xlsx_style style)
{
    keep(book,
         worksheet_merge_range(book->current, row_of(area.row), column_of(area.column),
                               row_of(area.row + area.rows - 1),
                               column_of(area.column + area.columns - 1), "", book->style[style]));
}

void xlsx_colour_when(xlsx *book, xlsx_area area, const char *formula, xlsx_colour colour)
{
    char text[300];
    snprintf(text, sizeof text, "%s", formula);
    lxw_conditional_format when = {
        .type = LXW_CONDITIONAL_TYPE_FORMULA, .value_string = text, .format = book->colour[colour]};
    keep(book,
         worksheet_conditional_format_range(book->current, row_of(area.row), column_of(area.column),
                                            row_of(area.row + area.rows - 1),
                                            column_of(area.column + area.columns - 1), &when));
}

void xlsx_validate(xlsx *book, xlsx_area area, const xlsx_rule *rule)
{
    char formula[256], title[33], hint[256], message[256];
    snprintf(formula, sizeof formula, "%s", rule->formula);
    snprintf(title, sizeof title, "%s", rule->title);
    snprintf(hint, sizeof hint, "%s", rule->hint);
    snprintf(message, sizeof message, "%s", rule->message);
    lxw_data_validation what = {.validate = LXW_VALIDATION_TYPE_CUSTOM_FORMULA,
                                .value_formula = formula,
                                .input_title = title,
                                .input_message = hint,
                                .error_title = title,
                                .error_message = message};
    keep(book,
         worksheet_data_validation_range(book->current, row_of(area.row), column_of(area.column),
                                         row_of(area.row + area.rows - 1),
                                         column_of(area.column + area.columns - 1), &what));
}

void xlsx_print(xlsx *book, xlsx_page page)
{
    keep(book, worksheet_print_area(book->current, 0, 0, row_of(page.last_row),
                                    column_of(page.last_column)));
    worksheet_fit_to_pages(book->current, (uint16_t)page.wide, (uint16_t)(page.header_row < 0));
    if (page.wide > 1)
        keep(book, worksheet_repeat_columns(book->current, 0, 0));
    if (page.header_row >= 0)
        keep(book, worksheet_repeat_rows(book->current, 0, row_of(page.header_row)));
    if (page.landscape)
        worksheet_set_landscape(book->current);
    worksheet_set_margins(book->current, 0.5, 0.5, 0.6, 0.6);
    keep(book, worksheet_set_footer(book->current, "&L&8rwedge " RWEDGE_VERSION "&C&8&A&R&8&P/&N"));
}

/* ---- Charts ---------------------------------------------------------------------------------- */

/* Curves of a family differ in dashes as well as in shade: they stay apart in print and for
 * every eye. */
static void draw_line(lxw_chart_series *series, int index, xlsx_drawing drawing)
{
    static const lxw_color_t shades[] = {LXW_COLOR_BLACK, 0x0072B2, 0x009E73, 0xD55E00, 0x8A5A83};
    static const uint8_t dashes[] = {LXW_CHART_LINE_DASH_SOLID, LXW_CHART_LINE_DASH_DASH};
    lxw_chart_line line = {
        .color = shades[index % 5], .width = 1.25F, .dash_type = dashes[(index / 5) % 2]};
    if (drawing == XLSX_THICK_LINE)
        line =
            (lxw_chart_line){.color = 0xE69F00, .width = 3, .dash_type = LXW_CHART_LINE_DASH_SOLID};
    else if (drawing == XLSX_DASHED_LINE)
        line = (lxw_chart_line){
            .color = 0x707070, .width = 1.5F, .dash_type = LXW_CHART_LINE_DASH_DASH};
    else if (drawing == XLSX_OUTLINE)
        line = (lxw_chart_line){.color = LXW_COLOR_BLACK, .width = 1.5F};
    else if (drawing == XLSX_MARK || drawing == XLSX_LABEL)
        line = (lxw_chart_line){.none = LXW_TRUE};
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

static void draw_series(xlsx *book, lxw_chart *drawn, const xlsx_series *what, int index)
{
    lxw_chart_series *series = chart_add_series(drawn, what->x, what->y);
    if (what->name != NULL && what->drawing != XLSX_LABEL)
        chart_series_set_name(series, what->name);
    draw_line(series, index, what->drawing);
    draw_mark(series, what->drawing);
    if (what->drawing == XLSX_LABEL) {
        lxw_chart_font font = {.size = 10};
        char name[60];
        snprintf(name, sizeof name, "%s", what->name);
        lxw_chart_data_label text = {.value = name}, *texts[] = {&text, NULL};
        chart_series_set_labels(series);
        chart_series_set_labels_position(series, LXW_CHART_LABEL_POSITION_CENTER);
        chart_series_set_labels_font(series, &font);
        keep(book, chart_series_set_labels_custom(series, texts));
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
    chart_axis_set_num_format(drawn->x_axis, "0.0");
    chart_axis_set_num_format(drawn->y_axis, "General");
    if (chart->bare) {
        chart_axis_off(drawn->x_axis);
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
        keep(book, LXW_ERROR_MEMORY_MALLOC_FAILED);
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
    keep(book,
         worksheet_insert_chart_opt(book->current, row_of(row), column_of(column), drawn, &place));
}
