# SPDX-License-Identifier: GPL-3.0-or-later
"""The sheet Calculator: inputs, results, the verdict, and the figures of the paper with the case marked."""
from book import LINE_HEIGHT, Chart, axis
from cells import INPUTS, MATERIAL, YIELD_FACTOR, cell_of
from formulas import short

LABEL, CELL, VALUE, UNIT, HINT = range(5)
INPUT_GROUPS = [("Shape", "theta theta_deg a radius"), ("Materials", "material E1 nu1 E2 nu2 k yield_stress"), ("Loads", "P Q f")]
RESULT_GROUPS = [
    ("Safety", "yield_factor safety_strength safety"), ("Geometry", "b a_over_b AP_over_theta_b A dundurs_beta"),
    ("Pressure", "p0 p_transition p_mean"), ("Partial slip", "Q_over_fP c c_over_b"),
    ("Tension at the trailing edge x = -b", "max_tension max_tension_sliding"),
    ("First yield, in full sliding", "P_over_bk load_over_bk P_yield yield_branch yield_x yield_y f_critical von_mises_sliding"),
    ("Shakedown: sliding pass after pass, in full sliding", "P_over_bk_shakedown safety_strength_shakedown")]
INPUT_ROW, RESULT_ROW = 7, 25
OF_CALCULATOR = dict(material=MATERIAL, yield_factor=YIELD_FACTOR)
OTHER_STYLES = dict(yield_factor="strong", safety="strong", safety_strength="strong", safety_strength_shakedown="strong", dundurs_beta="signed", Q_over_fP="signed", yield_x="signed")
NOTES = [
    "Accuracy: geometry, pressure, slip and tension as exact as the spreadsheet computes; elastic limit within 0.05 %; load at yield "
    "and safety on load within 0.15 % (0.5 % where a/b at yield is 0.01 to 0.02, 2 % down to 0.003); critical friction within 0.001; "
    "place of yield within 0.02 a or b (0.35 a at the surface with nu1 above 0.4; 0.003 b where a/b at yield is below 0.02). For a/b "
    "from 0.003, f up to 0.8, nu1 from 0 to 0.5. Shakedown within 1 %, for a/b from 0.1, nu1 from 0.25 to 0.35: perfect plasticity, "
    "small strains, passes from far to far under the same P and f.",
    'Cylinder and flat pad: the sheet Pads. A moment M and a bulk tension sigma on a wedge are not here, as no plain formula holds '
    'them; the command "rwedge solve" has them. Plane strain; see "About".']

# ---- The verdict: the sentence of "rwedge solve --verdict", the figures, and what is doubtful ----

ELASTIC, YIELDS, IN_SLIDING = ("Elastic with a factor of ", "It yields: the stress is ", "the factor on P, in full sliding, is ")
ON_STRESS = (
    f'IF(rw_yield_factor<1,"{YIELDS}"&{short("(1/rw_yield_factor)", 3)}&" times what body 1 bears",'
    f'"{ELASTIC}"&{short("rw_yield_factor", 3)}&" on the stress")'
    f'&IF(ISNUMBER(rw_safety_strength),", a factor of "&{short("rw_safety_strength", 4)}&" if it slid","")')
ON_LOAD = (
    f'"{IN_SLIDING}"&IF(ISNUMBER(rw_safety),{short("rw_safety", 4)}&"; there it yields first at x = "&{short("rw_yield_x", 2)}'
    f'&", y = "&{short("rw_yield_y", 2)}&" mm, "&IF(rw_yield_y>0,"below","at")&" the surface",rw_safety)&"."')
STRENGTH = (
    'IF(OR(rwt_ok=0,rwt_slides=1),"No results: the status says why.",'
    'IF(rwt_has_k=0,"No yield stress is given, so nothing is known of its strength.",'
    'IF(rwt_a=0,"It yields: the stress at a sharp apex has no bound.",'
    f'IF(rw_yield_factor="","",{ON_STRESS}&"; ")&IF(rw_safety="","beyond that its strength is outside the tables of this workbook.",'
    f'{ON_LOAD}))))')
