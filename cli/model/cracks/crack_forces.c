/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "cracks.h"

#include <math.h>
#include <stdlib.h>

const char *const shear_names[SHEARS] = {"none", "locked", "free"};

static double radians(double angle)
{
    return angle * PI / 180;
}

void crack_lengths(double from, double to, size_t n, double length[])
{
    for (size_t i = 0; i < n; i++)
        length[i] = from * pow(to / from, (double)i / (double)(n - 1));
    length[n - 1] = to;
}

crack_K crack_K_of(const crack_case *crack, double angle, bool presses)
{
    const size_t all = crack->last->loads * crack->lengths;
    crack_K K = {.I = memory_zeroed(3 * all, sizeof *K.I)};
    K.II = K.I + all;
    K.share = K.II + all;
    K.status = (presses ? rwedge_cycle_closing_crack : rwedge_cycle_crack)(
        crack->last->cycle, crack->x, radians(angle), crack->last->loads, crack->lengths,
        crack->length, K.I, K.II, K.share);
    return K;
}

crack_ranges crack_ranges_of(const crack_case *crack, double angle, const crack_K *K)
{
    const size_t n = crack->lengths, all = SHEARS * n;
    crack_ranges r = {.I = memory_zeroed(4 * all, sizeof *r.I), .status = RWEDGE_OK};
    r.II = r.I + all;
    r.K_max = r.II + all;
    r.R = r.K_max + all;
    for (int shear = 0; shear < SHEARS && r.status == RWEDGE_OK; shear++) {
        const size_t at = (size_t)shear * n;
        if (crack->is_wanted[shear])
            r.status = K == NULL ? rwedge_cycle_closing_ranges(
                                       crack->last->cycle, crack->x, radians(angle), shear, n,
                                       crack->length, r.I + at, r.II + at, r.K_max + at, r.R + at)
                                 : rwedge_crack_ranges(crack->last->loads, n, K->I, K->II, shear,
                                                       r.I + at, r.II + at, r.K_max + at, r.R + at);
    }
    return r;
}

crack_growth crack_growth_of(const crack_case *crack, double angle, bool presses, int shear,
                             double from, double to)
{
    const crack_law *law = &crack->law;
    const double constants[] = {isnan(law->dK_th) ? 0 : law->dK_th,
                                isnan(law->ds0) ? HUGE_VAL : law->ds0, isnan(law->C) ? 1 : law->C,
                                isnan(law->m) ? 1 : law->m, isnan(law->K_c) ? HUGE_VAL : law->K_c};
    crack_growth g = {0};
    g.status = (presses ? rwedge_cycle_closing_growth : rwedge_cycle_growth)(
        crack->last->cycle, crack->x, radians(angle), shear, 5, constants, from, to, &g.end,
        &g.cycles, &g.least, &g.least_at);
    return g;
}

/* dK over the threshold at the first length. */
static double ratio_at_first(const crack_case *crack, double angle, int shear, int32_t *status)
{
    crack_case of_first = *crack;
    of_first.lengths = 1;
    for (int k = 0; k < SHEARS; k++)
        of_first.is_wanted[k] = k == shear;
    const crack_ranges r = crack_ranges_of(&of_first, angle, NULL);
    const double dK = hypot(r.I[shear], r.II[shear]);
    *status = r.status;
    free(r.I);
    return dK / crack_threshold(&crack->law, crack->length[0]);
}

crack_growth crack_verdict_of(const crack_case *crack, double angle, int shear)
{
    crack_growth g = crack_growth_of(crack, angle, true, shear, crack->length[0],
                                     crack->length[crack->lengths - 1]);
    if (g.status == RWEDGE_OK)
        g.first = ratio_at_first(crack, angle, shear, &g.status);
    return g;
}

bool crack_grows(const crack_growth *g)
{
    return !(isinf(g->cycles) && isfinite(g->end));
}
