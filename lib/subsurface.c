/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The subsurface branch is found at f = 0, where it is on the axis, and followed in f to where it is asked for.
 *
 * Why this cannot miss a maximum. J2 has at most one local maximum below the surface, at x >= 0, for any alpha, f and nu;
 * where there is one for some f there is one for every smaller f; and once the surface maximum has overtaken it, it stays
 * overtaken as f grows. These three facts are not proved here but checked by the tests (strength_survey), which search the
 * whole half-plane without using them. Given them, a path of maxima from f = 0 reaches the maximum or ends at a fold before
 * f. A step along the path counts only if every iterate had a negative definite Hessian: it cannot slip to the saddle that
 * the maximum meets at the fold. */
#include "subsurface.h"

#include "domain.h"
#include "solve.h"
#include "von_mises.h"

#include <float.h>

/* ---- On the axis, f = 0 ---- */

typedef struct {
    const rw_potential *potential;
    double kappa;
} axis;

/* There G = i P(y) and G' = P'(y) are real functions, J2 = (y P')^2 + kappa P^2 and dJ2/dy = 2 P' steepness,
 * steepness = y P' + y^2 P'' + kappa P; P' > 0. */
static double steepness(double log_y, const void *context)
{
    const axis *a = context;
    const double y = exp(log_y);
    const rw_field field = rw_potential_at(a->potential, 0, y);
    return field.H_re - rw_potential_curvature(a->potential, 0, y).K_im + a->kappa * field.G_im;
}

/* y d(steepness)/dy. */
static double slope_of_steepness(double log_y, const void *context)
{
    const axis *a = context;
    const double y = exp(log_y);
    const rw_curvature bend = rw_potential_curvature(a->potential, 0, y);
    return (1 + a->kappa) * rw_potential_at(a->potential, 0, y).H_re - 3 * bend.K_im - bend.L_re;
}

/* Depth of the maximum on the axis; NaN where J2 falls all the way from the surface. The steepness is negative at the
 * surface (kappa P) and far below (J2 falls like 1/y^2); it is positive on at most one interval, which holds its peak, and
 * J2 has its maximum at the interval's lower end. Where the interval exists, the peak is between 0.29 and 0.64 alpha (tests:
 * strength_survey); below y = 1 it has ended. */
static double depth_on_axis(const axis *a)
{
    const double log_alpha = log(a->potential->alpha);
    const double lo = log_alpha + log(0.25), hi = log_alpha + log(0.75);
    if (slope_of_steepness(lo, a) <= 0 || slope_of_steepness(hi, a) >= 0)
        return NAN;
    const double peak = rw_root(slope_of_steepness, a, lo, hi);
    if (!(steepness(peak, a) > 0))
        return NAN;
    return exp(rw_root(steepness, a, peak, 0));
}

/* ---- Along the branch ---- */

typedef struct {
    double f, x, y;
    rw_von_mises at; /* J2 and its derivatives there */
} branch_point;

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
    return (step){(at->xy * y - at->yy * x) * per_determinant, (at->xy * x - at->xx * y) * per_determinant};
}

static double length(step s)
{
    return hypot(s.x, s.y);
}

/* Newton from the given point. False where it leaves the region in which J2 is concave. */
static bool settle(const rw_potential *potential, double kappa, branch_point *point)
{
    enum { MAX_STEPS = 12 };
    static const double LONGEST = 0.5;      /* of the depth: y stays positive */
    static const double SQUARE_ROOT = 1e-8; /* Newton doubles the digits: the step after this one is rounding */
    for (int i = 0; i < MAX_STEPS; i++) {
        point->at = rw_von_mises_at(potential, point->f, kappa, point->x, point->y);
        if (!is_concave(&point->at))
            return false;
        const step d = solve_hessian(&point->at, point->at.x, point->at.y);
        if (!(length(d) < LONGEST))
            return false;
        point->x += d.x * point->y;
        point->y += d.y * point->y;
        if (length(d) < SQUARE_ROOT) {
            point->at.J2 += (point->at.x * d.x + point->at.y * d.y) / 2;
            return true;
        }
    }
    return false;
}

/* Where the branch ends, from two points on it. Next to a fold the determinant falls to 0 like the square root of the
 * distance, so that its square is linear in f. HUGE_VAL where it does not fall. */
static double fold_ahead(const branch_point *before, const branch_point *now)
{
    const double d0 = determinant(&before->at), d1 = determinant(&now->at);
    const double fall = (d0 - d1) * (d0 + d1);
    return fall > 0 ? now->f + d1 * d1 * ((now->f - before->f) / fall) : HUGE_VAL;
}

/* The branch at friction f, from the point *now on it; false where it ends before. */
static bool follow(const rw_potential *potential, double kappa, double f, rw_branch_extent extent, branch_point *now)
{
    static const double LONGEST = 0.4; /* a step of the prediction, over the depth */
    double stride = f - now->f;
    while (now->f < f) {
        const step tangent = solve_hessian(&now->at, now->at.drift_x, now->at.drift_y);
        stride = fmin(fmin(stride, f - now->f), LONGEST / length(tangent));
        if (stride < 1e-12 * f)
            return false; /* the fold: it is not reached, only approached */
        branch_point next = {.f = now->f + stride, .x = now->x + stride * tangent.x * now->y,
                             .y = now->y + stride * tangent.y * now->y};
        if (stride == f - now->f)
            next.f = f;
        if (!settle(potential, kappa, &next)) {
            stride /= 4;
            continue;
        }
        if (extent == RW_STOP_WHERE_OVERTAKEN && rw_surface_maximum(potential->alpha, next.f, kappa).J2 >= next.at.J2)
            return false;
        stride = 0.9 * (fold_ahead(now, &next) - next.f);
        *now = next;
    }
    return true;
}

bool rw_subsurface_maximum(double alpha, double f, double kappa, rw_branch_extent extent, rw_maximum *maximum)
{
    rw_potential potential;
    rw_potential_init(&potential, alpha);
    const axis on_axis = {&potential, kappa};
    branch_point point = {.f = 0, .x = 0, .y = depth_on_axis(&on_axis)};
    if (isnan(point.y))
        return false;
    point.at = rw_von_mises_at(&potential, 0, kappa, 0, point.y);
    if (extent == RW_STOP_WHERE_OVERTAKEN && rw_surface_maximum(alpha, 0, kappa).J2 >= point.at.J2)
        return false;
    if (!follow(&potential, kappa, f, extent, &point))
        return false;
    *maximum = (rw_maximum){.J2 = point.at.J2, .x = point.x, .y = point.y};
    return true;
}
