/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "fretting.h"

#include <math.h>

const char *const full_wear_columns[FULL_WEAR_COLUMNS] = {"worn_depth", "worn_to", "depth_max",
                                                          "worn_area"};

/* Half of the range of Q, where nothing else changes. */
static double range_of_Q(const last_cycle *last)
{
    double least = INFINITY, most = -INFINITY;
    for (size_t i = 0; i < last->loads; i++) {
        const bool is_steady = last->P[i] == last->P[0] && last->M[i] == last->M[0] &&
                               last->sigma[i] == last->sigma[0];
        if (!is_steady)
            failure("--full-wear: load %zu of the cycle has another P, M or sigma than load 1; "
                    "allowed: a cycle of Q alone, P before it by --load",
                    i + 1);
        least = fmin(least, last->Q[i]);
        most = fmax(most, last->Q[i]);
    }
    return most / 2 - least / 2;
}

void full_wear_find(const last_cycle *last, full_wear *wear)
{
    double x;
    if (rwedge_contact_beta(last->before) != 0)
        failure("--full-wear: is of similar bodies; --similar takes these as such");
    wear->before = last->before;
    wear->Q_a = range_of_Q(last);
    int32_t status = rwedge_contact_worn_zone(last->before, wear->Q_a, &wear->left, &wear->right,
                                              &wear->worn_left, &wear->worn_right, &wear->area);
    if (status == RWEDGE_OK)
        status = rwedge_contact_deepest_wear(last->before, wear->Q_a, &wear->depth, &x);
    if (status == RWEDGE_ESLIDING)
        failure("--full-wear: Q goes to and fro by %g, and all of the contact slips: wear has no "
                "end",
                wear->Q_a);
    status_check(status, "--full-wear");
}

/* Empty below the surface and at the edges of the zone that sticks, where the pressure is
 * infinite: there nothing is worn. */
static double depth_at(const full_wear *wear, double x)
{
    double depth, p;
    if (x == wear->left || x == wear->right)
        return 0;
    const int32_t status = rwedge_contact_full_wear(wear->before, wear->Q_a, 1, &x, &depth, &p);
    return status == RWEDGE_OK ? depth : NAN;
}

void full_wear_write(const full_wear *wear, double x, double y, records *rows)
{
    const bool is_left = x < wear->left / 2 + wear->right / 2;
    records_value(rows, cell_number(y > 0 ? NAN : depth_at(wear, x)));
    records_value(rows, cell_number(is_left ? wear->worn_left : wear->worn_right));
    records_value(rows, cell_number(wear->depth));
    records_value(rows, cell_number(wear->area));
}
