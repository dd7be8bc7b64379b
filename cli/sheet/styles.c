/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "parts.h"

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
    for (int i = XLSX_HEADER; i <= XLSX_UPRIGHT; i++) {
        format_set_bold(style[i]);
        format_set_bottom(style[i], LXW_BORDER_THIN);
    }
    format_set_rotation(style[XLSX_UPRIGHT], 90);
    format_set_align(style[XLSX_UPRIGHT], LXW_ALIGN_CENTER);
    format_set_text_wrap(style[XLSX_HEADER]);
    format_set_align(style[XLSX_HEADER], LXW_ALIGN_RIGHT);
    format_set_align(style[XLSX_HEADER], LXW_ALIGN_VERTICAL_BOTTOM);
    format_set_font_size(style[XLSX_NOTE], 9);
    format_set_font_color(style[XLSX_NOTE], 0x505050);
    format_set_text_wrap(style[XLSX_WRAPPED]);
    format_set_align(style[XLSX_WRAPPED], LXW_ALIGN_VERTICAL_TOP);
}

/* Four to six digits; zero is 0. LibreOffice writes no minus in such parts. */
#define RESULT_FORMAT "[=0]0;[<0.001]0.0000E+00;0.00###"

static void style_cells(lxw_format *const style[])
{
    frame(style[XLSX_INPUT], 0xFFF8D0);
    for (int i = XLSX_INPUT; i <= XLSX_BARE; i++) {
        format_set_unlocked(style[i]);
        format_set_align(style[i], LXW_ALIGN_RIGHT);
    }
    frame(style[XLSX_RESULT], 0xE8F0F8);
    format_set_num_format(style[XLSX_RESULT], RESULT_FORMAT);
    format_set_align(style[XLSX_RESULT], LXW_ALIGN_RIGHT);
    frame(style[XLSX_SIGNED], 0xE8F0F8);
    format_set_align(style[XLSX_SIGNED], LXW_ALIGN_RIGHT);
    frame(style[XLSX_STRONG], 0xE8F0F8);
    format_set_num_format(style[XLSX_STRONG], "0.00");
    format_set_align(style[XLSX_STRONG], LXW_ALIGN_RIGHT);
    format_set_bold(style[XLSX_STRONG]);
    format_set_font_size(style[XLSX_STRONG], 12);
    frame(style[XLSX_VERDICT], 0xFFFFFF);
    format_set_bold(style[XLSX_VERDICT]);
    format_set_font_size(style[XLSX_VERDICT], 12);
    format_set_text_wrap(style[XLSX_VERDICT]);
    format_set_align(style[XLSX_VERDICT], LXW_ALIGN_VERTICAL_CENTER);
    format_set_indent(style[XLSX_UNIT], 1);
    format_set_num_format(style[XLSX_NUMBER], "0.0#####");
    format_set_num_format(style[XLSX_SMALL], "0.0#######");
    format_set_num_format(style[XLSX_LARGE], "0.0##");
    format_set_num_format(style[XLSX_FIXED_4], "0.0000");
    format_set_num_format(style[XLSX_FIXED_6], "0.000000");
    format_set_num_format(style[XLSX_POWER], "0.00000E+00");
}

static bool make_colours(xlsx *book)
{
    static const lxw_color_t shade[] = {0xC6EFCE, 0xFFEB9C, 0xFFC7CE, 0xFFF8D0, 0xE8F0F8},
                             text[] = {0x006100, 0x7F4F00, 0x9C0006, 0x010101, 0x010101};
    for (int i = 0; i < XLSX_COLOUR_COUNT; i++) {
        book->colour[i] = workbook_add_format(book->workbook);
        if (book->colour[i] == NULL)
            return false;
        format_set_bg_color(book->colour[i], shade[i]);
        format_set_font_color(book->colour[i], text[i]);
        format_set_border(book->colour[i], LXW_BORDER_THIN);
        format_set_border_color(book->colour[i], 0x808080);
    }
    return true;
}

bool xlsx_make_styles(xlsx *book)
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
