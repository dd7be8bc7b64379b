/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "yield/climb.h"

#include "base/domain.h"
#include "base/select.h"
#include "stress/stress.h"

#include <float.h>

enum { LINE = 7, CLIMB_MAX = 60 };

/* Half-lengths of the line on which a climb looks for a higher place, in radians and ln r. It
 * starts with FIRST, and with LATER where it goes on from a top. It ends at ROUGH when only the top
 * must be told from others, and at LAST. Each is NARROWER than the one before. */
static const double FIRST_SPAN = 0.4, LATER_SPAN = 1e-4, ROUGH_SPAN = 1e-2, LAST_SPAN = 1e-6,
                    NARROWER = 1.0 / 16;

/* The relative rise of J2 that counts as none. */
static const double NO_GAIN = 4 * DBL_EPSILON;

/* How well a rough climb knows a top: a fraction of J2, and of the distance from the mark. */
static const double ROUGHLY = 0.05;

static double J2_of(const rw_highest *s, rw_field normal, rw_field shear)
{
    const rw_stress_state state = rw_superpose(normal, shear);
    const double difference = state.difference - s->tension, mean = state.mean + s->tension;
    return difference * difference + state.shear * state.shear + s->kappa * mean * mean;
}

void rw_J2_from(rw_highest *s, const rw_contact_fields *fields, int side, int n, double J2[])
{
    const double f = side * s->contact->f;
    for (int i = 0; i < n; i++) {
        J2[i] = J2_of(s, rw_field_in(&fields->normal, i),
                      rw_field_multiple(f, rw_field_in(&fields->tangential, i)));
        s->known = rw_larger(s->known, J2[i]);
    }
}

/* J2 at n <= RW_BATCH points. A higher one becomes the highest so far. */
static void evaluate(rw_highest *s, int n, const double x[], const double y[], double J2[])
{
    rw_contact_fields fields;
    rw_contact_fields_at(s->contact, 1, s->contact->memory.count, n, x, y, &fields);
    rw_J2_from(s, &fields, 1, n, J2);
    for (int i = 0; i < n; i++)
        if (J2[i] > s->J2) {
            s->J2 = J2[i];
            s->x = x[i];
            s->y = y[i];
        }
}

/* ---- Climbing ---- */

/* Looks at n <= LINE places, and moves to the highest if it is higher than the top. An angle beyond
 * the surface counts as the surface. */
static void look_at(rw_highest *s, rw_climb *c, int n, const rw_polar at[], double J2[])
{
    double x[LINE], y[LINE];
    for (int i = 0; i < n; i++) {
        const double r = fmax(c->innermost, fmin(c->outermost, exp(at[i].log_radius))),
                     angle = at[i].angle, cosine = cos(angle), sine = sin(angle);
        const bool is_below = angle > 0 && angle < RW_PI;
        x[i] = c->centre + r * (is_below ? cosine : angle <= 0 ? 1 : -1);
        y[i] = is_below ? r * sine : 0;
        y[i] = rw_off_apex(s->contact, x[i], y[i], r);
    }
    evaluate(s, n, x, y, J2);
    for (int i = 0; i < n; i++)
        if (J2[i] > c->J2) {
            c->top = at[i];
            c->J2 = J2[i];
        }
}

/* A line of unit direction through a place, points on it around that place, and the middle one or a
 * higher one. */
typedef struct {
    rw_highest *highest;
    rw_climb *climb;
    rw_polar through, direction;
    double span, J2[LINE];
    int top;
} line;

/* The points are a step of 1 apart, the middle one is at 0. */
static rw_polar place_on(const line *l, double at)
{
    const double t = at * 2 * l->span / (LINE + 1);
    return (rw_polar){l->through.angle + t * l->direction.angle,
                      l->through.log_radius + t * l->direction.log_radius};
}

static void look_around(line *l)
{
    rw_polar place[LINE];
    for (int i = 0; i < LINE; i++)
        place[i] = place_on(l, i - LINE / 2);
    look_at(l->highest, l->climb, LINE, place, l->J2);
    l->top = LINE / 2;
    for (int i = 0; i < LINE; i++)
        l->top = l->J2[i] > l->J2[l->top] ? i : l->top;
}

/* While the highest point is at an end, the line goes on from there, twice as long. Nothing is
 * higher beyond the limits of angle and radius. */
static void look_farther(line *l)
{
    look_around(l);
    while (l->top == 0 || l->top == LINE - 1) {
        l->through = l->climb->top;
        l->span *= 2;
        look_around(l);
    }
}

