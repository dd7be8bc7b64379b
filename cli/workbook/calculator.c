/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The calculator: inputs, checks, results. */
#include "calculator.h"

#include "charts.h"
#include "formula.h"
#include "working.h"

#include <math.h>
#include <stddef.h>
#include <stdio.h>
#include <string.h>

#include <rwedge.h>

enum { LABEL, NAME, VALUE, UNIT, REMARK };
enum { INPUT_ROW = 4, STATUS_ROW = 14, RESULT_ROW = 18, CHART_COLUMN = 6 };
enum { CHECK_ROW = WORKING_ROW + NUS + 3, CHECK_COLUMN = WORKING_COLUMN + 4 };
enum { THETA, ROUNDING, E1, NU1, E2, NU2, LOAD, FRICTION_F, STRENGTH_K, INPUTS };

/* What an input must be, as a condition that it is not, and the words for it. */
typedef struct {
    const char *label, *name, *unit, *hint;
    const char *wrong; /* with the name for each %s */
    const char *must;
} input_cell;

#define ABOVE_0 "OR(%s<1E-30,%s>1E+30)", "must be above 0"
#define POISSON "OR(%s<=-1,%s>0.5)", "must be above -1 and not above 0.5"

static const input_cell inputs[INPUTS] = {
    [THETA] = {"Angle between flank and surface", "rw_theta", "rad", "small: up to about 0.1",
               "OR(%s<1E-30,%s>=PI()/2)", "must be above 0 and below pi/2 rad"},
    [ROUNDING] = {"Half-width of the rounding, a = R theta", "rw_a", "mm",
                  "R is the radius of the apex", ABOVE_0},
    [E1] = {"Young's modulus, half-plane", "rw_E1", "MPa", "", ABOVE_0},
    [NU1] = {"Poisson's ratio, half-plane", "rw_nu1", "-",
             "0 to 0.5; the body whose yield is looked at", POISSON},
    [E2] = {"Young's modulus, wedge", "rw_E2", "MPa", "1E+30 where it is rigid", ABOVE_0},
    [NU2] = {"Poisson's ratio, wedge", "rw_nu2", "-", "", POISSON},
    [LOAD] = {"Normal load per unit length", "rw_P", "N/mm", "", ABOVE_0},
    [FRICTION_F] = {"Coefficient of friction", "rw_f", "-",
                    "0 to 0.8; full sliding, 0: normal load", "OR(%s<0,%s>1E+6)",
                    "must not be below 0"},
    [STRENGTH_K] = {"Yield stress in pure shear, half-plane", "rw_k", "MPa",
                    "tensile yield stress / sqrt(3)", ABOVE_0},
};

/* Two steel bodies: a/b = 0.29, and yield at half as much again. */
static const workbook_inputs example = {0.01, 0.05, 210000, 0.3, 210000, 0.3, 190, 0.2, 400};

static void title(xlsx *book)
{
    xlsx_text(book, 0, LABEL, "Contact of a wedge with a rounded apex and a half-plane",
              XLSX_TITLE);
    xlsx_text(book, 1, LABEL,
              "Type into the yellow cells. Any consistent units do; those shown are mm, N, MPa. "
              "Plane strain; elastically similar bodies unless f = 0.",
              XLSX_NOTE);
}

static void check_cell(xlsx *book, int i)
{
    char formula[FORMULA_SIZE], wrong[200];
    const input_cell *cell = &inputs[i];
    snprintf(wrong, sizeof wrong, cell->wrong, cell->name, cell->name);
    compose(formula,
            "=IF(NOT(ISNUMBER(%s)),\"%s is missing or not a number\",IF(%s,\"%s %s\",\"\"))",
            cell->name, cell->name, wrong, cell->name, cell->must);
    xlsx_text(book, CHECK_ROW + i, CHECK_COLUMN, cell->name, XLSX_NOTE);
    xlsx_text_formula(book, CHECK_ROW + i, CHECK_COLUMN + 1, formula, "", XLSX_PLAIN);
    compose(formula, "rwt_check%d", i + 1);
    xlsx_name(book, formula, CHECK_ROW + i, CHECK_COLUMN + 1);
}

