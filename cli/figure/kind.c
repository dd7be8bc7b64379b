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
        failure("figure %s: %s", inputs->name, rwedge_strerror(status));
}

static bool need_all_digits(const range *values)
{
    char first[NUMBER_SIZE], second[NUMBER_SIZE];
    for (int64_t i = 0; i < values->count; i++)
        for (int64_t k = 0; k < i; k++) {
            drawing_number(range_value(values, i), DRAWING_DIGITS, first);
            drawing_number(range_value(values, k), DRAWING_DIGITS, second);
            if (strcmp(first, second) == 0)
                return true;
        }
    return false;
}

const char *case_text(const figure_case *inputs, int variable, int64_t i, char text[NUMBER_SIZE])
{
    const range *values = &inputs->value[variable];
    drawing_number(range_value(values, i), need_all_digits(values) ? NUMBER_DIGITS : DRAWING_DIGITS,
                   text);
    return text;
}

void style_of_family(curve *line, int i)
{
    static const int cycle[] = {BLACK, BLUE, VERMILLION, GREEN, PURPLE};
    enum { CYCLE = sizeof cycle / sizeof cycle[0] };
    line->colour = cycle[i % CYCLE];
    line->dash = i % 4; /* 4 and 5 have no common divisor: a pair comes again after 20 curves */
}

curve *draw_member(const figure_case *inputs, int variable, int n, const char *words,
                   const dataset *rows, int x, int y, drawing *plot)
{
    char text[NUMBER_SIZE];
    curve *line = drawing_curve(plot, rows, n, x, y);
    style_of_family(line, n);
    snprintf(line->legend, sizeof line->legend, "%s%s", words,
             case_text(inputs, variable, n, text));
    return line;
}

void draw_family(const figure_case *inputs, int variable, const dataset *rows, int x, int y,
                 drawing *plot)
{
    for (int n = 0; n < dataset_curves(rows); n++)
        draw_member(inputs, variable, n, "", rows, x, y, plot);
}

double step_of_levels(double top)
{
    const double decade = pow(10, floor(log10(top / 8)));
    const double times = top / 8 / decade;
    return (times >= 5 ? 5 : times >= 2.5 ? 2.5 : 1) * decade;
}
