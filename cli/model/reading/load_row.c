/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "reading.h"

#include <stdio.h>
#include <string.h>

bool load_header_find(const char *const name[], size_t count, header *names,
                      char complaint[COMPLAINT_SIZE])
{
    static const bool wanted[INPUT_COUNT] = {
        [INPUT_P] = true, [INPUT_M] = true, [INPUT_Q] = true, [INPUT_SIGMA] = true};
    if (!header_find(name, count, wanted, NULL, names, complaint))
        return false;
    if (header_has_input(names, INPUT_P) && header_has_input(names, INPUT_Q))
        return true;
    snprintf(complaint, COMPLAINT_SIZE, "column %s: missing; a history needs P and Q%s",
             header_has_input(names, INPUT_P) ? "Q" : "P", header_separator_hint(name, count));
    return false;
}

static bool read_cell(const char *text, int input, char decimal_sign, double *value,
                      char complaint[COMPLAINT_SIZE])
{
    char name[INPUT_NAME_SIZE];
    if (number_read_cell(text, decimal_sign, value))
        return true;
    if (text[strspn(text, " \t")] == '\0')
        snprintf(complaint, COMPLAINT_SIZE, "%s: the cell is empty", input_column(input, name));
    else
        snprintf(complaint, COMPLAINT_SIZE, "%s %.60s: must be a number, with a decimal %s",
                 input_column(input, name), text, decimal_sign == ',' ? "comma" : "point");
    return false;
}

/* Moment and tension are 0 where they have no column. */
bool load_row_read(const header *names, const char *const cells[], size_t count, char separator,
                   char decimal_sign, load *to, char complaint[COMPLAINT_SIZE])
{
    double value[INPUT_COUNT] = {0};
    if (!header_fits(names->count, count, separator, complaint))
        return false;
    for (int i = INPUT_P; i <= INPUT_SIGMA; i++)
        if (header_has_input(names, i) &&
            !read_cell(cells[names->column[i]], i, decimal_sign, &value[i], complaint))
            return false;
    *to = (load){value[INPUT_P], value[INPUT_M], value[INPUT_Q], value[INPUT_SIGMA]};
    return true;
}
