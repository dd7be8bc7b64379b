/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What the page asks about a history of loads: what its last cycle does along the surface, and
 * where that is worst. */
#include "page.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

typedef struct {
    contact_case setup;
    unit_system units;
    material constants;
    int criterion, column; /* that is chosen, and its column */
    criteria wanted;
    load_list loads;
    size_t done, all; /* loads of all cycles */
    bool is_refused;  /* the answer says why */
    last_cycle last;
    measured along;
    worst_row worst[COLUMN_MAX];
    bool is_answered;
} question;

static question asked;

static void forget(void)
{
    rwedge_contact_destroy(asked.setup.contact);
    load_list_free(&asked.loads);
    last_cycle_free(&asked.last);
    free(asked.along.place);
    memset(&asked, 0, sizeof asked);
}

/* ---- What is asked ---- */

/* Those of one line, "name=text", which it takes apart in place. */
static constant_words words_of(char *line)
{
    char *text = strchr(line, '=');
    if (text != NULL)
        *text++ = '\0';
    return (constant_words){line, text != NULL ? text : line + strlen(line)};
}

static bool take_constants(size_t count, const constant_words words[])
{
    const constant_words *fault;
    complaint why;
    if (material_take_all(count, words, &asked.units, &asked.constants, &fault, &why))
        return true;
    return material_constant(fault->name) < 0
               ? json_refuse("", "%.60s: %s", fault->name, why.text)
               : json_refuse("", "%.60s %.60s: %s", fault->name, fault->text, why.text);
}

/* From a line of each constant. */
static bool read_constants(char *lines)
{
    constant_words *words = NULL;
    size_t count = 0;
    asked.constants = material_unknown();
    for (char *line = strtok(lines, "\n"); line != NULL; line = strtok(NULL, "\n")) {
        words = memory_for_one_more(words, count, sizeof *words);
        words[count++] = words_of(line);
    }
    const bool is_read = take_constants(count, words);
    free(words);
    return is_read;
}

/* Chooses a measure by its column. */
static void choose(const char *column)
{
    asked.column = measure_column_named(column);
    if (asked.column < 0)
        asked.column = measure_column(RWEDGE_MEASURE_SWT, PART_VALUE);
    asked.criterion = measure_criterion(asked.column);
}

/* The usual criteria and that which is chosen. False where it lacks what it needs. */
static bool collect_criteria(double nu, bool is_plane_stress)
{
    criteria *wanted = &asked.wanted;
    const int i = asked.criterion;
    *wanted = criteria_usual(&asked.setup);
    wanted->nu = nu;
    wanted->is_plane_stress = is_plane_stress;
    wanted->given = asked.constants;
    criteria_take(&asked.setup, RWEDGE_MEASURE_FATEMI_SOCIE, wanted);
    const char *lacks = i == NO_CRITERION ? NULL : criteria_take(&asked.setup, i, wanted);
    if (lacks == NULL) {
        if (i != NO_CRITERION)
            wanted->is_wanted[i] = true;
        return true;
    }
    return strcmp(lacks, "yield_stress") == 0
               ? json_refuse("criterion", "needs a yield stress")
               : json_refuse("criterion", "needs %s of the material", lacks);
}

/* ---- The loads ---- */

/* The next load; false where it is refused. Those of the form have no line. */
static bool apply_next(listed_load next, size_t cycle)
{
    complaint why;
    if (loads_apply_next(next.to, &asked.setup.shape, asked.setup.f, asked.setup.contact, &why))
        return true;
    if (next.line == 0)
        return json_refuse("", "%s", why.text);
    return cycle > 1 ? json_refuse("", "line %d, cycle %zu: %s", next.line, cycle, why.text)
                     : json_refuse("", "line %d: %s", next.line, why.text);
}

/* P and M come first; then Q and sigma go to and fro. */
static bool to_and_fro(load form)
{
    const listed_load before = {.to = {.P = form.P, .M = form.M}};
    if (form.Q == 0 && form.sigma == 0)
        return json_refuse("", "Q or sigma of the form goes to and fro where no loads are given; "
                               "both are 0");
    if (!apply_next(before, 1))
        return false;
    load_list_add(&asked.loads, form, 0);
    load_list_add(&asked.loads,
                  (load){.P = form.P, .M = form.M, .Q = -form.Q, .sigma = -form.sigma}, 0);
    return true;
}

