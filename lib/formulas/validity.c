/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What makes results doubtful. Nothing is refused for it. */
#include "rwedge.h"

#include <math.h>
#include <stdbool.h>

/* The wedge is taken for a half-plane: the part 2 theta/pi of its angle is missing, 6 % at this
 * angle, and its stiffness errs like that. The slope tan(theta) differs from theta by theta^2/3,
 * 0.3 %. */
static const double LARGEST_ANGLE = 0.1;

/* Rounding leaves Dundurs' beta this far from 0 where the bodies are alike. */
static const double BETA_ROUNDING = 1e-12;

/* Beyond these, lengths or stresses look as if they came in different units, such as GPa with
 * MPa. Metals have k/E between 1e-4 and 1e-2. Moduli in GPa make the contact of an ordinary
 * pad, a/b of about 1, a thousand times as wide, or that of a round one thirty times. */
static const double ROUNDING_LOW = 0.01, ROUNDING_HIGH = 1e4;
static const double STRENGTH_LOW = 1e-5, STRENGTH_HIGH = 0.1;

/* 0 is the sharp wedge, or no strength: nothing to compare. No comparison raises an exception. */
static bool is_out_of_proportion(double ratio, double low, double high)
{
    return isgreater(ratio, 0) && (isless(ratio, low) || isgreater(ratio, high));
}

int32_t rwedge_validity(double theta, double alpha, double beta, double f, double k_over_E,
                        double safety)
{
    int32_t doubts = 0;
    if (isgreater(theta, LARGEST_ANGLE))
        doubts |= RWEDGE_DOUBT_ANGLE;
    if (isgreater(f, 0) && isgreater(fabs(beta), BETA_ROUNDING))
        doubts |= RWEDGE_DOUBT_COUPLING;
    if (isless(safety, 1))
        doubts |= RWEDGE_DOUBT_YIELD;
    if (is_out_of_proportion(alpha, ROUNDING_LOW, ROUNDING_HIGH))
        doubts |= RWEDGE_DOUBT_ROUNDING;
    if (is_out_of_proportion(k_over_E, STRENGTH_LOW, STRENGTH_HIGH))
        doubts |= RWEDGE_DOUBT_STRENGTH;
    return doubts;
}

const char *rwedge_validity_text(int32_t doubt)
{
    switch (doubt) {
    case RWEDGE_DOUBT_ANGLE:
        return "theta is above 0.1 rad: the wedge is hardly a half-plane";
    case RWEDGE_DOUBT_COUPLING:
        return "Dundurs' beta is not 0: with friction its coupling is neglected";
    case RWEDGE_DOUBT_YIELD:
        return "P is above P_yield: the contact yields in full sliding";
    case RWEDGE_DOUBT_ROUNDING:
        return "a/b is below 0.01 or above 10000: are the units consistent?";
    case RWEDGE_DOUBT_STRENGTH:
        return "k/E is below 0.00001 or above 0.1: are the stresses in one unit?";
    default:
        return "";
    }
}
