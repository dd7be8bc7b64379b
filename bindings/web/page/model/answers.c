/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What the page asks about one contact: the words of the model, the answer to a case, and the input
 * that gives a safety. */
#include "page.h"

#include "model/results/results.h"
#include "text/text.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* ---- Words ---- */

static void write_input_words(void)
{
    for (int i = 0; i < INPUT_COUNT; i++) {
        const int other = input_alternative(i);
        json_add("{'inputs':{%t:{'option':%t,'unit':%t,'meaning':%t}}}", input_kinds[i].column,
                 input_kinds[i].option, input_kinds[i].unit, input_kinds[i].meaning);
        if (other > i)
            json_add("{'alternatives':{%t:%t}}", input_kinds[i].column, input_kinds[other].column);
    }
}

static void write_need(const char *criterion, const char *name)
{
    const int constant = material_constant(name);
    const bool is_of_case = strcmp(name, "E") == 0 || strcmp(name, "yield_stress") == 0;
    if (constant >= 0 && !is_of_case)
        json_add("{'needs':{%t:[{'name':%t,'meaning':%t,'unit':%t}]}}", criterion, name,
                 material_meaning(constant), material_unit(constant));
}

/* What of a material each criterion asks for: its constants, its limit, its curve of life. */
static void write_needs(void)
{
    for (int i = 0; i < measure_count(); i++) {
        const char *column = measure_kind_of(i)->column;
        const int criterion = measure_criterion(i);
        if (criterion == NO_CRITERION || measure_kind_of(i)->part != PART_VALUE ||
            criterion_is_damage(criterion))
            continue;
        for (int32_t j = 0; rwedge_constant_name(criterion, j)[0] != '\0'; j++)
            write_need(column, rwedge_constant_name(criterion, j));
        write_need(column, rwedge_criterion_limit(criterion));
    }
}

EXPORTED const char *page_words(void)
{
    json_begin();
    write_input_words();
    for (int i = 0; i < RESULT_COUNT; i++)
        json_add("{'results':[{'name':%t,'unit':%t,'meaning':%t}]}", result_kinds[i].name,
                 result_kinds[i].unit, result_kinds[i].meaning);
    for (int i = 0; i < measure_count(); i++)
        json_add("{'measures':{%t:{'unit':%t,'meaning':%t}}}", measure_kind_of(i)->column,
                 measure_kind_of(i)->unit, measure_kind_of(i)->meaning);
    write_needs();
    return json_end();
}

/* NAN where the text is none; the decimal sign is a point. */
EXPORTED double page_number(const char *text)
{
    double value;
    return number_read_cell(text, '.', &value) ? value : NAN;
}

/* ---- One contact ---- */

static rwedge_contact *handed_over;

void answers_hand_over(rwedge_contact *contact)
{
    rwedge_contact_destroy(handed_over);
    handed_over = contact;
}

/* The contact of the last answer; the caller destroys it. NULL where there is none. */
EXPORTED rwedge_contact *page_contact(void)
{
    rwedge_contact *contact = handed_over;
    handed_over = NULL;
    return contact;
}

static void refuse(int input, const char *fault)
{
    json_fault(input < INPUT_COUNT ? input_kinds[input].column : "", fault);
}

static void write_verdict(verdict result)
{
    json_add("{'verdict':{'colour':%t,'text':%t,'strength':%t,'factor':%n}}", result.colour,
             result.text, result.strength, result.factor);
}

/* The numbers of all inputs, 0 where they are not given, and a refusal of each that is none. */
static bool write_inputs(const input_texts *texts, double value[INPUT_COUNT])
{
    complaint why;
    char all[1000] = "";
    for (int i = INPUT_P; i <= INPUT_SIGMA; i++)
        json_add("{'shares':{%t:%n}}", input_kinds[i].column, field_share(i));
    for (int i = 0; i < INPUT_COUNT; i++) {
        value[i] = 0;
        if (!input_is_given(texts, i))
            continue;
        if (!input_read(texts, i, &value[i], &why)) {
            refuse(i, why.text);
            list_add(all, sizeof all, "; ", "%s", why.text);
            continue;
        }
        json_add("{'inputs':{%t:%n}}", input_kinds[i].column, value[i]);
    }
    if (all[0] != '\0')
        write_verdict(verdict_of_fault(RWEDGE_OK, all));
    return all[0] == '\0';
}

