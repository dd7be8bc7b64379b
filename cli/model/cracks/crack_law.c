/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "cracks.h"

#include <math.h>

crack_law crack_law_of(const material *constants)
{
    return (crack_law){material_value(constants, "dK_th"), material_value(constants, "ds0"),
                       material_value(constants, "paris_C"), material_value(constants, "paris_m"),
                       material_value(constants, "K_c")};
}

const char *crack_law_lacks(const crack_law *law, const char **beside)
{
    const bool has_C = !isnan(law->C), has_m = !isnan(law->m);
    if (has_C != has_m) {
        *beside = has_C ? "paris_C" : "paris_m";
        return has_C ? "paris_m" : "paris_C";
    }
    *beside = "ds0";
    return !isnan(law->ds0) && isnan(law->dK_th) ? "dK_th" : NULL;
}

bool crack_has_threshold(const crack_law *law)
{
    return !isnan(law->dK_th);
}

double crack_threshold(const crack_law *law, double length)
{
    return rwedge_short_crack_threshold(length, law->dK_th, isnan(law->ds0) ? HUGE_VAL : law->ds0);
}

bool crack_has_rate(const crack_law *law)
{
    return !isnan(law->C);
}
