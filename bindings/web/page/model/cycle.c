/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What the page asks about a history of loads: what its last cycle does along the surface, where
 * that is worst, and the loop. */
#include "page.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

typedef struct {
    contact_case setup;
    material constants;
    int criterion, column; /* that is chosen, and its column */
    load_list loads;
    last_cycle last;
    measured along;
    double worst_x[COLUMN_COUNT], worst[COLUMN_COUNT]; /* NAN and 0 where nothing is above 0 */
    loop loop;
} question;

static question asked; /* JavaScript reads its arrays until the next one */

static void forget(void)
{
    rwedge_contact_destroy(asked.setup.contact);
    load_list_free(&asked.loads);
    last_cycle_free(&asked.last);
    free(asked.along.place);
    free(asked.loop.x);
    memset(&asked, 0, sizeof asked);
}

/* ---- What is asked ---- */

/* From "name=text" of each constant, a line each; it takes the lines apart in place. */
static bool read_constants(char *lines, complaint *why)
{
    asked.constants = material_unknown();
    for (char *name = strtok(lines, "\n"); name != NULL; name = strtok(NULL, "\n")) {
        char *text = strchr(name, '=');
        if (text != NULL)
            *text++ = '\0';
        const int constant = text != NULL ? material_constant(name) : -1;
        if (material_is_remark(name))
            continue;
        complain(why, "%.60s: %s", name,
                 constant < 0 ? "no constant that is known here" : "must be a number");
        if (constant < 0 || !number_read_cell(text, '.', &asked.constants.value[constant]))
            return false;
    }
    return true;
}

/* By its column. */
static void choose(const char *column)
{
    asked.column = MEASURE_SWT;
    for (int i = 0; i < COLUMN_COUNT; i++)
        if (strcmp(column, measure_kinds[i].column) == 0)
            asked.column = i;
    asked.criterion = measure_criterion(asked.column);
}

static double constant_of(int constant)
{
    return constant < MATERIAL_COUNT ? asked.constants.value[constant] : 0;
}

/* The usual criteria and that which is chosen. False, with what it needs, where it lacks that. */
static bool collect_criteria(double nu, bool is_plane_stress, criteria *wanted, complaint *why)
{
    const int i = asked.criterion, own = criterion_kinds[i].constant;
    const double fs_k = asked.constants.value[MATERIAL_FS_K];
    const bool lacks_su = i == CRITERION_MCDIARMID && isnan(asked.constants.value[MATERIAL_SU]);
    const bool lacks_own = isnan(constant_of(own));
    *wanted = criteria_usual(&asked.setup);
    wanted->nu = nu;
    wanted->is_plane_stress = is_plane_stress;
    wanted->constants = &asked.constants;
    wanted->su = asked.constants.value[MATERIAL_SU];
    wanted->constant[i] = constant_of(own);
    wanted->constant[CRITERION_FATEMI_SOCIE] =
        criteria_fatemi_socie(&asked.setup, isnan(fs_k) ? 1 : fs_k);
    if (i == CRITERION_FATEMI_SOCIE && isnan(asked.setup.k))
        complain(why, "needs a yield stress");
    else
        complain(why, "needs %s%s%s of the material", lacks_own ? material_names[own] : "",
                 lacks_own && lacks_su ? " and " : "", lacks_su ? "su" : "");
    return !isnan(wanted->constant[i]) && !lacks_su;
}

/* ---- The loads ---- */

/* P and M come first; then Q and sigma go to and fro. */
static bool to_and_fro(load form, complaint *why)
{
    const load before = {.P = form.P, .M = form.M};
    if (form.Q == 0 && form.sigma == 0)
        return complain(why, "Q or sigma of the form goes to and fro where no loads are "
                             "given; both are 0");
    if (!loads_apply_next(before, asked.setup.f, asked.setup.contact, why))
        return false;
    load_list_add(&asked.loads, form, 0);
    load_list_add(&asked.loads, (load){form.P, form.M, -form.Q, -form.sigma}, 0);
    return true;
}

