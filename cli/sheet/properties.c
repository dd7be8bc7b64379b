/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What cells and sheets have besides their contents, by name and texts. */
#include "parts.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <rwedge.h>

static void set_page(xlsx *book, int headers, bool landscape)
{
    worksheet_fit_to_pages(book->current, 1, (uint16_t)(headers == 0));
    if (headers > 0)
        xlsx_keep(book, worksheet_repeat_rows(book->current, 0, (lxw_row_t)headers - 1));
    if (landscape)
        worksheet_set_landscape(book->current);
    worksheet_set_margins(book->current, 0.4, 0.4, 0.6, 0.6);
    xlsx_keep(book,
              worksheet_set_footer(book->current, "&L&8rwedge " RWEDGE_VERSION "&C&8&A&R&8&P/&N"));
}

void xlsx_print(xlsx *book, xlsx_area area, int headers, bool landscape)
{
    xlsx_keep(book, worksheet_print_area(book->current, CELLS(area)));
    set_page(book, headers, landscape);
}

static void print(xlsx *book, xlsx_area at, const char *const text[])
{
    char name[LXW_MAX_SHEETNAME_LENGTH + 20];
    const int headers = atoi(text[1]);
    const bool landscape = text[2][0] != '\0';
    if (text[0][0] != '=') {
        xlsx_print(book, at, headers, landscape);
        return;
    }
    snprintf(name, sizeof name, "%s!_xlnm.Print_Area", book->current->name);
    xlsx_keep(book, workbook_define_name(book->workbook, name, text[0]));
    set_page(book, headers, landscape);
}

static void colour(xlsx *book, xlsx_area at, const char *const text[])
{
    lxw_conditional_format when = {.type = LXW_CONDITIONAL_TYPE_FORMULA,
                                   .value_string = (char *)text[2],
                                   .format = xlsx_style(book, text[1])};
    xlsx_keep(book, worksheet_conditional_format_range(book->current, CELLS(at), &when));
}

static void set_rule(xlsx *book, xlsx_area at, const char *const text[])
{
    char title[33]; /* more is refused */
    snprintf(title, sizeof title, "%s", text[2]);
    lxw_data_validation check = {.validate = LXW_VALIDATION_TYPE_CUSTOM_FORMULA,
                                 .value_formula = (char *)text[1],
                                 .input_title = title,
                                 .input_message = (char *)text[3],
                                 .error_title = title,
                                 .error_message = (char *)text[4]};
    xlsx_keep(book, worksheet_data_validation_range(book->current, CELLS(at), &check));
}

void xlsx_property(xlsx *book, const char *name, xlsx_area at, const char *const text[])
{
    lxw_protection may = {.format_columns = LXW_TRUE, .format_rows = LXW_TRUE};
    if (strcmp(name, "width") == 0)
        xlsx_width(book, at.column, at.last_column, atof(text[1]));
    else if (strcmp(name, "lines") == 0)
        xlsx_lines(book, at.row, atoi(text[1]));
    else if (strcmp(name, "freeze") == 0)
        xlsx_freeze(book, at.row, at.column);
    else if (strcmp(name, "merge") == 0)
        xlsx_keep(book,
                  worksheet_merge_range(book->current, CELLS(at), "", xlsx_style(book, text[1])));
    else if (strcmp(name, "protect") == 0)
        worksheet_protect(book->current, NULL, &may);
    else if (strcmp(name, "hide") == 0)
        worksheet_hide(book->current);
    else if (strcmp(name, "print") == 0)
        print(book, at, text);
    else if (strcmp(name, "colour") == 0)
        colour(book, at, text);
    else if (strcmp(name, "rule") == 0)
        set_rule(book, at, text);
    else if (strcmp(name, "chart") == 0)
        xlsx_chart(book, at, text);
    else
        xlsx_curve(book, text);
}
