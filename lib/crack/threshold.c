/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A short crack does not grow below K_th sqrt(l/(l + a0)). a0 is such that a plain specimen at its
 * fatigue limit, whose edge crack has K = Y ds0 sqrt(pi l), stands on the threshold as l -> 0. */
#include "base/domain.h"

#include <rwedge.h>

/* K/(sigma sqrt(pi l)) of an edge crack under uniform tension: in closed form in lib/README.md. */
static const double EDGE_CRACK = 1.12152225523105526;

double rwedge_short_crack_threshold(double length, double dK_th, double ds0)
{
    const bool has_limit = !(ds0 == HUGE_VAL);
    if (!rw_is_positive(length) || !rw_is_magnitude(dK_th) || (has_limit && !rw_is_positive(ds0)))
        return NAN;
    const double root = has_limit ? dK_th / (EDGE_CRACK * ds0) : 0;
    return dK_th / sqrt(1 + root * root / (RW_PI * length));
}
