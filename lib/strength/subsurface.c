/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The maximum below the surface. It is first found on the axis, at f = 0. From there it is
 * followed in f. For the smallest tips it is then followed in kappa.
 *
 * Why this cannot miss it. Two statements are used:
 * - A maximum below the surface that is higher than the surface's lies on the branch that begins
 *   on the axis.
 * - There is one other kind of local maximum, for f > 0.25, next to the corner x = a where the
 *   rounding ends. There the surface is higher, by at least 5 % of J2.
 * They are not proved here. The test yield_survey checks them: it searches the whole
 * half-plane without using them. For many alpha, f and nu tests/proof/certificate proves that the
 * result is the global maximum.
 *
 * If they hold, the path either reaches the maximum, or ends at a fold before it. In the second
 * case the surface governs. A step along the path counts only if every iterate had a negative
 * definite Hessian. So the path cannot change over to the saddle that the maximum meets at the
 * fold. */
#include "strength/maxima.h"

#include "base/domain.h"
#include "base/root.h"
#include "stress/von_mises.h"

#include <float.h>

/* ---- On the axis, f = 0 ---- */

typedef struct {
    const rw_potential *potential;
    double kappa;
} axis;

/* On the axis G = i P(y) and G' = P'(y), with real P < 0 < P'. So J2 = (y P')^2 + kappa P^2 and
 *     dJ2/dy = 2 P' steepness,     steepness = (y P' + y^2 P'') + kappa P.
 * The steepness is negative at the surface. It is negative far below, where J2 falls like 1/y^2.
 * It is positive on at most one interval. J2 has its maximum at the deeper end of that interval. */
static double steepness(double y, const void *context)
{
    const axis *a = context;
    rw_curvature bend;
    const rw_field field = rw_potential_with_curvature(a->potential, 0, y, &bend);
    return field.H_re - cimag(bend.K) + a->kappa * field.G_im;
}

/* A depth inside that interval, unless the interval is very short. As kappa grows, the interval
 * shrinks to a point between 0.55 alpha (small tips) and 0.35 alpha (Hertz). */
static double depth_of_last_rise(double alpha)
{
    return 0.56 * alpha / (1 + 0.65 * alpha * alpha);
}

/* The depth of the maximum; `above` is a smaller depth, inside the interval. The interval may be
 * many powers of ten long, so the maximum is first enclosed within a factor of FACTOR. */
static double depth_of_maximum(const axis *a, double above)
{
    static const double FACTOR = 4;
    while (FACTOR * above < 1 && steepness(FACTOR * above, a) > 0)
        above *= FACTOR;
    return rw_root(steepness, a, above, fmin(FACTOR * above, 1), 0);
}

/* ---- Along a path ---- */

typedef struct {
    double f, kappa;
} parameters;

typedef struct {
    double t; /* how far along the path, 0 to 1 */
    double x, y;
    rw_von_mises at; /* J2 and its derivatives there */
} path_point;

typedef struct {
    double x, y; /* over the depth y of the point */
} step;

static double determinant(const rw_von_mises *at)
{
    return at->xx * at->yy - at->xy * at->xy;
}

static bool is_concave(const rw_von_mises *at)
{
    return at->xx < 0 && determinant(at) > 0;
}

/* The step d with Hessian d = -(x, y). */
static step solve_hessian(const rw_von_mises *at, double x, double y)
{
    const double per_determinant = 1 / determinant(at);
    return (step){(at->xy * y - at->yy * x) * per_determinant,
                  (at->xy * x - at->xx * y) * per_determinant};
}

static double length(step s)
{
    return sqrt(s.x * s.x + s.y * s.y);
}

