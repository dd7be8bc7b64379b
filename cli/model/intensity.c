/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Stress intensities, and the growth of cracks, with their units: a bare number may be in MPa
 * sqrt(m) or in MPa sqrt(mm), which is 31.6 times as large. */
#include "model.h"

#include <ctype.h>
#include <math.h>
#include <string.h>

static const char dimension[] = "stress*sqrt(length)";

/* The working unit of K in that of a bare number. */
static double bare_factor(const unit_system *units)
{
    const double millimetre = 1e-3; /* where no working unit is known */
    return sqrt(units->K_length / (units->is_known ? units->length : millimetre));
}

static bool refuse_bare(const char *example, complaint *why)
{
    return complain(why, "needs its unit, such as \"%s\"", example);
}

/* The factor of a K with a unit, which must be there. */
static bool find_factor(const unit_system *units, const char *own, double *factor, complaint *why)
{
    measuring_unit unit;
    if (!unit_read(own, &unit))
        return complain(why, "the unit '%.40s' is not known; known are such as MPa sqrt(m)", own);
    return units_factor(units, own, dimension, SHARE_NONE, factor, why);
}

bool intensity_read(const char *text, char decimal_sign, const unit_system *units, double *value,
                    complaint *why)
{
    const char *own;
    double factor = NAN;
    if (!quantity_read(text, decimal_sign, value, &own))
        return complain(why, "must be a number with its unit, such as 4.2 MPa sqrt(m)");
    if (own == NULL && isnan(units->K_length))
        return refuse_bare("4.2 MPa sqrt(m)", why);
    if (own == NULL)
        factor = bare_factor(units);
    else if (!find_factor(units, own, &factor, why))
        return false;
    *value *= factor;
    return true;
}

/* Copies what stands before a part of a text; false where it has no room. */
static bool copy_before(const char *text, const char *part, char copy[80])
{
    const size_t length = (size_t)(part - text);
    if (length >= 80)
        return false;
    memcpy(copy, text, length);
    copy[length] = '\0';
    return true;
}

/* What follows ")^" is m, or the exponent again. */
static bool is_exponent(const char *text, double m)
{
    double again;
    return strcmp(text, "m") == 0 || (number_read_cell(text, '.', &again) && again == m);
}

/* "6.9e-12 m/cycle/(MPa sqrt(m))^3" in its three parts. */
static bool take_apart(const char *text, double m, char length[80], char K[80])
{
    static const char per_cycle[] = "/cycle";
    const char *open = strstr(text, "/("), *close = strstr(text, ")^");
    const size_t suffix = sizeof per_cycle - 1;
    if (open == NULL || close == NULL || close < open || !is_exponent(close + 2, m) ||
        !copy_before(text, open, length) || !copy_before(open + 2, close, K))
        return false;
    const size_t used = strlen(length);
    if (used > suffix && strcmp(length + used - suffix, per_cycle) == 0)
        length[used - suffix] = '\0';
    return true;
}

bool growth_read(const char *text, char decimal_sign, double m, const unit_system *units,
                 double *value, complaint *why)
{
    static const char example[] = "6.9e-12 m/(MPa sqrt(m))^3";
    char length[80], K[80];
    const char *own;
    double length_factor, K_factor;
    if (isnan(m))
        return complain(why, "needs the exponent too");
    if (number_read_cell(text, decimal_sign, value)) {
        if (isnan(units->K_length))
            return refuse_bare(example, why);
        *value *= pow(bare_factor(units), -m);
        return true;
    }
    if (!take_apart(text, m, length, K) || !quantity_read(length, decimal_sign, value, &own) ||
        own == NULL)
        return complain(why,
                        "must be a number with its unit, such as %s, which ends with the "
                        "exponent or m",
                        example);
    if (!units_factor(units, own, "length", SHARE_NONE, &length_factor, why) ||
        !find_factor(units, K, &K_factor, why))
        return false;
    *value *= length_factor * pow(K_factor, -m);
    return true;
}
