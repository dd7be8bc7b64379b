# SPDX-License-Identifier: GPL-3.0-or-later
"""The sheets of tables, and Look up, which interpolates the elastic limit."""
from source import rounded

TIPS = [0.01, 0.012, 0.015, 0.018, 0.022, 0.027, 0.033, 0.04, 0.05, 0.06, 0.075, 0.09, 0.11, 0.135, 0.165, 0.2, 0.25, 0.3, 0.36, 0.43,
        0.51, 0.6, 0.7, 0.8, 0.87, 0.92, 0.96, 0.985, 1]


def grid(rows, down, across, quantity):
    """The rows of a table as a block: its rows' and its columns' variable, and the numbers."""
    values = {(row[down], row.get(across)): row[quantity] for row in rows}
    lines, columns = (list(dict.fromkeys(row.get(variable) for row in rows)) for variable in (down, across))
    return lines, columns, [[value and rounded(value) for value in (values[line, column] for column in columns)] for line in lines]


def write_grid(sheet, row, column, rows, down, across, quantity, style="fixed_4", names=(None, None, None)):
    """With its variables left of it and above it: the one down, the one across, the numbers are named."""
    lines, columns, values = grid(rows, down, across, quantity)
    sheet.down(row + 1, column, lines, name=names[0])
    sheet.block(row, column + 1, [columns], "header", names[1])
    sheet.block(row + 1, column + 1, values, style, names[2])


def write_columns(sheet, row, column, rows, quantities, style):
    """The first of the quantities is the variable."""
    for i, quantity in enumerate(quantities):
        sheet.down(row, column + i, [row[quantity] if i == 0 else rounded(row[quantity]) for row in rows], style if i else "plain")


def elastic_limit(sheet, source):
    """The paper's grid, f down; then f = 0; then the two branches, to be looked up. Their a/b are closer where it is small: straight
    lines between these err as little as is said."""
    frictions, table = "0:0.8:0.0125", "elastic-limit"
    sheet.text(0, 0, "Elastic limit P/(bk)", "title")
    sheet.text(1, 0, "Load at first yield (von Mises, plane strain) in full sliding, k the yield stress in pure shear. a/b = 1 holds for "
                     "all a/b above 1. To the right: the two branches, for the sheet Look up.", "note")
    sheet.widths(A_K=8, L=3, M_BZ=8)
    sheet.text(2, 1, "a/b across, f down: P/(bk), nu = 0.3", "heading")
    sheet.text(3, 0, "f", "header")
    write_grid(sheet, 3, 0, source.table(table, nu=0.3, a_over_b="0.1:1:0.1", friction=frictions), "f", "a_over_b", "P_over_bk")
    sheet.text(2, 12, "f = 0, nu = 0.3", "heading")
    for i, header in enumerate(["a/b", "P/(bk)", "depth y/b"]):
        sheet.text(3, 12 + i, header, "header")
    write_columns(sheet, 4, 12, source.table(table, nu=0.3, a_over_b="0.01:1:0.01", friction=0), ["a_over_b", "P_over_bk", "y_over_b"],
                  "fixed_4")
    rows = source.table(table, nu=0.3, a_over_b=",".join(map(str, TIPS)), friction=frictions)
    sheet.text(3, 16, "f", "header")
    sheet.text(2, 17, "P/(bk) at the surface: a/b across, f down, nu = 0.3", "heading")
    write_grid(sheet, 3, 16, rows, "f", "a_over_b", "P_over_bk_surface", names=("rw_table_f", "rw_table_tips", "rw_table_surface"))
    sheet.text(2, 48, "P/(bk) below the surface; empty: there is no maximum there", "heading")
    _, tips, below = grid(rows, "f", "a_over_b", "P_over_bk_subsurface")
    sheet.block(3, 48, [tips], "header")
    sheet.block(4, 48, below, "fixed_4", "rw_table_below")
    sheet.sheet.freeze_panes(4, 0)
    sheet.print("A1:O104")


def maximum_tension(sheet, source):
    sheet.text(0, 0, "Maximum tension", "title")
    sheet.text(1, 0, "At the trailing edge in full sliding. a/b = 1 holds for all a/b above 1.", "note")
    sheet.text(2, 2, "b sigma/P, f across", "heading")
    sheet.text(3, 0, "a/b", "header")
    sheet.text(3, 1, "b sigma/(fP)", "header")
    rows = source.table("max-tension", a_over_b="0:1:0.01", friction="0.1:0.8:0.1")
    write_columns(sheet, 4, 0, rows[::8], ["a_over_b", "b_sigma_over_fP"], "fixed_6")
    _, frictions, values = grid(rows, "a_over_b", "f", "b_sigma_over_P")
    sheet.block(3, 2, [frictions], "header")
    sheet.block(4, 2, values, "fixed_6")
    sheet.widths(A=8, B=13, C_J=10)
    sheet.sheet.freeze_panes(4, 1)
    sheet.print("A1:J105", 4)


