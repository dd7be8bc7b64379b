/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "warnings.h"

#include "text/list.h"

#include <math.h>

#include <rwedge.h>

/* The wedge is taken for a half-plane: the part 2 theta/pi of its angle is missing, 6 % at this
 * angle, and its stiffness errs like that. The slope tan(theta) differs from theta by theta^2/3,
 * 0.3 %. */
static const double THETA_DOUBTFUL = 0.1;

/* Rounding leaves Dundurs' beta this far from 0 where the bodies are alike. */
static const double BETA_ROUNDING = 1e-12;

/* From here on, or from its inverse, lengths or stresses look as if they came in different
 * units: metals have k/E between 1e-4 and 1e-2; a rounding is seldom 1e-4 or 1e4 times the
 * contact, as mm for um, or MPa for GPa, would make it. */
static const double STRENGTH_RATIO_LOW = 1e-5, STRENGTH_RATIO_HIGH = 0.1, ROUNDING_RATIO = 1e4;

static void check_units(const contact_case *what, char *text, size_t size)
{
    const double b = rwedge_half_width(what->theta, what->a, what->A, what->P);
    const double rounding = what->a / b, strength = what->k / what->E1;
    if (rounding > 0 && (rounding > ROUNDING_RATIO || rounding < 1 / ROUNDING_RATIO))
        list_add(text, size, "; ", "a_over_b = %.3g: are a, P and E1 in consistent units?",
                 rounding);
    if (strength > STRENGTH_RATIO_HIGH || strength < STRENGTH_RATIO_LOW)
        list_add(text, size, "; ", "k/E1 = %.3g: are the stresses in one unit?", strength);
}

void warnings_write(const contact_case *what, double safety, char *text, size_t size)
{
    text[0] = '\0';
    if (what->theta > THETA_DOUBTFUL)
        list_add(text, size, "; ", "theta = %.3g rad: above %g the wedge is hardly a half-plane",
                 what->theta, THETA_DOUBTFUL);
    if (what->f > 0 && fabs(what->beta) > BETA_ROUNDING)
        list_add(text, size, "; ", "dundurs_beta = %.3g: with friction its coupling is neglected",
                 what->beta);
    if (!isnan(what->k) && safety < 1)
        list_add(text, size, "; ", "P is above P_yield: the contact yields in full sliding");
    check_units(what, text, size);
}
