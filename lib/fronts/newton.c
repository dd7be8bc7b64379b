/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The places of the fronts: by Newton's method for all at once, and front by front where that
 * fails. */
#include "base/domain.h"
#include "base/linear.h"
#include "base/tuned.h"
#include "fronts/fronts.h"

#include <string.h>

/* ---- All at once ---- */

static double largest(int n, const double v[])
{
    double most = 0;
    for (int i = 0; i < n; i++)
        most = fmax(most, fabs(v[i]));
    return most;
}

/* The width of the narrower zone beside a front, as an angle. */
static double narrower_zone(const rw_fronts *f, int j)
{
    const double before = j > 0 ? f->y[j - 1] : 0, after = j + 1 < f->fronts ? f->y[j + 1] : RW_PI;
    return fmin(f->y[j] - before, after - f->y[j]);
}

static double nearest_kink(const rw_fronts *f, double angle)
{
    double nearest = 1;
    for (int i = 0; i < f->problem->old->kinks; i++)
        nearest = fmin(nearest, fabs(rw_angle_of(f->problem, f->problem->old->kink[i]) - angle));
    return nearest;
}

/* The Jacobian, by forward differences from the residual r. */
static bool jacobian(rw_fronts *f, const double r[], double J[])
{
    const int n = f->unknowns;
    for (int j = 0; j < n; j++) {
        const double y = f->y[j];
        const double h =
            j < f->fronts ? fmin(1e-5 * narrower_zone(f, j), fmax(0.3 * nearest_kink(f, y), 3e-8))
                          : 1e-5;
        double moved[RW_MOST_FRONTS];
        f->y[j] = y + h;
        const bool is_done = rw_fronts_residual(f, moved);
        f->y[j] = y;
        if (!is_done)
            return false;
        for (int i = 0; i < n; i++)
            J[i * n + j] = (moved[i] - r[i]) / h;
    }
    return true;
}

/* A front does not jump over a kink of the old traction: it stops just beyond it. */
static void stop_at_kinks(const rw_fronts *f, int j, double d[])
{
    const rw_problem *p = f->problem;
    for (int i = 0; i < p->old->kinks; i++) {
        const double to = rw_angle_of(p, p->old->kink[i]) - f->y[j];
        if (to * (to - d[j]) < 0 && fabs(to) > 4e-5)
            d[j] = to + copysign(2e-5, d[j]);
    }
}

/* The part of the step d that leaves at least a quarter of each zone. */
static double damping(const rw_fronts *f, const double d[])
{
    double part = 1;
    for (int i = 0; i <= f->fronts; i++) {
        const double gap = (i < f->fronts ? f->y[i] : RW_PI) - (i > 0 ? f->y[i - 1] : 0);
        const double grows = (i < f->fronts ? d[i] : 0) - (i > 0 ? d[i - 1] : 0);
        if (grows < 0)
            part = fmin(part, 0.75 * gap / -grows);
    }
    return part;
}

/* Tries ever shorter steps along d and keeps the best, with its residual in r. */
static bool go_along(rw_fronts *f, const double d[], double r[], double *size)
{
    const int n = f->unknowns;
    double from[RW_MOST_FRONTS], best[RW_MOST_FRONTS], lowest = HUGE_VAL, new_r[RW_MOST_FRONTS];
    const double before = largest(n, r), whole = damping(f, d);
    memcpy(from, f->y, sizeof from);
    for (double part = whole; part >= 0.05 * whole; part /= 2) {
        for (int i = 0; i < n; i++)
            f->y[i] = from[i] + part * d[i];
        if (!rw_fronts_residual(f, new_r))
            return false;
        if (largest(n, new_r) < lowest) {
            lowest = largest(n, new_r);
            memcpy(best, f->y, sizeof best);
            memcpy(r, new_r, sizeof new_r);
        }
        if (lowest < before * (1 - 1e-2 * part))
            break;
    }
    memcpy(f->y, best, sizeof best);
    *size = lowest;
    return true;
}

/* The sign that K has where the traction beyond a front would exceed friction, so that the front
 * must move into the zone that sticks; and the way there. */
static int slip_at(const rw_fronts *f, int j)
{
    return f->label[j] != 0 ? f->label[j] : f->label[j + 1];
}

static int inwards(const rw_fronts *f, int j)
{
    return f->label[j] != 0 ? 1 : -1;
}

/* A front that moves into the zone that sticks lowers its own K, but not in places that have
 * slipped before: there K stays, and its slope is noise. The step of such a front is set: beyond
 * them. */
static void pass_flat_parts(const rw_fronts *f, double J[], const double r[], double d[])
{
    const int n = f->unknowns;
    for (int j = 0; j < f->fronts; j++) {
        const int way = r[j] * slip_at(f, j) * inwards(f, j) > 0 ? 1 : -1;
        const double slope = J[j * n + j];
        if (way * r[j] * slope < 0 && fabs(r[j]) < RW_FLAT * fabs(slope))
            continue;
        for (int i = 0; i < n; i++)
            J[j * n + i] = i == j;
        d[j] = way * RW_FLAT;
        stop_at_kinks(f, j, d);
    }
}

