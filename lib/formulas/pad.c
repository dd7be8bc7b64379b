/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "formulas/pad.h"

/* An arc outside the patch has a tilt of -1 or 1. These are added apart: for a symmetric pad they
 * cancel exactly. */
rw_pressing rw_pad_pressing(const rw_pad *pad, rw_patch patch)
{
    rw_pressing sum = {0, 0, 0};
    double aside = 0;
    for (size_t i = 0; i < pad->count; i++) {
        const rw_arc arc = pad->arcs[i];
        const double weight = pad->weights[i];
        int side = arc.left < patch.right ? 1 : -1;
        if (rw_arc_is_inside(arc, patch)) {
            const rw_pressing carried = rw_arc_pressing(arc, patch, &side);
            sum.load += weight * carried.load;
            sum.moment += weight * carried.moment;
            sum.tilt += weight * carried.tilt;
        }
        aside += side * weight;
    }
    sum.tilt += aside;
    return sum;
}

rw_edge_rates rw_pad_edge_rates(const rw_pad *pad, rw_patch patch)
{
    rw_edge_rates sum = {0, 0};
    for (size_t i = 0; i < pad->count; i++) {
        if (!rw_arc_is_inside(pad->arcs[i], patch))
            continue;
        const rw_arc_ends ends = rw_arc_ends_of(pad->arcs[i], patch);
        const rw_edge_rates rates = rw_patch_edge_rates(&ends);
        sum.at_left += pad->weights[i] * rates.at_left;
        sum.at_right += pad->weights[i] * rates.at_right;
    }
    return sum;
}

/* How much the profile of an arc rises from its left end to x. */
static double rise(rw_arc arc, double x)
{
    const double a = rw_arc_half_length(arc);
    if (x <= arc.left)
        return 0;
    return x < arc.right ? (x - arc.left) / a * ((x - arc.left) / 2) : 2 * (a + (x - arc.right));
}

double rw_pad_rise(const rw_pad *pad, rw_patch patch, double x)
{
    double sum = 0;
    for (size_t i = 0; i < pad->count; i++) {
        const rw_arc arc = pad->arcs[i];
        if (arc.left >= patch.right && x > patch.right)
            sum += pad->weights[i] * rise(arc, x);
        else if (arc.right <= patch.left && x < patch.left)
            sum += pad->weights[i] * rise((rw_arc){-arc.right, -arc.left}, -x);
    }
    return sum;
}

double rw_pad_height(const rw_pad *pad, double x)
{
    double sum = 0;
    for (size_t i = 0; i < pad->count; i++) {
        const rw_arc arc = pad->arcs[i];
        if (arc.left >= 0 && arc.right > 0)
            sum += pad->weights[i] * rise(arc, x);
        else if (arc.right > 0 && x < arc.right) /* in the middle */
            sum += pad->weights[i] * (x / arc.right * (x / 2));
        else if (arc.right > 0 || arc.left == 0) /* or a kink there */
            sum += pad->weights[i] * (x - arc.right / 2);
    }
    return sum;
}

bool rw_pad_is_kink(const rw_pad *pad, double x)
{
    for (size_t i = 0; i < pad->count; i++)
        if (pad->arcs[i].left == x && pad->arcs[i].right == x)
            return true;
    return false;
}