def contact_law(sheet, source):
    sheet.text(0, 0, "Contact law", "title")
    sheet.text(1, 0, "Load, pressure at x = 0 and where the rounding ends, x = a (0 where the contact ends before).", "note")
    for column, header in enumerate(["a/b", "AP/(theta b)", "AP/(theta a)", "A p0/theta", "A p(a)/theta"]):
        sheet.text(3, column, header, "header")
    write_columns(sheet, 4, 0, source.table("contact-law", a_over_b="0.01:2:0.01"),
                  ["a_over_b", "AP_over_theta_b", "AP_over_theta_a", "peak_pressure", "transition_pressure"], "fixed_6")
    sheet.widths(A=8, B_E=15)
    sheet.sheet.freeze_panes(4, 1)
    sheet.print("A1:F204", 4)


def critical_friction(sheet, source):
    sheet.text(0, 0, "Critical friction", "title")
    sheet.text(1, 0, "The f at which first yield jumps from below to the surface; 0: it is at the surface without friction.", "note")
    sheet.text(2, 1, "nu across", "heading")
    sheet.text(3, 0, "a/b", "header")
    write_grid(sheet, 3, 0, source.table("critical-friction", a_over_b="0.01:1:0.01", nu="0.2:0.5:0.025"), "a_over_b", "nu", "f_critical")
    sheet.widths(A_N=8)
    sheet.sheet.freeze_panes(4, 1)
    sheet.print("A1:N104", 4)


# ---- Look up ----

LOOK_UP = [
    "Type a/b and f, or copy a blue cell to the right of your own two columns, on any sheet of this workbook.",
    "a/b from 0.01 (from 1 on, all are Hertz' contact), f from 0 to 0.8; nu = 0.3. For other nu take the sheet Batch.",
    "Its table is on the right of the sheet Elastic limit: the two branches, at the surface and below it.",
    "The formula interpolates each branch by itself, linearly, and takes the smaller. The limit has a kink where they cross;",
    "the branches have none. Where one of the four entries below the surface is missing, the surface decides.",
    "Error: 0.12 % at most, over the middles of all cells of the table."]
# entries of the table, of which the formula gives back the value; then rows to type into
LOOK_UP_EXAMPLES = [(0.3, 0.1), (0.11, 0.3), (1, 0)]
LOOK_UP_FIRST, LOOK_UP_LAST = 11, 30


def interpolated(tip, f):
    """The row and the column of the next smaller entries of the table; on a line through two entries of a row, and of the row below;
    between these rows, which are 1/80 apart. Where an entry is missing, FORECAST has one point, and the surface decides."""
    tip_node, f_node = f"MIN(MATCH({tip},rw_table_tips,1),28)", f"MIN(MATCH({f},rw_table_f,1),64)"
    tips = f"INDEX(rw_table_tips,{tip_node}):INDEX(rw_table_tips,{tip_node}+1)"

    def along(table, step):
        return f"FORECAST(MIN(1,{tip}),INDEX({table},{f_node}{step},{tip_node}):INDEX({table},{f_node}{step},{tip_node}+1),{tips})"

    def between(table):
        return f"{along(table, '')}*({f_node}-80*{f})+{along(table, '+1')}*(1-{f_node}+80*{f})"

    return (f'IF(OR({tip}="",{f}=""),"",IF(OR({f}<0,{f}>0.8),NA(),'
            f"MIN({between('rw_table_surface')},IFERROR({between('rw_table_below')},1E+99))))")


def look_up(sheet, source):
    sheet.text(0, 0, "Look up: the elastic limit between the entries of the table", "title")
    sheet.texts(2, 0, *LOOK_UP)
    for column, header in enumerate(["a/b", "f", "P/(bk)"]):
        sheet.text(LOOK_UP_FIRST - 2, column, header, "header")
    for row in range(LOOK_UP_FIRST, LOOK_UP_LAST + 1):
        example = LOOK_UP_EXAMPLES[row - LOOK_UP_FIRST:][:1]
        for column in range(2):
            sheet.number(row - 1, column, example[0][column] if example else None, "input")
        sheet.formula(row - 1, 2, interpolated(f"A{row}", f"B{row}"),
                      source.number("elastic_limit", *example[0], 0.3) if example else None, "result")
    for column, least, most, name, hint in [("A", ">=0.01", "<1E+60", "a/b", "0.01 and above"), ("B", ">=0", "<=0.8", "f", "0 to 0.8")]:
        cell = f"{column}{LOOK_UP_FIRST}"
        said = "a/b must be a number, 0.01 or above." if name == "a/b" else "f must be a number, 0 to 0.8."
        sheet.rule(f"{cell}:{column}{LOOK_UP_LAST}", f"AND({cell}{least},{cell}{most})", name, hint, said)
    sheet.widths(A_C=16, D=60)
    sheet.sheet.freeze_panes(LOOK_UP_FIRST - 1, 0)
    sheet.protect()
    sheet.print("A1:D30", landscape=True)
