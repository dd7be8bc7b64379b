/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "setup.h"

#include <inttypes.h>
#include <math.h>
#include <string.h>

struct poptOption load_option_table[] = {
    {VALUE("load", OPTION_LOAD),
     "The next load of a history instead of --P and --Q, or P,M,Q,sigma; repeat it", "P,Q"},
    {VALUE("history", OPTION_HISTORY),
     "A history from a CSV file with the columns P, Q, perhaps M or tilt, sigma; - is standard "
     "input",
     "FILE"},
    {VALUE("compliance", OPTION_COMPLIANCE),
     "The rig prescribes the column displacement in place of Q; how far it gives way under Q = 1",
     "NUMBER"},
    {ENCODING_OPTION},
    {INCLUDED(exactness_option_table), NULL, NULL},
    POPT_TABLEEND,
};

const char *history_file(const arguments *line)
{
    return line->operand != NULL && line->operand[0] != NULL ? line->operand[0]
                                                             : line->value[OPTION_HISTORY];
}

/* What has been read, or offered. */
static load_history kept;
static bool is_kept, has_compliance;

/* A load as it was typed: forces of the whole contact, and a tension that may be a force. Of two
 * numbers, moment and tension are those of the load before, which were shared out then. */
static void share_out(const unit_system *units, bool is_whole, load *to)
{
    const double width = isnan(units->width) ? 1 : units->width,
                 section = isnan(units->section) ? 1 : units->section;
    to->P /= width;
    to->Q /= width;
    to->M /= is_whole ? width : 1;
    to->sigma /= is_whole ? section : 1;
}

void load_history_offer(const char *name, const unit_system *units, const load *to, size_t count)
{
    kept = (load_history){.name = name,
                          .is_of_case = true,
                          .load = memory_zeroed(count, sizeof *to),
                          .row = memory_zeroed(count, sizeof *kept.row),
                          .count = count};
    memcpy(kept.load, to, count * sizeof *to);
    for (size_t i = 0; i < count; i++)
        share_out(units, true, &kept.load[i]);
    is_kept = true;
}

bool history_is_given(const arguments *line)
{
    return history_file(line) != NULL || line->value[OPTION_LOAD] != NULL || kept.is_of_case;
}

void history_check(const arguments *line)
{
    if (line->value[OPTION_COMPLIANCE] != NULL && !history_is_given(line))
        usage_error("--compliance %s: needs loads from a file with the column displacement",
                    line->value[OPTION_COMPLIANCE]);
    const char *encoding = line->value[OPTION_ENCODING];
    if (encoding != NULL && history_file(line) == NULL &&
        line->value[OPTION_INPUT + INPUT_PROFILE] == NULL)
        usage_error("--encoding %s: needs --history or --profile", encoding);
    for (int i = INPUT_P; i <= INPUT_SIGMA && history_is_given(line); i++)
        if (line->value[OPTION_INPUT + i] != NULL)
            usage_error("%s %s: given together with %s, which has the loads; allowed: one of the "
                        "two",
                        input_kinds[i].flag, line->value[OPTION_INPUT + i],
                        history_file(line) == NULL            ? "--load"
                        : line->value[OPTION_HISTORY] != NULL ? "--history"
                                                              : history_file(line));
}

/* ---- The rig ---- */

/* The compliance in the working units, per unit length. */
static double read_compliance(const arguments *line)
{
    const unit_system *units = units_of(line);
    const char *text = line->value[OPTION_COMPLIANCE], *own = NULL;
    double value;
    complaint why;
    if (text == NULL)
        text = "";
    if (loads_read_compliance(text, '.', units, &value, &why))
        return value;
    const bool has_unit = quantity_read(text, '.', &value, &own) && own != NULL;
    usage_error("--compliance %s: %s%s", text, why.text,
                has_unit && !units->is_known ? ": --units, such as --units mm,N,MPa, converts it"
                                             : "");
}

/* Gives it to loads that are driven; refuses it where none is. */
void load_history_give_compliance(const arguments *line, load_history *loads)
{
    const char *text = line->value[OPTION_COMPLIANCE];
    const bool is_driven = loads_are_driven(loads->load, loads->count);
    if (text == NULL && !is_driven)
        return;
    if (!is_driven)
        usage_error("--compliance %s: needs loads from a file with the column displacement", text);
    const double compliance = read_compliance(line);
    for (size_t i = 0; i < loads->count; i++)
        loads->load[i].compliance = compliance;
    if (!loads->is_of_case && header_has_input(&loads->names, INPUT_Q))
        notice("%s: column Q is not used: the displacement stands in its place", loads->name);
}

/* ---- Rows in memory ---- */

