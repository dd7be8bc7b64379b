/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "loads.h"

#include "header.h"
#include "text/message.h"
#include "text/number.h"

#include <inttypes.h>
#include <string.h>

int32_t loads_apply_monotonic(double P, double Q, rwedge_contact *contact)
{
    const int32_t status = rwedge_contact_load(contact, P, 0);
    return status == RWEDGE_OK ? rwedge_contact_load(contact, P, Q) : status;
}

/* The next load; what is wrong with it goes to the complaint. */
static bool apply(double P, double Q, double f, rwedge_contact *contact,
                  char complaint[COMPLAINT_SIZE])
{
    const int32_t status = rwedge_contact_load(contact, P, Q);
    char limit[NUMBER_SIZE];
    number_write(f * P, 6, '.', limit);
    if (status == RWEDGE_ESLIDING)
        snprintf(complaint, COMPLAINT_SIZE, "Q must not exceed f P = %s: there is no equilibrium",
                 limit);
    else if (status == RWEDGE_EDOMAIN)
        snprintf(complaint, COMPLAINT_SIZE, "P must not be below 0, and Q must be 0 where P is");
    else if (status != RWEDGE_OK)
        snprintf(complaint, COMPLAINT_SIZE, "%s", rwedge_strerror(status));
    return status == RWEDGE_OK;
}

/* ---- The command line ---- */

static bool read_pair(const char *text, size_t length, double *P, double *Q)
{
    const size_t first = number_length(text);
    if (!number_read_part(text, first, P) || text[first] != ',')
        return false;
    const size_t second = number_length(text + first + 1);
    return number_read_part(text + first + 1, second, Q) && first + 1 + second == length;
}

int loads_apply_list(const char *lines, double f, rwedge_contact *contact)
{
    for (bool last = false; !last;) {
        double P, Q;
        char complaint[COMPLAINT_SIZE];
        const size_t length = strcspn(lines, "\n");
        last = lines[length] == '\0';
        if (!read_pair(lines, length, &P, &Q))
            return usage_error("--load %.*s: must be two numbers P,Q",
                               (int)(length < 60 ? length : 60), lines);
        if (!apply(P, Q, f, contact, complaint))
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

static bool read_row(header *names, const csv_input *row, char decimal_sign, double *P, double *Q,
                     char complaint[COMPLAINT_SIZE])
{
    static const int columns[] = {INPUT_P, INPUT_Q};
    double *const values[] = {P, Q};
    if (!header_fits(names, row, complaint))
        return false;
    note_numbers(names, row, decimal_sign);
    for (int i = 0; i < 2; i++) {
        const char *text = csv_input_cell(row, names->column[columns[i]]);
        if (number_read_cell(text, decimal_sign, values[i]))
            continue;
        snprintf(complaint, COMPLAINT_SIZE, "%s %.60s: must be a number, with a decimal %s",
                 i == 0 ? "P" : "Q", text, decimal_sign == ',' ? "comma" : "point");
        return false;
    }
    return true;
}

/* A row that cannot be applied ends it: what comes after would belong to another history. */
static bool apply_row(header *names, csv_input *in, bool malformed, char decimal_sign, double f,
                      rwedge_contact *contact)
{
    double P, Q;
    char complaint[COMPLAINT_SIZE] = "misplaced quotes";
    if (!malformed && read_row(names, in, decimal_sign, &P, &Q, complaint) &&
        apply(P, Q, f, contact, complaint))
        return true;
    failure("%s: line %" PRId64 ": %s", csv_input_name(in), csv_input_line(in), complaint);
    return false;
}

static int find_columns(csv_input *in, header *names)
{
    const bool wanted[INPUT_COUNT] = {[INPUT_P] = true, [INPUT_Q] = true};
    if (!header_read(in, wanted, NULL, names))
        return STATUS_FAILED;
    for (int i = 0; i < INPUT_COUNT; i++)
        if (wanted[i] && names->column[i] == names->count)
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
