# SPDX-License-Identifier: GPL-3.0-or-later
"""Has LibreOffice recalculate the workbook: the values in the file are those of its formulas, and its results for random
inputs are the library's.

    workbook_recalculate.py RWEDGE WORKBOOK FOLDER LOCALE CASES

LOCALE (en-US, de-DE) is that of LibreOffice. Standard library only, and LibreOffice's module uno."""
import csv
import math
import os
import random
import re
import subprocess
import sys
import time
import xml.etree.ElementTree as ET
import zipfile

import uno
from com.sun.star.beans import PropertyValue
from com.sun.star.sheet import FormulaResult
from com.sun.star.table.CellContentType import FORMULA

RWEDGE, WORKBOOK, FOLDER, LOCALE, CASES = sys.argv[1:5] + [int(sys.argv[5])]
INPUTS = ["theta", "a", "E1", "nu1", "E2", "nu2", "P", "f", "k"]
# The workbook's result, the column of "rwedge solve", the tolerance: relative, absolute.
RESULTS = [
    ("rw_compliance", "A", 1e-13, 0), ("rw_b", "b", 1e-12, 0), ("rw_a_over_b", "a_over_b", 1e-12, 0),
    ("rw_p0", "p0", 1e-12, 0), ("rw_max_tension", "max_tension_sliding", 1e-12, 0),
    ("rw_load_over_bk", "load_over_bk", 1e-12, 0), ("rw_P_over_bk", "P_over_bk", 5e-4, 0),
    ("rw_P_yield", "P_yield", 1.5e-3, 0), ("rw_safety", "safety", 1.5e-3, 0), ("rw_f_critical", "f_critical", 0, 6e-3),
]
YIELD_NEAR_SHARP = 4e-3  # of rw_P_yield and rw_safety where a/b at yield is below 0.02
MAIN = "{http://schemas.openxmlformats.org/spreadsheetml/2006/main}"
failures = 0


def same(what, good, detail):
    global failures
    if not good:
        failures += 1
        if failures <= 20:
            print("FAILED: %s: %s" % (what, detail))


def profile():
    """LibreOffice's settings: recalculate what is loaded, always; the locale."""
    folder = os.path.join(FOLDER, "profile-" + LOCALE, "user")
    os.makedirs(folder)
    with open(os.path.join(folder, "registrymodifications.xcu"), "w") as file:
        file.write('''<?xml version="1.0" encoding="UTF-8"?>
<oor:items xmlns:oor="http://openoffice.org/2001/registry" xmlns:xs="http://www.w3.org/2001/XMLSchema"
 xmlns:xsi="http://www.w3.org/2001/XMLSchema-instance">
<item oor:path="/org.openoffice.Office.Calc/Formula/Load"><prop oor:name="OOXMLRecalcMode" oor:op="fuse"><value>0</value>
</prop></item>
<item oor:path="/org.openoffice.Setup/L10N"><prop oor:name="ooSetupSystemLocale" oor:op="fuse"><value>%s</value></prop></item>
</oor:items>
''' % LOCALE)
    return "file://" + os.path.dirname(folder)


def start():
    pipe = "rwedge%d%s" % (os.getpid(), LOCALE.replace("-", ""))
    process = subprocess.Popen(["soffice", "-env:UserInstallation=" + profile(), "--headless", "--norestore", "--nologo",
                                "--accept=pipe,name=%s;urp;" % pipe], stdout=subprocess.DEVNULL,
                               stderr=subprocess.DEVNULL)
    local = uno.getComponentContext()
    resolver = local.ServiceManager.createInstanceWithContext("com.sun.star.bridge.UnoUrlResolver", local)
    for _ in range(240):
        try:
            context = resolver.resolve("uno:pipe,name=%s;urp;StarOffice.ComponentContext" % pipe)
            return process, context.ServiceManager.createInstanceWithContext("com.sun.star.frame.Desktop", context)
        except Exception:
            time.sleep(0.5)
    process.kill()
    sys.exit("LibreOffice does not start")


def stored(path):
    """The values of the first sheet's formulas as they are in the file: cell name to number or text."""
    root = ET.fromstring(zipfile.ZipFile(path).read("xl/worksheets/sheet1.xml"))
    cells = {}
    for cell in root.iter(MAIN + "c"):
        if cell.find(MAIN + "f") is not None:
            value = cell.find(MAIN + "v")
            text = value.text if value is not None and value.text is not None else ""
            cells[cell.get("r")] = text if cell.get("t") == "str" else float(text)
    return cells


def check_stored(sheet):
    cells = stored(WORKBOOK)
    same("formulas in the file", len(cells) > 600, len(cells))
    for name, value in cells.items():
        cell = sheet.getCellRangeByName(name)
        same("formula read " + name, cell.Type == FORMULA and cell.getError() == 0,
             (cell.Formula[:200], "error %d" % cell.getError()))
        got = cell.String if isinstance(value, str) else cell.Value
        good = got == value if isinstance(value, str) else abs(got - value) <= 1e-9 * abs(value) + 1e-14
        same("value stored in " + name, good, (value, got, cell.Formula[:200]))
    print("%d values of formulas are as stored" % len(cells))