static void input_rows(xlsx *book)
{
    const double value[INPUTS] = {example.theta, example.a, example.E1, example.nu1, example.E2,
                                  example.nu2,   example.P, example.f,  example.k};
    xlsx_text(book, INPUT_ROW - 1, LABEL, "Inputs", XLSX_HEADING);
    for (int i = 0; i < INPUTS; i++) {
        xlsx_text(book, INPUT_ROW + i, LABEL, inputs[i].label, XLSX_PLAIN);
        xlsx_text(book, INPUT_ROW + i, NAME, inputs[i].name, XLSX_NOTE);
        xlsx_number(book, INPUT_ROW + i, VALUE, value[i], XLSX_INPUT);
        xlsx_text(book, INPUT_ROW + i, UNIT, inputs[i].unit, XLSX_UNIT);
        xlsx_text(book, INPUT_ROW + i, REMARK, inputs[i].hint, XLSX_NOTE);
        xlsx_name(book, inputs[i].name, INPUT_ROW + i, VALUE);
        check_cell(book, i);
    }
}

/* ---- What holds ------------------------------------------------------------------------------ */

static void flag(xlsx *book, int i, const char *name, const char *formula)
{
    xlsx_text(book, CHECK_ROW + INPUTS + i, CHECK_COLUMN, name, XLSX_NOTE);
    formula_cell(book, CHECK_ROW + INPUTS + i, CHECK_COLUMN + 1, formula, 1, XLSX_PLAIN);
    xlsx_name(book, name, CHECK_ROW + INPUTS + i, CHECK_COLUMN + 1);
}

/* A result is computed where all that it needs is there; the others go on. The comparison with
 * 0.01 has room for rounding. */
static void flags(xlsx *book)
{
    xlsx_text(book, CHECK_ROW - 1, CHECK_COLUMN,
              "What is wrong with an input; what can be computed (1)", XLSX_NOTE);
    flag(book, 0, "rwt_ok",
         "=IF(rwt_check1&rwt_check2&rwt_check3&rwt_check4&rwt_check5&rwt_check6&rwt_check7=\"\",1,"
         "0)");
    flag(book, 1, "rwt_ok_nu", "=IF(rwt_ok=1,IF(rw_nu1>=0,1,0),0)");
    flag(book, 2, "rwt_ok_f", "=IF(AND(rwt_ok_nu=1,rwt_check8=\"\"),IF(rw_f<=0.8,1,0),0)");
    flag(book, 3, "rwt_ok_tip", "=IF(rwt_ok=1,IF(rw_a_over_b>=0.01*(1-1E-9),1,0),0)");
    flag(book, 4, "rwt_ok_yield", "=IF(AND(rwt_ok_f=1,rwt_check9=\"\"),1,0)");
}

static const char status_formula[] =
    "=IF(rwt_check1<>\"\",rwt_check1,IF(rwt_check2<>\"\",rwt_check2,IF(rwt_check3<>\"\",rwt_check3,"
    "IF(rwt_check4<>\"\",rwt_check4,IF(rwt_check5<>\"\",rwt_check5,IF(rwt_check6<>\"\",rwt_check6,"
    "IF(rwt_check7<>\"\",rwt_check7,IF(rwt_check8<>\"\",rwt_check8,IF(rwt_check9<>\"\",rwt_check9,"
    "IF(rwt_ok_nu=0,\"rw_nu1 "
    "is below 0, outside the tables: no yield\",IF(rwt_ok_f=0,\"rw_f is above 0.8, outside the "
    "tables: no yield\",IF(rwt_ok_tip=0,\"a/b is below 0.01, outside the tables: no elastic "
    "limit\",IF(rwt_reached=0,\"rw_P_yield has a/b below 0.01, outside the "
    "tables\",\"OK\")))))))))))))";

