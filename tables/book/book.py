# SPDX-License-Identifier: GPL-3.0-or-later
"""The spreadsheet file: how its cells look, their names, what is printed, and its curves."""
import math
import os
from datetime import datetime, timezone

import xlsxwriter
from xlsxwriter.utility import xl_col_to_name, xl_range_abs, xl_rowcol_to_cell

from source import rounded

# Four to six digits; zero is 0. LibreOffice writes no minus in such parts.
RESULT = "[=0]0;[<0.001]0.0000E+00;0.00###"
GREY_FRAME = dict(border=1, border_color="#808080")
STYLES = {
    "plain": {},
    "title": dict(bold=True, font_size=16),
    "heading": dict(bold=True, font_size=12),
    # of a table's column; upright is read from below: the column may be narrow
    "header": dict(bold=True, bottom=1, text_wrap=True, align="right", valign="bottom"),
    "upright": dict(bold=True, bottom=1, rotation=90, align="center"),
    "note": dict(font_size=11, font_color="#505050"),
    "wrapped_note": dict(font_size=11, font_color="#505050", text_wrap=True, valign="top"),
    "wrapped": dict(text_wrap=True, valign="top"),  # a paragraph
    # a cell to type into; bare without a frame: a colour shows where it is
    "input": dict(GREY_FRAME, bg_color="#FFF8D0", locked=False, align="right"),
    "bare": dict(locked=False, align="right"),
    # about six significant digits; signed where it may be below 0
    "result": dict(GREY_FRAME, num_format=RESULT, bg_color="#E8F0F8", align="right"),
    "signed": dict(GREY_FRAME, bg_color="#E8F0F8", align="right"),
    "strong": dict(GREY_FRAME, num_format="0.00", bg_color="#E8F0F8", bold=True, font_size=12, align="right"),
    "unit": dict(indent=1),  # a text after a number
    "fixed_4": dict(num_format="0.0000"),
    "fixed_6": dict(num_format="0.000000"),
    "verdict": dict(GREY_FRAME, bg_color="#FFFFFF", bold=True, font_size=12, text_wrap=True, valign="vcenter"),
    # of cells that a condition colours; the last two as input and result
    "green": dict(GREY_FRAME, bg_color="#C6EFCE", font_color="#006100"),
    "amber": dict(GREY_FRAME, bg_color="#FFEB9C", font_color="#7F4F00"),
    "red": dict(GREY_FRAME, bg_color="#FFC7CE", font_color="#9C0006"),
    "yellow": dict(GREY_FRAME, bg_color="#FFF8D0", font_color="#000000"),
    "blue": dict(GREY_FRAME, bg_color="#E8F0F8", font_color="#000000"),
}
LINE_HEIGHT = 15
SHEETS = ["Calculator", "Batch", "Pads", "Materials", "Look up", "Elastic limit", "Maximum tension", "Contact law", "Critical friction", "About", "Working"]


def date():
    """The same file again: a date that SOURCE_DATE_EPOCH sets, as it does for other tools, or a fixed one, never the clock's."""
    seconds = os.environ.get("SOURCE_DATE_EPOCH") or "1767225600"  # 2026-01-01
    return datetime.fromtimestamp(int(seconds), timezone.utc).replace(tzinfo=None)


class Book:
    def __init__(self, path, version):
        self.file, self.version, self.hidden = xlsxwriter.Workbook(path), version, []
        self.file.set_properties(dict(title="rwedge: contact of a rounded wedge", author=f"rwedge {version}", created=date()))
        self.styles = {name: self.file.add_format(look) if look else None for name, look in STYLES.items()}
        self.sheets = {name: Sheet(self, self.file.add_worksheet(name)) for name in SHEETS}

    def close(self):
        """Names of working cells do not show in lists of names."""
        for name in self.file.defined_names:
            if name[0].startswith("rwt_"):
                name[3] = True
        self.file.close()