/* The top of a parabola through the highest point and its neighbours, at most half a step away. */
static rw_polar top_of_parabola(const line *l)
{
    const double *J2 = l->J2 + l->top;
    const double fall = (J2[0] - J2[-1]) + (J2[0] - J2[1]), lean = J2[1] - J2[-1];
    return place_on(l, l->top - LINE / 2 + (fall > 0 ? lean / (2 * fall) : 0));
}

/* Moves to the highest place along a line, both ways. */
static void climb_along(rw_highest *s, rw_climb *c, double to_angle, double to_log_radius,
                        double span, double last_span)
{
    enum { MOST_TURNS = 30 }; /* a few are enough, but on a plateau */
    const double length = hypot(to_angle, to_log_radius);
    if (length == 0)
        return;
    line l = {s, c, c->top, {to_angle / length, to_log_radius / length}, .span = span};
    look_farther(&l);
    for (int i = 0; i < MOST_TURNS && l.span > last_span; i++) {
        l.through = top_of_parabola(&l);
        l.span *= NARROWER;
        look_farther(&l);
    }
}

/* Two places that are each highest for their radius make a line, and the next climb goes along it
 * (Powell's conjugate direction). It is exact where J2 is quadratic. It follows the ridges of
 * narrow roundings, where J2 is flat to 1e-9. */
static void climb_to(rw_highest *s, rw_climb *c, double last_span)
{
    double span = FIRST_SPAN;
    for (int i = 0; i < CLIMB_MAX; i++) { /* a few are enough, but on a plateau */
        const double before = c->J2;
        climb_along(s, c, 1, 0, span, last_span);
        const rw_polar start = c->top;
        climb_along(s, c, 0, 1, span, last_span);
        climb_along(s, c, 1, 0, span, last_span);
        climb_along(s, c, c->top.angle - start.angle, c->top.log_radius - start.log_radius, span,
                    last_span);
        if (last_span == ROUGH_SPAN || c->J2 - before <= NO_GAIN * before)
            return;
        span = LATER_SPAN;
    }
}

/* Moves to the highest place of each radius. A ridge lies beside the angles of the grid: along it
 * J2 may rise where the grid falls, by as much as the angle from one to the other changes. */
static void climb_ridge(rw_highest *s, rw_climb *c)
{
    const double angle = c->top.angle, step = log(1 / RW_FALL);
    double log_radius = log(c->innermost);
    while (log_radius < log(c->outermost)) {
        rw_polar at[LINE];
        double J2[LINE];
        for (int i = 0; i < LINE; i++, log_radius += step)
            at[i] = (rw_polar){angle, log_radius};
        look_at(s, c, LINE, at, J2);
    }
}

/* A top much nearer to the centre than to its own mark is narrow from there. */
static void climb_around_centre(rw_highest *s, double from_mark)
{
    const double r = hypot(s->x, s->y);
    if (!(r > 0 && r < from_mark / 5))
        return;
    rw_climb c = {0, 1e-3 * r, 1e3 * r, {atan2(s->y, s->x), log(r)}, s->J2, 0};
    climb_to(s, &c, LAST_SPAN);
}

/* Climbs roughly first. That is enough for a top that is lower than the highest, and for one that
 * was climbed already, from a mark about as near: a mark much farther away sees less detail. */
static void climb_to_top(rw_highest *s, rw_climb *c)
{
    climb_to(s, c, ROUGH_SPAN);
    const double r = exp(c->top.log_radius);
    const double to_known =
        hypot(c->centre + r * cos(c->top.angle) - s->top_x, r * sin(c->top.angle) - s->top_y);
    if (c->J2 < (1 - ROUGHLY) * s->J2 || (to_known < ROUGHLY * r && s->top_radius < 2 * r))
        return;
    climb_ridge(s, c);
    climb_to(s, c, LAST_SPAN);
    if (c->J2 >= s->J2) {
        climb_around_centre(s, exp(c->top.log_radius));
        s->top_x = s->x;
        s->top_y = s->y;
        s->top_radius = exp(c->top.log_radius);
    }
}

void rw_climb_from(rw_highest *s, rw_climb from)
{
    const rw_polar start = from.top;
    const double surface = 0;
    double at_mark;
    if (!rw_is_kink(&s->contact->geometry, from.centre)) /* J2 is finite there */
        evaluate(s, 1, &from.centre, &surface, &at_mark);
    from.J2 = 0; /* known from a grid, whose fields have an error */
    look_at(s, &from, 1, &start, &at_mark);
    climb_to_top(s, &from);
}
