# SPDX-License-Identifier: GPL-3.0-or-later
"""Has LibreOffice recalculate the workbook: the results in the file are those of its formulas, and its results for random
inputs, on the sheet Calculator and in the rows of Batch, are the library's. Working cells have no value in the file.

    workbook_recalculate.py RWEDGE FOLDER WORKBOOK

One LibreOffice opens the workbook once, and computes first with a decimal point, then with a comma. Standard library only, and
LibreOffice's module uno."""
import csv
import math
import os
import random
import re
import subprocess
import sys
import xml.etree.ElementTree as ET
import zipfile

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "support"))

from office import Office, settings  # noqa: E402
from com.sun.star.sheet import FormulaResult  # noqa: E402

RWEDGE, FOLDER, WORKBOOK = sys.argv[1:]
INPUTS = ["E1", "nu1", "E2", "nu2", "theta", "theta_deg", "a", "radius", "P", "Q", "f", "k", "yield_stress"]
# The column of "rwedge solve" and of Batch, the name in Calculator, the tolerance: relative, absolute.
EXACT = [
    ("A", "rw_compliance"), ("b", "rw_b"), ("a_over_b", "rw_a_over_b"), ("AP_over_theta_b", "rw_load_number"),
    ("p0", "rw_p0"), ("p_transition", "rw_p_transition"), ("Q_over_fP", "rw_Q_over_fP"), ("c", "rw_c"),
    ("c_over_b", "rw_c_over_b"), ("max_tension", "rw_tension"), ("max_tension_sliding", "rw_max_tension"),
    ("load_over_bk", "rw_load_over_bk"),
]
RESULTS = [(column, name, 1e-11, 0) for column, name in EXACT] + [
    ("dundurs_beta", "rw_beta", 1e-12, 1e-13), ("von_mises_sliding", "rw_von_mises", 5e-4, 0),
    ("P_over_bk", "rw_P_over_bk", 5e-4, 0), ("f_critical", "rw_f_critical", 0, 1e-3),
    ("P_yield", "rw_P_yield", 1.5e-3, 0), ("safety", "rw_safety", 1.5e-3, 0),
    ("yield_x", "rw_yield_x", 0, 2e-2), ("yield_y", "rw_yield_y", 0, 2e-2), # in a
]
AFTER_YIELD = ("P_yield", "safety", "yield_x", "yield_y")
TIP_MIN = 0.003
MAIN = "{http://schemas.openxmlformats.org/spreadsheetml/2006/main}"
FIRST_ROW, ROWS = 1, 200  # of Batch, from 0
failures = 0


def same(what, good, detail):
    global failures
    if not good:
        failures += 1
        if failures <= 20:
            print("FAILED: %s: %s" % (what, detail))


# ---- LibreOffice ----


def speak(office, locale):
    provider = office.service("com.sun.star.configuration.ConfigurationProvider")
    access = provider.createInstanceWithArguments("com.sun.star.configuration.ConfigurationUpdateAccess",
                                                  settings(nodepath="/org.openoffice.Setup/L10N"))
    access.setPropertyValue("ooSetupSystemLocale", locale)
    access.commitChanges()


def value_of(cell):
    if cell.getError() != 0:
        return "error %d" % cell.getError()
    return cell.String if cell.FormulaResultType2 == FormulaResult.STRING else cell.Value


def check_no_errors(sheet):
    errors = sheet.queryFormulaCells(FormulaResult.ERROR)
    same("no error on " + sheet.Name, errors.Count == 0, errors.RangeAddressesAsString)


def range_named(document, name):
    match = re.fullmatch(r"\$?'?([^'.]+)'?\.(.*)", document.NamedRanges.getByName(name).Content)
    return document.Sheets.getByName(match[1]).getCellRangeByName(match[2].replace("$", ""))


# ---- The file ----


NUMBER = re.compile(r"-?\d+(?:[.,]\d+)?(?:E-\d+)?")


def numbers_in(text):
    return [float(number.replace(",", ".")) for number in NUMBER.findall(text)]


def alike(text, other):
    """The same words; numbers within what the place of first yield errs by."""
    return NUMBER.sub("", text) == NUMBER.sub("", other) and all(
        abs(a - b) <= 2e-3 * (abs(a) + 1) for a, b in zip(numbers_in(text), numbers_in(other)))


def check_stored(document):
    """The library's results in the file are those of the formulas, within the table's error."""
    archive, count, wrong = zipfile.ZipFile(WORKBOOK), 0, []
    for number, name in enumerate(document.Sheets.ElementNames, 1):
        sheet = document.Sheets.getByName(name)
        check_no_errors(sheet)
        for cell in ET.fromstring(archive.read("xl/worksheets/sheet%d.xml" % number)).iter(MAIN + "c"):
            stored = cell.findtext(MAIN + "v") or ""
            if cell.find(MAIN + "f") is None or stored == "":
                continue  # what is not stored is computed on opening
            count += 1
            got = value_of(sheet.getCellRangeByName(cell.get("r")))
            if cell.get("t") == "str":
                good = isinstance(got, str) and alike(got, stored)
            else:
                good = not isinstance(got, str) and abs(got - float(stored)) <= 2e-3 * abs(got) + 1e-13
            if not good:
                wrong.append((name, cell.get("r"), stored, got))
    print("%d values of formulas are stored" % count)
    same("values are stored as they are computed", not wrong and count > 100, wrong[:5])


