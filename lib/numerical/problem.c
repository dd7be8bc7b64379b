/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "numerical/problem.h"

#include "base/domain.h"

/* Edges that differ by less, over the width, do not. */
static const double SAME_EDGE = 1e-12;

static double pressure(const rw_eccentric *potential, rw_patch patch, double x)
{
    return x > patch.left && x < patch.right ? -rw_eccentric_at(potential, x, 0).G_im : 0;
}

double rw_friction_after(const rw_problem *p, double x)
{
    return p->f * pressure(&p->to_pressure, p->to, x);
}

double rw_friction_before(const rw_problem *p, double x)
{
    return p->f * pressure(&p->from_pressure, p->from, x);
}

/* Of the profile whose slope is ((x - x_0)/half)^2. */
static double second_pressure(const rw_problem *p, rw_patch patch, double x)
{
    if (!(x > patch.left && x < patch.right))
        return 0;
    const double m = rw_patch_middle(patch);
    return sqrt((x - patch.left) * (patch.right - x)) * (x - m + 2 * (m - p->middle)) /
           (p->half * p->half);
}

static double second_layer(const rw_problem *p, double x)
{
    return p->f * (second_pressure(p, p->to, x) - second_pressure(p, p->from, x));
}

double rw_base_traction(const rw_problem *p, rw_layers layers, double x)
{
    double t = rw_traction_at(&p->old->traction, x);
    if (layers.first != 0)
        t += layers.first * (rw_friction_after(p, x) - rw_friction_before(p, x));
    if (layers.second != 0)
        t += layers.second * second_layer(p, x);
    return t;
}

double rw_angle_of(const rw_problem *p, double x)
{
    const double part = (x - p->to.left) / (p->to.right - p->to.left);
    return 2 * asin(sqrt(fmax(0, fmin(1, part))));
}

double rw_place_of(const rw_problem *p, double angle)
{
    const double half = sin(angle / 2);
    return p->to.left + (p->to.right - p->to.left) * half * half;
}

/* Load and tilt that the second profile takes. */
static void second_pressing(const rw_problem *p, rw_patch patch, double *load, double *tilt)
{
    const double m = rw_patch_middle(patch) - p->middle, s = rw_patch_half_width(patch);
    const double unit = p->half * p->half;
    *load = RW_PI * m * (s * s / unit);
    *tilt = (m * m + s * s / 2) / unit;
}

void rw_problem_init(rw_problem *p, double a, double f, rw_patch from, rw_patch to,
                     const rw_shear_state *old, double shear, double stretch)
{
    const double slack = SAME_EDGE * (to.right - to.left);
    *p = (rw_problem){.a = a, .f = f, .from = from, .to = to, .old = old};
    p->both = (rw_patch){fmin(from.left, to.left), fmax(from.right, to.right)};
    rw_eccentric_init(&p->from_pressure, a, from);
    rw_eccentric_init(&p->to_pressure, a, to);
    p->is_still = from.left == to.left && from.right == to.right;
    p->grows[0] = to.left < from.left - slack;
    p->grows[1] = to.right > from.right + slack;
    const rw_pressing before = rw_patch_pressing(a, from), after = rw_patch_pressing(a, to);
    p->load = after.load - before.load;
    p->tilt = after.tilt - before.tilt;
    p->middle = rw_patch_middle(to);
    p->half = rw_patch_half_width(to);
    double load, tilt;
    second_pressing(p, to, &p->layer_load, &p->layer_tilt);
    second_pressing(p, from, &load, &tilt);
    p->layer_load -= load;
    p->layer_tilt -= tilt;
    p->shear = shear;
    p->stretch = stretch;
}
