# SPDX-License-Identifier: GPL-3.0-or-later
"""The hidden sheet Working: the working cells of the calculator, the table of yield, and the points of the charts."""
from xlsxwriter.utility import xl_range_abs

import field
from cells import CASE, GROUPS, SHOWN, cell_of
from formulas import at_f, at_row, cosine, if_row, is_there, weigh
from source import FRICTIONS, NUS, TIPS, limits, rounded

NOTES, FIRST = 9, 10  # the rows of the columns of numbers: what they are, and the first number
TABLE_ROW = 64

# The sketch of the calculator: lines one after another, then letters where they stand; x, y in units of the picture.
SKETCH = {
    "half-plane": [(-5, 0), (5, 0)],
    "wedge": [(-4.6, 1.74), (-1, 0.3), (-0.75, 0.209), (-0.5, 0.145), (0, 0.11), (0.5, 0.145), (0.75, 0.209), (1, 0.3), (4.6, 1.74)],
    "top": [(-4.6, 1.74), (4.6, 1.74)],
    "angle": [(3.6, 0), (3.58, 0.35), (3.5, 0.7), (3.4, 0.98), (3.28, 1.2)],
    "a": [(0, -0.55), (0, -0.45), (1, -0.45), (1, 0.3)],
    "b": [(0, -1.2), (0, -1.1), (1.9, -1.1), (1.9, 0)],
    "P": [(0, 3.1), (0, 2), (-0.16, 2.25), (0, 2), (0.16, 2.25)],
    "Q": [(-1.9, -1.9), (-0.5, -1.9), (-0.75, -1.8), (-0.5, -1.9), (-0.75, -2)],
    "tension": [(-1.9, -0.4), (-2.9, -0.4), (-2.65, -0.3), (-2.9, -0.4), (-2.65, -0.5)],
}
LETTERS = {
    "theta": (4.05, 0.62), "a": (0.5, -0.68), "b": (0.95, -1.33), "P": (0.35, 2.75), "Q (f)": (-0.05, -1.9), "R = a/theta": (0, 0.75),
    "2: wedge, E2, nu2": (0, 1.4), "1: half-plane, E1, nu1, k": (2.9, -2.35), "tension, x = -b": (-3.3, -0.75),
}
# LibreOffice loses the names of curves that are in no cell when a sheet is inserted in front.
CURVES = ["P/(bk), f = 0, nu = 0.3", "its depth y/b", "P/(bk), your f and nu1", "your case", "your a/b, nu1", "b sigma/(fP)",
          "a/b = 1.0", "0.9", "0.8", "0.7", "0.6", "0.5", "0.4", "0.3", "0.2", "0.1"]


def limit_at_tip(node):
    """P/(bk) at a node of a/b, for the f and nu1 of the case."""
    tip = f"INDEX(rwt_tips,{node})"
    largest = f"MAX({at_row('rwt_surface', node)},{if_row(node, at_row('rwt_below', node))})"
    return f"IF(rwt_ok_f=1,(ASIN({tip})/{tip}+{cosine(tip)})/SQRT({largest}),NA())"


def limit_at_friction(node):
    """And at a node of f, for its a/b and nu1."""
    surface, below = (weigh(lambda nu, table=table: at_f(table, node, nu)) for table in ("rwt_surface", "rwt_below"))
    return (f"IF(AND(rwt_ok_f=1,rwt_ok_tip=1,rwt_a>0),(ASIN(rwt_n5)/rwt_n5+rwt_cos)"
            f"/SQRT(MAX({surface},IF({is_there(node)}=3,{below},0))),NA())")