def check_file(path):
    """What spreadsheet programs would repair, or do not know."""
    archive = zipfile.ZipFile(path)
    names = [name.get("name").lower() for name in ET.fromstring(archive.read("xl/workbook.xml")).iter(MAIN + "definedName")
             if name.get("localSheetId") is None]
    same("names that differ in more than capitals", len(names) == len(set(names)) > 60, len(names))
    same("names that are no cells", not [name for name in names if re.fullmatch(r"[a-z]{1,3}[0-9]+", name)], names)
    text = archive.read("xl/worksheets/sheet1.xml").decode()
    known = {"ABS", "AND", "ASIN", "COUNT", "EXP", "IF", "INDEX", "ISNUMBER", "LN", "MATCH", "MAX", "MIN", "N", "NA", "NOT",
             "OR", "PI", "SQRT", "SUMPRODUCT"}
    used = set(re.findall(r"([A-Z][A-Z.]*)\(", re.sub(r"&quot;.*?&quot;|\".*?\"", "", " ".join(
        re.findall("<f>(.*?)</f>", text)))))
    same("functions that every spreadsheet has", used <= known, used - known)
    sheets = [sheet.get("name") for sheet in ET.fromstring(archive.read("xl/workbook.xml")).iter(MAIN + "sheet")]
    same("sheets", sheets == ["Calculator", "Elastic limit", "Maximum tension", "Contact law", "Critical friction", "About"],
         sheets)
    same("charts", sum(name.startswith("xl/charts/chart") for name in archive.namelist()) == 3, archive.namelist())


def contact_load(tip):
    """AP/(theta a)"""
    if tip >= 1:
        return math.pi / 2 / tip**2
    return (math.asin(tip) + tip * math.sqrt(1 - tip * tip)) / tip**2


def random_case(draw, i):
    nu = draw.choice([0, 0.2, 0.25, 0.3, 0.35, 0.45, 0.5]) if i % 4 == 0 else draw.uniform(0, 0.5)
    f = [0, draw.uniform(0, 0.8), draw.uniform(0, 0.4), draw.uniform(0.1, 0.35), 0.8 * draw.randint(0, 8) / 8][i % 5]
    E1, E2, nu2 = 10**draw.uniform(3, 6), 10**draw.uniform(3, 6), draw.uniform(0, 0.5)
    theta, a = 10**draw.uniform(-3, -0.5), 10**draw.uniform(-3, 1)
    A = 2 * (1 - nu**2) / E1 + 2 * (1 - nu2**2) / E2
    tip = 10**draw.uniform(-1.99, 0.3) if i % 2 else draw.uniform(0.02, 1.1)
    return dict(theta=theta, a=a, E1=E1, nu1=nu, E2=E2, nu2=nu2, P=contact_load(tip) * theta * a / A, f=f,
                k=theta / A * 10**draw.uniform(-1.3, 0.1))


def solve(cases):
    path = os.path.join(FOLDER, "cases-%s.csv" % LOCALE)
    with open(path, "w", newline="") as file:
        writer = csv.DictWriter(file, INPUTS)
        writer.writeheader()
        for case in cases:
            writer.writerow({name: repr(float(case[name])) for name in INPUTS})
    done = subprocess.run([RWEDGE, "solve", "--input", path], stdout=subprocess.PIPE, universal_newlines=True)
    return list(csv.DictReader(done.stdout.splitlines()))


def yield_tip(case, row):
    """a/b under the load at yield."""
    target = float(row["P_yield"]) * float(row["A"]) / (case["theta"] * case["a"])
    low, high = 1e-8, 1e8
    for _ in range(200):
        middle = math.sqrt(low * high)
        low, high = (middle, high) if contact_load(middle) > target else (low, middle)
    return low


class Calculator:
    def __init__(self, document):
        self.document = document
        document.enableAutomaticCalculation(False)  # enter() calculates once, not after each cell
        self.sheet = document.Sheets.getByIndex(0)
        self.cells = {}
        for i in range(document.NamedRanges.Count):
            name = document.NamedRanges.getByIndex(i)
            match = re.fullmatch(r"\$?'?Calculator'?\.\$([A-Z]+)\$(\d+)", name.Content)
            if match:
                self.cells[name.Name] = self.sheet.getCellRangeByName("".join(match.groups()))

    def enter(self, case):
        for name in INPUTS:
            value = case.get(name)
            if value is None:
                self.cells["rw_" + name].String = ""
            elif isinstance(value, str):
                self.cells["rw_" + name].String = value
            else:
                self.cells["rw_" + name].Value = value
        self.document.calculate()

    def result(self, name):
        cell = self.cells[name]
        if cell.getError() != 0:
            return "error %d" % cell.getError()
        return cell.String if cell.FormulaResultType2 == FormulaResult.STRING else cell.Value