static void add(load_history *loads, load next, csv_row row)
{
    loads->load = memory_for_one_more(loads->load, loads->count, sizeof *loads->load);
    loads->row = memory_for_one_more(loads->row, loads->count, sizeof *loads->row);
    loads->load[loads->count] = next;
    loads->row[loads->count++] = row;
}

/* ---- The command line ---- */

/* A first load with decimal commas, as 135,75,0,0, is four numbers too. */
static void say_four_values(const char *line, int length)
{
    static const char digits[] = "0123456789";
    const int P = (int)strspn(line, digits);
    const char *moment = line + P + (line[P] == ',' ? 1 : 0);
    const int M = (int)strspn(moment, digits);
    if (M > 1 && strncmp(moment + M, ",0,", 3) == 0)
        notice("--load %.*s: P %.*s and M %.*s; a decimal is written %.*s.%.*s", length, line, P,
               line, M, moment, P, line, M, moment);
}

/* A load of two numbers leaves moment and tension as they are; without P there is no moment. */
void load_history_read_list(const arguments *line, load_history *loads)
{
    load to = {0};
    double number[4];
    const char *lines = line->value[OPTION_LOAD];
    *loads = (load_history){.name = NULL};
    for (bool last = false; !last;) {
        const size_t length = strcspn(lines, "\n");
        last = lines[length] == '\0';
        const int count = number_read_list(lines, length, ',', 4, number);
        if (count == 4)
            to = (load){.P = number[0], .M = number[1], .Q = number[2], .sigma = number[3]};
        else if (count == 2)
            to = (load){
                .P = number[0], .M = number[0] == 0 ? 0 : to.M, .Q = number[1], .sigma = to.sigma};
        else
            usage_error("--load %.*s: must be numbers P,Q or P,M,Q,sigma",
                        (int)(length < 60 ? length : 60), lines);
        share_out(units_of(line), count == 4, &to);
        if (loads->count == 0)
            say_four_values(lines, (int)length);
        add(loads, to, (csv_row){.whole = lines});
        lines += length + 1;
    }
}

/* ---- A file ---- */

static bool find_columns(void *context, header *names, complaint *why)
{
    (void)context;
    return load_header_find(names, why);
}

/* A row that is no load ends them: the loads after it would belong to another history. */
static bool read_rows(table_input *t, load_history *loads, complaint *why)
{
    load to;
    csv_row row;
    complaint reason;
    csv_input *in = t->in;
    while (table_next(t)) {
        if (!load_row_read(&t->names, in->row.cell, in->row.count, in->separator, t->decimal_sign,
                           &to, &reason))
            return complain(why, "%.200s: line %" PRId64 ": %s", in->name, in->row.line,
                            reason.text);
        header_note_unused(&t->names, in->row.cell);
        csv_row_keep(in, &row);
        add(loads, to, row);
    }
    return in->problem.text[0] == '\0' || complain(why, "%s", in->problem.text);
}

bool load_history_read_file(const char *file, const reading *how, load_history *loads,
                            complaint *why)
{
    table_input *t = memory_zeroed(1, sizeof *t); /* the header points into it: it stays */
    const table_wanted wanted = {.find = find_columns, .counts_missing = true};
    const bool is_open = table_open(file, how, &wanted, t);
    *loads = (load_history){.name = t->in->name};
    if (!is_open || !read_rows(t, loads, why))
        return !is_open && complain(why, "%s", t->in->problem.text);
    if (loads->count == 0)
        return complain(why, "%s: no loads; needed: rows of P and Q", t->in->name);
    loads->names = t->names;
    loads->has_mark = t->in->has_mark;
    if (t->remark.text[0] != '\0')
        notice("%s: %s", t->in->name, t->remark.text);
    csv_input_close(t->in); /* the names stay */
    return true;
}

static void read_file(const char *file, const reading *how, load_history *loads)
{
    complaint why;
    if (!load_history_read_file(file, how, loads, &why))
        failure("%s", why.text);
}

void load_history_read(const arguments *line, char decimal_sign, load_history *loads)
{
    const char *file = history_file(line);
    const reading how = reading_of(line, decimal_sign);
    if (!is_kept && file != NULL)
        read_file(file, &how, &kept);
    else if (!is_kept)
        load_history_read_list(line, &kept);
    if (!has_compliance)
        load_history_give_compliance(line, &kept);
    is_kept = has_compliance = true;
    *loads = kept;
}

/* Load cells often count pressing as negative. */
static const char *sign_hint(const load_history *loads)
{
    static char hint[200] = "";
    const size_t column = loads->names.column[INPUT_P];
    bool is_negative = !loads->is_of_case && column < loads->names.count;
    for (size_t i = 0; i < loads->count && is_negative; i++)
        is_negative = loads->load[i].P <= 0;
    if (is_negative)
        snprintf(hint, sizeof hint,
                 "; P is never above 0: where pressing is negative, --column "
                 "P='-%.60s' turns its sign",
                 loads->names.name[column]);
    return hint;
}