/* The next load of all cycles; false where it is refused. */
static bool go_on(void)
{
    const rwedge_contact *contact = asked.setup.contact;
    const size_t i = asked.done++, n = asked.loads.count, last = asked.all - n;
    if (i == last)
        last_cycle_begin(&asked.setup, &asked.wanted, contact, n, &asked.last);
    if (!apply_next(asked.loads.load[i % n], i / n + 1))
        return false;
    load *to = &asked.loads.load[i % n].to;
    if (to->is_driven)
        to->Q = loads_of(contact).Q;
    if (i >= last)
        last_cycle_add(*to, contact, &asked.last);
    return true;
}

/* The moment of a pad that is held is a result. */
static bool has_no_moments(const load_list *loads)
{
    for (size_t i = 0; asked.setup.is_held && i < loads->count; i++)
        if (loads->load[i].to.M != 0)
            return json_refuse("", "line %d: M %.6g: of a pad that is held M is a result",
                               loads->load[i].line, loads->load[i].to.M);
    return true;
}

/* A rig that prescribes displacements keeps the tilt. */
static bool keeps_tilt(const load_list *loads)
{
    for (size_t i = 1; i < loads->count; i++)
        if (loads->load[i].to.is_driven && loads->load[i].to.tilt != loads->load[0].to.tilt)
            return json_refuse("",
                               "line %d: tilt %.6g: must be that of the first load, %.6g, "
                               "beside a displacement",
                               loads->load[i].line, loads->load[i].to.tilt, loads->load[0].to.tilt);
    return true;
}

/* A pad whose loads have tilts comes down at the first. */
static bool hold(void)
{
    const load_list *loads = &asked.loads;
    const double tilt = loads->count > 0 ? loads->load[0].to.tilt : 0;
    if (loads->count == 0 || !loads->load[0].to.is_guided)
        return has_no_moments(loads);
    if (asked.setup.rotation == ROTATION_FREE)
        return json_refuse("", "column tilt: given together with a rotation that is free");
    if (asked.setup.is_held && asked.setup.rotation != ROTATION_HELD)
        return json_refuse("", "column tilt: given together with the tilt of the form; allowed: "
                               "one of the two");
    if (!keeps_tilt(loads))
        return false;
    return loads_hold(tilt, asked.setup.contact) == RWEDGE_OK ||
           json_refuse("", "tilt %.6g: so large a tilt lays a flank on the surface", tilt);
}

/* Without a text the loads of the form go to and fro. */
static bool collect_loads(load form, const char *text, char decimal_sign, const char *times)
{
    int64_t cycles;
    if (!number_read_whole(times, 1, 1000000, &cycles))
        return json_refuse("", "cycles must be a whole number from 1 to 1000000");
    if (asked.setup.status != RWEDGE_OK)
        return json_refuse("", "the contact cannot be made");
    if (!(text[0] != '\0' ? load_list_read(text, decimal_sign, &asked.loads) && hold()
                          : to_and_fro(form)))
        return false;
    asked.all = (size_t)cycles * asked.loads.count;
    return true;
}

/* ---- The measures ---- */

/* Measures at places along the surface, and where they are worst. The pressure is infinite at
 * none. */
static int32_t measure(void)
{
    size_t n = 0;
    asked.along = stops_usual(&asked.last);
    for (size_t i = 0; i < asked.along.count; i++)
        if (!pad_is_kink(&asked.setup.shape, asked.along.place[i].x))
            asked.along.place[n++] = asked.along.place[i];
    asked.along.count = asked.along.line = n;
    const int32_t status = last_cycle_measure(&asked.last, n, asked.along.place);
    return status == RWEDGE_OK && n > 0 ? worst_places(&asked.last, &asked.along, asked.worst)
                                        : status;
}

/* ---- Answers ---- */

/* One of each place along the surface; the number is that of the first. */
static void write_along(const double *number)
{
    const size_t distance = sizeof *asked.along.place / sizeof *number;
    json_add("[");
    for (size_t i = 0; i < asked.along.count; i++)
        json_add("%n", number[i * distance]);
    json_add("]");
}

static void write_column(int column)
{
    json_add("{'measured':{%t:", measure_kind_of(column)->column);
    write_along(&asked.along.place->value[column]);
    json_add("}}");
}

