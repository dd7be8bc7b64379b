/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "sheet.h"

#include <errno.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include <rwedge.h>
#include <xlsxwriter.h>

struct xlsx {
    output *out;
    lxw_workbook *workbook;
    lxw_worksheet *current;
    lxw_format *style[XLSX_STYLES]; /* NULL: how the program likes it */
    /* libxlsxwriter writes to a path, and seeks in the file. So it first writes a temporary
     * file. */
    spool spool;
    lxw_error error;
};

/* The arguments that a cell is for the library. */
#define CELL_AT(row, column) (lxw_row_t)(row), (lxw_col_t)(column)

const char *xlsx_missing(void)
{
    return NULL;
}

/* Remembers what went wrong first. Where memory is short, or its temporary folder is full, the
 * library leaves things out. Not all of its functions say so, but errno is set. */
static void keep(xlsx *book, lxw_error error)
{
    if (error == LXW_NO_ERROR &&
        (errno == ENOMEM || errno == ENOSPC || errno == EIO || errno == EINTR || errno == EFBIG))
        error = errno == ENOMEM ? LXW_ERROR_MEMORY_MALLOC_FAILED : LXW_ERROR_CREATING_TMPFILE;
    if (book->error == LXW_NO_ERROR)
        book->error = error;
}

/* More than libxlsxwriter takes at a time, for a sheet, a row or the end of the file: where it
 * lacks memory, it may end by a signal. */
static void need_memory(void)
{
    enum { SPARE = 4 << 20 };
    void *volatile spare = malloc(SPARE); /* volatile: or the compiler leaves both calls out */
    free(memory_checked(spare));
}

/* ---- Styles ---------------------------------------------------------------------------------- */

/* Six to nine digits show. False where memory is short. */
static bool make_styles(xlsx *book)
{
    static const char *const numbers[XLSX_STYLES] = {[XLSX_LARGE] = "0.0##",
                                                     [XLSX_MIDDLE] = "0.0#####",
                                                     [XLSX_SMALL] = "0.0#######",
                                                     [XLSX_POWER] = "0.00000E+00"};
    for (xlsx_style i = XLSX_TITLE; i < XLSX_STYLES; i++) {
        book->style[i] = workbook_add_format(book->workbook);
        if (book->style[i] == NULL)
            return false;
        if (numbers[i] != NULL)
            format_set_num_format(book->style[i], numbers[i]);
        if (i <= XLSX_HEADER)
            format_set_bold(book->style[i]);
    }
    format_set_font_size(book->style[XLSX_TITLE], 16);
    format_set_font_size(book->style[XLSX_HEADING], 12);
    format_set_bottom(book->style[XLSX_HEADER], LXW_BORDER_THIN);
    format_set_text_wrap(book->style[XLSX_HEADER]);
    format_set_align(book->style[XLSX_HEADER], LXW_ALIGN_RIGHT);
    format_set_align(book->style[XLSX_HEADER], LXW_ALIGN_VERTICAL_BOTTOM);
    format_set_indent(book->style[XLSX_UNIT], 1);
    return true;
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

xlsx *xlsx_begin(output *out, const char *title)
{
    time_t date;
    if (!creation_date(&date))
        failure("%s: the variable SOURCE_DATE_EPOCH: must be a whole number of seconds, 0 to "
                "253402300799, the end of the year 9999",
                out->name);
    need_memory();
    xlsx *book = memory_zeroed(1, sizeof *book);
    book->out = out;
    lxw_workbook_options options = {.constant_memory = LXW_TRUE};
    errno = 0;
    if (spool_begin(&book->spool))
        book->workbook = workbook_new_opt(book->spool.name, &options);
    if (book->workbook == NULL || !make_styles(book))
        failure("%s: a temporary file for the spreadsheet cannot be made", out->name);
    lxw_doc_properties properties = {
        .title = (char *)title, .author = "rwedge " RWEDGE_VERSION, .created = date};
    keep(book, workbook_set_properties(book->workbook, &properties));
    return book;
}

void xlsx_sheet(xlsx *book, const char *name)
{
    lxw_worksheet *sheet = workbook_get_worksheet_by_name(book->workbook, name);
    const bool is_new = sheet == NULL;
    need_memory();
    if (is_new)
        sheet = workbook_add_worksheet(book->workbook, name);
    if (sheet == NULL) {
        keep(book, LXW_ERROR_MEMORY_MALLOC_FAILED);
        return;
    }
    if (is_new)
        worksheet_set_paper(sheet, 9); /* A4 */
    book->current = sheet;
}

/* Rows wait in files of their own. Where the system's library forgets that writing failed, as that
 * of Windows does, closing would pack what there is. */
static bool are_rows_written(const xlsx *book)
{
    lxw_worksheet *sheet;
    LXW_FOREACH_WORKSHEET(sheet, book->workbook)
    if (sheet->optimize_tmpfile != NULL &&
        (fflush(sheet->optimize_tmpfile) != 0 || ferror(sheet->optimize_tmpfile)))
        return false;
    return true;
}

void xlsx_finish(xlsx *book)
{
    char buffer[1 << 14];
    need_memory();
    errno = 0;
    keep(book, are_rows_written(book) ? LXW_NO_ERROR : LXW_ERROR_CREATING_TMPFILE);
    keep(book, workbook_close(book->workbook));
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

void xlsx_number(xlsx *book, int row, int column, double value, xlsx_style style)
{
    if (column == 0)
        need_memory();
    keep(book,
         worksheet_write_number(book->current, CELL_AT(row, column), value, book->style[style]));
}

void xlsx_text(xlsx *book, int row, int column, const char *text, xlsx_style style)
{
    if (column == 0)
        need_memory();
    if (!utf8_is_whole(text))
        keep(book, LXW_ERROR_PARAMETER_VALIDATION);
    else
        keep(book,
             worksheet_write_string(book->current, CELL_AT(row, column), text, book->style[style]));
}

/* ---- Sheets ---------------------------------------------------------------------------------- */

void xlsx_width(xlsx *book, int column, double characters)
{
    keep(book, worksheet_set_column(book->current, (lxw_col_t)column, (lxw_col_t)column, characters,
                                    NULL));
}

void xlsx_freeze(xlsx *book, int row, int column)
{
    worksheet_freeze_panes(book->current, CELL_AT(row, column));
}

void xlsx_print(xlsx *book, int last_row, int last_column, xlsx_pages pages, bool landscape)
{
    keep(book, worksheet_print_area(book->current, 0, 0, CELL_AT(last_row, last_column)));
    worksheet_fit_to_pages(book->current, 1, pages == XLSX_ONE_PAGE);
    if (pages == XLSX_PAGES)
        keep(book, worksheet_repeat_rows(book->current, 0, 0));
    if (landscape)
        worksheet_set_landscape(book->current);
    worksheet_set_margins(book->current, 0.4, 0.4, 0.6, 0.6);
    keep(book, worksheet_set_footer(book->current, "&L&8rwedge " RWEDGE_VERSION "&C&8&A&R&8&P/&N"));
}