def check_first_input(document, calculator):
    """What is typed first changes all that depends on it, though the working cells have no value in the file."""
    strength = calculator.cell("rw_k").Value
    calculator.cell("rw_k").Value = 500
    first = {name: calculator.result(name) for _, name, _, _ in RESULTS}
    document.calculateAll()
    document.calculateAll()  # once alone left out a cell of those without a value in the file
    same("after the first input", first == {name: calculator.result(name) for _, name, _, _ in RESULTS}, first)
    calculator.cell("rw_k").Value = strength


def check_file(path):
    """What spreadsheet programs would repair, or do not know."""
    archive = zipfile.ZipFile(path)
    book = ET.fromstring(archive.read("xl/workbook.xml"))
    names = [name for name in book.iter(MAIN + "definedName") if name.get("localSheetId") is None]
    lower = [name.get("name").lower() for name in names]
    same("names that differ in more than capitals", len(lower) == len(set(lower)) > 100, len(lower))
    same("names that are no cells", not [name for name in lower if re.fullmatch(r"[a-z]{1,3}[0-9]+", name)], lower)
    same("working names are hidden", all((name.get("hidden") == "1") == name.get("name").startswith("rwt_") for name in names),
         [name.get("name") for name in names])
    known = {"ABS", "ACOS", "AND", "ASIN", "ATAN", "ATAN2", "COS", "COSH", "COUNT", "COUNTA", "FORECAST", "IF", "IFERROR", "INDEX", "INT", "ISNUMBER", "ISTEXT", "LN", "LOG10",
             "MATCH", "MAX", "MID", "MIN", "MMULT", "N", "NA", "NOT", "OR", "PI", "ROUND", "ROUNDDOWN", "ROW", "SEARCH", "SIN", "SQRT", "SUMPRODUCT", "TANH"}
    sheets = [(sheet.get("name"), sheet.get("state")) for sheet in book.iter(MAIN + "sheet")]
    longest = 0
    for number in range(1, len(sheets) + 1):
        root = ET.fromstring(archive.read("xl/worksheets/sheet%d.xml" % number))
        formulas = [cell.text for cell in root.iter(MAIN + "f")]
        used = set(re.findall(r"([A-Z][A-Z0-9.]*)\(", re.sub(r'"[^"]*"', "", " ".join(formulas))))
        same("functions that every spreadsheet has", used <= known, used - known)
        longest = max([longest] + [len(formula) for formula in formulas])
    same("formulas that Excel takes", 0 < longest <= 8192, longest)
    same("sheets", sheets[:2] == [("Calculator", None), ("Batch", None)] and sheets[-1] == ("Working", "hidden"), sheets)
    area = [name.text for name in book.iter(MAIN + "definedName") if name.text.startswith("Batch!$A$1:INDEX(")]
    same("Batch prints its used rows", len(area) == 1 and area[0].endswith(",rwt_used)"), area)


# ---- Cases ----


def contact_load(tip):
    """AP/(theta a)"""
    if tip >= 1:
        return math.pi / 2 / tip**2
    return (math.asin(tip) + tip * math.sqrt(1 - tip * tip)) / tip**2


def random_case(draw, i):
    """Every fourth at a node or an edge of the table; every fifth sharp, or beyond the table."""
    nu = draw.choice([0, 0.175, 0.2, 0.25, 0.3, 0.35, 0.45, 0.475, 0.5]) if i % 4 == 0 else draw.uniform(0, 0.5)
    f = [0, draw.uniform(0, 0.8), draw.uniform(0, 0.4), draw.uniform(0.1, 0.35), 0.8 * draw.randint(0, 8) / 8][i % 5]
    E1, E2, nu2 = 10**draw.uniform(3, 6), 10**draw.uniform(3, 6), draw.uniform(0, 0.5)
    theta, a = 10**draw.uniform(-3, -0.5), 10**draw.uniform(-3, 1)
    case = dict(E1=E1, nu1=nu, E2=E2, nu2=nu2)
    if i % 3 == 0:
        del case["E2"], case["nu2"]
        E2, nu2 = E1, nu
    A = 2 * (1 - nu**2) / E1 + 2 * (1 - nu2**2) / E2
    tip = [10**draw.uniform(-2.4, 0.3), draw.uniform(0.02, 1.1), draw.choice([0.003, 0.00301, 0.999, 1, 1.001])][
        0 if i % 2 else 1 if i % 8 else 2]
    P = contact_load(tip) * theta * a / A
    k = theta / A * 10**draw.uniform(-1.3, 0.3)
    case.update(P=P, Q=draw.choice([0, -0.999, 0.999, 0.5, draw.uniform(-1, 1)]) * f * P, f=f)
    if i % 20 == 7:
        a = 0.0
    if i % 20 == 9:
        case["P"] *= 1e4
    case.update(dict(theta_deg=math.degrees(theta), radius=a / theta) if i % 7 == 0 else dict(theta=theta, a=a))
    case.update(dict(yield_stress=k * math.sqrt(3)) if i % 7 == 3 else {} if i % 7 == 5 else dict(k=k))
    return case


