/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "parts.h"

#include <errno.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include <rwedge.h>

xlsx_area xlsx_area_of(const char *cells)
{
    const char *colon = strchr(cells, ':');
    const char *last = colon != NULL ? colon + 1 : cells;
    return (xlsx_area){(int)lxw_name_to_row(cells), lxw_name_to_col(cells),
                       (int)lxw_name_to_row(last), lxw_name_to_col(last)};
}

void xlsx_column_name(int column, char name[XLSX_COLUMN_SIZE])
{
    lxw_col_to_name(name, (lxw_col_t)column, LXW_TRUE);
}

const char *xlsx_missing(void)
{
    return NULL;
}

void xlsx_keep(xlsx *book, lxw_error error)
{
    if (error == LXW_NO_ERROR &&
        (errno == ENOMEM || errno == ENOSPC || errno == EIO || errno == EINTR || errno == EFBIG))
        error = errno == ENOMEM ? LXW_ERROR_MEMORY_MALLOC_FAILED : LXW_ERROR_CREATING_TMPFILE;
    if (book->error == LXW_NO_ERROR)
        book->error = error;
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
    *date = (time_t)(seconds > 0 ? seconds : 1); /* 0 is the clock for the library */
    return sound && (*date == seconds || seconds == 0);
}

xlsx *xlsx_begin(output *out, const char *title, bool in_order)
{
    time_t date;
    if (!creation_date(&date))
        failure("%s: the variable SOURCE_DATE_EPOCH: must be a whole number of seconds, 0 to "
                "253402300799, the end of the year 9999",
                out->name);
    xlsx *book = memory_zeroed(1, sizeof *book);
    book->out = out;
    lxw_workbook_options options = {.constant_memory = in_order};
    errno = 0;
    if (spool_begin(&book->spool))
        book->workbook = workbook_new_opt(book->spool.name, &options);
    if (book->workbook == NULL || !xlsx_make_styles(book))
        failure("%s: a temporary file for the spreadsheet cannot be made", out->name);
    lxw_doc_properties properties = {
        .title = (char *)title, .author = "rwedge " RWEDGE_VERSION, .created = date};
    xlsx_keep(book, workbook_set_properties(book->workbook, &properties));
    return book;
}

void xlsx_sheet(xlsx *book, const char *name)
{
    lxw_worksheet *sheet = workbook_get_worksheet_by_name(book->workbook, name);
    const bool is_new = sheet == NULL;
    if (is_new)
        sheet = workbook_add_worksheet(book->workbook, name);
    if (sheet == NULL) {
        xlsx_keep(book, LXW_ERROR_MEMORY_MALLOC_FAILED);
        return;
    }
    if (is_new)
        worksheet_set_paper(sheet, 9); /* A4 */
    book->current = sheet;
}

void xlsx_finish(xlsx *book)
{
    char buffer[1 << 14];
    errno = 0;
    xlsx_keep(book, workbook_close(book->workbook));
    const char *problem = book->error != LXW_NO_ERROR ? lxw_strerror(book->error) : NULL;
    FILE *from = problem == NULL ? spool_read(&book->spool) : NULL;
    for (size_t count; from != NULL && (count = fread(buffer, 1, sizeof buffer, from)) > 0;)
        output_write(book->out, buffer, count);
    if (problem == NULL && (from == NULL || ferror(from)))
        problem = strerror(errno);
    if (problem != NULL)
        failure("%s: %s", book->out->name, problem);
    spool_end(&book->spool);
    free(book);
}

/* ---- Cells ----------------------------------------------------------------------------------- */

void xlsx_number(xlsx *book, int row, int column, double value, const char *style)
{
    if (isfinite(value))
        xlsx_keep(book, worksheet_write_number(book->current, CELL_AT(row, column), value,
                                               xlsx_style(book, style)));
    else
        xlsx_keep(book, worksheet_write_blank(book->current, CELL_AT(row, column),
                                              xlsx_style(book, style)));
}

void xlsx_text(xlsx *book, int row, int column, const char *text, const char *style)
{
    if (!utf8_is_whole(text))
        xlsx_keep(book, LXW_ERROR_PARAMETER_VALIDATION);
    else
        xlsx_keep(book, worksheet_write_string(book->current, CELL_AT(row, column), text,
                                               xlsx_style(book, style)));
}

void xlsx_formula(xlsx *book, int row, int column, const char *formula, cell value,
                  const char *style)
{
    lxw_format *look = xlsx_style(book, style);
    if (value.text == NULL && isfinite(value.number))
        xlsx_keep(book,
                  worksheet_write_formula_num(book->current, CELL_AT(row, column), formula, look,
                                              number_rounded(value.number, XLSX_DIGITS)));
    else
        xlsx_keep(book, worksheet_write_formula_str(book->current, CELL_AT(row, column), formula,
                                                    look, value.text != NULL ? value.text : ""));
}

void xlsx_name(xlsx *book, const char *name, xlsx_area area)
{
    char place[LXW_MAX_SHEETNAME_LENGTH + LXW_MAX_CELL_RANGE_LENGTH + 5],
        cells[LXW_MAX_CELL_RANGE_LENGTH];
    lxw_rowcol_to_range_abs(cells, CELLS(area));
    snprintf(place, sizeof place, "='%s'!%s", book->current->name, cells);
    xlsx_keep(book, workbook_define_name(book->workbook, name, place));
}

/* ---- Sheets ---------------------------------------------------------------------------------- */

void xlsx_width(xlsx *book, int first_column, int last_column, double characters)
{
    xlsx_keep(book, worksheet_set_column(book->current, (lxw_col_t)first_column,
                                         (lxw_col_t)last_column, characters, NULL));
}

void xlsx_lines(xlsx *book, int row, int lines)
{
    xlsx_keep(book,
              worksheet_set_row(book->current, (lxw_row_t)row, lines * LXW_DEF_ROW_HEIGHT, NULL));
}

void xlsx_freeze(xlsx *book, int rows, int columns)
{
    worksheet_freeze_panes(book->current, CELL_AT(rows, columns));
}

void xlsx_hide_columns(xlsx *book, int first_column, int last_column)
{
    lxw_row_col_options options = {.hidden = LXW_TRUE};
    xlsx_keep(book, worksheet_set_column_opt(book->current, (lxw_col_t)first_column,
                                             (lxw_col_t)last_column, 12, NULL, &options));
}

void xlsx_hide_names(xlsx *book, const char *beginning)
{
    struct lxw_defined_name *name;
    TAILQ_FOREACH(name, book->workbook->defined_names, list_pointers)
    if (strncmp(name->name, beginning, strlen(beginning)) == 0)
        name->hidden = LXW_TRUE;
}
