/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The peak is a smooth function of the logarithm of the depth but for its second derivative, which
 * jumps where another place of the path begins to touch the ball. It is scanned coarsely; from each
 * maximum of the scan it is climbed, by the slope, to where that has a root. */
#include "shakedown/deepest.h"

#include "base/domain.h"
#include "base/root.h"

static const double STEP = 0.3, CLOSE_STEP = 0.1; /* of a path */

/* ---- The scan ---- */

enum { DEPTHS = 128 };

/* The ratio of a depth to the one above. A branch below the surface that is about to vanish is flat
 * beside a rise: a close scan finds it. */
static const double COARSE = 1.6, CLOSE = 1.2;

typedef struct {
    int n;
    double ratio;
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

static depth_scan scan_depths(const rw_pass *pass, double ratio)
{
    static const double DEEPEST = 1.5;
    const double last = DEEPEST * rw_patch_half_width(pass->patch);
    depth_scan s;
    s.n = 0;
    s.ratio = ratio;
    for (double y = shallowest(pass); s.n < DEPTHS && y < last; y *= ratio) {
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
    return log(s->y[i]) - log(s->ratio) * rise / bend;
}

/* ---- The climb ---- */

typedef struct {
    const rw_pass *pass;
    bool is_whole;       /* each peak is found from the whole path */
    double first, final; /* the logarithms of the depths between which it is */
    rw_least_peak *last; /* at the depth before */
} climb;

/* The slope follows from the whole path, or from the places that touch at the depth before. */
static double slope_at(double log_y, const void *context)
{
    const climb *c = context;
    rw_least_peak next;
    if (c->is_whole || !rw_least_peak_follows(c->last, c->pass, exp(log_y), &next))
        next = rw_least_peak_at(c->pass, exp(log_y), CLOSE_STEP);
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

/* A maximum: the logarithm of its depth, and its peak. */
typedef struct {
    double log_y;
    rw_least_peak peak;
} top;

/* Climbs from a depth upwards; false where there is no maximum. */
static bool climb_from(const climb *c, double log_y, const rw_least_peak *start, top *to)
{
    *c->last = *start;
    to->log_y = top_from(c, log_y);
    if (isnan(to->log_y))
        return false;
    slope_at(to->log_y, c);
    to->peak = *c->last;
    return true;
}

/* Whether the peak a step beside a maximum rises away from it, or is higher: there is another. */
static bool leads_away(const climb *c, const top *from, double step, rw_least_peak *beside)
{
    const double log_y = from->log_y + step;
    return log_y > c->first && log_y < c->final &&
           rw_least_peak_follows(&from->peak, c->pass, exp(log_y), beside) &&
           (beside->peak > from->peak.peak || step * beside->slope > 0);
}

/* Two tops may be nearly equal, and so close that the scan shows one: the other is climbed from
 * beside it. */
static void climb_beside(const climb *c, top *highest)
{
    static const double STEPS[] = {-0.5, -0.25, -0.1, 0.1, 0.25, 0.5};
    const top first = *highest;
    for (size_t i = 0; i < sizeof STEPS / sizeof STEPS[0]; i++) {
        rw_least_peak beside;
        top other;
        if (leads_away(c, &first, STEPS[i], &beside) &&
            climb_from(c, first.log_y + STEPS[i], &beside, &other) &&
            other.peak.peak > highest->peak.peak)
            *highest = other;
    }
}

/* The maximum above a guess. At the end the path is sampled closely: false where the climb has
 * missed another place, or there is no maximum. */
static bool maximum_from(const climb *c, double guess, rw_depth *depth)
{
    static const double HIDDEN = 1e-11;
    const rw_least_peak start =
        rw_least_peak_at(c->pass, exp(guess), c->is_whole ? CLOSE_STEP : STEP);
    top found;
    if (!climb_from(c, guess, &start, &found))
        return false;
    climb_beside(c, &found);
    const double y = exp(found.log_y);
    *depth = (rw_depth){rw_least_peak_checked(&found.peak, c->pass, y, CLOSE_STEP), y};
    return c->is_whole || depth->peak <= found.peak.peak * (1 + HIDDEN);
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
    const depth_scan s = scan_depths(pass, CLOSE);
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
    const depth_scan scan = scan_depths(pass, COARSE);
    const double coarse_surface = rw_least_peak_coarse(pass, 0);
    rw_depth below;
    const bool has_one = highest(scan.n, scan.peak) * DEFICIT > coarse_surface &&
                         highest_maximum(pass, &scan, &below);
    if (has_one && below.peak > coarse_surface * DEFICIT)
        return below;
    const rw_depth surface = {rw_surface_peak(pass), 0};
    return has_one && below.peak > surface.peak ? below : surface;
}
