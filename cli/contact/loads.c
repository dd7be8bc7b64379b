/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "loads.h"

#include "header.h"
#include "text/list.h"
#include "text/message.h"
#include "text/number.h"

#include <inttypes.h>
#include <math.h>
#include <string.h>

static int32_t apply(load to, rwedge_contact *contact)
{
    return rwedge_contact_apply(contact, to.P, to.M, to.Q, to.sigma);
}

int32_t loads_apply_monotonic(load to, rwedge_contact *contact)
{
    const int32_t status = apply((load){.P = to.P, .M = to.M}, contact);
    return status == RWEDGE_OK ? apply(to, contact) : status;
}

/* ---- What is wrong with a load ---- */

static bool is_in_domain(load to, const rwedge_contact *contact)
{
    rwedge_contact *trial = NULL;
    int32_t status = rwedge_contact_copy(contact, &trial);
    if (status == RWEDGE_OK)
        status = apply(to, trial);
    rwedge_contact_destroy(trial);
    return status != RWEDGE_EDOMAIN;
}

/* The magnitude below which a moment lays no flank on the surface, to the digits that are shown. */
static double largest_moment(load to, const rwedge_contact *contact)
{
    double allowed = 0, refused = to.M;
    while (fabs(refused - allowed) > 1e-7 * fabs(refused)) {
        to.M = allowed + (refused - allowed) / 2;
        if (is_in_domain(to, contact))
            allowed = to.M;
        else
            refused = to.M;
    }
    return fabs(allowed);
}

static load_fault domain_fault(load to, const rwedge_contact *contact)
{
    char limit[NUMBER_SIZE];
    load_fault fault = {.input = INPUT_COUNT};
    load level = to;
    level.M = 0;
    if (to.P < 0)
        fault = (load_fault){INPUT_P, "must not be below 0, and Q must be 0 where P is"};
    else if (to.P == 0)
        fault = (load_fault){INPUT_M, "must be 0 where P is"};
    else if (is_in_domain(level, contact)) {
        fault.input = INPUT_M;
        number_write(largest_moment(to, contact), 6, '.', limit);
        snprintf(fault.why, sizeof fault.why,
                 "must be below %s in magnitude: more lays a flank on the surface", limit);
    } else
        snprintf(fault.why, sizeof fault.why, "%s", rwedge_strerror(RWEDGE_EDOMAIN));
    return fault;
}

static load_fault path_fault(load to, const rwedge_contact *contact)
{
    load last;
    load_fault fault = {.input = INPUT_SIGMA};
    rwedge_contact_loads(contact, &last.P, &last.M, &last.Q, &last.sigma);
    snprintf(fault.why, sizeof fault.why, "no closed form: %s",
             rwedge_contact_obstacle(contact, to.P, to.M, to.Q, to.sigma));
    const double most = rwedge_contact_largest_tension_step(contact, to.Q);
    if (to.P == last.P && to.M == last.M && fabs(to.sigma - last.sigma) > most) {
        char limit[NUMBER_SIZE];
        number_write(most, 6, '.', limit);
        list_add(fault.why, sizeof fault.why, "; ", "sigma may change by %s with this Q", limit);
    }
    return fault;
}

load_fault loads_fault(int32_t status, load to, double f, const rwedge_contact *contact)
{
    load_fault fault = {.input = INPUT_Q};
    char limit[NUMBER_SIZE];
    if (status == RWEDGE_EDOMAIN)
        return domain_fault(to, contact);
    if (status == RWEDGE_EPATH)
        return path_fault(to, contact);
    if (status == RWEDGE_ESLIDING) {
        number_write(f * to.P, 6, '.', limit);
        snprintf(fault.why, sizeof fault.why, "must not exceed f P = %s: there is no equilibrium",
                 limit);
        return fault;
    }
    fault.input = INPUT_COUNT;
    snprintf(fault.why, sizeof fault.why, "%s", rwedge_strerror(status));
    return fault;
}

/* The next load of a history; what is wrong with it goes to the complaint. */
static bool apply_next(load to, double f, rwedge_contact *contact, char complaint[COMPLAINT_SIZE])
{
    const int32_t status = apply(to, contact);
    if (status == RWEDGE_OK)
        return true;
    const load_fault fault = loads_fault(status, to, f, contact);
    char name[INPUT_NAME_SIZE] = "";
    if (fault.input < INPUT_COUNT && status != RWEDGE_EPATH) /* the path has no one to blame */
        input_column(fault.input, name);
    snprintf(complaint, COMPLAINT_SIZE, "%s%s%s", name, name[0] != '\0' ? " " : "", fault.why);
    return false;
}

/* ---- The command line ---- */

/* Reads up to most numbers, separated by commas; how many there are, 0 where it is not that. */
static int read_numbers(const char *text, size_t length, int most, double number[])
{
    for (int n = 0; n < most; n++) {
        const size_t own = number_length(text);
        if (!number_read_part(text, own, &number[n]))
            return 0;
        if (own == length)
            return n + 1;
        if (own > length || text[own] != ',')
            return 0;
        text += own + 1;
        length -= own + 1;
    }
    return 0;
}