def late_case(draw, i):
    """It yields near the table's end, where the branch below the surface has gaps; the first was 34 % too high."""
    if i == 0:
        return dict(E1=210000.0, nu1=0.45, theta=0.02, a=0.05, P=10361.4, f=0.339936, k=2180.89)
    E1, nu, theta, a = 10**draw.uniform(3, 6), draw.uniform(0.33, 0.5), 10**draw.uniform(-3, -1), 10**draw.uniform(-3, 1)
    A = 4 * (1 - nu**2) / E1
    P = contact_load(10**draw.uniform(-2.4, 0)) * theta * a / A
    return dict(E1=E1, nu1=nu, theta=theta, a=a, P=P, f=draw.uniform(0.27, 0.38), k=theta / A * draw.uniform(1.3, 1.9))


def solve(case, *options):
    """The results of "rwedge solve", as texts; None where it refuses."""
    inputs = ["--similar"] + ["--%s=%r" % (name.replace("_", "-"), value) for name, value in case.items()] + list(options)
    done = subprocess.run([RWEDGE, "solve", "--layout", "row"] + inputs, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL,
                          universal_newlines=True)
    return next(csv.DictReader(done.stdout.splitlines()), None)


def table(name, **values):
    """The first row of a table of the tool."""
    inputs = ["--%s=%s" % (option.replace("_", "-"), value) for option, value in values.items()]
    done = subprocess.run([RWEDGE, "table", name] + inputs, stdout=subprocess.PIPE, universal_newlines=True)
    return next(csv.DictReader(done.stdout.splitlines()))


def yield_tip(case, row):
    """a/b under the load at yield."""
    return float(solve(dict(case, P=float(row["P_yield"]), Q=0.0))["a_over_b"])


class Calculator:
    def __init__(self, document):
        self.document, self.entered = document, {}
        document.Sheets.getByName("Calculator").unprotect("")

    def cell(self, name):
        return range_named(self.document, name)

    def enter(self, case):
        """What changes: each input has all computed again."""
        for name in INPUTS:
            value = case.get(name)
            if value == self.entered.get(name, self):
                continue
            if value is None or isinstance(value, str):
                self.cell("rw_" + name).String = value or ""
            else:
                self.cell("rw_" + name).Value = value
        self.entered = {name: case.get(name) for name in INPUTS}

    def result(self, name):
        return value_of(self.cell(name))


class Batch:
    def __init__(self, document):
        self.document = document
        self.sheet = document.Sheets.getByName("Batch")
        self.sheet.unprotect("")
        header = self.sheet.getCellRangeByPosition(0, 0, 60, 0).getDataArray()[0]
        self.columns = {name: i for i, name in enumerate(header) if name}
        same("inputs of Batch", list(header[1:14]) == INPUTS, header)

    def enter(self, cases):
        """All rows: those without a case are emptied."""
        rows = [tuple("" if case.get(name) is None else case[name] for name in INPUTS) for case in cases]
        rows += [("",) * len(INPUTS)] * (ROWS - len(rows))
        self.sheet.getCellRangeByPosition(1, FIRST_ROW, len(INPUTS), FIRST_ROW + ROWS - 1).setDataArray(tuple(rows))
        self.read()

    def read(self):
        last = max(self.columns.values())
        self.data = self.sheet.getCellRangeByPosition(0, FIRST_ROW, last, FIRST_ROW + ROWS).getDataArray()
        check_no_errors(self.sheet)

    def last_printed(self):
        """Of the formula that is the sheet's print area."""
        return range_named(self.document, "rwt_used").getDataArray()[0][0]

    def result(self, row, column):
        return self.data[row][self.columns[column]]


def expected(case, row, column, at_yield):
    """What the workbook must show: a number with its tolerances, None for nothing, or a text that it begins with."""
    sharp, a_over_b = float(row["a_over_b"]) == 0, float(row["a_over_b"])
    has_k = "k" in case or "yield_stress" in case
    if column in ("P_over_bk", "f_critical", "von_mises_sliding") and not sharp and a_over_b < TIP_MIN * (1 - 1e-9):
        return None
    if column in ("f_critical", "von_mises_sliding") and sharp:
        return None
    if column in AFTER_YIELD and has_k and at_yield < 0.97 * TIP_MIN and not sharp:
        return "> " if column == "safety" and a_over_b >= TIP_MIN else None  # a bound below 1 says nothing
    if row[column] in ("", "inf"):
        return None
    return float(row[column])


def rounding(case):
    theta = case.get("theta", math.radians(case.get("theta_deg", 0)))
    return case.get("a", case.get("radius", 0) * theta)


