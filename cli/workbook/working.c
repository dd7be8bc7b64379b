/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The calculator's working cells: the steps of model.c as formulas, with their names.
 * Names that begin with rw_ are for the user; those of the working cells begin with rwt_. A step
 * may fail for inputs that the results refuse. Its cell is then not used. What the charts draw is
 * then #N/A, and they leave it out. */
#include "working.h"

#include "formula.h"
#include "table_sheets.h"

#include <math.h>
#include <stdio.h>

/* ---- Single steps ---------------------------------------------------------------------------- */

typedef struct {
    xlsx *book;
    int row;
} listing;

static void step(listing *list, const char *name, const char *formula, double value,
                 const char *what)
{
    xlsx_text(list->book, list->row, WORKING_COLUMN, what, XLSX_NOTE);
    xlsx_text(list->book, list->row, WORKING_COLUMN + 1, name, XLSX_NOTE);
    formula_cell(list->book, list->row, WORKING_COLUMN + 2, formula, value, XLSX_PLAIN);
    xlsx_name(list->book, name, list->row, WORKING_COLUMN + 2);
    list->row++;
}

static void newton_steps(listing *list, const workbook_results *out)
{
    char formula[FORMULA_SIZE], name[16];
    step(list, "rwt_x1", "=MIN(rwt_x,2/PI())", fmin(out->x, 2 / 3.14159265358979323846),
         "not beyond Hertz");
    step(list, "rwt_n0", "=rwt_x1*(2-(4/PI()-1)*PI()^2/4*rwt_x1)", out->step[0],
         "a/b, first guess");
    for (int i = 0; i < NEWTON_STEPS; i++) {
        char load[160];
        compose(name, "rwt_n%d", i + 1);
        snprintf(load, sizeof load, "(ASIN(rwt_n%d)+rwt_n%d*SQRT((1-rwt_n%d)*(1+rwt_n%d)))", i, i,
                 i, i);
        compose(formula, "=MIN(1,rwt_n%d-(rwt_n%d^2*%s-rwt_x1*%s^2)/(2*ASIN(rwt_n%d)*rwt_n%d))", i,
                i, load, load, i, i);
        step(list, name, formula, out->step[i + 1], "a Newton step");
    }
}

static void contact_steps(listing *list, const workbook_results *out)
{
    step(list, "rwt_x", "=rw_theta*rw_a/(rw_compliance*rw_P)", out->x, "theta a/(A P)");
    newton_steps(list, out);
    step(list, "rwt_tip", "=MIN(1,rw_a_over_b)", out->tip, "a/b, 1 for Hertz");
    step(list, "rwt_c", "=SQRT((1-rwt_tip)*(1+rwt_tip))", out->cosine, "cos(phi0)");
    step(list, "rwt_ratio", "=2*rwt_tip/(ASIN(rwt_tip)+rwt_tip*rwt_c)", out->tension_ratio,
         "b sigma/(fP)");
    step(list, "rwt_beta",
         "=0.5*(rw_E1/(1+rw_nu1)*(1-2*rw_nu2)-rw_E2/(1+rw_nu2)*(1-2*rw_nu1))/(rw_E1/"
         "(1+rw_nu1)*(1-rw_nu2)+rw_E2/(1+rw_nu2)*(1-rw_nu1))",
         out->beta, "Dundurs' beta");
}