def check_cases(calculator):
    draw = random.Random(2026)
    cases = [random_case(draw, i) for i in range(CASES)]
    worst = {name: 0 for name, *_ in RESULTS}
    compared = 0
    rows = solve(cases)
    same("rows of solve", len(rows) == len(cases), len(rows))
    for case, row in zip(cases, rows):
        calculator.enter(case)
        sharp = float(row["a_over_b"]) < 0.01 * (1 - 1e-9)
        at_yield = yield_tip(case, row) if row["P_yield"] else 0
        status = calculator.result("rw_status")
        if not sharp and at_yield > 0.0102:
            same("status", status == "OK", (status, case))
        elif not sharp and at_yield < 0.0098:
            same("status", "rw_P_yield has a/b below 0.01" in status, (status, case))
        for name, column, relative, absolute in RESULTS:
            got = calculator.result(name)
            if sharp and name in ("rw_P_over_bk", "rw_f_critical") or at_yield < 0.0102 and name in ("rw_P_yield",
                                                                                                     "rw_safety"):
                same("no number outside the tables", got == "" or not sharp and at_yield > 0.0098, (name, got, case))
                continue
            if name in ("rw_P_yield", "rw_safety") and at_yield < 0.02:
                relative = YIELD_NEAR_SHARP
            want = float(row[column])
            good = not isinstance(got, str) and abs(got - want) <= relative * abs(want) + absolute
            same(name, good, "expected %r, got %r, for %r" % (want, got, case))
            if good:
                compared += 1
                worst[name] = max(worst[name], abs(got - want) / (1 if absolute else abs(want) or 1))
    print("%d cases, %d results compared; largest errors:" % (len(cases), compared))
    for name, *_ in RESULTS:
        print("    %-16s %.1e" % (name, worst[name]))


def check_refusals(calculator):
    good = dict(theta=0.01, a=0.05, E1=2.1e5, nu1=0.3, E2=2.1e5, nu2=0.3, P=190.0, f=0.2, k=400.0)
    refused = [
        (dict(theta=None), "rw_theta is missing", "rw_b"), (dict(theta="0.01"), "rw_theta is missing", "rw_b"),
        (dict(theta=0.0), "rw_theta must", "rw_b"), (dict(theta=1.6), "rw_theta must", "rw_b"),
        (dict(a=0.0), "rw_a must", "rw_b"), (dict(E1=-1.0), "rw_E1 must", "rw_b"), (dict(E2=None), "rw_E2 is missing", "rw_b"),
        (dict(nu1=0.51), "rw_nu1 must", "rw_b"), (dict(nu2=-1.0), "rw_nu2 must", "rw_b"), (dict(P=0.0), "rw_P must", "rw_b"),
        (dict(f=-0.1), "rw_f must", "rw_max_tension"), (dict(f=None), "rw_f is missing", "rw_P_over_bk"),
        (dict(k=0.0), "rw_k must", "rw_safety"), (dict(nu1=-0.1), "rw_nu1 is below 0, outside", "rw_P_over_bk"),
        (dict(f=0.81), "rw_f is above 0.8, outside", "rw_P_yield"), (dict(P=1e5), "a/b is below 0.01, outside", "rw_P_over_bk"),
        (dict(k=4000.0), "rw_P_yield has a/b below 0.01, outside", "rw_safety"),
    ]
    for change, words, without in refused:
        calculator.enter(dict(good, **change))
        status = calculator.result("rw_status")
        same("status for %r" % change, words in status, status)
        same("no result for %r" % change, calculator.result(without) == "", (without, calculator.result(without)))
        for name, *_ in RESULTS:
            same("no error for %r" % change, not str(calculator.result(name)).startswith("error"), name)
    calculator.enter(dict(good, P=2e4, theta=0.2, E2=1e6))
    remarks = calculator.result("rw_remarks")
    same("remarks", remarks == "P is above P_yield. theta is above 0.1 rad. Dundurs' beta is not 0. ", remarks)
    calculator.enter(dict(good, f=0.81))
    same("the tension needs no table", abs(calculator.result("rw_max_tension") - 0.81 / 0.2 * calculator_tension) < 1e-9
         * calculator_tension, calculator.result("rw_max_tension"))
    calculator.enter(good)
    same("remarks of the example", calculator.result("rw_remarks") == "", calculator.result("rw_remarks"))
    same("status of the example", calculator.result("rw_status") == "OK", calculator.result("rw_status"))
    print("%d refusals" % len(refused))


process, desktop = start()
try:
    hidden = PropertyValue("Hidden", 0, True, 0)
    document = desktop.loadComponentFromURL("file://" + os.path.abspath(WORKBOOK), "_blank", 0, (hidden,))
    document.calculateAll()
    check_file(WORKBOOK)
    check_stored(document.Sheets.getByIndex(0))
    calculator = Calculator(document)
    shown = calculator.cells["rw_a"].String
    same("the locale's decimal sign", shown == ("0,05" if LOCALE == "de-DE" else "0.05"), shown)
    calculator_tension = calculator.result("rw_max_tension")
    check_cases(calculator)
    check_refusals(calculator)
    document.close(True)
finally:
    try:
        desktop.terminate()
    except Exception:
        process.terminate()
    process.wait(30)
print("%d failures" % failures)
sys.exit(failures > 0)