def check_result(case, row, at_yield, column, relative, absolute, got, branch, worst):
    if column in AFTER_YIELD and 0.97 * TIP_MIN <= at_yield <= 1.03 * TIP_MIN:
        return  # at the end of the table it may be either
    if column in ("P_yield", "safety"):
        relative = 2e-2 if at_yield < 0.01 else 5e-3 if at_yield < 0.02 else relative
    if column == "p_transition" and abs(float(row["a_over_b"]) - 1) < 1e-9:
        absolute = 1e-7 * float(row["p0"])  # it goes like the root of 1 - a/b
    unit = 1
    if column in ("yield_x", "yield_y"):
        # next to a cusp the branch may be the other one, with another place
        if branch and branch != row["yield_branch"]:
            return
        unit = rounding(case) * min(1, 1 / at_yield) or 1 if at_yield else 1
        flat = branch == "surface" and case["nu1"] > 0.4
        absolute = (3e-3 / at_yield if 0 < at_yield < 0.02 else 0.35 if flat else absolute) * unit
    want = expected(case, row, column, at_yield)
    if want is None:
        good = got == ""
    elif isinstance(want, str):
        bound = float(got[2:].replace(",", ".")) if isinstance(got, str) and got.startswith("> ") else math.inf
        good = bound <= float(row["safety"].lstrip("> "))
    else:
        good = not isinstance(got, str) and abs(got - want) <= relative * abs(want) + absolute
        if good:
            worst[column] = max(worst.get(column, 0), abs(got - want) / (unit if absolute else abs(want) or 1))
    same("Batch, " + column, good, "expected %r, got %r, for %r" % (want, got, case))


def check_strength(case, row, got):
    """The safety on strength is that of P_over_bk."""
    if row["P_over_bk"] and row["load_over_bk"] and TIP_MIN * (1 + 1e-9) <= float(row["a_over_b"]):
        want = float(row["P_over_bk"]) / float(row["load_over_bk"])
        same("safety on strength", not isinstance(got, str) and abs(got / want - 1) <= 5e-4, (want, got, case))


def check_shakedown(case, row, limit, strength):
    """The limit is the library's within 1 %, where the shipped tables have it; the safety on strength is that of the limit."""
    tip = float(row["a_over_b"])
    if not (0.25 <= case["nu1"] <= 0.35 and case["f"] <= 0.8 and tip >= 0.1):
        same("no shakedown outside the tables", limit == "" == strength, (limit, case))
        return 0
    want = float(table("shakedown-limit", a_over_b=min(1, tip), friction=case["f"], nu=case["nu1"])["P_over_bk"])
    same("the shakedown limit", not isinstance(limit, str) and abs(limit / want - 1) <= 1e-2, (want, limit, case))
    if row["load_over_bk"]:
        factor = limit / float(row["load_over_bk"])
        same("safety on strength, pass after pass", abs(strength / factor - 1) <= 1e-10, (factor, strength, case))
    return abs(limit / want - 1)


def check_warnings(case, row, got):
    """The library's words; those of the tables' ends are the workbook's own."""
    ours = [text for text in got.split("; ") if text and "outside the tables" not in text]
    theirs = [text for text in row["warnings"].split("; ") if text and "1e14" not in text]
    same("warnings", ours == theirs, (theirs, ours, case))


def check_factor(case, row, got):
    """Under the given Q: the largest stress at many places, so never below the library's, and within 2 %."""
    if not row["load_over_bk"] or not float(row["a_over_b"]) >= TIP_MIN * (1 + 1e-9):
        same("no factor", got == "" or row["load_over_bk"] and float(row["a_over_b"]) > 0.99 * TIP_MIN, (got, case))
        return 0
    want = float(solve(case, "--yield-factor")["yield_factor"])
    same("the factor under this Q", not isinstance(got, str) and -1e-9 <= got / want - 1 <= 2e-2, (want, got, case))
    return got / want - 1


def check_sentence(case, row, got, factor):
    """It begins with the factor under this Q, and tells that on P."""
    if "k" not in case and "yield_stress" not in case:
        good = got.startswith("No yield stress is given")
    elif float(row["a_over_b"]) == 0:
        good = got == "It yields: the stress at a sharp apex has no bound."
    elif "outside the tables" in got:
        good = min(float(row["a_over_b"]), yield_tip(case, row)) < 1.03 * TIP_MIN
    else:
        safety, said = float(row["safety"].lstrip("> ")), numbers_in(got.split("in full sliding, is ")[1])[0]
        good = said <= safety if "is > " in got else abs(said / safety - 1) <= 2e-3
    if factor != "":
        first = numbers_in(got)[0]
        good = good and got.startswith("It yields: the stress is" if factor < 1 else "Elastic with a factor of") and abs(
            (1 / first if factor < 1 else first) / factor - 1) <= 6e-3
    same("the sentence", good, (got, row["safety"], factor, case))