static void patch_steps(listing *list, const workbook_results *out)
{
    char formula[FORMULA_SIZE], name[16];
    step(list, "rwt_kn", "=MIN(MATCH(rw_nu1,rwt_nu,1),14)", out->nu_node + 1, "first node of nu");
    step(list, "rwt_fn", "=MIN(MAX(MATCH(rw_f,rwt_f,1)-1,1),19)", out->f_node + 1,
         "first node of f");
    step(list, "rwt_m", "=(1-2*rw_nu1)^2/3", out->m, "m(nu)");
    for (int i = 0; i < 3; i++) {
        const int p = (i + 1) % 3, q = (i + 2) % 3;
        compose(name, "rwt_wm%d", i + 1);
        compose(formula,
                "=(rwt_m-INDEX(rwt_ms,rwt_kn+%d))*(rwt_m-INDEX(rwt_ms,rwt_kn+%d))/"
                "((INDEX(rwt_ms,rwt_kn+%d)-INDEX(rwt_ms,rwt_kn+%d))*(INDEX(rwt_ms,rwt_kn+%d)-INDEX("
                "rwt_ms,rwt_kn+%d)))",
                p, q, i, p, i, q);
        step(list, name, formula, out->weight_nu[i], "weight of nu");
    }
    xlsx_name_range(list->book, "rwt_wm", list->row - 3, WORKING_COLUMN + 2, 3, 1);
    for (int i = 0; i < 3; i++) {
        const int p = (i + 1) % 3, q = (i + 2) % 3;
        compose(name, "rwt_wf%d", i + 1);
        compose(formula,
                "=(rw_f^2-INDEX(rwt_f,rwt_fn+%d)^2)*(rw_f^2-INDEX(rwt_f,rwt_fn+%d)^2)/"
                "((INDEX(rwt_f,rwt_fn+%d)^2-INDEX(rwt_f,rwt_fn+%d)^2)*(INDEX(rwt_f,rwt_fn+%d)^2-"
                "INDEX(rwt_f,rwt_fn+%d)^2))",
                p, q, i, p, i, q);
        step(list, name, formula, out->weight_f[i], "weight of f");
    }
}

static void limit_steps(listing *list, const workbook_results *out)
{
    step(list, "rwt_t", "=LN(rwt_tip/(1+rwt_c))", out->t, "ln tan(phi0/2)");
    step(list, "rwt_node", "=MIN(MATCH(MAX(rwt_t,INDEX(rwt_ts,1)),rwt_ts,1),60)", out->node + 1,
         "tip below");
    step(list, "rwt_u",
         "=(rwt_t-INDEX(rwt_ts,rwt_node))/(INDEX(rwt_ts,rwt_node+1)-INDEX(rwt_ts,rwt_node))",
         out->share, "share of the next");
    step(list, "rwt_limit_s", "=(1-rwt_u)*INDEX(rwt_ls,rwt_node)+rwt_u*INDEX(rwt_ls,rwt_node+1)",
         out->limit_surface, "limit, surface");
    step(list, "rwt_limit_b",
         "=IF(COUNT(INDEX(rwt_lb,rwt_node):INDEX(rwt_lb,rwt_node+1))=2,(1-rwt_u)*INDEX(rwt_lb,rwt_"
         "node)+rwt_u*INDEX(rwt_lb,rwt_node+1),\"\")",
         out->limit_below, "limit below");
}

static void crossing_step(listing *list, const char *name, const char *column, double value,
                          const char *what)
{
    char formula[FORMULA_SIZE];
    compose(formula,
            "=IF(AND(rwt_reached>0,rwt_reached<61),IF(AND(INDEX(%s,rwt_reached)>=rwt_k,INDEX(%s,"
            "rwt_reached+1)>0),INDEX(rwt_lf,rwt_reached)+LN(rwt_k/INDEX(%s,rwt_reached))/"
            "LN(INDEX(%s,rwt_reached+1)/"
            "INDEX(%s,rwt_reached))*(INDEX(rwt_lf,rwt_reached+1)-INDEX(rwt_lf,rwt_reached)),\"\"),"
            "\"\")",
            column, column, column, column, column);
    step(list, name, formula, value, what);
}

static void yield_steps(listing *list, const workbook_results *out)
{
    step(list, "rwt_k", "=rw_k*rw_compliance/rw_theta", out->strength, "k A/theta");
    step(list, "rwt_reached", "=SUMPRODUCT(--(rwt_se>=rwt_k))", out->reached,
         "tips that yield before");
    crossing_step(list, "rwt_y_s", "rwt_ss", out->yield_surface, "ln(AP/(theta a)), surface");
    crossing_step(list, "rwt_y_b", "rwt_sb", out->yield_below, "the same below");
    crossing_step(list, "rwt_y_e", "rwt_se", out->yield_either, "the same, either");
    step(list, "rwt_y",
         "=IF(rwt_reached=0,\"\",IF(rwt_reached=61,PI()/2*(rwt_k/"
         "INDEX(rwt_se,61))^2,EXP(IF(COUNT(rwt_y_s,rwt_y_b)>0,MIN(rwt_y_s,rwt_y_b),rwt_y_e))))",
         out->yield, "AP/(theta a) at yield");
}

