/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "figure.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

double case_value(const figure_case *inputs, int variable)
{
    return range_value(&inputs->value[variable], 0);
}

void case_check(const figure_case *inputs, int32_t status)
{
    if (status != RWEDGE_OK)
        failure("figure %s: %s", inputs->kind->name, rwedge_strerror(status));
}

/* A value as text, with at most `digits` digits; 1/6 for a sixth. */
static void write_value(double value, int digits, char text[NUMBER_SIZE])
{
    static const char *const sixths[] = {"0", "1/6", "1/3", "1/2", "2/3", "5/6", "1"};
    const double nearest = floor(6 * value + 0.5);
    if (nearest >= 1 && nearest <= 5 && nearest != 3 && fabs(6 * value - nearest) < 1e-9)
        snprintf(text, NUMBER_SIZE, "%s", sixths[(int)nearest]);
    else
        number_write(value, digits, '.', text);
}

static bool need_all_digits(const range *values)
{
    char first[NUMBER_SIZE], second[NUMBER_SIZE];
    for (int64_t i = 0; i < values->count; i++)
        for (int64_t k = 0; k < i; k++) {
            write_value(range_value(values, i), FIGURE_DIGITS, first);
            write_value(range_value(values, k), FIGURE_DIGITS, second);
            if (strcmp(first, second) == 0)
                return true;
        }
    return false;
}

void case_names(const figure_case *inputs, int variable, char names[FIGURE_NAMES_SIZE])
{
    const range *values = &inputs->value[variable];
    const int digits = need_all_digits(values) ? NUMBER_DIGITS : FIGURE_DIGITS;
    char text[NUMBER_SIZE];
    names[0] = '\0';
    for (int64_t i = 0; i < values->count; i++) {
        write_value(range_value(values, i), digits, text);
        list_add(names, FIGURE_NAMES_SIZE, " ", "%s", text);
    }
}

double step_of_levels(double top)
{
    const double decade = pow(10, floor(log10(top / 8)));
    const double times = top / 8 / decade;
    return (times >= 5 ? 5 : times >= 2.5 ? 2.5 : 1) * decade;
}