static bool refuse_load(int line, size_t cycle, const complaint *reason, complaint *why)
{
    char place[60] = "";
    if (line > 0)
        snprintf(place, sizeof place, cycle > 1 ? "line %d, cycle %zu: " : "line %d: ", line,
                 cycle);
    return complain(why, "%s%.300s", place, reason->text);
}

static bool go_through(const criteria *wanted, int64_t cycles, complaint *why)
{
    rwedge_contact *contact = asked.setup.contact;
    const size_t n = asked.loads.count, last = (size_t)(cycles - 1) * n;
    complaint reason;
    for (size_t i = 0; i < last + n; i++) {
        const listed_load *next = &asked.loads.load[i % n];
        if (i == last)
            last_cycle_begin(&asked.setup, wanted, contact, n, &asked.last);
        if (!loads_apply_next(next->to, asked.setup.f, contact, &reason))
            return refuse_load(next->line, i / n + 1, &reason, why);
        if (i >= last)
            last_cycle_add(contact, &asked.last);
    }
    return true;
}

/* Without a text the loads of the form go to and fro. */
static bool apply(const criteria *wanted, load form, const char *text, char decimal_sign,
                  const char *times, complaint *why)
{
    int64_t cycles;
    if (!number_read_whole(times, 1, 1000000, &cycles))
        return complain(why, "cycles must be a whole number from 1 to 1000000");
    if (asked.setup.status != RWEDGE_OK)
        return complain(why, "the contact cannot be made");
    return (text[0] != '\0' ? load_list_read(text, decimal_sign, &asked.loads, why)
                            : to_and_fro(form, why)) &&
           go_through(wanted, cycles, why);
}

/* ---- The measures ---- */

/* At places along the surface. The pressure is infinite at none. */
static int32_t measure(void)
{
    size_t n = 0;
    asked.along = stops_usual(&asked.last);
    for (size_t i = 0; i < asked.along.count; i++)
        if (!pad_is_kink(&asked.setup.shape, asked.along.place[i].x))
            asked.along.place[n++] = asked.along.place[i];
    asked.along.count = n;
    return last_cycle_measure(&asked.last, n, asked.along.place);
}

static void find_worst(int column)
{
    const measured *along = &asked.along;
    asked.worst_x[column] = NAN;
    if (along->place[measured_best(along, column)].value[column] > 0)
        last_cycle_worst(&asked.last, column, along->count, along->place, &asked.worst_x[column],
                         &asked.worst[column]);
}

/* ---- Answers ---- */

/* Where JavaScript finds numbers, how many, and how far from each other. */
static void write_numbers(const double *numbers, size_t count, size_t distance)
{
    json_add("{'address':%n,'length':%n,'distance':%n}", (double)(uintptr_t)numbers, (double)count,
             (double)distance);
}

/* One of each place along the surface; the number is that of the first. */
static void write_along(const double *number)
{
    write_numbers(number, asked.along.count, sizeof *asked.along.place / sizeof *number);
}

static void write_column(int column)
{
    json_add("{'measured':{%t:", measure_kinds[column].column);
    write_along(&asked.along.place->value[column]);
    json_add("}}");
}

static void write_worst(int column)
{
    find_worst(column);
    if (!isnan(asked.worst_x[column]))
        json_add("{'worst':{%t:{'x':%n,'value':%n}}}", measure_kinds[column].column,
                 asked.worst_x[column], asked.worst[column]);
}

/* The usual measures, and the chosen criterion behind the other ones. */
static void write_measures(void)
{
    const bool is_usual = asked.column < MEASURE_COUNT;
    json_add("{'x':");
    write_along(&asked.along.place->x);
    json_add("}");
    for (int i = 0; i < MEASURE_COUNT; i++) {
        write_column(i);
        if (i + 1 == MEASURE_SLIP_RANGE && !is_usual)
            write_column(asked.column);
        if (measure_kinds[i].part == PART_VALUE)
            write_worst(i);
    }
    if (!is_usual)
        write_worst(asked.column);
}

