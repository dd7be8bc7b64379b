/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "series.h"

#include <math.h>
#include <string.h>

/* A row that is read. */
typedef struct {
    const series *all;
    const char *const *cell;
    input_texts texts; /* of the contact, without P and M */
    test_case *to;
} reader;

static bool is_blank(const char *text)
{
    return text[strspn(text, " \t")] == '\0';
}

const char *test_log_name(const series *all, const char *const row[], size_t count)
{
    const bool has_name = series_has(all, TEST_LOADS) && all->column[TEST_LOADS] < count;
    return has_name && !is_blank(row[all->column[TEST_LOADS]]) ? row[all->column[TEST_LOADS]] : "";
}

/* ---- Numbers ---- */

static bool has_cell(const reader *r, int column)
{
    return series_has(r->all, column) && !is_blank(r->cell[r->all->column[column]]);
}

/* The number of a cell, or what stands for one that is empty or not there. */
static bool read_number(const reader *r, int column, double otherwise, double *value,
                        complaint *why)
{
    *value = otherwise;
    if (!has_cell(r, column))
        return true;
    return header_cell(&r->all->names, r->cell, r->all->column[column], test_columns[column].name,
                       r->all->constants.cell_decimal_sign, value, why);
}

/* Run-outs as tables have them: ">1e7", "> 10^7". */
static bool read_life(const reader *r, complaint *why)
{
    const char *text = has_cell(r, TEST_LIFE) ? r->cell[r->all->column[TEST_LIFE]] : "";
    const char *number = text + strspn(text, " \t");
    double value = NAN, power;
    r->to->is_run_out = *number == '>';
    number += r->to->is_run_out ? 1 : 0;
    number += strspn(number, " \t");
    const bool is_power = strncmp(number, "10^", 3) == 0;
    if (is_blank(text))
        value = NAN;
    else if (is_power && number_read_cell(number + 3, '.', &power))
        value = pow(10, power);
    else if (is_power || !number_read_cell(number, r->all->constants.cell_decimal_sign, &value))
        value = -1;
    r->to->tested = value;
    return isnan(value) || (value > 0 && value <= 1e60) ||
           complain(why, "%s %.60s: must be a number above 0, or a run-out, as >1e7",
                    test_columns[TEST_LIFE].name, text);
}

/* ---- The contact ---- */

/* An input of the row, 0 where it is not given. */
static bool read_input(const input_texts *texts, int input, double *value, complaint *why)
{
    *value = 0;
    return !input_is_given(texts, input) || input_read(texts, input, value, why);
}

static bool has_second_body(const input_texts *texts)
{
    double E2;
    complaint why;
    return !(input_is_given(texts, INPUT_E2) && input_read(texts, INPUT_E2, &E2, &why) &&
             isinf(E2));
}

/* An empty cell is a gap in the data, but for P where something else gives it. */
static bool refuse_gaps(const reader *r, const input_texts *texts, complaint *why)
{
    const bool needs_P = !has_cell(r, TEST_P0) && !has_cell(r, TEST_LOADS);
    for (int i = 0; i < INPUT_COUNT; i++) {
        const bool may_lack =
            (i == INPUT_P && !needs_P) || (i == INPUT_NU2 && !has_second_body(texts));
        if (header_has_input(&r->all->names, i) && !input_is_given(texts, i) && !may_lack)
            return complain(why, "%s: the cell is empty", input_kinds[i].column);
    }
    return true;
}

/* In plane stress the contact does not have it, but the strains do. */
static bool read_constants(const reader *r, complaint *why)
{
    const series *all = r->all;
    test_case *to = r->to;
    to->asked = all->asked;
    for (int i = 0; i < material_count(); i++) {
        const size_t column = all->constant[i];
        double *value = &to->asked.given.value[i];
        if (column == all->names.count)
            continue;
        if (!header_cell(&all->names, r->cell, column, material_name(i),
                         all->constants.cell_decimal_sign, value, why))
            return false;
        if (!material_is_in_range(i, *value))
            return complain(why, "%s %.60s: must be a number, %s", material_name(i),
                            r->cell[column], material_allowed(i));
    }
    return !to->asked.is_plane_stress || read_input(&r->texts, INPUT_NU1, &to->asked.nu, why);
}

/* The criteria are those of the series. */
static bool take_constants(test_case *to, complaint *why)
{
    if (!to->asked.is_plane_stress)
        to->asked.nu = to->setup.nu1;
    for (int i = 0; i < CRITERION_COUNT; i++) {
        const char *lacks =
            to->asked.is_computed[i] ? criteria_take(&to->setup, i, &to->asked) : NULL;
        if (lacks != NULL)
            return complain(why, "%s: needs %s", criterion_name(i), lacks);
    }
    return true;
}

/* ---- The loads ---- */