def check_cases(calculator, batch, new_case, count, beside):
    """Random cases in Batch, and the first of them in Calculator too."""
    draw = random.Random(2026)
    cases = [new_case(draw, i) for i in range(count)]
    rows = [solve(case) for case in cases]
    batch.enter(cases)
    worst = {}
    for i, (case, row) in enumerate(zip(cases, rows)):
        same("error", batch.result(i, "error") == "", (batch.result(i, "error"), case))
        at_yield = yield_tip(case, row) if row["P_yield"] not in ("", "0") else 0
        for column, name, relative, absolute in RESULTS:
            check_result(case, row, at_yield, column, relative, absolute, batch.result(i, column), batch.result(i, "yield_branch"), worst)
        check_strength(case, row, batch.result(i, "safety_strength"))
        worst["shakedown"] = max(worst.get("shakedown", 0), check_shakedown(
            case, row, batch.result(i, "P_over_bk_shakedown"), batch.result(i, "safety_strength_shakedown")))
        check_warnings(case, row, batch.result(i, "warnings"))
        if i < beside:
            calculator.enter(case)
            for column, name, _, _ in RESULTS + [("safety_strength", "rw_safety_strength", 0, 0),
                                                 ("warnings", "rw_remarks", 0, 0), ("yield_branch", "rw_branch", 0, 0)]:
                here, there = calculator.result(name), batch.result(i, column)
                same("Calculator and Batch, " + column, here == there, (here, there, case))
            factor = calculator.result("rw_yield_factor")
            worst["yield_factor"] = max(worst.get("yield_factor", 0), check_factor(case, row, factor))
            check_sentence(case, row, calculator.result("rw_verdict"), factor)
    same("rows that are printed", batch.last_printed() == count + FIRST_ROW, (batch.last_printed(), count))
    same("rows without a case", batch.result(ROWS - 1, "error") == "" == batch.result(ROWS - 1, "b"), batch.result(ROWS - 1, "b"))
    print("%d cases; largest errors: %s" % (count, ", ".join("%s %.1e" % item for item in sorted(worst.items()))))


# ---- Messages ----

GOOD = dict(theta=0.01, a=0.05, E1=2.1e5, nu1=0.3, E2=2.1e5, nu2=0.3, P=190.0, Q=20.0, f=0.2, k=400.0)
# What is changed, what the status begins with and has in it, what the row's error or warnings have in them.
MESSAGES = [
    (dict(), "OK", "", ""),
    (dict(k=None), "CAUTION: no yield stress", "", ""),
    (dict(theta=None), "CHECK THE INPUTS", "theta or theta_deg is missing", "error"),
    (dict(theta="0.o1"), "CHECK THE INPUTS", "theta must be a number above 0, below pi/2", "error"),
    (dict(theta_deg=2.0), "CHECK THE INPUTS", "theta and theta_deg: give one of the two", "error"),
    (dict(theta=None, theta_deg=90.0), "CHECK THE INPUTS", "theta_deg must be a number above 0, below 90", "error"),
    (dict(a=-1.0), "CHECK THE INPUTS", "a must be a number, 0 or above", "error"),
    (dict(E1=-1.0), "CHECK THE INPUTS", "E1 must be a number above 0", "error"),
    (dict(E2=None), "CHECK THE INPUTS", "E2 and nu2: give both, or neither", "error"),
    (dict(E2="soft"), "CHECK THE INPUTS", "E2 must be a number above 0, or inf for a rigid wedge", "error"),
    (dict(nu1=0.51), "CHECK THE INPUTS", "nu1 must be a number from 0 to 0.5", "error"),
    (dict(P=0.0), "CHECK THE INPUTS", "P must be a number above 0", "error"),
    (dict(Q="much"), "CHECK THE INPUTS", "Q must be a number", "error"),
    (dict(f=-0.1), "CHECK THE INPUTS", "f must be a number, 0 or above", "error"),
    (dict(yield_stress=500.0), "CHECK THE INPUTS", "k and yield_stress: give one of the two", "error"),
    (dict(P=-1.0, f=None, nu2=2.0), "CHECK THE INPUTS", "nu2 must be a number from 0 to 0.5; P must be a number above 0; f is missing",
     "error"),
    (dict(P=600.0, f=0.5), "YIELDS: P is above", "", "warnings"),
    (dict(Q=39.0), "SLIDES: Q is above f P", "", "error"),
    (dict(f=0.81), "CAUTION: ", "f is above 0.8, outside the tables: no yield", "warnings"),
    (dict(P=3e5, k=None), "CAUTION: ", "a/b is below 0.003, outside the tables: no elastic limit", "warnings"),
    (dict(P=3e4, k=15000.0), "CAUTION: ", "yield is outside the tables", "warnings"),
    (dict(theta=0.2, k=8000.0), "CAUTION: ", "theta is above 0.1 rad", "warnings"),
    (dict(E2=1e6, P=60.0, Q=0.0), "CAUTION: ", "Dundurs' beta is not 0", "warnings"),
    (dict(E1=210.0, E2=210.0), "CAUTION: ", "k/E is below 0.00001 or above 0.1", "warnings"),
    (dict(P=1e-7, Q=None), "CAUTION: ", "a/b is below 0.01 or above 10000", "warnings"),
]


