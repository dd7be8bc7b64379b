/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "kind.h"

double case_value(const figure_case *of, int variable)
{
    return range_value(&of->value[variable], 0);
}

void style_of_family(curve *one, int i)
{
    static const int cycle[] = {BLACK, BLUE, VERMILLION, GREEN, PURPLE};
    enum { CYCLE = sizeof cycle / sizeof cycle[0] };
    one->colour = cycle[i % CYCLE];
    one->dash = i % 4; /* 4 and 5 have no common divisor: a pair comes again after 20 curves */
}