class Sheet:
    """Rows and columns count from 0, as in XlsxWriter; its other functions are those of "sheet"."""

    def __init__(self, book, sheet):
        self.book, self.sheet = book, sheet
        sheet.set_paper(9)  # A4

    def text(self, row, column, text, style="plain"):
        self.sheet.write_string(row, column, text, self.book.styles[style])

    def texts(self, row, column, *texts, style="plain"):
        for i, text in enumerate(texts):
            self.text(row + i, column, text, style)

    def number(self, row, column, value, style="plain"):
        """NaN and None are an empty cell, which is left out where it is plain."""
        if value is None or math.isnan(value):
            self.sheet.write_blank(row, column, None, self.book.styles[style])
        else:
            self.sheet.write_number(row, column, value, self.book.styles[style])

    def formula(self, row, column, formula, value, style="plain"):
        """With the value that programs show which do not compute; without one they have to."""
        if isinstance(value, (int, float)):
            value = "" if math.isnan(value) else rounded(value)
        self.sheet.write_formula(row, column, "=" + formula, self.book.styles[style], "" if value is None else value)

    def name(self, name, row, column, rows=1, columns=1):
        cells = xl_range_abs(row, column, row + rows - 1, column + columns - 1)
        self.book.file.define_name(name, f"='{self.sheet.name}'!{cells}")

    def block(self, row, column, values, style="plain", name=None):
        """Rows of numbers."""
        for i, line in enumerate(values):
            for j, value in enumerate(line):
                if value is not None and not math.isnan(value):
                    self.number(row + i, column + j, value, style)
        if name:
            self.name(name, row, column, len(values), len(values[0]))

    def down(self, row, column, values, style="plain", name=None):
        self.block(row, column, [[value] for value in values], style, name)

    def widths(self, **columns):
        """By the letters of columns: A=8, B_C=9."""
        for letters, width in columns.items():
            first, _, last = letters.partition("_")
            self.sheet.set_column(f"{first}:{last or first}", width)

    def rule(self, cells, condition, title, hint, message):
        """What is typed must make the condition true, a formula for the first cell."""
        self.sheet.data_validation(cells, dict(validate="custom", value="=" + condition, input_title=title[:32], input_message=hint,
                                               error_title=title[:32], error_message=message))

    def colour(self, cells, style, condition):
        self.sheet.conditional_format(cells, dict(type="formula", criteria="=" + condition, format=self.book.styles[style]))

    def print(self, cells, headers=0, landscape=False, breaks=()):
        """One page wide; one page high, or, with so many rows as headers on each, as many pages as it takes. With breaks before these
        columns at letters of 8 points, the first column on each page. The cells may be a formula."""
        sheet = self.sheet
        if cells.startswith("="):
            self.book.file.define_name(f"{sheet.name}!_xlnm.Print_Area", cells)
        else:
            sheet.print_area(cells)
        if breaks:
            sheet.set_print_scale(73)
            sheet.set_v_pagebreaks(list(breaks))
            sheet.repeat_columns(0, 0)
            sheet.print_across()
        else:
            sheet.fit_to_pages(1, 0 if headers else 1)
        if headers:
            sheet.repeat_rows(0, headers - 1)
        if landscape:
            sheet.set_landscape()
        sheet.set_margins(0.3, 0.3, 0.5, 0.6)
        sheet.set_footer(f"&L&8rwedge {self.book.version}&C&8&A&R&8&P/&N")

    def protect(self):
        """None but cells of the styles "input" and "bare" can be typed into; there is no password."""
        self.sheet.protect("", dict(format_columns=True, format_rows=True))


def place(row, column):
    """ "$AB12": the column stays where a row is copied. """
    return xl_rowcol_to_cell(row, column, col_abs=True)


def letters(column):
    return xl_col_to_name(column)


# ---- Curves ----

# Curves of a family differ in dashes as well as in shade: they stay apart in print and for every eye.
FAMILY = [dict(color=shade, width=1.25, dash_type=dash) for dash in ("solid", "dash")
          for shade in ("#000000", "#0072B2", "#009E73", "#D55E00", "#8A5A83")]
LINES = {
    "thick": dict(color="#E69F00", width=3),
    "dashed": dict(color="#707070", width=1.5, dash_type="dash"),
    "outline": dict(color="#000000", width=1.5),
    "bar_ground": dict(color="#E0E0E0", width=14),
    "bar_good": dict(color="#2E8B57", width=14),
    "bar_bad": dict(color="#C0392B", width=14),
}
NO_LINE = dict(none=True)
MARK = dict(type="diamond", size=11, fill=dict(color="#D00000"))


def axis(least, most, step=0, title="", number_format=""):
    """Its numbers show where it has a title or a format."""
    look = dict(min=least, max=most, num_format=number_format)
    if step:
        look["major_unit"] = step
    if title:
        return dict(look, name=title, name_font=dict(size=10, bold=False),
                    major_gridlines=dict(visible=True, line=dict(color="#E0E0E0", width=0.5)))
    return dict(look, major_gridlines=dict(visible=False), visible=bool(number_format))


class Chart:
    """Points with straight lines between them; with a title there is a legend. The cell of its corner, its size and how far it is
    right of and below the corner, in pixels."""

    def __init__(self, sheet, cell, size, offset, x, y, title=""):
        self.chart = sheet.book.file.add_chart(dict(type="scatter", subtype="straight"))
        self.curves = 0
        self.chart.set_x_axis(dict(x, num_format=x["num_format"] or "0.0"))
        self.chart.set_y_axis(dict(y, num_format=y["num_format"] or "General"))
        self.chart.set_title(dict(name=title, name_font=dict(size=11, bold=True)) if title else dict(none=True))
        self.chart.set_legend(dict(position="bottom" if title else "none", font=dict(size=8)))
        sheet.sheet.insert_chart(cell, self.chart, dict(x_scale=size[0] / 480, y_scale=size[1] / 288, x_offset=offset[0],
                                                        y_offset=offset[1]))

    def add(self, x, y, line, **more):
        """The ranges of its places, as "='Sheet'!$A$1:$A$9"; the name is in a cell."""
        if line == "family":
            line = FAMILY[self.curves % len(FAMILY)]
        self.curves += 1
        self.chart.add_series(dict(dict(marker=dict(type="none")), categories=x, values=y, line=LINES.get(line, line)
                                   if isinstance(line, str) else line, **more))

    def mark(self, x, y, name):
        self.add(x, y, NO_LINE, name=name, marker=MARK)

    def label(self, x, y, text):
        """A text at an invisible point."""
        self.add(x, y, NO_LINE, data_labels=dict(value=True, position="center", font=dict(size=10), custom=[dict(value=text)]))