/* A profile has its slopes, for its drawing; its sharp edges have an infinite pressure. */
static void write_setup(const contact_case *setup)
{
    const pad *shape = &setup->shape;
    json_add("{'setup':{'nu1':%n,'theta':%n,'a':%n,'radius':%n,'flat':%n,'M':%n,'Q':%n,'sigma':%n,"
             "'f':%n,'k':%n,'body':%n,'coupled':%n,'places':[]}}",
             setup->nu1, shape->theta, shape->a, shape->radius, shape->flat, setup->M, setup->Q,
             setup->sigma, setup->f, setup->k, field_is_of_pad() ? 2.0 : 1.0,
             (double)setup->is_coupled);
    for (size_t i = 0; shape->places != NULL && i < shape->places->count; i++)
        json_add("{'setup':{'places':[{'x':%n,'slope':%n}]}}", shape->places->x[i],
                 shape->places->slope[i]);
    json_add("{'remark':%t}", field_remark());
}

/* The pad becomes body 1 of the texts where k is its own. */
static bool take_body(input_texts *texts)
{
    complaint why;
    char all[300];
    if (!field_is_of_pad() || other_body_take(texts, &why))
        return true;
    snprintf(all, sizeof all, "the strength of the pad: %s", why.text);
    refuse(INPUT_COUNT, all);
    write_verdict(verdict_of_fault(RWEDGE_OK, all));
    return false;
}

static bool write_case(const input_texts *texts, case_needs needs, contact_case *setup)
{
    complaint why;
    if (!case_read(texts, needs, setup, &why)) {
        refuse(setup->at_fault, why.text);
        write_verdict(verdict_of_fault(setup->status, why.text));
        return false;
    }
    write_setup(setup);
    return true;
}

static void write_hardest(const results *answer)
{
    if (isfinite(answer->hardest_von_mises)) /* not at a sharp apex */
        json_add("{'hardest':{'factor':%n,'x':%n,'y':%n,'von_mises':%n}}",
                 answer->value[RESULT_YIELD_FACTOR].number, answer->hardest_x, answer->hardest_y,
                 answer->hardest_von_mises);
}

static void write_zones(const rwedge_contact *contact)
{
    const size_t n = rwedge_contact_zone_count(contact);
    double *edges = memory_zeroed(3 * n + 1, sizeof *edges);
    rwedge_contact_zones(contact, n, edges, edges + n, edges + 2 * n);
    for (size_t i = 0; i < n; i++)
        json_add("{'zones':[{'from':%n,'to':%n,'slip':%n}]}", edges[i], edges[n + i],
                 edges[2 * n + i]);
    free(edges);
}

static void add_assumed(void *context, const char *text)
{
    (void)context;
    json_add("{'assumed':[%t]}", text);
}

static void add_told(void *context, const char *text)
{
    (void)context;
    json_add("{'told':[%t]}", text);
}

/* Writes what was assumed, and which errors are told, as a report has them. */
static void write_remarks(const contact_case *setup, const input_texts *texts,
                          const results *answer)
{
    const profile_making *making = field_making();
    const case_said said = {.has_E2 = input_is_given(texts, INPUT_E2),
                            .has_f = input_is_given(texts, INPUT_F),
                            .fits = making->fits,
                            .takes_hull = making->takes_hull,
                            .has_units = field_units()->is_known,
                            .has_width = !isnan(field_units()->width),
                            .is_of_body2 = field_is_of_pad()};
    assumptions_tell(setup, &said, add_assumed, NULL);
    errors_tell(setup, answer->doubts, false, add_told, NULL);
}

static void write_equations(const contact_case *setup, const results *answer)
{
    equation all[EQUATIONS_MAX];
    const int count = equations_of(setup, answer, all);
    for (int i = 0; i < count; i++)
        json_add("{'equations':[{'name':%t,'symbols':%t,'numbers':%t,'value':%n,'unit':%t}]}",
                 all[i].name, all[i].symbols, all[i].numbers, all[i].value, all[i].unit);
}