static void write_worst(int column)
{
    const worst_row *row = &asked.worst[column];
    if (!isnan(row->value))
        json_add("{'worst':{%t:{'x':%n,'value':%n}}}", measure_kind_of(column)->column, row->x,
                 row->value);
}

/* Those that are always there, and the chosen criterion before those of friction. */
static void write_measures(void)
{
    const bool is_usual = measure_kind_of(asked.column)->condition == COLUMN_ALWAYS;
    json_add("{'x':");
    write_along(&asked.along.place->x);
    json_add("}");
    for (int i = 0; i < measure_count(); i++) {
        const measure_kind *kind = measure_kind_of(i);
        if (kind->condition != COLUMN_ALWAYS)
            continue;
        if (kind->number == RWEDGE_MEASURE_SLIP_RANGE && !is_usual)
            write_column(asked.column);
        write_column(i);
        write_worst(i);
    }
    if (!is_usual)
        write_worst(asked.column);
}

/* What the chosen criterion comes to where it is worst, and its constants. Its damage is computed
 * there alone. */
static void write_verdict(void)
{
    const worst_row *row = &asked.worst[asked.column];
    measured_place at = {.x = row->x, .y = row->y};
    const int damage = measure_damage(asked.criterion);
    if (criterion_is_damage(damage))
        criteria_take(&asked.setup, damage, &asked.last.asked);
    if (last_cycle_measure(&asked.last, 1, &at) != RWEDGE_OK)
        return;
    const criterion_verdict verdict = criterion_verdict_at(&asked.last.asked, &at, asked.criterion);
    json_add("{'limit':%n,'safety':%n,'life':%n}", verdict.allowable, verdict.safety, verdict.life);
    for (int32_t j = 0; j < rwedge_criterion_constants(asked.criterion); j++) {
        const char *name = rwedge_constant_name(asked.criterion, j);
        if (material_is_option(material_constant(name)))
            json_add("{'constants':{%t:%n}}", name, asked.wanted.constants[asked.criterion][j]);
    }
}

static void write_answer(void)
{
    char computed[DOUBT_SIZE] = "";
    int32_t status = last_cycle_end(&asked.last);
    if (status == RWEDGE_OK)
        status = measure();
    if (status == RWEDGE_OK && asked.along.count == 0)
        json_refuse("", "there is no contact in the cycle");
    else if (status != RWEDGE_OK)
        json_refuse("", "This cannot be computed: %s", rwedge_strerror(status));
    else {
        load_list_write(&asked.loads);
        doubts_write((doubts){.error = asked.last.error}, computed, sizeof computed);
        json_add("{'slipKnown':%n,'computed':%t}", (double)asked.last.slip_known, computed);
        write_measures();
        write_verdict();
        answers_hand_over(asked.last.before);
        asked.last.before = NULL;
        asked.is_answered = true;
    }
}

const last_cycle *cycle_answered(const material **constants)
{
    *constants = &asked.constants;
    return asked.is_answered ? &asked.last : NULL;
}

/* Asks about the case of the form, and pasted loads, which are gone through so many times. The
 * constants of the material may have their units; `units` are those of all else. page_cycle_go()
 * and page_cycle_answer() follow. */
EXPORTED void page_cycle_begin(char *fields, const char *text, int decimal_sign, const char *times,
                               const char *criterion, int is_plane_stress, char *constants,
                               const char *units)
{
    load form;
    double nu;
    forget();
    asked.units = units_named(units);
    choose(criterion);
    json_begin();
    asked.is_refused = !(read_constants(constants) &&
                         answers_history(fields, is_plane_stress, &asked.setup, &form, &nu) &&
                         collect_criteria(nu, is_plane_stress) &&
                         collect_loads(form, text, (char)decimal_sign, times));
}

/* Goes to the next load. The part of them that is done: 1 where none is left, or one is refused. */
EXPORTED double page_cycle_go(void)
{
    asked.is_refused = asked.is_refused || !go_on();
    return asked.is_refused ? 1 : (double)asked.done / (double)asked.all;
}

/* The loads of the last cycle, columns that are not used, the measures along the surface, the worst
 * places, the verdict of a criterion by the constants of a material; or what is wrong. The contact
 * before the cycle is handed over. */
EXPORTED const char *page_cycle_answer(void)
{
    if (!asked.is_refused)
        write_answer();
    return json_end();
}