def check_messages(document, calculator, batch):
    cases = [dict(GOOD, **change) for change, *_ in MESSAGES]
    batch.enter(cases)
    for i, (change, begins, contains, column) in enumerate(MESSAGES):
        calculator.enter(cases[i])
        status = calculator.result("rw_status")
        same("status for %r" % change, status.startswith(begins) and contains in status, status)
        row = {name: batch.result(i, name) for name in ("error", "warnings", "b")}
        if column:
            same("row for %r" % change, row[column] != "" and contains in row[column], row)
        refused = begins.startswith("CHECK")
        same("results for %r" % change, (row["b"] == "") == refused, row)
        same("no list that goes on, %r" % change, not (status + row["error"] + row["warnings"]).endswith(("; ", " ")), (status, row))
        if begins.startswith("SLIDES"):
            same("no safety where it slides, %r" % change, calculator.result("rw_safety") == "", calculator.result("rw_safety"))
        same("an error for %r" % change, (row["error"] != "") == (column == "error"), row)
        check_no_errors(document.Sheets.getByName("Calculator"))
    calculator.enter({})
    same("status without inputs", calculator.result("rw_status") == "Type into the yellow cells.", calculator.result("rw_status"))
    calculator.enter(dict(GOOD, E2="inf", nu2=None))
    rigid = solve(dict(GOOD, E2=1e30))
    same("a rigid wedge", abs(calculator.result("rw_b") / float(rigid["b"]) - 1) < 1e-12, calculator.result("rw_b"))
    calculator.enter(dict(GOOD, E1=7.2e4, Q=-20.0))
    shown = [calculator.cell(name).String for name in ("rw_beta", "rw_Q_over_fP", "rw_yield_x")]
    same("a minus", all(text.startswith("-") for text in shown), shown)
    calculator.enter(dict(GOOD, a=0.0))
    same("a sharp wedge", (calculator.result("rw_safety"), calculator.result("rw_P_yield"), calculator.result("rw_p0")) ==
         (0, 0, ""), calculator.result("rw_safety"))
    same("its status", calculator.result("rw_status").startswith("YIELDS"), calculator.result("rw_status"))
    print("%d messages" % len(MESSAGES))


def check_fill_down(batch):
    """A row copied below the last computes as well."""
    sheet = batch.sheet
    last = sheet.getCellRangeByPosition(0, FIRST_ROW + ROWS - 1, 200, FIRST_ROW + ROWS - 1)
    sheet.copyRange(sheet.getCellByPosition(0, FIRST_ROW + ROWS).CellAddress, last.RangeAddress)
    for j, name in enumerate(INPUTS):
        if name in GOOD:
            sheet.getCellByPosition(1 + j, FIRST_ROW + ROWS).Value = GOOD[name]
    batch.read()
    good = solve(GOOD)
    same("a row filled down", abs(batch.result(ROWS, "b") / float(good["b"]) - 1) < 1e-12, batch.result(ROWS, "b"))


# ---- Materials, and the sheet Pads ----


def check_materials(calculator):
    """A name stands for what the material has; both are refused."""
    material = calculator.cell("rw_material")
    case = dict(theta=0.01, a=0.05, P=190.0, Q=20.0, f=0.2, yield_stress=600.0)
    calculator.enter(case)
    same("without a material", "E1 is missing" in calculator.result("rw_status"), calculator.result("rw_status"))
    material.String = "sae-1015-normalized"
    want = solve(dict(case, E1=206800.0, nu1=0.3))
    for column, name in EXACT:
        got = calculator.result(name)
        same("of a material, " + column, got == "" if want[column] == "" else abs(got - float(want[column])) <= 1e-11 * abs(got), got)
    calculator.enter(dict(case, E1=2.1e5))
    same("both", "material and E1: give one of the two" in calculator.result("rw_status"), calculator.result("rw_status"))
    material.String = "rqc-100"  # has a yield stress, and no E
    calculator.enter(dict(case, E1=2.1e5, nu1=0.3, yield_stress=None))
    want = solve(dict(case, E1=2.1e5, nu1=0.3, yield_stress=683.0))
    same("its yield stress", abs(calculator.result("rw_load_over_bk") / float(want["load_over_bk"]) - 1) < 1e-11,
         (calculator.result("rw_status"), calculator.result("rw_load_over_bk"), want["load_over_bk"]))
    material.String = "cheese"
    same("no material", "none of that name" in calculator.result("rw_status"), calculator.result("rw_status"))
    material.String = ""


PAD_COLUMNS = ["b", "left", "right", "tilt", "p0", "c", "stick_left", "stick_right", "max_tension", "load_over_bk"]
PAD_NAMES = dict(max_tension="tension")