/* The step of Newton's method from the residual r. */
static bool find_step(const rw_fronts *f, const double J[], const double r[], double d[])
{
    const int n = f->unknowns;
    double A[RW_MOST_FRONTS * RW_MOST_FRONTS];
    memcpy(A, J, sizeof A);
    for (int i = 0; i < n; i++)
        d[i] = -r[i];
    pass_flat_parts(f, A, r, d);
    if (!rw_solve((size_t)n, 1, A, d))
        return false;
    for (int j = 0; j < f->fronts; j++)
        stop_at_kinks(f, j, d);
    return true;
}

/* Broyden's update: the Jacobian after a move that changed the residual. */
static void update(int n, const double move[], const double change[], double J[])
{
    double square = 0;
    for (int i = 0; i < n; i++)
        square += move[i] * move[i];
    for (int i = 0; i < n; i++) {
        double rest = change[i];
        for (int j = 0; j < n; j++)
            rest -= J[i * n + j] * move[j];
        for (int j = 0; j < n; j++)
            J[i * n + j] += rest * move[j] / square;
    }
}

bool rw_fronts_newton(rw_fronts *f, double nothing)
{
    const int n = f->unknowns;
    double r[RW_MOST_FRONTS], d[RW_MOST_FRONTS], J[RW_MOST_FRONTS * RW_MOST_FRONTS];
    if (!rw_fronts_residual(f, r))
        return false;
    int worse = 0;
    double before = 0, size = largest(n, r);
    while (!(size < nothing)) {
        if (!(size < RW_POOR * before) && !jacobian(f, r, J))
            return false;
        before = size;
        if (!find_step(f, J, r, d))
            return false;
        double move[RW_MOST_FRONTS], change[RW_MOST_FRONTS], kept[RW_MOST_FRONTS];
        memcpy(kept, f->y, sizeof kept);
        memcpy(change, r, sizeof change);
        if (!go_along(f, d, r, &size))
            return false;
        if (size >= before) {
            if (before < 30 * nothing || (before < 1000 * nothing && worse > 1)) {
                memcpy(f->y, kept, sizeof kept);
                return true;
            }
            worse++;
        }
        for (int i = 0; i < f->fronts; i++)
            if (narrower_zone(f, i) < 1e-9)
                return false;
        for (int i = 0; i < n; i++) {
            move[i] = f->y[i] - kept[i];
            change[i] = r[i] - change[i];
        }
        update(n, move, change, J);
    }
    return true;
}

/* ---- Front by front ---- */

/* K of a front at an angle, with the sign of slip. */
static bool singularity_at(rw_fronts *f, int j, double angle, double *value)
{
    double r[RW_MOST_FRONTS];
    const double y = f->y[j];
    f->y[j] = angle;
    const bool is_done = rw_fronts_residual(f, r);
    f->y[j] = y;
    *value = slip_at(f, j) * r[j];
    return is_done;
}

/* Regula falsi (Illinois) between a and b. */
static bool close_in(rw_fronts *f, int j, double a, double at_a, double b, double at_b)
{
    for (int turn = 0; turn < 30 && fabs(b - a) > 1e-7; turn++) {
        const double c = b - at_b * (b - a) / (at_b - at_a);
        double at_c;
        if (!singularity_at(f, j, c, &at_c))
            return false;
        if (at_c * at_b < 0) {
            a = b;
            at_a = at_b;
        } else {
            at_a /= 2;
        }
        b = c;
        at_b = at_c;
    }
    f->y[j] = b;
    return true;
}

static bool relax_front(rw_fronts *f, int j)
{
    const double start = f->y[j];
    double a = start, at_a;
    if (!singularity_at(f, j, a, &at_a))
        return false;
    const double direction = at_a > 0 ? inwards(f, j) : -inwards(f, j);
    const double limit = direction < 0       ? j > 0 ? f->y[j - 1] : 0
                         : j + 1 < f->fronts ? f->y[j + 1]
                                             : RW_PI;
    double step = 0.02 * fmin(1, fabs(limit - start) / 0.04);
    while (fabs(limit - a) > 1e-4 * fabs(limit - start)) {
        double b = a + direction * step, at_b;
        if ((b - limit) * direction >= -1e-3 * fabs(limit - start))
            b = (a + limit) / 2;
        if (!singularity_at(f, j, b, &at_b))
            return false;
        if (at_a * at_b <= 0)
            return close_in(f, j, a, at_a, b, at_b);
        a = b;
        at_a = at_b;
        step *= 2;
    }
    return false; /* the zone vanishes */
}

bool rw_fronts_relax(rw_fronts *f)
{
    if (f->unknowns != f->fronts)
        return false;
    double moved;
    do {
        moved = 0;
        for (int j = 0; j < f->fronts; j++) {
            const double before = f->y[j];
            if (!relax_front(f, j))
                return false;
            moved = fmax(moved, fabs(f->y[j] - before));
        }
    } while (!(moved < 1e-3));
    return true;
}