/* Of two numbers, moment and tension stay as they are; without P there is no moment. */
static bool read_load(const char *text, size_t length, const rwedge_contact *contact, load *to)
{
    double number[4];
    const int count = read_numbers(text, length, 4, number);
    if (count == 4)
        *to = (load){number[0], number[1], number[2], number[3]};
    if (count != 2)
        return count == 4;
    rwedge_contact_loads(contact, &to->P, &to->M, &to->Q, &to->sigma);
    to->P = number[0];
    to->M = to->P == 0 ? 0 : to->M;
    to->Q = number[1];
    return true;
}

int loads_apply_list(const char *lines, double f, rwedge_contact *contact)
{
    for (bool last = false; !last;) {
        load to;
        char complaint[COMPLAINT_SIZE];
        const size_t length = strcspn(lines, "\n");
        last = lines[length] == '\0';
        if (!read_load(lines, length, contact, &to))
            return usage_error("--load %.*s: must be numbers P,Q or P,M,Q,sigma",
                               (int)(length < 60 ? length : 60), lines);
        if (!apply_next(to, f, contact, complaint))
            return usage_error("--load %.*s: %s", (int)(length < 60 ? length : 60), lines,
                               complaint);
        lines += length + 1;
    }
    return STATUS_DONE;
}

/* ---- A file ---- */

static void note_numbers(header *names, const csv_input *row, char decimal_sign)
{
    double number;
    for (size_t i = 0; i < names->count; i++)
        if (number_read_cell(csv_input_cell(row, i), decimal_sign, &number))
            names->has_numbers[i] = true;
}

/* The four columns of a load; moment and tension are 0 where they have none. */
static bool read_row(header *names, const csv_input *row, char decimal_sign, load *to,
                     char complaint[COMPLAINT_SIZE])
{
    double value[INPUT_COUNT] = {0};
    if (!header_fits(names, row, complaint))
        return false;
    note_numbers(names, row, decimal_sign);
    for (int i = INPUT_P; i <= INPUT_SIGMA; i++) {
        char name[INPUT_NAME_SIZE];
        const char *text =
            names->column[i] < names->count ? csv_input_cell(row, names->column[i]) : NULL;
        if (text == NULL || number_read_cell(text, decimal_sign, &value[i]))
            continue;
        snprintf(complaint, COMPLAINT_SIZE, "%s %.60s: must be a number, with a decimal %s",
                 input_column(i, name), text, decimal_sign == ',' ? "comma" : "point");
        return false;
    }
    *to = (load){value[INPUT_P], value[INPUT_M], value[INPUT_Q], value[INPUT_SIGMA]};
    return true;
}

/* A row that cannot be applied ends it: what comes after would belong to another history. */
static bool apply_row(header *names, csv_input *in, bool malformed, char decimal_sign, double f,
                      rwedge_contact *contact)
{
    load to;
    char complaint[COMPLAINT_SIZE];
    if (malformed)
        snprintf(complaint, COMPLAINT_SIZE, "%s", csv_input_fault(in));
    else if (read_row(names, in, decimal_sign, &to, complaint) &&
             apply_next(to, f, contact, complaint))
        return true;
    failure("%s: line %" PRId64 ": %s", csv_input_name(in), csv_input_line(in), complaint);
    return false;
}

static int find_columns(csv_input *in, header *names)
{
    const bool wanted[INPUT_COUNT] = {
        [INPUT_P] = true, [INPUT_M] = true, [INPUT_Q] = true, [INPUT_SIGMA] = true};
    if (!header_read(in, wanted, NULL, names))
        return STATUS_FAILED;
    for (int i = INPUT_P; i <= INPUT_Q; i += INPUT_Q - INPUT_P)
        if (names->column[i] == names->count)
            return failure("%s: column %s: missing; a history needs P and Q%s", csv_input_name(in),
                           i == INPUT_P ? "P" : "Q", header_separator_hint(names));
    return STATUS_DONE;
}

int loads_apply_file(const char *path, const char *encoding, char decimal_sign, double f,
                     rwedge_contact *contact)
{
    csv_input *in = csv_input_open(path, decimal_sign == ',' ? ';' : ',', encoding);
    if (in == NULL)
        return STATUS_FAILED;
    header names;
    csv_event event = CSV_END;
    int64_t loads = 0;
    int status = find_columns(in, &names);
    while (status == STATUS_DONE && (event = csv_input_next(in)) != CSV_END) {
        const bool applied = event != CSV_FAILED && apply_row(&names, in, event == CSV_MALFORMED,
                                                              decimal_sign, f, contact);
        status = applied ? STATUS_DONE : STATUS_FAILED;
        loads++;
    }
    if (status == STATUS_DONE && loads == 0)
        status = failure("%s: no loads; needed: rows of P and Q", csv_input_name(in));
    if (status == STATUS_DONE)
        header_name_unused(&names, in);
    header_free(&names);
    csv_input_close(in);
    return status;
}
