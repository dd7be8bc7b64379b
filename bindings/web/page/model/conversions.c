/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What the page asks about units: the factors with which its numbers go from one set to another. A
 * set is "mm,N,MPa"; any other text is one that nobody knows, and the factor is 1. */
#include "page.h"

#include <math.h>

unit_system units_named(const char *words)
{
    unit_system units = units_unknown;
    complaint why;
    return units_read(words, &units, &why) ? units : units_unknown;
}

/* The factor of a number of a dimension, as inputs and constants have it. */
EXPORTED double page_factor(const char *from, const char *to, const char *dimension)
{
    const unit_system before = units_named(from), after = units_named(to);
    return units_conversion(&before, &after, dimension);
}

/* The factor of a constant of a material; 1 where the name is unknown. The factor of paris_C
 * depends on the exponent; it is 1 where the text of that is no number. */
EXPORTED double page_constant_factor(const char *from, const char *to, const char *name,
                                     const char *exponent)
{
    const unit_system before = units_named(from), after = units_named(to);
    const int constant = material_constant(name);
    double m;
    if (constant < 0)
        return 1;
    const bool has_exponent = number_read_cell(exponent, '.', &m);
    const double factor = material_conversion(constant, has_exponent ? m : NAN, &before, &after);
    return isnan(factor) ? 1 : factor;
}
