/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "parts.h"

#include <string.h>

/* Four to six digits; zero is 0. LibreOffice writes no minus in such parts. */
#define RESULT_FORMAT "[=0]0;[<0.001]0.0000E+00;0.00###"

typedef struct {
    const char *name, *format; /* of numbers */
    double size;
    lxw_color_t ink, ground; /* what has a ground has a frame */
    uint8_t across, down;    /* of lxw_format_alignments */
    bool bold, line_below, wrapped, upright, indented, unlocked;
} look;

static const lxw_color_t BLACK = 0x010101; /* 0 is none */

/* The first is how the program likes it. */
static const look looks[XLSX_STYLES] = {
    {.name = "plain"},
    {"title", .bold = true, .size = 16},
    {"heading", .bold = true, .size = 12},
    /* of a table's column; upright is read from below: the column may be narrow */
    {"header", .bold = true, .line_below = true, .wrapped = true, .across = LXW_ALIGN_RIGHT,
     .down = LXW_ALIGN_VERTICAL_BOTTOM},
    {"upright", .bold = true, .line_below = true, .upright = true, .across = LXW_ALIGN_CENTER},
    {"note", .size = 9, .ink = 0x505050},                         /* small print */
    {"wrapped", .wrapped = true, .down = LXW_ALIGN_VERTICAL_TOP}, /* a paragraph */
    /* a cell to type into; bare without a frame: a colour shows where it is */
    {"input", .ground = 0xFFF8D0, .unlocked = true, .across = LXW_ALIGN_RIGHT},
    {"bare", .unlocked = true, .across = LXW_ALIGN_RIGHT},
    /* about six significant digits; signed where it may be below 0 */
    {"result", .format = RESULT_FORMAT, .ground = 0xE8F0F8, .across = LXW_ALIGN_RIGHT},
    {"signed", .ground = 0xE8F0F8, .across = LXW_ALIGN_RIGHT},
    {"unit", .indented = true}, /* a text after a number */
    {"number", .format = "0.0#####"},
    {"small", .format = "0.0#######"},
    {"large", .format = "0.0##"},
    {"fixed_4", .format = "0.0000"},
    {"fixed_6", .format = "0.000000"},
    {"power", .format = "0.00000E+00"},
    {"verdict", .ground = 0xFFFFFF, .bold = true, .size = 12, .wrapped = true,
     .down = LXW_ALIGN_VERTICAL_CENTER}, /* a text in a frame over several cells */
    {"strong", .format = "0.00", .ground = 0xE8F0F8, .bold = true, .size = 12,
     .across = LXW_ALIGN_RIGHT},
    /* of cells that a condition colours; the last two as input and result */
    {"green", .ground = 0xC6EFCE, .ink = 0x006100},
    {"amber", .ground = 0xFFEB9C, .ink = 0x7F4F00},
    {"red", .ground = 0xFFC7CE, .ink = 0x9C0006},
    {"yellow", .ground = 0xFFF8D0, .ink = BLACK},
    {"blue", .ground = 0xE8F0F8, .ink = BLACK},
};

lxw_format *xlsx_style(const xlsx *book, const char *name)
{
    int i = 0;
    while (strcmp(looks[i].name, name) != 0)
        i++;
    return book->style[i];
}

static void set_style(lxw_format *style, const look *as)
{
    if (as->bold)
        format_set_bold(style);
    if (as->size > 0)
        format_set_font_size(style, as->size);
    if (as->ink != 0)
        format_set_font_color(style, as->ink);
    if (as->format != NULL)
        format_set_num_format(style, as->format);
    if (as->unlocked)
        format_set_unlocked(style);
    if (as->ground != 0) {
        format_set_border(style, LXW_BORDER_THIN);
        format_set_border_color(style, 0x808080);
        format_set_bg_color(style, as->ground);
    }
    if (as->line_below)
        format_set_bottom(style, LXW_BORDER_THIN);
    if (as->wrapped)
        format_set_text_wrap(style);
    if (as->upright)
        format_set_rotation(style, 90);
    if (as->indented)
        format_set_indent(style, 1);
    format_set_align(style, as->across);
    format_set_align(style, as->down);
}

bool xlsx_make_styles(xlsx *book)
{
    for (int i = 1; i < XLSX_STYLES; i++) {
        book->style[i] = workbook_add_format(book->workbook);
        if (book->style[i] == NULL)
            return false;
        set_style(book->style[i], &looks[i]);
    }
    return true;
}