/* When to say what the library says. The thresholds are the library's: a test compares. */
static const struct {
    int32_t doubt;
    const char *condition;
} remarks[] = {
    {RWEDGE_DOUBT_YIELD, "N(rw_safety)*(1-N(rw_safety))>0"},
    {RWEDGE_DOUBT_ANGLE, "rw_theta>0.1"},
    {RWEDGE_DOUBT_COUPLING, "AND(ABS(rwt_beta)>1E-12,N(rw_f)>0)"},
    {RWEDGE_DOUBT_ROUNDING, "OR(rw_a_over_b<0.01,rw_a_over_b>10000)"},
    {RWEDGE_DOUBT_STRENGTH, "AND(rwt_check9=\"\",OR(N(rw_k)/rw_E1<0.00001,N(rw_k)/rw_E1>0.1))"},
};

/* What holds, without what follows from it: all of them fit beside the chart. */
static void write_remarks(char formula[FORMULA_SIZE])
{
    compose(formula, "=IF(rwt_ok=0,\"\",\"\"");
    for (size_t i = 0; i < sizeof remarks / sizeof remarks[0]; i++) {
        const char *text = rwedge_validity_text(remarks[i].doubt);
        const size_t used = strlen(formula);
        snprintf(formula + used, FORMULA_SIZE - used, "&IF(%s,\"%.*s. \",\"\")",
                 remarks[i].condition, (int)strcspn(text, ":"), text);
    }
    strcat(formula, ")");
}

static void status_rows(xlsx *book)
{
    char formula[FORMULA_SIZE];
    xlsx_text(book, STATUS_ROW, LABEL, "Status", XLSX_HEADING);
    xlsx_text(book, STATUS_ROW, NAME, "rw_status", XLSX_NOTE);
    xlsx_text_formula(book, STATUS_ROW, VALUE, status_formula, "OK", XLSX_STATUS);
    xlsx_name(book, "rw_status", STATUS_ROW, VALUE);
    xlsx_text(book, STATUS_ROW + 1, LABEL, "Remarks", XLSX_PLAIN);
    xlsx_text(book, STATUS_ROW + 1, NAME, "rw_remarks", XLSX_NOTE);
    write_remarks(formula);
    xlsx_text_formula(book, STATUS_ROW + 1, VALUE, formula, "", XLSX_CHECK);
    xlsx_name(book, "rw_remarks", STATUS_ROW + 1, VALUE);
}

/* ---- Results --------------------------------------------------------------------------------- */

typedef struct {
    const char *label, *name, *unit, *hint, *formula;
    size_t value; /* where it is in workbook_results */
} result_cell;

#define RESULT(member) offsetof(workbook_results, member)

static const result_cell results[] = {
    {"Composite compliance A", "rw_compliance", "1/MPa", "2(1-nu1^2)/E1 + 2(1-nu2^2)/E2",
     "=IF(rwt_ok=1,2*(1-rw_nu1^2)/rw_E1+2*(1-rw_nu2^2)/rw_E2,\"\")", RESULT(A)},
    {"Half-width of the contact b", "rw_b", "mm", "", "=IF(rwt_ok=1,rw_a/rw_a_over_b,\"\")",
     RESULT(b)},
    {"Rounding over contact a/b", "rw_a_over_b", "-", "1 and more: Hertz' contact",
     "=IF(rwt_ok=1,IF(rwt_x>=2/PI(),SQRT(PI()/2*rwt_x),rwt_n5),\"\")", RESULT(a_over_b)},
    {"Peak pressure p0", "rw_p0", "MPa", "at x = 0",
     "=IF(rwt_ok=1,rw_theta/rw_compliance*IF(rw_a_over_b<1,2/PI()*(ASIN(rwt_tip)/"
     "rwt_tip+LN((1+rwt_c)/rwt_tip)),1/rw_a_over_b),\"\")",
     RESULT(p0)},
    {"Maximum tension", "rw_max_tension", "MPa", "at the trailing edge, full sliding",
     "=IF(AND(rwt_ok=1,rwt_check8=\"\"),rw_f*rw_P/rw_b*rwt_ratio,\"\")", RESULT(tension)},
    {"Load P/(bk)", "rw_load_over_bk", "-", "of the load given",
     "=IF(AND(rwt_ok=1,rwt_check9=\"\"),rw_P/(rw_b*rw_k),\"\")", RESULT(load_over_bk)},
    {"Elastic limit P/(bk)", "rw_P_over_bk", "-", "at this a/b and f: it yields above",
     "=IF(AND(rwt_ok_f=1,rwt_ok_tip=1),MIN(rwt_limit_s,rwt_limit_b),\"\")", RESULT(limit)},
    {"Load at first yield", "rw_P_yield", "N/mm", "the contact grows on the way",
     "=IF(rwt_ok_yield=1,IF(rwt_reached=0,\"\",rwt_y*rw_theta*rw_a/rw_compliance),\"\")",
     RESULT(P_yield)},
    {"Safety factor P_yield/P", "rw_safety", "-", "below 1 it yields",
     "=IF(ISNUMBER(rw_P_yield),rw_P_yield/rw_P,\"\")", RESULT(safety)},
    {"Critical friction", "rw_f_critical", "-", "above it, yield starts at the surface",
     "=IF(AND(rwt_ok_nu=1,rwt_ok_tip=1),IF(rwt_gaps=0,0,SQRT(INDEX(rwt_f,rwt_g)^2+(INDEX(rwt_f,rwt_"
     "g+1)^2-INDEX(rwt_f,rwt_g)^2)*INDEX(rwt_gap,rwt_g)/"
     "(INDEX(rwt_gap,rwt_g)-INDEX(rwt_gap,rwt_g+1)))),\"\")",
     RESULT(f_critical)},
};
enum { RESULTS = sizeof results / sizeof results[0] };