FIGURES = (
    f'IF(rwt_ok=0,"","b = "&{short("rw_b", 4)}&" mm, half-width of the contact"'
    f'&IF(rwt_a>0,";  p0 = "&{short("rw_p0", 4)}&" MPa, peak pressure","")'
    f'&IF(ISNUMBER(rw_c_over_b),";  c/b = "&{short("rw_c_over_b", 4)}&" of the contact sticks",""))')
STATUS = (
    'IF(rwt_any=0,"Type into the yellow cells.",IF(rwt_bad<>"","CHECK THE INPUTS: "&rwt_bad,'
    'IF(rwt_slides=1,"SLIDES: Q is above f P, there is no equilibrium.",'
    'IF(AND(ISNUMBER(rw_safety),N(rw_safety)<1),"YIELDS: P is above the load at first yield in full sliding. ","")'
    '&IF(rw_remarks<>"","CAUTION: "&rw_remarks,'
    'IF(rwt_has_k=0,"CAUTION: no yield stress is given, so there is no safety","OK")))))')
COLOURS = [("OK", "green"), ("CAUTION", "amber"), ("CHECK", "red"), ("YIELDS", "red"), ("SLIDES", "red")]


def strength_shown(shown):
    return (f"{ELASTIC}{shown['yield_factor']:.3g} on the stress, a factor of {shown['safety_strength']:.4g} if it slid; "
            f"{IN_SLIDING}{shown['safety']:.4g}; there it yields first at x = {shown['yield_x']:.2g}, y = {shown['yield_y']:.2g} mm, "
            f"{'below' if shown['yield_y'] > 0 else 'at'} the surface.")


def figures_shown(shown):
    return (f"b = {shown['b']:.4g} mm, half-width of the contact;  p0 = {shown['p0']:.4g} MPa, peak pressure;  "
            f"c/b = {shown['c_over_b']:.4g} of the contact sticks")