/* The load of a p0, of the contact without loads. */
static bool find_P(const reader *r, double M, complaint *why)
{
    test_case *to = r->to;
    double p0;
    if (!read_number(r, TEST_P0, 0, &p0, why))
        return false;
    if (M != 0)
        return complain(why, "p0 %.6g: given together with M; allowed: P with it", p0);
    if (!(p0 > 0))
        return complain(why, "p0 %.6g: must be a number above 0", p0);
    const int32_t status = rwedge_contact_peak_load(to->setup.contact, p0, &to->P);
    if (status == RWEDGE_EABSENT)
        return complain(why, "p0 %.6g: the pad has this largest pressure under no load", p0);
    return status == RWEDGE_OK || complain(why, "p0 %.6g: %s", p0, rwedge_strerror(status));
}

static void add_before(test_case *to, load next)
{
    to->before[to->before_count++] = next;
}

/* P and M come under the tension before; then Q and sigma go together. */
static bool make_cycle(const reader *r, double M, double before, complaint *why)
{
    test_case *to = r->to;
    double Q_max, Q_min, sigma_max, sigma_min;
    if (!read_number(r, TEST_Q_MAX, 0, &Q_max, why) ||
        !read_number(r, TEST_Q_MIN, -Q_max, &Q_min, why) ||
        !read_number(r, TEST_SIGMA_MAX, 0, &sigma_max, why) ||
        !read_number(r, TEST_SIGMA_MIN, -sigma_max, &sigma_min, why))
        return false;
    if (!has_cell(r, TEST_Q_MAX) && !has_cell(r, TEST_SIGMA_MAX))
        return complain(why, "Q_max: the cell is empty, and so is that of sigma_max");
    to->own[0] = (load){.P = to->P, .M = M, .Q = Q_max, .sigma = sigma_max};
    to->own[1] = (load){.P = to->P, .M = M, .Q = Q_min, .sigma = sigma_min};
    if (before != 0)
        add_before(to, (load){.sigma = before});
    add_before(to, (load){.P = to->P, .M = M, .sigma = before});
    to->cycle = to->own;
    to->count = 2;
    return true;
}

static bool take_log(const reader *r, const test_log *log, double M, double before, complaint *why)
{
    static const int others[] = {TEST_Q_MAX, TEST_Q_MIN, TEST_SIGMA_MAX, TEST_SIGMA_MIN};
    test_case *to = r->to;
    for (int i = 0; i < 4; i++)
        if (has_cell(r, others[i]))
            return complain(why, "%s: given together with loads; allowed: one of the two",
                            test_columns[others[i]].name);
    if (log->why.text[0] != '\0')
        return complain(why, "%s", log->why.text);
    if (loads_are_guided(log->to, log->count))
        return complain(why, "loads: tilts are not taken here; allowed: a column tilt beside");
    if (before != 0)
        add_before(to, (load){.sigma = before});
    if (to->P > 0)
        add_before(to, (load){.P = to->P, .M = M, .sigma = before});
    to->cycle = log->to;
    to->count = log->count;
    return true;
}

static bool read_loads(const reader *r, const input_texts *texts, const test_log *log,
                       complaint *why)
{
    test_case *to = r->to;
    double M, before;
    if (!read_input(texts, INPUT_P, &to->P, why) || !read_input(texts, INPUT_M, &M, why) ||
        !read_number(r, TEST_SIGMA_BEFORE, 0, &before, why))
        return false;
    if (M != 0 && to->setup.is_held)
        return complain(why, "M %.6g: given together with tilt; allowed: one of the two", M);
    if (has_cell(r, TEST_P0) && to->P > 0)
        return complain(why, "p0: given together with P; allowed: one of the two");
    if (has_cell(r, TEST_P0) && !find_P(r, M, why))
        return false;
    return log != NULL ? take_log(r, log, M, before, why) : make_cycle(r, M, before, why);
}

/* ---- All ---- */

static input_texts texts_of(const series *all, const char *const row[])
{
    const char *text[INPUT_COUNT];
    for (int i = 0; i < INPUT_COUNT; i++)
        text[i] = header_has_input(&all->names, i) ? row[all->names.column[i]] : NULL;
    return header_texts(&all->names, &all->constants, text);
}

double test_friction(const series *all, const char *const row[], size_t count)
{
    double f;
    complaint why;
    if (count != all->names.count)
        return 0;
    const input_texts texts = texts_of(all, row);
    return read_input(&texts, INPUT_F, &f, &why) ? f : 0;
}

bool test_read(const series *all, const char *const row[], size_t count, const test_log *log,
               test_case *to, complaint *why)
{
    *to = (test_case){.tested = NAN};
    if (!header_fits(all->names.count, count, all->separator, why))
        return false;
    const input_texts texts = texts_of(all, row);
    reader r = {all, row, texts, to};
    r.texts.text[INPUT_P] = r.texts.text[INPUT_M] = NULL;
    if (!refuse_gaps(&r, &texts, why) || !header_texts_agree(&texts, &all->constants, why) ||
        !read_life(&r, why) || !read_constants(&r, why) ||
        !case_read(&r.texts, CASE_OF_HISTORY, &to->setup, why))
        return false;
    if (to->setup.status != RWEDGE_OK)
        return complain(why, "the contact: %s", rwedge_strerror(to->setup.status));
    return take_constants(to, why) && read_loads(&r, &texts, log, why);
}
