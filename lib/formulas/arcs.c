/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "formulas/arcs.h"

#include "base/array.h"

rw_pad *rw_pad_create(size_t count)
{
    rw_pad *pad = malloc(sizeof *pad);
    if (!pad)
        return NULL;
    *pad = (rw_pad){.arcs = malloc(count * sizeof *pad->arcs),
                    .weights = malloc(count * sizeof *pad->weights)};
    if (pad->arcs && pad->weights)
        return pad;
    rw_pad_destroy(pad);
    return NULL;
}

rw_pad *rw_pad_copy(const rw_pad *pad, bool *is_whole)
{
    rw_pad *copy = rw_copied(pad, pad != NULL, sizeof *copy, is_whole);
    if (!copy)
        return NULL;
    copy->arcs = rw_copied(pad->arcs, pad->count, sizeof *pad->arcs, is_whole);
    copy->weights = rw_copied(pad->weights, pad->count, sizeof *pad->weights, is_whole);
    return copy;
}

void rw_pad_destroy(rw_pad *pad)
{
    if (!pad)
        return;
    free(pad->arcs);
    free(pad->weights);
    free(pad);
}

void rw_pad_append(rw_pad *pad, rw_arc arc, double weight)
{
    pad->arcs[pad->count] = arc;
    pad->weights[pad->count++] = weight;
    pad->is_symmetric = true;
    for (size_t i = 0, j = pad->count - 1; i <= j && j < pad->count; i++, j--)
        if (pad->arcs[i].left != -pad->arcs[j].right || pad->arcs[i].right != -pad->arcs[j].left ||
            pad->weights[i] != pad->weights[j])
            pad->is_symmetric = false;
}

/* An arc outside the patch has a tilt of -1 or 1. These are added apart: for a symmetric pad they
 * cancel exactly. */
rw_pressing rw_arcs_pressing(const rw_arcs *arcs, rw_patch patch)
{
    rw_pressing sum = {0, 0, 0};
    double aside = 0;
    for (size_t i = 0; i < arcs->count; i++) {
        const rw_arc arc = rw_arc_at(arcs, i);
        const double weight = rw_arc_weight(arcs, i);
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

rw_edge_rates rw_arcs_edge_rates(const rw_arcs *arcs, rw_patch patch)
{
    rw_edge_rates sum = {0, 0};
    for (size_t i = 0; i < arcs->count; i++) {
        if (!rw_arc_is_inside(rw_arc_at(arcs, i), patch))
            continue;
        const rw_arc_ends ends = rw_arc_ends_of(rw_arc_at(arcs, i), patch);
        const double weight = rw_arc_weight(arcs, i);
        const double slant = ends.sin_middle * ends.sin_half_over; /* (c_0 - c_1)/(2 alpha) */
        sum.at_left += weight * (ends.half_over - slant);
        sum.at_right += weight * (ends.half_over + slant);
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

double rw_arcs_height(const rw_arcs *arcs, double x)
{
    double sum = 0;
    for (size_t i = 0; i < arcs->count; i++) {
        const rw_arc arc = rw_arc_at(arcs, i);
        const double weight = rw_arc_weight(arcs, i);
        if (arc.left >= 0 && arc.right > 0)
            sum += weight * rise(arc, x);
        else if (arc.right > 0 && x < arc.right) /* in the middle */
            sum += weight * (x / arc.right * (x / 2));
        else if (arc.right > 0 || arc.left == 0) /* or a kink there */
            sum += weight * (x - arc.right / 2);
    }
    return sum;
}

double rw_arcs_shape(const rw_arcs *arcs, double x)
{
    double sum = 0;
    for (size_t i = 0; i < arcs->count; i++) {
        const rw_arc arc = rw_arc_at(arcs, i);
        const double from_middle = x - (arc.left + arc.right) / 2, width = arc.right - arc.left;
        sum += rw_arc_weight(arcs, i) * (x > arc.left && x < arc.right
                                             ? from_middle * (from_middle / width) + width / 4
                                             : fabs(from_middle));
    }
    return sum;
}

bool rw_arcs_have_kink(const rw_arcs *arcs, double x)
{
    for (size_t i = 0; i < arcs->count; i++)
        if (rw_arc_at(arcs, i).left == x && rw_arc_at(arcs, i).right == x)
            return true;
    return false;
}
