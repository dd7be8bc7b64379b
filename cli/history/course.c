/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "course.h"

#include "text/message.h"
#include "number/number.h"

#include <inttypes.h>
#include <math.h>

struct poptOption course_option_table[] = {
    {NULL, '\0', POPT_ARG_INCLUDE_TABLE, load_option_table, 0, NULL, NULL},
    {"cycles", '\0', POPT_ARG_STRING, NULL, OPTION_CYCLES,
     "Go through the loads N times, one after the other (default: see below)", "N"},
    {"until", '\0', POPT_ARG_NONE, NULL, OPTION_UNTIL,
     "Where a load cannot be applied, go as far as the loads before it", NULL},
    POPT_TABLEEND,
};

enum { CYCLES_MAX = 1000000 };

const char *course_file(const arguments *given)
{
    return given->operand != NULL && given->operand[0] != NULL ? given->operand[0]
                                                               : given->value[OPTION_HISTORY];
}

static void find_loads(const arguments *given, const input_texts *texts, load_source *from,
                       load_source *before)
{
    *from = load_source_of(given);
    *before = (load_source){0};
    if (course_file(given) != NULL) {
        before->list = from->list;
        from->list = NULL;
    }
    const char *word = given->operand != NULL ? given->operand[0] : NULL;
    if (word != NULL && given->operand[1] != NULL)
        usage_error("%s: unexpected; allowed: one file of loads", given->operand[1]);
    if (word != NULL && load_source_is_given(from))
        usage_error("%s: given together with --history; allowed: one of the two", word);
    if (word != NULL)
        from->file = word;
    if (!load_source_is_given(from))
        usage_error("a file of loads must follow, with the columns P and Q, perhaps M, "
                    "sigma; or --load P,Q for each");
    load_source_check_encoding(from);
    load_source_check(from, texts);
}

static int64_t read_cycles(const arguments *given, int64_t usual)
{
    const char *text = given->value[OPTION_CYCLES];
    int64_t cycles = usual;
    if (text != NULL && !number_read_whole(text, 1, CYCLES_MAX, &cycles))
        usage_error("--cycles %s: must be a whole number from 1 to %d", text, CYCLES_MAX);
    return cycles;
}

size_t course_row(const course *whole, size_t step)
{
    return step % whole->loads.count;
}

load course_load(const course *whole, size_t step)
{
    return whole->loads.load[course_row(whole, step)];
}

rwedge_contact *course_begin(const course *whole)
{
    rwedge_contact *contact;
    const int32_t status = case_contact(&whole->what, &contact);
    if (status != RWEDGE_OK)
        failure("the contact: %s", rwedge_strerror(status));
    load_table_apply_all(&whole->before, whole->what.f, contact);
    return contact;
}

/* Where there are several cycles, the word says in which it was. */
static void refuse(const course *whole, size_t step, bool until, const char *complaint)
{
    char word[40] = "", place[LOAD_PLACE_SIZE];
    const size_t row = course_row(whole, step);
    if (step >= whole->loads.count)
        snprintf(word, sizeof word, ", cycle %zu", step / whole->loads.count + 1);
    if (!until || step == 0)
        load_table_fail(&whole->loads, row, word, complaint);
    notice("%s%s: %s; the results end before it", load_table_place(&whole->loads, row, place), word,
           complaint);
}

static bool try_load(const course *whole, size_t step, bool until, rwedge_contact *contact)
{
    char complaint[COMPLAINT_SIZE];
    if (load_table_apply(&whole->loads, course_row(whole, step), whole->what.f, contact, complaint))
        return true;
    refuse(whole, step, until, complaint);
    return false;
}

void course_go_on(const course *whole, size_t step, rwedge_contact *contact)
{
    try_load(whole, step, false, contact);
}

static void try_loads(course *whole, bool until)
{
    const size_t wanted = whole->loads.count * (size_t)whole->cycles;
    rwedge_contact *contact = course_begin(whole);
    while (whole->steps < wanted && try_load(whole, whole->steps, until, contact)) {
        whole->steps++;
        whole->error = fmax(whole->error, rwedge_contact_error(contact));
    }
    rwedge_contact_destroy(contact);
}

void course_read(const arguments *given, char decimal_sign, course_usage usage, course *whole)
{
    input_texts texts;
    load_source from, before;
    char complaint[COMPLAINT_SIZE];
    *whole = (course){0};
    input_texts_from_options(given, &texts);
    input_options_check_hull(given);
    find_loads(given, &texts, &from, &before);
    read_cycles(given, usage.cycles);
    if (!case_read(&texts, CASE_OF_COURSE, &whole->what, complaint))
        usage_error("%s", complaint);
    load_table_read(&from, decimal_sign, &whole->loads);
    if (before.list != NULL)
        load_table_read(&before, decimal_sign, &whole->before);
    const bool to_and_fro = usage.of_two > 0 && whole->loads.count == 2;
    whole->cycles = read_cycles(given, to_and_fro ? usage.of_two : usage.cycles);
    try_loads(whole, given->value[OPTION_UNTIL] != NULL);
}