/* Newton's method from the given point. False if it leaves the region in which J2 is concave. */
static bool settle(const rw_potential *potential, parameters q, path_point *point)
{
    enum { MAX_STEPS = 12 };
    static const double LONGEST = 0.5; /* of the depth: y stays positive */
    /* Newton doubles the digits: the step after this one is rounding */
    static const double SQUARE_ROOT = 1e-8;
    for (int i = 0; i < MAX_STEPS; i++) {
        point->at = rw_von_mises_at(potential, q.f, q.kappa, point->x, point->y);
        if (!is_concave(&point->at))
            return false;
        const step d = solve_hessian(&point->at, point->at.x, point->at.y);
        if (!(length(d) < LONGEST))
            return false;
        point->x += d.x * point->y;
        point->y += d.y * point->y;
        const double gain = (point->at.x * d.x + point->at.y * d.y) / 2;
        /* The second test is for small tips without friction. At a tip of 1e-10 the maximum is so
         * flat that rounding of the gradient moves it by 1e-6. */
        if (length(d) < SQUARE_ROOT || gain < DBL_EPSILON / 4 * point->at.J2) {
            point->at.J2 += gain;
            return true;
        }
    }
    return false;
}

/* Where the path ends, estimated from two points on it. Next to a fold the determinant falls to 0
 * like the square root of the distance, so its square is linear. HUGE_VAL if it does not fall. */
static double fold_ahead(const path_point *before, const path_point *now)
{
    const double d0 = determinant(&before->at), d1 = determinant(&now->at);
    const double fall = (d0 - d1) * (d0 + d1);
    return fall > 0 ? now->t + d1 * d1 * ((now->t - before->t) / fall) : HUGE_VAL;
}

static parameters between(parameters start, parameters end, double t)
{
    return (parameters){start.f + t * (end.f - start.f),
                        start.kappa + t * (end.kappa - start.kappa)};
}

/* Moves *point from the start of the path to its end. False if the maximum ends before that. */
static bool follow(const rw_potential *potential, parameters start, parameters end,
                   path_point *point)
{
    static const double LONGEST = 0.4;    /* the longest predicted step, over the depth */
    static const double SHORTEST = 1e-13; /* a shorter stride, over the path, is at the fold */
    const double df = end.f - start.f, dkappa = end.kappa - start.kappa;
    double stride = 1;
    while (point->t < 1) {
        const rw_von_mises *at = &point->at;
        const step tangent = solve_hessian(at, df * at->f_x + dkappa * at->kappa_x,
                                           df * at->f_y + dkappa * at->kappa_y);
        const double to_go = 1 - point->t;
        stride = fmin(stride, to_go);
        if (length(tangent) * stride > LONGEST)
            stride = LONGEST / length(tangent);
        if (!(stride >= SHORTEST))
            return false;
        path_point next = {.t = stride < to_go ? point->t + stride : 1,
                           .x = point->x + stride * tangent.x * point->y,
                           .y = point->y + stride * tangent.y * point->y};
        if (settle(potential, between(start, end, next.t), &next)) {
            stride = 0.95 * (fold_ahead(point, &next) - next.t);
            *point = next;
        } else {
            stride /= 4;
        }
    }
    return true;
}

bool rw_subsurface_maximum(double alpha, double f, double kappa, rw_maximum *maximum)
{
    /* over all alpha and nu, the fold with the largest f is at 0.556 (test_strength) */
    static const double LAST = 0.6;
    if (f > LAST)
        return false;
    rw_potential potential;
    rw_potential_init(&potential, alpha, 1);
    axis on_axis = {&potential, 0};
    const double probe = depth_of_last_rise(alpha);
    const double rise = steepness(probe, &on_axis);
    const double pressure = -rw_potential_at(&potential, 0, probe).G_im;
    /* The smallest tips may have a maximum at f > 0 although kappa is too large for one
     * on the axis. Then the path starts with a smaller kappa. */
    on_axis.kappa = fmin(kappa, 0.9 * rise / pressure);
    path_point point = {.t = 0, .x = 0, .y = depth_of_maximum(&on_axis, probe)};
    point.at = rw_von_mises_at(&potential, 0, on_axis.kappa, 0, point.y);
    const parameters start = {0, on_axis.kappa}, corner = {f, on_axis.kappa}, end = {f, kappa};
    if (f > 0 && !follow(&potential, start, corner, &point))
        return false;
    point.t = 0;
    if (kappa > on_axis.kappa && !follow(&potential, corner, end, &point))
        return false;
    *maximum = (rw_maximum){.J2 = point.at.J2, .x = fmax(0, point.x), .y = point.y};
    return true;
}
