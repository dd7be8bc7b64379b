/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The energy of one load step.
 *
 * The front of slip passes the layers ds of the path. In a layer the slope D of the path changes
 * by w = |+-1 - D|. The shear traction then changes by f w times that of a flat punch of half-width
 * eta(s). Outside the punch the points slip by
 *     |d slip| = (A f w/pi) arcosh(|x|/eta(s)) ds.
 * The pressure is p = -int ds'/(pi sqrt(eta(s')^2 - x^2)), a sum of flat punches. The mean of
 * arcosh(|x|/eta) under the pressure of one of them, of half-width eta', is ln(eta'/eta). So the
 * work of friction is
 *     int f |p| |d slip| dx = (A f^2 w/pi) ds int_s^P ln(eta(s')/eta(s)) ds'.
 * Now ln(eta'/eta) = int du (d ln eta/du), and the integrals are exchanged. A layer s1 < s < s0 of
 * constant w, passed while the edge moves from P0 to P1, dissipates
 *     (A f^2 w/pi) int B(u) du/(u m(u)),
 *     B(u) = int (P(s) - u)+ ds over s1 < s < min(s0, u),   m = d ln u/d ln eta.
 * This is one integral of one sign, and nothing in it cancels. m is 2 for Hertz and 1 for the sharp
 * wedge. Of any other symmetric pad the integral is taken over the half-widths. */
#include "history/dissipation.h"

#include "base/always.h"
#include "base/domain.h"
#include "base/root.h"
#include "base/sort.h"
#include "rwedge.h"

#include <float.h>

/* A layer. The front goes from s0 to s1, the edge from p0 to p1; s0 <= s1, p <= s. All four are
 * depths below the load `top` at the start of the step, because layers may be thin. */
typedef struct {
    double top, corner_load;
    double s0, s1, p0, p1;
    const rw_geometry *pad; /* NULL for the wedge */
} layer;

/* ---- The integrand ---- */

/* B at the depth d. P - u is linear in s. So B is the area of a trapezium, or of its part above
 * 0. */
static double overlap(const layer *l, double d)
{
    const double from = fmax(l->s0, d), length = l->s1 - from;
    if (length <= 0)
        return 0;
    /* always: s1 - s0 is not less than the length */
    const double slope = ALWAYS(l->s1 > l->s0) ? (l->p1 - l->p0) / (l->s1 - l->s0) : 0;
    const double at_s1 = d - l->p1, at_from = d - (l->p0 + slope * (from - l->s0));
    if (at_s1 >= 0 && at_from >= 0)
        return length * (at_s1 + at_from) / 2;
    const double above = fmax(at_s1, at_from), below = fmin(at_s1, at_from);
    return above > 0 ? length * above / (above - below) * above / 2 : 0;
}

/* m(u) for a load u. Under corner_load the contact reaches the end of the rounding. Up to that load
 * m = 2 (Hertz). Beyond, the half-width e = eta/a solves e load(1/e) = (pi/2) ratio. The left side
 * is concave, so Newton's steps from below stay below. At most 4 are needed. */
static double logarithmic_slope(double u, double corner_load)
{
    if (u <= corner_load)
        return 2;
    if (u * DBL_EPSILON > corner_load) /* of the sharp wedge corner_load is 0 */
        return 1;
    const double ratio = u / corner_load;
    double e = fmax(sqrt(ratio), RW_HALF_PI / 2 * ratio), rounded = 0, whole = 0;
    for (int step = 0; ALWAYS(step < 8); step++) { /* 4 are enough */
        rounded = asin(1 / e) * e;
        whole = rounded + rw_cos_asin(1 / e);
        const double change = (RW_HALF_PI * ratio - e * whole) / (2 * rounded);
        e += change;
        if (change < 1e-14 * e)
            break;
    }
    return 2 * rounded / whole;
}

static double integrand(const layer *l, double d)
{
    const double u = l->top - d;
    if (u <= 0) /* rounding of a depth next to the origin, where B/u is finite and without weight */
        return 0;
    return overlap(l, d) / (u * logarithmic_slope(u, l->corner_load));
}

/* ---- Its integral ---- */

/* A panel: a range of u in which the integrand is smooth, except that near corner_load it has a
 * square root of u - corner_load. */
typedef struct {
    const layer *l;
    /* lo and hi: the loads at its ends, less corner_load; depth: that of hi */
    double depth, lo, hi;
} panel;

static double plain(double below, const void *context)
{
    const panel *p = context;
    return integrand(p->l, p->depth + below);
}

/* u = corner_load + t^2. */
static double square_root(double t, const void *context)
{
    const panel *p = context;
    const double top = sqrt(p->hi);
    return 2 * t * integrand(p->l, p->depth + (top - t) * (top + t));
}

static double panel_integral(const layer *l, double shallow, double deep)
{
    const panel p = {l, shallow, l->top - deep - l->corner_load, l->top - shallow - l->corner_load};
    /* of a panel's end that is meant to be the corner; the corner may be far above the load */
    const double rounding = rw_memory_tolerance(fmax(l->top, l->corner_load));
    /* Panels are cut at the corner, so that none has it inside by more than rounding. */
    if (p.hi <= rounding || NEVER(p.lo < -rounding) || p.lo > deep - shallow)
        return rw_integral(plain, &p, 0, deep - shallow);
    return rw_integral(square_root, &p, sqrt(fmax(p.lo, 0)), sqrt(p.hi));
}

/* The integral from one depth to another, between which B is one polynomial. There is a pole at u =
 * 0, so the panels get shorter towards it, in geometric sequence. Panels that rounding does not
 * separate from u = 0 add nothing, because B is of order u there. */
static double smooth_integral(const layer *l, double shallow, double deep)
{
    double sum = 0;
    while (shallow < deep && l->top - shallow > DBL_EPSILON * l->top) {
        const double next = fmin(deep, l->top - (l->top - shallow) / 4);
        sum += panel_integral(l, shallow, next);
        shallow = next;
    }
    return sum;
}

/* ---- Over the half-widths of a pad ---- */

typedef struct {
    const layer *l;
    double from, to;
} span;

/* du/(u m) is d(ln eta). Roots at both ends are smooth in t. */
static double at_half_width(double t, const void *context)
{
    const span *s = context;
    const double sine = sin(t), width = s->to - s->from, b = s->from + width * sine * sine;
    return overlap(s->l, s->l->top - rw_normal_load(s->l->pad, b)) / b * width * sin(2 * t);
}

static double half_width_at(const layer *l, double depth)
{
    return rw_half_width(l->pad, fmax(0, l->top - depth));
}

/* The integral is cut where B is another polynomial, where the contact reaches an arc, and in
 * geometric sequence. */
static double next_cut(const layer *l, const double cut[4], double from, double end)
{
    const rw_pad *pad = l->pad->pad;
    double next = from > 0 ? fmin(end, 4 * from) : end;
    for (int i = 0; i < 4; i++)
        next = rw_earlier(cut[i], from, next);
    for (size_t i = 0; i < pad->count; i++)
        next = rw_earlier(pad->arcs[i].right, from, rw_earlier(pad->arcs[i].left, from, next));
    return next;
}

static double integral_of_pad(const layer *l)
{
    const double cut[] = {half_width_at(l, l->p0), half_width_at(l, l->p1), half_width_at(l, l->s0),
                          half_width_at(l, l->s1)};
    const double end = fmax(cut[0], cut[1]);
    double sum = 0;
    for (double from = cut[3], next; from < end; from = next) {
        next = next_cut(l, cut, from, end);
        const span s = {l, from, next};
        sum += rw_integral(at_half_width, &s, 0, RW_HALF_PI);
    }
    return sum;
}

static double layer_integral(const layer *l)
{
    if (l->pad)
        return integral_of_pad(l);
    const double corner = l->top - l->corner_load; /* the depth where m(u) has its corner */
    double cut[5] = {l->p0, l->p1, l->s0, corner, l->s1};
    rw_sort(cut, 5);
    const double shallowest = fmin(l->p0, l->p1), deepest = l->s1;
    double sum = 0;
    for (int i = 1; i < 5; i++)
        sum += smooth_integral(l, fmax(cut[i - 1], shallowest), fmin(cut[i], deepest));
    return sum;
}

/* ---- The step ---- */

typedef struct {
    const rw_memory *memory;
    double top, run, rise; /* the step: t = 0 ... 1 */
    double corner_load;
    const rw_geometry *pad;
} step;

/* How far a corner of the path lies below its end. */
static double depth_of(const step *s, size_t i)
{
    return s->top - s->memory->corners[i].load;
}

/* Slip of one sign while t goes from start to end. The front is where the path meets the line of
 * slope `slip` from the load. Between 0 and t the line climbs by t climb; going back along the
 * path, it nears the line by 1 - slip D per depth. */
static double sweep(const step *s, int slip, double start, double end)
{
    const double climb = slip * s->rise - s->run;
    const rw_corner *corners = s->memory->corners;
    double front = fmax(0, -s->run * start), t = start, sum = 0;
    for (size_t i = s->memory->count - 1; i > 0 && t < end; i--) {
        const double bottom = depth_of(s, i - 1);
        const double weight = 1 - slip * corners[i].ratio;
        if (bottom <= front || weight <= 0)
            front = fmax(front, bottom);
        if (bottom <= front)
            continue;
        const double t_bottom = t + weight * (bottom - front) / climb;
        const double next =
            t_bottom > end ? fmin(bottom, front + (end - t) * climb / weight) : bottom;
        const double t_next = fmin(t_bottom, end);
        const layer l = {s->top,      s->corner_load,   front, next,
                         -s->run * t, -s->run * t_next, s->pad};
        sum += weight * layer_integral(&l);
        front = next;
        t = t_next;
    }
    return sum;
}

static int sign(double v)
{
    return (v > 0) - (v < 0);
}

/* A falling load. The edge moves along the path. `missing` is the shear of the step less that of
 * the path there. Where it changes sign, the zone of slip has shrunk to nothing. A new one begins,
 * with the other sign. */
static double falling(const step *s)
{
    const rw_corner *corners = s->memory->corners;
    double t = 0, start = 0, missing = 0, sum = 0;
    int slip = 0;
    for (size_t i = s->memory->count - 1; i > 0 && t < 1; i--) {
        const double next = fmin(1, depth_of(s, i - 1) / -s->run);
        const double rate = s->rise - corners[i].ratio * s->run;
        const double then = missing + rate * (next - t);
        if (slip != 0 && slip * then < 0) {
            const double crossing = t + missing / -rate;
            sum += sweep(s, slip, start, crossing);
            start = crossing;
            slip = -slip;
        } else if (slip == 0) {
            slip = sign(rate);
            start = t;
        }
        missing = then;
        t = next;
    }
    return slip != 0 ? sum + sweep(s, slip, start, 1) : sum;
}

double rw_dissipation(const rw_memory *memory, rw_memory_loads to, const rw_geometry *g)
{
    const rw_corner *end = rw_memory_end(memory);
    const step s = {.memory = memory,
                    .top = end->load,
                    .run = to.load - end->load,
                    .rise = to.shear - end->shear,
                    .corner_load = RW_HALF_PI * g->a * rw_unit_stress(g),
                    .pad = g->pad ? g : NULL};
    if (s.run < 0)
        return falling(&s);
    if (fabs(s.rise) <= s.run + rw_memory_tolerance(to.load))
        return 0;
    return sweep(&s, sign(s.rise), 0, 1);
}