static void write_results(const contact_case *setup, const input_texts *texts, char decimal_sign,
                          const char *length)
{
    results answer;
    complaint why;
    const results_wanted wanted = {
        .edges = true, .shakedown = true, .moment = setup->is_held, .coupling = setup->is_coupled};
    bool there = results_compute(setup, wanted, &answer, &why);
    if (there && setup->status != RWEDGE_OK)
        there = complain(&why, "%s", rwedge_strerror(setup->status));
    if (!there) {
        refuse(INPUT_COUNT, why.text);
        write_verdict(verdict_of_fault(RWEDGE_OK, why.text));
        return;
    }
    there = results_find_hardest(setup, &answer) == RWEDGE_OK;
    if (field_is_of_pad())
        other_body_mirror(&answer);
    if (there)
        write_hardest(&answer);
    write_zones(setup->contact);
    resolution_write(setup);
    for (int i = 0; i < RESULT_COUNT; i++) {
        const cell *value = &answer.value[i];
        if (value->text != NULL && value->text[0] != '\0')
            json_add("{'results':{%t:%t}}", result_kinds[i].name, value->text);
        else
            json_add("{'results':{%t:%n}}", result_kinds[i].name,
                     value->text == NULL ? value->number : NAN);
    }
    write_verdict(verdict_of(&answer, decimal_sign, length));
    write_remarks(setup, texts, &answer);
    write_equations(setup, &answer);
}

/* Answers the case of the form: its inputs, numbers and results, or what is wrong; its verdict,
 * with the unit of lengths. The contact under its loads is handed over. */
EXPORTED const char *page_answer(char *fields, const char *length, int decimal_sign)
{
    contact_case setup = {.contact = NULL};
    input_texts texts = field_texts(fields);
    double value[INPUT_COUNT];
    json_begin();
    if (write_inputs(&texts, value) && take_body(&texts) &&
        write_case(&texts, CASE_OF_SOLVE, &setup))
        write_results(&setup, &texts, (char)decimal_sign, length);
    answers_hand_over(setup.contact);
    return json_end();
}

bool answers_history(char *fields, bool is_plane_stress, contact_case *setup, load *form,
                     double *nu)
{
    input_texts texts = field_texts(fields);
    double value[INPUT_COUNT];
    if (!write_inputs(&texts, value))
        return false;
    if (field_is_of_pad()) /* a history is of the half-plane */
        texts.text[INPUT_K] = texts.text[INPUT_YIELD_STRESS] = NULL;
    *nu = value[INPUT_NU1];
    texts.is_plane_stress = texts.is_plane_stress || is_plane_stress;
    *form = (load){
        .P = value[INPUT_P], .M = value[INPUT_M], .Q = value[INPUT_Q], .sigma = value[INPUT_SIGMA]};
    for (int i = INPUT_P; i <= INPUT_SIGMA; i++)
        texts.text[i] = NULL;
    return write_case(&texts, CASE_OF_HISTORY, setup);
}

/* Finds, for the case of the form, whose own text of that input does not count, the number that
 * gives the safety, or says why there is none. `on` is "P", of full sliding; "stress", under the
 * loads; or "sliding", the stress in full sliding. */
EXPORTED const char *page_find(char *fields, const char *name, const char *on, double safety)
{
    input_texts texts = field_texts(fields);
    const int input = inverse_input(name);
    contact_case setup = {.contact = NULL};
    double value;
    complaint why;
    const bool is_of_load = strcmp(on, "P") == 0;
    json_begin();
    if (!take_body(&texts))
        return json_end();
    if (is_of_load
            ? inverse_find(&texts, input, safety, &setup, &value, &why)
            : inverse_find_stress(&texts, input, safety, strcmp(on, "sliding") == 0, &value, &why))
        json_add("{'value':%n}", value);
    else
        json_fault("", why.text);
    rwedge_contact_destroy(setup.contact);
    return json_end();
}