static void critical_steps(listing *list, const workbook_results *out)
{
    int base = out->gaps; /* as find_critical() has it */
    if (base > 1 && base < FRICTIONS && isnan(out->curve_below[base]))
        base--;
    step(list, "rwt_gaps", "=SUMPRODUCT(--(rwt_gap<0))", out->gaps, "f that yield below");
    step(list, "rwt_g",
         "=IF(AND(rwt_gaps>1,NOT(ISNUMBER(INDEX(rwt_cb,rwt_gaps+1)))),rwt_gaps-1,rwt_gaps)", base,
         "node before the cusp");
}

static void mark_steps(listing *list, const workbook_inputs *in, const workbook_results *out)
{
    step(list, "rwt_mark_tip", "=IF(ISNUMBER(rw_a_over_b),rwt_tip,0)", out->tip, "marked a/b");
    step(list, "rwt_mark_f", "=IF(ISNUMBER(rw_f),rw_f,0)", in->f, "marked f");
    step(list, "rwt_mark_limit", "=IF(ISNUMBER(rw_P_over_bk),rw_P_over_bk,NA())", out->limit,
         "marked limit");
    step(list, "rwt_mark_tension", "=IF(ISNUMBER(rw_a_over_b),rwt_ratio,NA())", out->tension_ratio,
         "marked tension");
}

/* ---- Nodes ----------------------------------------------------------------------------------- */

static void headers(xlsx *book, int column, const char *const names[], int count)
{
    for (int i = 0; i < count; i++)
        xlsx_text(book, WORKING_ROW - 1, column + i, names[i], XLSX_HEADER);
}

static void columns(xlsx *book, int column, const char *const names[], int count, int rows)
{
    for (int i = 0; i < count; i++)
        if (names[i] != NULL)
            xlsx_name_range(book, names[i], WORKING_ROW, column + i, rows, 1);
}

static void nu_nodes(xlsx *book, const limit_table *table)
{
    static const char *const header[] = {"nu", "m(nu)"}, *const name[] = {"rwt_nu", "rwt_ms"};
    const int column = WORKING_COLUMN + 4;
    headers(book, column, header, 2);
    columns(book, column, name, 2, NUS);
    for (int i = 0; i < NUS; i++) {
        xlsx_number(book, WORKING_ROW + i, column, table->nu[i], XLSX_PLAIN);
        xlsx_number(book, WORKING_ROW + i, column + 1,
                    (1 - 2 * table->nu[i]) * (1 - 2 * table->nu[i]) / 3, XLSX_PLAIN);
    }
}

/* The nine products of weights. */
static void weight_square(xlsx *book, const workbook_results *out)
{
    const int column = WORKING_COLUMN + 6;
    char formula[FORMULA_SIZE];
    xlsx_text(book, WORKING_ROW - 1, column, "weights", XLSX_HEADER);
    xlsx_name_range(book, "rwt_w", WORKING_ROW, column, 3, 3);
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++)
            formula_cell(book, WORKING_ROW + i, column + j,
                         compose(formula, "=rwt_wm%d*rwt_wf%d", i + 1, j + 1),
                         out->weight_nu[i] * out->weight_f[j], XLSX_PLAIN);
}

static void tip_limits(xlsx *book, const workbook_results *out, int i)
{
    char patch[300], formula[FORMULA_SIZE];
    const int row = WORKING_ROW + i, first = i * NUS;
    snprintf(patch, sizeof patch,
             "INDEX(" NAME_SURFACE ",%d+rwt_kn,rwt_fn):INDEX(" NAME_SURFACE ",%d+rwt_kn,rwt_fn+2)",
             first, first + 2);
    formula_cell(book, row, TIPS_COLUMN + 4,
                 compose(formula, "=1/SQRT(MAX(1E-6,SUMPRODUCT(rwt_w/(%s)^2)))", patch),
                 out->surface[i], XLSX_PLAIN);
    snprintf(patch, sizeof patch,
             "INDEX(" NAME_BELOW ",%d+rwt_kn,rwt_fn):INDEX(" NAME_BELOW ",%d+rwt_kn,rwt_fn+2)",
             first, first + 2);
    formula_cell(
        book, row, TIPS_COLUMN + 5,
        compose(
            formula,
            "=IF(rwt_fn<=15,IF(COUNT(%s)=9,1/SQRT(MAX(1E-6,SUMPRODUCT(rwt_w/(%s)^2))),\"\"),\"\")",
            patch, patch),
        out->below[i], XLSX_PLAIN);
}