def check_pad(calculator, case, pad, names, tolerances):
    """The results of "rwedge solve" for a pad; what has no closed form is empty, and the status says so."""
    inputs = dict(case, **pad)
    row = solve(dict(inputs, M=pad.get("M", 0.0)), "--exact")
    if row is None:
        same("no closed form, " + names, "no closed form" in calculator.result("rw_%s_status" % names), inputs)
        same("no stick zone, " + names, calculator.result("rw_%s_c" % names) == "", inputs)
        return
    for column in PAD_COLUMNS:
        got, want = calculator.result("rw_%s_%s" % (names, PAD_NAMES.get(column, column))), row.get(column, "")
        if (names == "flat" and column == "tilt") or (column.startswith("stick") and want == ""):
            continue  # where it slides there is no zone
        scale = float(row["b"]) if column in ("left", "right", "stick_left", "stick_right") else abs(float(want or 1))
        scale = max(scale, float(row["p0"]) * case["f"]) if column == "max_tension" else scale
        good = got in ("", 0) if want == "" else not isinstance(got, str) and abs(got - float(want)) <= tolerances.get(
            column, 1e-9) * scale + 1e-300
        same("Pads, %s, %s" % (names, column), good, (want, got, inputs))


def check_limits(calculator, case, names, tip, worst):
    for name, kind in (("P_over_bk", "elastic-limit"), ("P_over_bk_shakedown", "shakedown-limit")):
        got = calculator.result("rw_%s_%s" % (names, name))
        is_exact = names == "cylinder" and kind == "elastic-limit"
        if not (is_exact or 0.25 <= case["nu1"] <= 0.35) or not (case["f"] <= 0.8 and tip <= 0.99):
            same("no limit outside the tables", got == "", (got, case))
            continue
        want = float(table(kind, pad="flat", a_over_b=tip, friction=case["f"], nu=case["nu1"])["P_over_bk"])
        worst[names, kind] = max(worst.get((names, kind), 0), abs(got / want - 1))
        within = 5e-4 if is_exact else 2e-2 if kind == "elastic-limit" else 1e-2
        same("Pads, %s" % kind, abs(got / want - 1) <= within, (want, got, case, tip))


def check_pads(document, calculator):
    document.Sheets.getByName("Pads").unprotect("")
    draw, worst = random.Random(7), {}
    for i in range(14):
        E2 = {} if i % 2 else dict(E2=10**draw.uniform(4, 5.5), nu2=draw.uniform(0.1, 0.4))
        f = [0.0, draw.uniform(0.05, 0.8)][i % 7 != 3]
        case = dict(E1=10**draw.uniform(4, 5.5), nu1=draw.uniform(0.25, 0.35) if i % 5 else 0.2, P=10**draw.uniform(0, 3), f=f, k=400.0, **E2)
        case["Q"] = draw.choice([0, -0.999, 0.5, draw.uniform(-1, 1)]) * f * case["P"]
        R, b = 10**draw.uniform(0, 2), None
        calculator.enter(dict(case, theta=0.01, a=0.05))
        calculator.cell("rw_radius_of_pad").Value = R
        hertz = float(solve(dict(case, radius=R))["b"])
        a = hertz * [draw.uniform(0.05, 1), draw.uniform(1, 8)][i % 3 == 0]
        calculator.cell("rw_flat_of_pad").Value = a
        M = [0.0, draw.uniform(-0.2, 0.2) * case["P"] * hertz][i % 3 == 1]
        sigma = [0.0, draw.uniform(-1, 1) * 4 * case["Q"] / (math.pi * hertz) * draw.choice([0.3, 0.9, 1.5])][i % 4 == 2]
        for name, value in (("rw_M", M), ("rw_sigma", sigma)):
            calculator.cell(name).Value = value
        check_pad(calculator, case, dict(radius=R, M=M, sigma=sigma), "cylinder", {})
        same("M and sigma on a flat pad", ("not here" in calculator.result("rw_flat_status")) == (M != 0 or sigma != 0),
             calculator.result("rw_flat_status"))
        for name in ("rw_M", "rw_sigma"):
            calculator.cell(name).String = ""
        check_pad(calculator, case, dict(radius=R, flat=a), "flat", dict(p0=1e-3) if a / calculator.result("rw_flat_b") <= 0.99 else dict(p0=9))
        check_limits(calculator, case, "cylinder", 0, worst)
        check_limits(calculator, case, "flat", a / calculator.result("rw_flat_b"), worst)
        check_no_errors(document.Sheets.getByName("Pads"))
    for name, text, said in (("rw_radius_of_pad", "", "radius must be"), ("rw_flat_of_pad", "wide", "a must be")):
        cell = calculator.cell(name)
        value, cell.String = cell.Value, text
        same("a mistake", said in calculator.result("rw_cylinder_status"), calculator.result("rw_cylinder_status"))
        check_no_errors(document.Sheets.getByName("Pads"))
        cell.Value = value
    print("14 pads; largest errors of limits: %s" % worst)


# ---- The sheet Look up ----


