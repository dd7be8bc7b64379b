/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "setup.h"

#include <math.h>
#include <string.h>

static unit_system assumed; /* where --units gives none */

void units_assume(const unit_system *units)
{
    assumed = *units;
}

/* The unit of length in a K that has no unit of its own. */
static double read_K_length(const arguments *line)
{
    const char *text = line->value[OPTION_K_IN];
    if (text != NULL && strcmp(text, "m") != 0 && strcmp(text, "mm") != 0)
        usage_error("--K-in %s: must be m or mm", text);
    return text == NULL ? NAN : strcmp(text, "m") == 0 ? 1 : 1e-3;
}

void units_say_of_K(const arguments *line)
{
    const unit_system *units = units_of(line);
    if (units->K_length == 1 && !units->is_known)
        notice("--K-in m: lengths are taken to be in mm; --units says other ones");
}

double option_size(const arguments *line, int number, const char *name, const char *dimension,
                   const unit_system *units)
{
    const char *text = line->value[number], *own;
    double size = NAN, factor = 1;
    complaint why;
    if (text != NULL && !quantity_read(text, '.', &size, &own))
        size = 0;
    else if (text != NULL && !units_factor(units, own, dimension, SHARE_NONE, &factor, &why))
        usage_error("--%s %s: %s%s", name, text, why.text,
                    units->is_known ? "" : ": --units, such as --units mm,N,MPa, converts it");
    size *= factor;
    if (text != NULL && !(size > 0 && number_is_size(size)))
        usage_error("--%s %s: must be a number above 0, in the working units", name, text);
    return size;
}

const unit_system *units_of(const arguments *line)
{
    static unit_system units;
    complaint why;
    units = units_unknown;
    if (line->value[OPTION_UNITS] != NULL && !units_read(line->value[OPTION_UNITS], &units, &why))
        usage_error("--units %s", why.text);
    if (line->value[OPTION_UNITS] == NULL && assumed.is_known) {
        units.is_known = true;
        units.length = assumed.length;
        units.force = assumed.force;
    }
    units.has_options = true;
    units.K_length = read_K_length(line);
    units.width = option_size(line, OPTION_WIDTH, "width", "length", &units);
    units.section = option_size(line, OPTION_SECTION, "section", "area", &units);
    return &units;
}