class Working:
    def __init__(self, sheet, source, table, shown):
        self.sheet, self.source, self.table, self.shown = sheet, source, table, shown
        self.points = {}  # of a curve: the ranges of x and y
        sheet.text(0, 0, "Working cells: please do not edit", "heading")
        self.write_cells()
        self.write_nodes()
        self.write_case()
        self.write_sketch()
        self.write_bar()
        self.names = self.write_names()
        self.write_table()
        self.write_limits()
        field.write(sheet)
        sheet.sheet.hide()

    def range(self, column, rows, first=FIRST):
        return f"='{self.sheet.sheet.name}'!{xl_range_abs(first, column, first + rows - 1, column)}"

    def write_cells(self):
        """Those of the calculator, side by side: label, name, formula."""
        for column, cell in enumerate(CASE[len(SHOWN) - 2:]):
            self.sheet.texts(2, column, cell.label, cell.name, style="note")
            self.sheet.formula(4, column, cell.formula, None)
            self.sheet.name(cell.name, 4, column)
            if cell.name[:-1] in GROUPS and cell.name.endswith("1"):
                self.sheet.name(cell.name[:-1], 4, column, columns=3)

    def write_nodes(self):
        nodes = [("rwt_nu", NUS), ("rwt_ms", self.table.ms), ("rwt_f", FRICTIONS), ("rwt_ts", self.table.ts),
                 ("rwt_end", [self.table.end])]
        for column, (name, values) in enumerate(nodes):
            self.sheet.text(NOTES, column, name, "note")
            self.sheet.down(FIRST, column, values, name=name)
        self.sheet.block(FIRST + 2, 4, [[1, 1, 1]], name="rwt_ones")
        self.sheet.text(NOTES, 7, "rwt_count", "note")
        self.sheet.down(FIRST, 7, range(1, TIPS + 1), name="rwt_count")

    def write_case(self):
        """The curves of the case, and its marks: charts leave out what is #N/A."""
        sheet, tips, f, nu = self.sheet, self.table.tips, self.shown["f"], self.shown["nu1"]
        for column, note in enumerate(["a/b", "P/(bk)", "f", "P/(bk)", "a/b", "f", "P/(bk)", "b sigma/(fP)"], 8):
            sheet.text(NOTES, column, note, "note")
        sheet.down(FIRST, 8, [rounded(tip) for tip in tips], name="rwt_tips")
        sheet.down(FIRST, 10, FRICTIONS)
        for i, tip in enumerate(tips):
            sheet.formula(FIRST + i, 9, limit_at_tip(i + 1), self.source.number("elastic_limit", tip, f, nu))
        for i, friction in enumerate(FRICTIONS):
            sheet.formula(FIRST + i, 11, limit_at_friction(i + 1),
                          self.source.number("elastic_limit", self.shown["a_over_b"], friction, nu))
        sheet.formula(FIRST, 12, "IF(rwt_ok=1,rwt_n5,0)", self.shown["a_over_b"])
        sheet.formula(FIRST, 13, "rwt_fr", f)
        sheet.formula(FIRST, 14, f"IF(ISNUMBER({cell_of('P_over_bk').name}),rw_P_over_bk,NA())", self.shown["P_over_bk"])
        sheet.formula(FIRST, 15, "IF(rwt_ok=1,2*rwt_n5/(ASIN(rwt_n5)+rwt_n5*rwt_cos),NA())",
                      self.source.number("max_tension", self.shown["a_over_b"]))
        tip, friction, limit, tension = (self.range(column, 1) for column in (12, 13, 14, 15))
        self.points.update({
            "limit against a/b": (self.range(8, len(tips)), self.range(9, len(tips))), "its case": (tip, limit),
            "limit against f": (self.range(10, len(FRICTIONS)), self.range(11, len(FRICTIONS))), "f of the case": (friction, limit),
            "tension of the case": (tip, tension)})

    def write_sketch(self):
        """Two columns each, in the order of the pictures' parts."""
        parts = [("line", name, points) for name, points in SKETCH.items()]
        parts += [("letter", name, [point]) for name, point in LETTERS.items()]
        for i, (kind, name, points) in enumerate(parts):
            column = 16 + 2 * i
            self.sheet.text(NOTES, column, name, "note")
            self.sheet.block(FIRST, column, points)
            self.points[kind, name] = self.range(column, len(points)), self.range(column + 1, len(points))

    def write_bar(self):
        """From 0 to the factor, and from there to the end; then the line at 1. One column of heights is for a factor that is good,
        one for a bad one: what is not to be seen is above the picture."""
        sheet = self.sheet
        sheet.down(FIRST, 53, [0])
        sheet.formula(FIRST + 1, 53, 'IF(ISNUMBER(rw_yield_factor),MIN(3,rw_yield_factor),'
                      'IF(rw_safety="",0,IF(ISNUMBER(rw_safety),MIN(3,rw_safety),3)))', self.shown["yield_factor"])
        sheet.name("rwt_factor", FIRST + 1, 53)
        sheet.down(FIRST + 2, 53, [3, 1, 1])
        for row in (FIRST, FIRST + 1):
            sheet.formula(row, 54, "IF(rwt_factor<1,9,0)", 0)
            sheet.formula(row, 55, "IF(rwt_factor<1,0,9)", 9)
        sheet.down(FIRST, 56, [0, 0, 0, -0.45, 0.45])
        x, ground = self.range(53, 2), (self.range(53, 2, FIRST + 1), self.range(56, 2, FIRST + 1))
        self.points.update(bar_ground=ground, bar_good=(x, self.range(54, 2)), bar_bad=(x, self.range(55, 2)),
                           outline=(self.range(53, 2, FIRST + 3), self.range(56, 2, FIRST + 3)))

    def write_names(self):
        self.sheet.texts(FIRST, 52, *CURVES, style="note")
        return {name: f"='{self.sheet.sheet.name}'!$BA${FIRST + 1 + i}" for i, name in enumerate(CURVES)}

    def write_limits(self):
        """Tables that are shipped as files too, and the a/b of their rows, in the column of each."""
        row = TABLE_ROW + 240
        for name, table in (("rwt_shakedown", "shakedown-limit"), ("rwt_flat_limit", "flat-elastic-limit"),
                            ("rwt_flat_shakedown", "flat-shakedown-limit")):
            tips, values = limits(table)
            self.sheet.text(row, 0, f"P/(bk) of {table}: a row for each a/b, three blocks of nu, f across", "note")
            self.sheet.down(row + 1, 0, tips, name=name + "_tips")
            self.sheet.block(row + 1, 1, values, name=name)
            row += len(tips) + 2

    def write_table(self):
        notes = [("rwt_surface", "(A sqrt(J2)/theta)^2 on the surface: a row for each t, 16 blocks of nu, f across", self.table.surface),
                 ("rwt_below", "the same below the surface; empty: none there", self.table.below),
                 ("rwt_place", "the place, every other t: x/(a f) on the surface; x/(a f), then y/a, below it", self.table.places)]
        row = TABLE_ROW - 1
        for name, note, values in notes:
            self.sheet.text(row, 0, note, "note")
            self.sheet.block(row + 1, 0, values, name=name)
            row += len(values) + 2