void load_history_read_measured(const arguments *line, char decimal_sign, load_history *loads)
{
    reading how = reading_of(line, decimal_sign);
    how.is_measured = true;
    read_file(history_file(line), &how, loads);
    const char *hint = sign_hint(loads);
    if (hint[0] != '\0')
        failure("%s: %s", loads->name, hint + strlen("; "));
}

/* ---- Applied ---- */

const char *load_history_place(const load_history *loads, size_t row, char place[LOAD_PLACE_SIZE])
{
    if (loads->is_of_case)
        snprintf(place, LOAD_PLACE_SIZE, "%.250s: load %zu", loads->name, row + 1);
    if (loads->is_of_case)
        return place;
    if (loads->name != NULL) {
        snprintf(place, LOAD_PLACE_SIZE, "%.250s: line %" PRId64, loads->name,
                 loads->row[row].line);
        return place;
    }
    const char *text = loads->row[row].whole;
    snprintf(place, LOAD_PLACE_SIZE, "--load %.*s", (int)strcspn(text, "\n"), text);
    return place;
}

void load_history_fail(const load_history *loads, size_t row, const char *word,
                       const complaint *why)
{
    char place[LOAD_PLACE_SIZE];
    load_history_place(loads, row, place);
    if (loads->name != NULL)
        failure("%s%s: %s%s", place, word, why->text, sign_hint(loads));
    usage_error("%s%s: %s", place, word, why->text);
}

/* A pad that the loads hold comes down at the first tilt. */
static void hold(const load_history *loads, contact_case *setup)
{
    complaint why;
    const double tilt = loads->load[0].tilt;
    if (setup->rotation == ROTATION_FREE || (setup->is_held && setup->rotation != ROTATION_HELD)) {
        complain(&why, "tilt %.6g: given together with %s; allowed: one of the two", tilt,
                 setup->rotation == ROTATION_FREE ? "--rotation free" : "--tilt");
        load_history_fail(loads, 0, "", &why);
    }
    const int32_t status = loads_hold(tilt, setup->contact);
    if (status == RWEDGE_EDOMAIN) {
        complain(&why, "tilt %.6g: so large a tilt lays a flank on the surface", tilt);
        load_history_fail(loads, 0, "", &why);
    }
    status_check(status, "the contact");
    setup->is_held = true;
    setup->tilt = tilt;
}

/* A rig that prescribes displacements keeps the tilt. */
static void refuse_turning(const load_history *loads)
{
    complaint why;
    size_t i = 1;
    if (!loads_are_driven(loads->load, loads->count) || !loads_turn(loads->load, loads->count))
        return;
    while (loads->load[i].tilt == loads->load[0].tilt)
        i++;
    complain(&why, "tilt %.6g: must be that of the first load, %.6g, beside a displacement",
             loads->load[i].tilt, loads->load[0].tilt);
    load_history_fail(loads, i, "", &why);
}

void load_history_check(const load_history *loads, contact_case *setup)
{
    complaint why;
    refuse_turning(loads);
    if (loads_are_guided(loads->load, loads->count)) {
        hold(loads, setup);
        return;
    }
    for (size_t i = 0; setup->is_held && i < loads->count; i++)
        if (loads->load[i].M != 0) {
            complain(&why, "M %.6g: given together with %s; allowed: one of the two",
                     loads->load[i].M,
                     setup->rotation == ROTATION_HELD ? "--rotation held" : "--tilt");
            load_history_fail(loads, i, "", &why);
        }
}

void load_history_apply_all(const load_history *loads, const contact_case *setup, doubts *all)
{
    complaint why;
    for (size_t i = 0; i < loads->count; i++) {
        if (!loads_apply_next(loads->load[i], &setup->shape, setup->f, setup->contact, &why))
            load_history_fail(loads, i, "", &why);
        if (all != NULL)
            doubts_add(all, doubts_of_state(setup, setup->contact));
    }
}

void history_case(const arguments *line, const input_texts *texts, case_needs needs,
                  char decimal_sign, contact_case *setup)
{
    load_history loads;
    complaint why;
    if (line->value[OPTION_HISTORY] != NULL && line->value[OPTION_LOAD] != NULL)
        usage_error("--history %s: given together with --load; allowed: one of the two",
                    line->value[OPTION_HISTORY]);
    if (!case_read(texts, needs, setup, &why))
        usage_error("%s", why.text);
    status_check(setup->status, "the contact");
    load_history_read(line, decimal_sign, &loads);
    load_history_check(&loads, setup);
    load_history_apply_all(&loads, setup, NULL);
    unused_say(&loads.names, loads.name);
    setup->has_history = true;
}