static void result_rows(xlsx *book, const workbook_results *out)
{
    xlsx_text(book, RESULT_ROW - 1, LABEL, "Results", XLSX_HEADING);
    for (int i = 0; i < RESULTS; i++) {
        double value;
        memcpy(&value, (const char *)out + results[i].value, sizeof value);
        xlsx_text(book, RESULT_ROW + i, LABEL, results[i].label, XLSX_PLAIN);
        xlsx_text(book, RESULT_ROW + i, NAME, results[i].name, XLSX_NOTE);
        formula_cell(book, RESULT_ROW + i, VALUE, results[i].formula, value, XLSX_RESULT);
        xlsx_text(book, RESULT_ROW + i, UNIT, results[i].unit, XLSX_UNIT);
        xlsx_text(book, RESULT_ROW + i, REMARK, results[i].hint, XLSX_NOTE);
        xlsx_name(book, results[i].name, RESULT_ROW + i, VALUE);
    }
}

static void notes(xlsx *book)
{
    static const char *const lines[] = {
        "Accuracy: a/b, b, p0 and the tension as exact as the spreadsheet computes; elastic limit "
        "within",
        "0.05 %; load at yield within 0.15 % (0.4 % where its a/b is below 0.02); critical "
        "friction within",
        "0.006. For 0.01 <= a/b (all above 1 is Hertz), 0 <= f <= 0.8, 0 <= nu1 <= 0.5. See "
        "\"About\".",
        "The charts show the curve of your case in orange and the case as a red diamond.",
    };
    for (int i = 0; i < 4; i++)
        xlsx_text(book, RESULT_ROW + RESULTS + 1 + i, LABEL, lines[i], XLSX_NOTE);
}

void sheet_calculator(xlsx *book, const limit_table *table)
{
    workbook_results out;
    workbook_compute(table, &example, &out);
    title(book);
    input_rows(book);
    flags(book);
    status_rows(book);
    result_rows(book, &out);
    notes(book);
    sheet_working(book, table, &example, &out);
    xlsx_width(book, LABEL, LABEL, 36);
    xlsx_width(book, NAME, NAME, 15);
    xlsx_width(book, VALUE, VALUE, 15);
    xlsx_width(book, UNIT, UNIT, 7);
    xlsx_width(book, REMARK, REMARK, 36);
    sheet_charts(book, 3, CHART_COLUMN);
    xlsx_freeze(book, 3, 0);
    xlsx_print(book, (xlsx_page){3 + 3 * CHART_ROWS, WORKING_COLUMN - 2, -1, true});
}
