/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "numerical/bonding.h"

#include "base/domain.h"
#include "base/root.h"

rw_bonding rw_bonding_of(const rw_arcs *arcs, rw_patch from, rw_patch to, double B)
{
    rw_bonding b = {.arcs = arcs, .from = from, .to = to, .B = B};
    rw_gauss(RW_TERMS, b.node, b.weight);
    return b;
}

/* tau per part of the way. Next to a growing edge n is rate/sqrt(distance) of what the pad has
 * there. */
static double rate_at(const rw_bonding *b, double part, double x)
{
    const rw_patch patch = {b->from.left + part * (b->to.left - b->from.left),
                            b->from.right + part * (b->to.right - b->from.right)};
    const double from_left = x - patch.left, to_right = patch.right - x;
    if (!(from_left > 0 && to_right > 0))
        return 0;
    const rw_edge_rates rates = rw_arcs_edge_rates(b->arcs, patch);
    const double at_left = 2 / RW_PI * rates.at_left * (b->from.left - b->to.left),
                 at_right = 2 / RW_PI * rates.at_right * (b->to.right - b->from.right);
    const double half = rw_patch_half_width(patch), u = (x - rw_patch_middle(patch)) / half;
    const double mean = (at_right + at_left) / 2, slope = (at_right - at_left) / 2;
    return -b->B / RW_PI * ((mean + slope * u) * log(to_right / from_left) + 2 * slope) /
           sqrt(from_left * to_right);
}

/* Between two parts of the way. An edge is at x at `passes`, which is not between them: there the
 * rate is like ln(d)/sqrt(d). */
static double sum_between(const rw_bonding *b, double x, double from, double to, double passes)
{
    enum { PANELS = 3 };
    const int way = from >= passes ? 1 : -1;
    const double near = sqrt(fmax(0, way > 0 ? from - passes : passes - to)),
                 far = sqrt(fmax(0, way > 0 ? to - passes : passes - from));
    double sum = 0, begun = near;
    for (int k = 1; k <= PANELS; k++) {
        const double end = k == PANELS ? far : near + (far - near) * pow(0.1, PANELS - k);
        for (int i = 0; i < RW_TERMS; i++) {
            const double v = b->node[i], y = begun + (end - begun) * v * v;
            sum +=
                2 * y * rate_at(b, passes + way * y * y, x) * (end - begun) * 2 * v * b->weight[i];
        }
        begun = end;
    }
    return sum;
}

/* When an edge that moves evenly is at x; far away if it hardly moves. */
static double passing(double from, double to, double x)
{
    static const double FAR = 1e6;
    const double passes = (x - from) / (to - from);
    return fabs(passes) < FAR ? passes : FAR;
}

double rw_bonding_at(const rw_bonding *b, double x)
{
    const double left = passing(b->from.left, b->to.left, x),
                 right = passing(b->from.right, b->to.right, x);
    const bool is_left = fmin(fabs(left), fabs(left - 1)) < fmin(fabs(right), fabs(right - 1));
    double at[4] = {0, 1, 1, 1}, sum = 0;
    int n = 1;
    for (int k = 0; k < 2; k++) {
        const double passes = (k == 0) == (left < right) ? left : right;
        if (passes > 0 && passes < 1)
            at[n++] = passes;
    }
    at[n] = 1;
    for (int i = 0; i < n; i++) {
        const bool from_pass = at[i] == left || at[i] == right,
                   to_pass = at[i + 1] == left || at[i + 1] == right;
        const double nearest = is_left ? left : right;
        const double passes = from_pass ? at[i] : to_pass ? at[i + 1] : nearest;
        sum += sum_between(b, x, at[i], at[i + 1], passes);
    }
    return sum;
}
