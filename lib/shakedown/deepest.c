/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The peak is a smooth function of the logarithm of the depth but for its second derivative, which
 * jumps where another place of the path begins to touch the ball. It is scanned coarsely; from each
 * maximum of the scan it is climbed, by the slope, to where that has a root. */
#include "shakedown/deepest.h"

#include "base/domain.h"
#include "base/root.h"

static const double STEP = 0.3, CLOSE_STEP = 0.1; /* of a path */

/* ---- The scan ---- */

enum { DEPTHS = 64 };

static const double RATIO = 1.6; /* of a depth to the one above */

typedef struct {
    int n;
    double y[DEPTHS], peak[DEPTHS];
} depth_scan;

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

static depth_scan coarse_scan(const rw_pass *pass)
{
    static const double DEEPEST = 1.5;
    const double last = DEEPEST * rw_patch_half_width(pass->patch);
    depth_scan s;
    s.n = 0;
    for (double y = shallowest(pass); s.n < DEPTHS && y < last; y *= RATIO) {
        s.y[s.n] = y;
        s.peak[s.n++] = rw_least_peak_coarse(pass, y);
    }
    return s;
}

/* The top of the parabola through three peaks of the scan, in the logarithm of the depth. */
static double parabola_top(const depth_scan *s, int i)
{
    const double rise = (s->peak[i + 1] - s->peak[i - 1]) / 2,
                 bend = s->peak[i - 1] - 2 * s->peak[i] + s->peak[i + 1];
    return log(s->y[i]) - log(RATIO) * rise / bend;
}

/* ---- The climb ---- */

typedef struct {
    const rw_pass *pass;
    bool is_whole;       /* each peak is found from the whole path */
    double first, final; /* the logarithms of the depths between which it is */
    rw_least_peak *last; /* at the depth before */
} climb;

/* If not from the whole path, from the places that touch at the depth before. */
static double slope_at(double log_y, const void *context)
{
    const climb *c = context;
    rw_least_peak next;
    if (c->is_whole)
        next = rw_least_peak_at(c->pass, exp(log_y), CLOSE_STEP);
    else if (!rw_least_peak_follows(c->last, c->pass, exp(log_y), &next))
        next = rw_least_peak_at(c->pass, exp(log_y), STEP);
    *c->last = next;
    return next.slope;
}

/* The logarithm of the depth where the slope changes its sign, from a guess upwards. NaN where the
 * peak grows to the end. */
static double top_from(const climb *c, double guess)
{
    static const double REACH = 0.05, FURTHER = 2, LONGEST = 0.4, NEAREST = 1e-7;
    const double way = c->last->slope > 0 ? 1 : -1, end = way > 0 ? c->final : c->first;
    double before = guess;
    for (double reach = REACH; way * (end - before) > 0; reach = fmin(FURTHER * reach, LONGEST)) {
        const double next = way * fmin(way * before + reach, way * end);
        if (way * slope_at(next, c) <= 0)
            return rw_root(slope_at, c, fmin(before, next), fmax(before, next), NEAREST);
        before = next;
    }
    return NAN;
}

/* A depth beside a maximum whose peak is higher; NaN where none of a few is. */
static double higher_beside(const climb *c, double log_y)
{
    static const double BESIDE[] = {-0.25, -0.1, 0.1, 0.25};
    const rw_least_peak maximum = *c->last;
    for (int i = 0; i < 4; i++) {
        const double other = log_y + BESIDE[i];
        rw_least_peak peak;
        if (other > c->first && other < c->final &&
            rw_least_peak_follows(&maximum, c->pass, exp(other), &peak) &&
            peak.peak > maximum.peak) {
            *c->last = peak;
            return other;
        }
    }
    return NAN;
}

/* The maximum above a guess. At the end the path is sampled closely: false where the climb has
 * missed another place, or there is no maximum. */
static bool maximum_from(const climb *c, double guess, rw_depth *depth)
{
    static const double HIDDEN = 1e-11;
    double log_y = guess;
    *c->last = rw_least_peak_at(c->pass, exp(guess), c->is_whole ? CLOSE_STEP : STEP);
    for (double start = guess; !isnan(start); start = higher_beside(c, log_y)) {
        log_y = top_from(c, start);
        if (isnan(log_y))
            return false;
        slope_at(log_y, c);
    }
    const double y = exp(log_y);
    *depth = (rw_depth){rw_least_peak_checked(c->last, c->pass, y, CLOSE_STEP), y};
    return c->is_whole || depth->peak <= c->last->peak * (1 + HIDDEN);
}

/* Near the i-th peak of the scan. */
static bool maximum_near(const rw_pass *pass, const depth_scan *s, int i, rw_depth *depth)
{
    rw_least_peak last;
    climb c = {pass, false, log(s->y[0]), log(s->y[s->n - 1]), &last};
    const double guess = parabola_top(s, i);
    if (maximum_from(&c, guess, depth))
        return true;
    c.is_whole = true;
    return maximum_from(&c, guess, depth);
}

static bool highest_maximum(const rw_pass *pass, const depth_scan *s, rw_depth *depth)
{
    bool has_one = false;
    for (int i = 1; i + 1 < s->n; i++) {
        rw_depth other;
        if (s->peak[i] >= s->peak[i - 1] && s->peak[i] > s->peak[i + 1] &&
            maximum_near(pass, s, i, &other) && (!has_one || other.peak > depth->peak)) {
            *depth = other;
            has_one = true;
        }
    }
    return has_one;
}

bool rw_subsurface_depth(const rw_pass *pass, rw_depth *depth)
{
    const depth_scan s = coarse_scan(pass);
    return highest_maximum(pass, &s, depth);
}

/* ---- The surface, and both ---- */

/* Two tops of the path that are close to each other may hide from a scan, which then is too low. Of
 * 60000 contacts four hid from one of these, none from both. */
double rw_surface_peak(const rw_pass *pass)
{
    static const double OTHER_STEP = 0.2, HIDDEN = 1e-12;
    const rw_least_peak peak = rw_least_peak_at(pass, 0, STEP);
    if (rw_least_peak_checked(&peak, pass, 0, OTHER_STEP) <= peak.peak * (1 + HIDDEN))
        return peak.peak;
    return fmax(peak.peak, rw_least_peak_at(pass, 0, OTHER_STEP).peak);
}

static double highest(int n, const double peak[])
{
    double most = 0;
    for (int i = 0; i < n; i++)
        most = fmax(most, peak[i]);
    return most;
}

/* Where coarse peaks tell which of both is higher, the other is not computed. */
rw_depth rw_deepest(const rw_pass *pass)
{
    static const double DEFICIT = 1.1; /* how much higher an exact peak may be than a coarse one */
    const depth_scan scan = coarse_scan(pass);
    const double coarse_surface = rw_least_peak_coarse(pass, 0);
    rw_depth below;
    const bool has_one = highest(scan.n, scan.peak) * DEFICIT > coarse_surface &&
                         highest_maximum(pass, &scan, &below);
    if (has_one && below.peak > coarse_surface * DEFICIT)
        return below;
    const rw_depth surface = {rw_surface_peak(pass), 0};
    return has_one && below.peak > surface.peak ? below : surface;
}