static void tip_stresses(xlsx *book, const workbook_results *out, int i)
{
    char formula[FORMULA_SIZE];
    const int row = WORKING_ROW + i, at = i + 1;
    formula_cell(book, row, TIPS_COLUMN + 6,
                 compose(formula, "=INDEX(rwt_load,%d)/INDEX(rwt_ls,%d)", at, at),
                 out->stress_surface[i], XLSX_PLAIN);
    formula_cell(book, row, TIPS_COLUMN + 7,
                 compose(formula,
                         "=IF(ISNUMBER(INDEX(rwt_lb,%d)),INDEX(rwt_load,%d)/INDEX(rwt_lb,%d),0)",
                         at, at, at),
                 out->stress_below[i], XLSX_PLAIN);
    formula_cell(book, row, TIPS_COLUMN + 8,
                 compose(formula, "=MAX(INDEX(rwt_ss,%d),INDEX(rwt_sb,%d))", at, at),
                 out->stress[i], XLSX_PLAIN);
    formula_cell(
        book, row, TIPS_COLUMN + 9,
        compose(formula, "=IF(rwt_ok_f=1,MIN(INDEX(rwt_ls,%d),INDEX(rwt_lb,%d)),NA())", at, at),
        fmin(out->surface[i], out->below[i]), XLSX_PLAIN);
}

static void tip_nodes(xlsx *book, const limit_table *table, const workbook_results *out)
{
    static const char *const header[] = {
        "a/b",           "t",           "AP/(theta b)",   "ln(AP/(theta a))",
        "limit surface", "limit below", "stress surface", "stress below",
        "stress",        "limit"};
    static const char *const name[] = {"rwt_tips", "rwt_ts", "rwt_load", "rwt_lf", "rwt_ls",
                                       "rwt_lb",   "rwt_ss", "rwt_sb",   "rwt_se", "rwt_le"};
    headers(book, TIPS_COLUMN, header, 10);
    columns(book, TIPS_COLUMN, name, 10, TIPS);
    for (int i = 0; i < TIPS; i++) {
        const double fixed[] = {table->tip[i], table->t[i], table->load[i], table->log_load[i]};
        for (int j = 0; j < 4; j++)
            xlsx_number(book, WORKING_ROW + i, TIPS_COLUMN + j, fixed[j], XLSX_PLAIN);
        tip_limits(book, out, i);
        tip_stresses(book, out, i);
    }
}

static void friction_limit(xlsx *book, int f, int column, const char *table, int above,
                           double value)
{
    char patch[300], formula[FORMULA_SIZE];
    const int offset = above * NUS, at = f + 1;
    if (column >= 3 && f >= FRICTIONS_BELOW) {
        xlsx_text_formula(book, WORKING_ROW + f, FRICTIONS_COLUMN + column, "=\"\"", "",
                          XLSX_PLAIN);
        return;
    }
    snprintf(patch, sizeof patch,
             "INDEX(%s,(rwt_node-1)*16+%d+rwt_kn,%d):INDEX(%s,(rwt_node-1)*16+%d+rwt_kn,%d)", table,
             offset, at, table, offset + 2, at);
    compose(formula, "=IF(COUNT(%s)=3,1/SQRT(MAX(1E-6,SUMPRODUCT(rwt_wm/(%s)^2))),\"\")", patch,
            patch);
    formula_cell(book, WORKING_ROW + f, FRICTIONS_COLUMN + column, formula, value, XLSX_PLAIN);
}

