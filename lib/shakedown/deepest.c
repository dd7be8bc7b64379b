/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The peak is a smooth function of the logarithm of the depth but for its second derivative, which
 * jumps where another place of the path begins to touch the ball. It is scanned coarsely; where the
 * scan has a maximum, its slope has a root. */
#include "shakedown/deepest.h"

#include "base/domain.h"
#include "base/root.h"

enum { DEPTHS = 64 };

static const double STEP = 0.3, CLOSE_STEP = 0.1; /* of a path */

typedef struct {
    const rw_pass *pass;
    double step;
} scan;

static double slope_at(double log_y, const void *context)
{
    const scan *s = context;
    return rw_least_peak_at(s->pass, exp(log_y), s->step).slope;
}

static double shallowest(const rw_pass *pass)
{
    double length = rw_patch_half_width(pass->patch);
    for (size_t i = 0; i < pass->arcs.count; i++) {
        const rw_arc arc = rw_arc_at(&pass->arcs, i);
        if (rw_arc_is_inside(arc, pass->patch) && arc.right > arc.left)
            length = fmin(length, rw_arc_half_length(arc));
    }
    return RW_SHALLOWEST * length;
}

/* Between two depths around a maximum of the scan. False where the slopes tell of none. */
static bool maximum_between(const scan *s, double above, double below, rw_depth *depth)
{
    static const double NEAREST = 1e-7;
    const double y = rw_root(slope_at, s, log(above), log(below), NEAREST);
    if (isnan(y))
        return false;
    depth->y = exp(y);
    depth->peak = rw_least_peak_at(s->pass, depth->y, s->step).peak;
    return true;
}

/* The path is sampled closely at the end. Where that finds a higher peak, it is from then on. */
static bool maximum_around(const rw_pass *pass, double above, double below, rw_depth *depth)
{
    static const double HIDDEN = 1e-11;
    const scan coarse = {pass, STEP}, close = {pass, CLOSE_STEP};
    if (!maximum_between(&coarse, above, below, depth))
        return false;
    const double peak = rw_least_peak_at(pass, depth->y, CLOSE_STEP).peak;
    if (peak <= depth->peak * (1 + HIDDEN)) {
        depth->peak = peak;
        return true;
    }
    return maximum_between(&close, above, below, depth);
}

bool rw_subsurface_depth(const rw_pass *pass, rw_depth *depth)
{
    static const double RATIO = 1.6, DEEPEST = 1.5;
    const double last = DEEPEST * rw_patch_half_width(pass->patch);
    double y[DEPTHS], peak[DEPTHS];
    int n = 0;
    for (double d = shallowest(pass); n < DEPTHS && d < last; d *= RATIO) {
        y[n] = d;
        peak[n++] = rw_least_peak_coarse(pass, d);
    }
    bool has_one = false;
    for (int i = 1; i + 1 < n; i++) {
        rw_depth other;
        if (peak[i] >= peak[i - 1] && peak[i] > peak[i + 1] &&
            maximum_around(pass, y[i - 1], y[i + 1], &other) &&
            (!has_one || other.peak > depth->peak)) {
            *depth = other;
            has_one = true;
        }
    }
    return has_one;
}

/* Two tops of the path that are close to each other may hide from a scan, which then is too low. Of
 * 60000 contacts four hid from one of these, none from both. */
double rw_surface_peak(const rw_pass *pass)
{
    static const double OTHER_STEP = 0.2;
    return fmax(rw_least_peak_at(pass, 0, STEP).peak, rw_least_peak_at(pass, 0, OTHER_STEP).peak);
}

rw_depth rw_deepest(const rw_pass *pass)
{
    const rw_depth surface = {rw_surface_peak(pass), 0};
    rw_depth below;
    return rw_subsurface_depth(pass, &below) && below.peak > surface.peak ? below : surface;
}