class Calculator:
    def __init__(self, sheet, working, shown):
        self.sheet, self.working, self.shown = sheet, working, shown
        sheet.text(0, 0, "Contact of a wedge with a rounded apex and a half-plane", "title")
        self.write_verdict()
        sheet.text(6, 0, "Type into the yellow cells. Any consistent units do; those shown are mm, N, MPa.", "note")
        self.write_groups(INPUT_ROW, INPUT_GROUPS)
        end = self.write_notes(self.write_groups(RESULT_ROW, RESULT_GROUPS))
        self.below = f"A{end + 2}"
        sheet.widths(A=34, B=20, C=13, D=7, E=40)
        self.draw_bar()
        self.draw_sketch()
        self.draw_figures()
        sheet.sheet.freeze_panes(4, 0)
        sheet.protect()
        sheet.print(f"A1:E{end}")

    # ---- Cells ----

    def write_verdict(self):
        lines = [(1, 3, "verdict", STRENGTH, "rw_verdict", strength_shown(self.shown)),
                 (3, 1, "verdict", FIGURES, None, figures_shown(self.shown)), (4, 3, "wrapped", STATUS, "rw_status", "OK")]
        self.sheet.sheet.set_row(2, 3 * LINE_HEIGHT)
        for row, height, style, formula, name, value in lines:
            self.sheet.sheet.set_row(row, height * LINE_HEIGHT)
            self.sheet.sheet.merge_range(row, 0, row, 4, "", self.sheet.book.styles[style])
            self.sheet.formula(row, 0, formula, value, style)
            if name:
                self.sheet.name(name, row, 0)
            for begins, colour in COLOURS:
                self.sheet.colour(f"A{row + 1}:E{row + 1}", colour, f'LEFT($A$5,{len(begins)})="{begins}"')
        self.sheet.text(5, 0, "rw_verdict, rw_status. The first factor is of the loads as they are, the second of full sliding, Q = f P.", "note")

    def write_groups(self, row, groups):
        """Returns the row below."""
        for heading, columns in groups:
            self.sheet.text(row, 0, heading, "heading")
            for row, column in enumerate(columns.split(), row + 1):
                self.write_cell(row, OF_CALCULATOR.get(column) or cell_of(column))
            row += 1
        return row

    def write_notes(self, row):
        """Returns the row below."""
        for note in NOTES:
            self.sheet.sheet.set_row(row, LINE_HEIGHT * (1 + len(note) // 120))
            self.sheet.sheet.merge_range(row, 0, row, 4, "", self.sheet.book.styles["wrapped_note"])
            self.sheet.text(row, 0, note, "wrapped_note")
            row += 1
        return row

    def write_cell(self, row, cell):
        """Label, name, value, unit and hint, side by side."""
        sheet, value = self.sheet, self.shown.get(cell.column)
        sheet.text(row, LABEL, cell.label)
        sheet.text(row, CELL, cell.name, "note")
        if cell.unit:
            sheet.text(row, UNIT, cell.unit, "unit")
        if cell.hint:
            sheet.text(row, HINT, cell.hint, "note")
        sheet.name(cell.name, row, VALUE)
        if cell is MATERIAL:
            sheet.number(row, VALUE, None, "input")
            sheet.sheet.data_validation(f"C{row + 1}", dict(validate="list", source="=rw_material_names", input_title="Material",
                                                            input_message=cell.hint, error_message=f"This must be {cell.must}."))
            return
        if cell not in INPUTS:
            sheet.formula(row, VALUE, cell.formula, value, OTHER_STYLES.get(cell.column, "result"))
            return
        sheet.number(row, VALUE, value, "input")
        sheet.rule(f"C{row + 1}", f"NOT({cell.wrong})", cell.label, cell.hint, f"{cell.column} must be {cell.must}.")

    # ---- Pictures ----

    def draw_bar(self):
        number_format = '[=1]"1: yields";[=3]"3 and more";0'
        bar = Chart(self.sheet, "A3", (800, 58), (4, 1), axis(0, 3, 1, number_format=number_format), axis(-0.6, 0.6))
        for line in ("bar_ground", "bar_good", "bar_bad", "outline"):
            bar.add(*self.working.points[line], line)

    def draw_sketch(self):
        sketch = Chart(self.sheet, "F7", (440, 330), (8, 0), axis(-5, 5, 1), axis(-2.6, 3.3))
        for key, points in self.working.points.items():
            if key[0] == "line":
                sketch.add(*points, "outline")
            elif key[0] == "letter":
                sketch.label(*points, key[1])

    def draw_figures(self):
        points, names = self.working.points, self.working.names
        below, size = self.below, (400, 440)
        # Figs. 3 and 4 take their curves from the sheet Elastic limit: f = 0 against a/b, and a/b = 1 to 0.1 against f
        law = Chart(self.sheet, below, size, (0, 0), axis(0, 1, 0.2, "a/b"), axis(0, 7, title="P/(bk); y/b"),
                    "Fig. 3: elastic limit against a/b")
        tips = "='Elastic limit'!$M$5:$M$104"
        law.add(tips, "='Elastic limit'!$N$5:$N$104", "family", name=names["P/(bk), f = 0, nu = 0.3"])
        law.add(tips, "='Elastic limit'!$O$5:$O$104", "dashed", name=names["its depth y/b"])
        law.add(*points["limit against a/b"], "thick", name=names["P/(bk), your f and nu1"])
        law.mark(*points["its case"], names["your case"])

        friction = Chart(self.sheet, below, size, (408, 0), axis(0, 0.8, 0.1, "f"), axis(0, 6, title="P/(bk)"),
                         "Fig. 4: elastic limit against friction (nu = 0.3)")
        for column, name in zip("KJIHGFEDCB", ["a/b = 1.0", "0.9", "0.8", "0.7", "0.6", "0.5", "0.4", "0.3", "0.2", "0.1"]):
            friction.add("='Elastic limit'!$A$5:$A$69", f"='Elastic limit'!${column}$5:${column}$69", "family", name=names[name])
        friction.add(*points["limit against f"], "thick", name=names["your a/b, nu1"])
        friction.mark(*points["f of the case"], names["your case"])

        tension = Chart(self.sheet, below, size, (816, 0), axis(0, 1, 0.2, "a/b"), axis(0.95, 1.3, title="b sigma/(fP)"),
                        "Fig. 6: maximum tension at the trailing edge")
        tension.add("='Maximum tension'!$A$5:$A$105", "='Maximum tension'!$B$5:$B$105", "family", name=names["b sigma/(fP)"])
        tension.mark(*points["tension of the case"], names["your case"])