/* Cycles to failure; NAN where the constants are not given. */
static double life_at(double value, double limit)
{
    const double *v = asked.constants.value, least = isnan(limit) ? 0 : limit;
    if (asked.criterion == CRITERION_SWT)
        return rwedge_smith_watson_topper_life(value, asked.setup.E1, v[MATERIAL_SF], v[MATERIAL_B],
                                               v[MATERIAL_EF], v[MATERIAL_C], least);
    if (asked.criterion == CRITERION_FATEMI_SOCIE)
        return rwedge_fatemi_socie_life(value, v[MATERIAL_G], v[MATERIAL_TF], v[MATERIAL_B0],
                                        v[MATERIAL_GF], v[MATERIAL_C0], least);
    return NAN;
}

static void write_constant(int constant)
{
    if (constant != MATERIAL_COUNT)
        json_add("{'constants':{%t:%n}}", material_names[constant],
                 asked.constants.value[constant]);
}

/* What the chosen criterion comes to where it is worst, and its constants. */
static void write_verdict(void)
{
    const double limit = material_allowable(&asked.constants, asked.criterion);
    const double value = asked.worst[asked.column];
    json_add("{'limit':%n,'safety':%n,'life':%n}", limit, value > 0 ? limit / value : NAN,
             life_at(value, limit));
    write_constant(criterion_kinds[asked.criterion].constant);
    if (asked.criterion == CRITERION_MCDIARMID)
        write_constant(MATERIAL_SU);
}

static void write_loop(void)
{
    asked.loop = loop_of(&asked.last, asked.worst_x[MEASURE_ENERGY_PER_AREA]);
    if (asked.loop.count == 0)
        return;
    json_add("{'loop':{'isWhole':%n,'place':%n,'x':", (double)asked.loop.is_whole,
             asked.loop.place);
    write_numbers(asked.loop.x, asked.loop.count, 1);
    json_add("'y':");
    write_numbers(asked.loop.y, asked.loop.count, 1);
    json_add("}}");
}

static void write_answer(void)
{
    last_cycle_end(&asked.last);
    const int32_t status = measure();
    if (asked.along.count == 0)
        json_refuse("", "there is no contact in the cycle");
    else if (status != RWEDGE_OK) {
        complaint why;
        complain(&why, "This cannot be computed: %s", rwedge_strerror(status));
        json_refuse("", why.text);
    } else {
        load_list_write(&asked.loads);
        json_add("{'slipKnown':%n,'error':%n}", (double)asked.last.slip_known, asked.last.error);
        write_measures();
        write_verdict();
        write_loop();
    }
}

/* Of the case of the form, and pasted loads, which are gone through so many times: the loads of the
 * last cycle, columns that are not used, the measures along the surface, the worst places, the
 * verdict of a criterion by the constants of a material, the loop; or what is wrong. */
EXPORTED const char *page_cycle(char *lines, const char *text, int decimal_sign, const char *times,
                                const char *criterion, int is_plane_stress, char *constants)
{
    load form;
    double nu;
    criteria wanted;
    complaint why;
    forget();
    choose(criterion);
    json_begin();
    if (!read_constants(constants, &why))
        json_refuse("", why.text);
    else if (!answers_history(lines, is_plane_stress, &asked.setup, &form, &nu))
        ; /* the answer says why */
    else if (!collect_criteria(nu, is_plane_stress, &wanted, &why))
        json_refuse("criterion", why.text);
    else if (!apply(&wanted, form, text, (char)decimal_sign, times, &why))
        json_refuse("", why.text);
    else
        write_answer();
    return json_end();
}