static void friction_curves(xlsx *book, const workbook_results *out, int f)
{
    char formula[FORMULA_SIZE];
    const int row = WORKING_ROW + f, at = f + 1;
    formula_cell(book, row, FRICTIONS_COLUMN + 5,
                 compose(formula, "=(1-rwt_u)*INDEX(rwt_f1,%d)+rwt_u*INDEX(rwt_f2,%d)", at, at),
                 out->curve_surface[f], XLSX_PLAIN);
    formula_cell(book, row, FRICTIONS_COLUMN + 6,
                 compose(formula,
                         "=IF(AND(ISNUMBER(INDEX(rwt_f3,%d)),ISNUMBER(INDEX(rwt_f4,%d))),(1-rwt_u)*"
                         "INDEX(rwt_f3,%d)+rwt_u*INDEX(rwt_f4,%d),\"\")",
                         at, at, at, at),
                 out->curve_below[f], XLSX_PLAIN);
    formula_cell(
        book, row, FRICTIONS_COLUMN + 7,
        compose(formula,
                "=IF(AND(rwt_ok_nu=1,rwt_ok_tip=1),MIN(INDEX(rwt_cs,%d),INDEX(rwt_cb,%d)),NA())",
                at, at),
        out->curve[f], XLSX_PLAIN);
    formula_cell(
        book, row, FRICTIONS_COLUMN + 8,
        compose(formula,
                "=IF(ISNUMBER(INDEX(rwt_cb,%d)),1/INDEX(rwt_cs,%d)^2-1/INDEX(rwt_cb,%d)^2,1)", at,
                at, at),
        out->gap[f], XLSX_PLAIN);
}

static void friction_nodes(xlsx *book, const limit_table *table, const workbook_results *out)
{
    static const char *const header[] = {"f",
                                         "surface, tip below",
                                         "surface, tip above",
                                         "below, tip below",
                                         "below, tip above",
                                         "limit surface",
                                         "limit below",
                                         "limit",
                                         "difference"};
    static const char *const name[] = {"rwt_f",  "rwt_f1", "rwt_f2", "rwt_f3", "rwt_f4",
                                       "rwt_cs", "rwt_cb", "rwt_ce", "rwt_gap"};
    headers(book, FRICTIONS_COLUMN, header, 9);
    columns(book, FRICTIONS_COLUMN, name, 9, FRICTIONS);
    for (int f = 0; f < FRICTIONS; f++) {
        xlsx_number(book, WORKING_ROW + f, FRICTIONS_COLUMN, table->f[f], XLSX_PLAIN);
        friction_limit(book, f, 1, NAME_SURFACE, 0, out->low_surface[f]);
        friction_limit(book, f, 2, NAME_SURFACE, 1, out->high_surface[f]);
        friction_limit(book, f, 3, NAME_BELOW, 0, out->low_below[f]);
        friction_limit(book, f, 4, NAME_BELOW, 1, out->high_below[f]);
        friction_curves(book, out, f);
    }
}

void sheet_working(xlsx *book, const limit_table *table, const workbook_inputs *in,
                   const workbook_results *out)
{
    static void (*const groups[])(listing *, const workbook_results *) = {
        contact_steps, patch_steps, limit_steps, yield_steps, critical_steps};
    listing list = {book, WORKING_ROW};
    xlsx_text(book, WORKING_ROW - 3, WORKING_COLUMN, "Working cells: please do not edit",
              XLSX_HEADING);
    xlsx_text(book, WORKING_ROW - 2, WORKING_COLUMN,
              "They interpolate the tables of the sheet \"Elastic limit\"; what they do is on the "
              "sheet \"About\".",
              XLSX_NOTE);
    for (size_t i = 0; i < sizeof groups / sizeof groups[0]; i++)
        groups[i](&list, out);
    mark_steps(&list, in, out);
    nu_nodes(book, table);
    weight_square(book, out);
    tip_nodes(book, table, out);
    friction_nodes(book, table, out);
    xlsx_width(book, WORKING_COLUMN, WORKING_COLUMN, 24);
    xlsx_width(book, WORKING_COLUMN + 1, WORKING_COLUMN + 1, 16);
    xlsx_width(book, WORKING_COLUMN + 2, FRICTIONS_COLUMN + 8, 12);
}