def between(table, i, j, share_f, share_tip):
    """None where a corner is missing."""
    corners = [table[i + k][j + m] for k in (0, 1) for m in (0, 1)]
    if "" in corners:
        return math.inf
    low, high = corners[0] + share_tip * (corners[1] - corners[0]), corners[2] + share_tip * (corners[3] - corners[2])
    return low + share_f * (high - low)


LOOK_UP_ROW = 10  # the first of its rows with a formula, from 0


def nodes_limit(tables, tips, frictions, tip, f):
    return min(table[frictions.index(f)][tips.index(tip)] or math.inf for table in tables)


def check_look_up(document):
    """The middles of all cells err as little as the sheet says; its formula does the same arithmetic."""
    sheet = document.Sheets.getByName("Look up")
    sheet.unprotect("")
    tips, frictions = range_named(document, "rw_table_tips").getDataArray()[0], [row[0] for row in range_named(document, "rw_table_f").getDataArray()]
    tables = [range_named(document, name).getDataArray() for name in ("rw_table_surface", "rw_table_below")]
    middles = [[(low + high) / 2 for low, high in zip(values, values[1:])] for values in (tips, frictions)]
    done = subprocess.run([RWEDGE, "table", "elastic-limit", "--nu", "0.3", "--a-over-b", ",".join(map(repr, middles[0])),
                           "--friction", ",".join(map(repr, middles[1]))], stdout=subprocess.PIPE, universal_newlines=True)
    worst = {"from 0.01": 0, "from 0.1": 0}
    sampled = []
    rows = list(csv.DictReader(done.stdout.splitlines()))
    same("middles", len(rows) == len(middles[0]) * len(middles[1]), len(rows))
    for n, row in enumerate(rows):
        j, i = divmod(n, len(middles[1]))
        got = min(between(table, i, j, 0.5, 0.5) for table in tables)
        error = abs(got / float(row["P_over_bk"]) - 1)
        worst["from 0.01"] = max(worst["from 0.01"], error)
        worst["from 0.1"] = max(worst["from 0.1"], error if float(row["a_over_b"]) > 0.1 else 0)
        if n % 157 == 0:
            sampled.append((middles[0][j], middles[1][i], got))
    # its formula, copied to the right of columns on another sheet
    document.Sheets.insertNewByName("Mine", document.Sheets.Count)
    mine = document.Sheets.getByName("Mine")
    sampled += [(2.5, 0.2, nodes_limit(tables, tips, frictions, 1, 0.2)), (0.009, 0.1, None), (0.5, 0.81, None)]
    for i, (tip, f, want) in enumerate(sampled):
        mine.getCellByPosition(4, i).Value, mine.getCellByPosition(5, i).Value = tip, f
        formula = sheet.getCellRangeByPosition(2, LOOK_UP_ROW, 2, LOOK_UP_ROW).RangeAddress
        mine.copyRange(mine.getCellByPosition(6, i).CellAddress, formula)
    for i, (tip, f, want) in enumerate(sampled):
        cell = mine.getCellByPosition(6, i)
        good = cell.getError() != 0 if want is None else cell.getError() == 0 and abs(cell.Value / want - 1) < 1e-12
        same("the formula of Look up", good, (tip, f, want, cell.Value))
    print("Look up: largest errors", worst)
    same("errors of Look up", worst["from 0.01"] <= 1.2e-3 and worst["from 0.1"] <= 1e-3, worst)


def check_legends(document):
    """The curves keep their names when a sheet is inserted in front."""
    document.Sheets.insertNewByName("Front", 0)
    charts = document.Sheets.getByName("Calculator").Charts
    names = []
    for i in range(charts.Count):
        diagram = charts.getByIndex(i).EmbeddedObject.FirstDiagram
        for series in diagram.CoordinateSystems[0].ChartTypes[0].DataSeries:
            label = series.DataSequences[0].Label
            names += [label.Data[0]] if label is not None and label.SourceRangeRepresentation else []
    same("legends", charts.Count == 5 and len(names) == 18 and names.count("your case") == 3 and "0.1" in names, names)


def check_book(office):
    document = office.open("file://" + os.path.abspath(WORKBOOK))
    document.enableAutomaticCalculation(True)  # as users have it; calculate() alone left a cell out
    calculator, batch = Calculator(document), Batch(document)
    check_first_input(document, calculator)
    check_file(WORKBOOK)
    check_stored(document)
    for locale, count, beside, shown in ("en-US", ROWS - 1, 15, "0.05"), ("de-DE", 30, 5, "0,05"):
        speak(office, locale)
        calculator.enter(GOOD)
        same("the decimal sign of " + locale, calculator.cell("rw_a").String == shown, calculator.cell("rw_a").String)
        check_cases(calculator, batch, random_case, count, beside)
    check_cases(calculator, batch, late_case, ROWS - 1, 1)
    check_messages(document, calculator, batch)
    check_materials(calculator)
    check_pads(document, calculator)
    check_fill_down(batch)
    check_look_up(document)
    check_legends(document)
    document.close(True)


office = Office(FOLDER)
try:
    check_book(office)
finally:
    office.end()
print("%d failures" % failures)
sys.exit(failures > 0)
