/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "potential/far_series.h"

#include "base/domain.h"

void rw_potential_far_coefficients(const rw_potential *potential, double far[RW_FAR_TERMS])
{
#define WEIGHT(n)                                                                                  \
    (((n) % 2 ? -1 : 1) / (RW_PI * (2 * (n) + 1) * (n) * ((n) + 1))) /* 4 (-1)^n/(pi m (m^2-1)) */
    static const double weight[RW_FAR_TERMS] = {0,          WEIGHT(1),  WEIGHT(2),  WEIGHT(3),
                                                WEIGHT(4),  WEIGHT(5),  WEIGHT(6),  WEIGHT(7),
                                                WEIGHT(8),  WEIGHT(9),  WEIGHT(10), WEIGHT(11),
                                                WEIGHT(12), WEIGHT(13), WEIGHT(14), WEIGHT(15)};
#undef WEIGHT
    const double alpha = potential->alpha, c0 = potential->c0;
    far[0] = rw_first_coefficient(potential);
    for (int n = 1; n < RW_FAR_TERMS; n++)
        far[n] = 0;
    if (alpha >= 1) /* Hertz: G = R/alpha */
        return;
    /* sin(m phi0)/alpha and cos(m phi0), m = 2n+1. The sine is divided by alpha. So alpha = 0 is
     * no special case. */
    double sine = 1, cosine = c0;
    const double cos2 = (1 - alpha) * (1 + alpha) - alpha * alpha;
    for (int n = 1; n < RW_FAR_TERMS; n++) {
        const double next = sine * cos2 + cosine * 2 * c0;
        cosine = cosine * cos2 - sine * alpha * (2 * c0 * alpha);
        sine = next;
        far[n] = weight[n] * ((2 * n + 1) * sine * c0 - cosine);
    }
}
