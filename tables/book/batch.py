# SPDX-License-Identifier: GPL-3.0-or-later
"""The sheet Batch: a case a row. Inputs are left, results right, named as "solve --input" names its columns; then the working cells,
which are hidden. A row refers to itself and to the tables alone: it may be copied."""
from book import LINE_HEIGHT, letters, place
from cells import BATCH_EXAMPLES, CASE, GROUPS, INPUTS, RESULTS, SHOWN, in_row

ROWS = 200
COLUMN = {cell.name: column for column, cell in enumerate(CASE, 1)}
# the first column of results, that of the texts at their end, and its last one
RESULT, TEXTS, LAST = len(INPUTS) + 1, len(SHOWN) - 1, letters(len(SHOWN))


def places(row):
    """Of the cells of a row, in place of the names that the calculator has."""
    here = {name: place(row, column) for name, column in COLUMN.items()}
    here["rw_material"] = '""'  # of the calculator alone
    here.update({group: f"{place(row, COLUMN[group + '1'])}:{place(row, COLUMN[group + '3'])}" for group in GROUPS})
    return here


def write(sheet, shown):
    """With what the results of the examples show."""
    texts = RESULTS[-2:]
    sheet.text(0, 0, "case", "header")
    for cell in CASE:
        upright = cell in SHOWN and cell not in texts
        sheet.text(0, COLUMN[cell.name], cell.column if cell in SHOWN else cell.name, "upright" if upright else "header")
    for row in range(1, ROWS + 1):
        write_row(sheet, row, shown[row - 1] if row <= len(shown) else {})
    for row, (name, _) in enumerate(BATCH_EXAMPLES, 1):
        sheet.text(row, 0, name, "bare")
    hide_working(sheet)
    check_typing(sheet)
    colour(sheet)
    sheet.widths(**{"A": 20, f"B_{letters(TEXTS - 1)}": 9, f"{letters(TEXTS)}_{LAST}": 45})
    sheet.sheet.set_row(0, 10 * LINE_HEIGHT)
    sheet.sheet.freeze_panes(1, 1)
    # inputs, results on two pages, texts; unused rows further down are printed without
    sheet.print(f"=Batch!$A$1:INDEX(Batch!${LAST}$1:${LAST}$10000,rwt_used)", 1, landscape=True,
                breaks=(RESULT, (RESULT + TEXTS) // 2, TEXTS))
    sheet.protect()


def write_row(sheet, row, shown):
    here = places(row)
    sheet.number(row, 0, None, "bare")
    for cell in CASE:
        if cell in INPUTS:
            sheet.number(row, COLUMN[cell.name], shown.get(cell.column), "bare")
        else:
            sheet.formula(row, COLUMN[cell.name], in_row(cell.formula, here), shown.get(cell.column))


def hide_working(sheet):
    """The last row that has an input is beside the hidden names."""
    last = len(CASE) + 1
    cells = "Batch!$B$2:$N$10000"
    sheet.formula(0, last, f'MAX(1,SUMPRODUCT(MAX(({cells}<>"")*ROW({cells}))))', 1 + len(BATCH_EXAMPLES))
    sheet.name("rwt_used", 0, last)
    sheet.sheet.set_column(len(SHOWN) + 1, last, 12, None, dict(hidden=True))


def check_typing(sheet):
    """What is typed is checked at once; what is pasted, by the column "error"."""
    for cell in INPUTS:
        column = letters(COLUMN[cell.name])
        sheet.rule(f"{column}2:{column}{ROWS + 1}", f"NOT({in_row(cell.wrong, places(1))})", cell.column, cell.label,
                   f"{cell.column} must be {cell.must}.")


def colour(sheet):
    """A row with an error, or that yields, is red, one with warnings amber. The cells to type into are yellow, and so are those of the
    next rows."""
    last = ROWS + 1
    for cells, style, condition in [
            (f"A2:A{last}", "red", 'OR(rw_error<>"",AND(ISNUMBER(rw_safety),rw_safety<1))'), (f"A2:A{last}", "amber", 'rw_remarks<>""'),
            (f"A2:A{last}", "yellow", "ROW()<=rwt_used+20"), (f"B2:N{last}", "yellow", "ROW()<=rwt_used+20"),
            (f"O2:{LAST}{last}", "blue", "ROW()<=rwt_used")]:
        sheet.colour(cells, style, in_row(condition, places(1)))
