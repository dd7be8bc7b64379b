/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The front N_0 = N* has slipped over the layers of the path between it and the contact N_n. The
 * slip at x is, over f theta and in the direction S of slip,
 *
 *     w(x) = sum c_i h_i(x),   h_i = gap(x; N_i) - gap(x; N_(i+1)),   c_i = 1 - S D_i >= 0,
 *
 * with the gap of gap.h. Up to the edge of N_i h_i is 0, from there to that of N_(i+1) it is
 * a gap, which is positive and rises. Beyond, h_i is concave: its slope is the Cauchy transform of
 * the pressure that N_(i+1) has more than N_i, which falls with the distance, and a constant.
 *
 * From the edge of N_j to that of N_(j+1), w is therefore a concave function, the sum of all i < j,
 * and c_j gap(x; N_j), which rises. A concave function is nowhere between two points below the
 * smaller of its values there. So w is positive up to a point if it is at the beginning, and if the
 * concave part there and the gap at the beginning have a positive sum. If they have not, the
 * interval is halved. */
#include "history/gap.h"
#include "history/path.h"

#include <float.h>

/* The rounding of gaps, and of edges over the width. A gap grows with the distance from the edge,
 * to the power 3/2 next to it. */
static const double ROUNDING = 1e-12, EDGE_ROUNDING = 8 * DBL_EPSILON;

/* How often an interval is halved. */
enum { HALVINGS = 16 };

typedef struct {
    const rw_geometry *geometry;
    const rw_memory *path;
    const rw_departure *departure;
    double edge_error;
    bool is_right;
} zone;

static rw_patch patch_of(const zone *z, size_t i)
{
    return i == 0 ? z->departure->corner.patch : z->path->corners[z->departure->kept + i - 1].patch;
}

static double edge_of(const zone *z, size_t i)
{
    const rw_patch patch = patch_of(z, i);
    return z->is_right ? patch.right : patch.left;
}

static double weight_of(const zone *z, size_t layer)
{
    return 1 - z->departure->slip * z->path->corners[z->departure->kept + layer].ratio;
}

typedef struct {
    double value, error;
} estimate;

static void add_gap(const zone *z, size_t i, double weight, double x, estimate *sum)
{
    const double gap = rw_patch_gap(z->geometry, patch_of(z, i), x),
                 distance = fabs(x - edge_of(z, i));
    sum->value += weight * gap;
    if (gap > 0)
        sum->error += (ROUNDING + 1.5 * z->edge_error / distance) * fabs(weight) * gap;
}

/* c_i h_i */
static void add_layer(const zone *z, size_t i, double x, estimate *sum)
{
    add_gap(z, i, weight_of(z, i), x, sum);
    add_gap(z, i + 1, -weight_of(z, i), x, sum);
}

static bool is_negative(estimate concave, estimate rising)
{
    return concave.value + rising.value < -(concave.error + rising.error);
}

/* w between two points of the j-th interval, at the nearer of which it is positive; `far` is
 * nearer to the contact's edge. */
static bool is_positive_between(const zone *z, size_t j, double near, double far, int halvings)
{
    estimate concave = {0, 0}, rising_near = {0, 0}, rising_far = {0, 0};
    for (size_t i = 0; i < j; i++)
        add_layer(z, i, far, &concave);
    add_gap(z, j, weight_of(z, j), near, &rising_near);
    add_gap(z, j, weight_of(z, j), far, &rising_far);
    if (!is_negative(concave, rising_near))
        return true;
    if (is_negative(concave, rising_far) || halvings == 0)
        return false;
    const double middle = near / 2 + far / 2;
    return is_positive_between(z, j, near, middle, halvings - 1) &&
           is_positive_between(z, j, middle, far, halvings - 1);
}

static bool slips_one_way(const zone *z)
{
    const size_t layers = z->path->count - z->departure->kept;
    const estimate none = {0, 0};
    estimate at_edge = {0, 0};
    for (size_t j = 1; j < layers; j++) {
        add_layer(z, j - 1, edge_of(z, layers), &at_edge);
        if (is_negative(at_edge, none) &&
            !is_positive_between(z, j, edge_of(z, j), edge_of(z, j + 1), HALVINGS))
            return false;
    }
    return true;
}

bool rw_slips_one_way(const rw_memory *path, const rw_departure *departure, const rw_geometry *g)
{
    const rw_corner *end = rw_memory_end(path);
    const double reach = fmax(fabs(end->patch.left), fabs(end->patch.right));
    const double error = EDGE_ROUNDING * reach / (1 - fabs(end->tilt));
    const zone right = {g, path, departure, error, true}, left = {g, path, departure, error, false};
    return slips_one_way(&right) && slips_one_way(&left);
}
