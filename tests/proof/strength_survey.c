/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Does the elastic limit belong to the global maximum? This searches the whole half-plane, x of
 * both signs, for random a/b, f and nu. The search knows nothing of how the library searches. It
 * also checks the facts on which the library's search rests:
 *   - A maximum below the surface is the one that rwedge_subsurface_yield() gives, or a second one.
 *     The second one is next to the corner x = a, at f > 0.25, and lower than the surface's. Its
 *     height over the surface's is printed.
 *   - On the surface there is one local maximum, and rwedge_surface_yield() finds it.
 *   - As f grows, yield moves from below to the surface once, and stays there. No maximum is left
 *     below for f > 0.6.
 *
 *     strength_survey CASES [SEED]
 *
 * It prints what it covered. Each case that contradicts a claim gets a line; the exit status is
 * then 1. */
#include "claims.h"
#include "rwedge.h"

#include <gsl/gsl_multimin.h>
#include <stdio.h>
#include <stdlib.h>

typedef struct {
    double alpha, f, nu;
} contact_case;

static int contradictions;

static void contradict(const contact_case *c, const char *claim, double found, double claimed)
{
    contradictions++;
    printf("a/b = %.17g, f = %.17g, nu = %.17g: %s: found %.17g, claimed %.17g\n", c->alpha, c->f,
           c->nu, claim, found, claimed);
}

static double J2_at(const contact_case *c, double x, double y)
{
    double sxx, syy, txy;
    if (rwedge_stress(c->alpha, c->f, 0, x, y, &sxx, &syy, &txy) != RWEDGE_OK)
        return NAN;
    const double szz = c->nu * (sxx + syy), p = sxx - syy, q = syy - szz, r = szz - sxx;
    return (p * p + q * q + r * r) / 6 + txy * txy;
}

/* Polar coordinates, logarithmic in the radius: from the scale of the rounding to that of the
 * contact and beyond. */
static double J2_polar(const contact_case *c, double log_r, double angle)
{
    const double r = exp(log_r);
    return J2_at(c, angle == PI / 2 ? 0 : r * cos(angle),
                 angle > 0 && angle < PI ? r * sin(angle) : 0);
}

static double negative_J2(const gsl_vector *v, void *params)
{
    const double angle = gsl_vector_get(v, 1);
    return -J2_polar(params, gsl_vector_get(v, 0), fmax(0, fmin(PI, angle)));
}

typedef struct {
    double log_r, angle, J2;
} place;

static place climb(const contact_case *c, place from, gsl_multimin_fminimizer *minimizer)
{
    double start[2] = {from.log_r, from.angle}, steps[2] = {0.05, 0.02};
    gsl_vector_view x = gsl_vector_view_array(start, 2), step = gsl_vector_view_array(steps, 2);
    contact_case copy = *c;
    gsl_multimin_function function = {negative_J2, 2, &copy};
    gsl_multimin_fminimizer_set(minimizer, &function, &x.vector, &step.vector);
    for (int i = 0; i < 400; i++)
        if (gsl_multimin_fminimizer_iterate(minimizer) != GSL_SUCCESS ||
            gsl_multimin_fminimizer_size(minimizer) < 1e-9)
            break;
    return (place){gsl_vector_get(minimizer->x, 0), gsl_vector_get(minimizer->x, 1),
                   -minimizer->fval};
}

/* A strict maximum below the surface: higher than a ring around it. */
static bool is_inside(const contact_case *c, place p)
{
    if (p.angle < 1e-2 || p.angle > PI - 1e-2)
        return false;
    for (int i = 0; i < 16; i++)
        if (J2_polar(c, p.log_r + 3e-3 * cos(i * PI / 8), p.angle + 3e-3 * sin(i * PI / 8)) >= p.J2)
            return false;
    return true;
}

enum { RADII = 150, ANGLES = 91, MOST = 8 };

typedef struct {
    double highest; /* over the whole grid, the surface included */
    int count;      /* of maxima below the surface, refined and told apart */
    place inside[MOST];
} survey;

static bool is_grid_maximum(double grid[RADII][ANGLES], int i, int j)
{
    for (int di = -1; di <= 1; di++)
        for (int dj = -1; dj <= 1; dj++)
            if ((di || dj) && grid[i + di][j + dj] > grid[i][j])
                return false;
    return true;
}

static void add(survey *s, place p)
{
    for (int i = 0; i < s->count; i++)
        if (hypot(s->inside[i].log_r - p.log_r, s->inside[i].angle - p.angle) < 1e-3)
            return;
    if (s->count < MOST)
        s->inside[s->count++] = p;
}

static survey search(const contact_case *c, gsl_multimin_fminimizer *minimizer)
{
    static double grid[RADII][ANGLES];
    const double lo = log(1e-3 * fmin(c->alpha, 1)), hi = log(4);
    survey s = {0, 0, {{0, 0, 0}}};
    for (int i = 0; i < RADII; i++)
        for (int j = 0; j < ANGLES; j++) {
            grid[i][j] = J2_polar(c, lo + (hi - lo) * i / (RADII - 1), PI * j / (ANGLES - 1));
            s.highest = fmax(s.highest, grid[i][j]);
        }
    for (int i = 1; i < RADII - 1; i++)
        for (int j = 1; j < ANGLES - 1; j++)
            if (is_grid_maximum(grid, i, j)) {
                const place from = {lo + (hi - lo) * i / (RADII - 1), PI * j / (ANGLES - 1),
                                    grid[i][j]};
                const place top = climb(c, from, minimizer);
                s.highest = fmax(s.highest, top.J2);
                if (is_inside(c, top))
                    add(&s, top);
            }
    return s;
}

/* Next to the fold, within 1e-3 of f or nu, the maximum is too flat for a search by values to
 * tell it from a slope. */
static bool is_next_to_fold(const contact_case *c)
{
    double limit, x, y;
    const bool before =
        rwedge_subsurface_yield(c->alpha, c->f * (1 - 1e-3), c->nu, &limit, &x, &y) == RWEDGE_OK;
    const bool after =
        rwedge_subsurface_yield(c->alpha, c->f * (1 + 1e-3), c->nu, &limit, &x, &y) == RWEDGE_OK;
    const double softer = fmax(0, c->nu - 1e-3), harder = fmin(0.5, c->nu + 1e-3);
    const bool with_less =
        rwedge_subsurface_yield(c->alpha, c->f, softer, &limit, &x, &y) == RWEDGE_OK;
    const bool with_more =
        rwedge_subsurface_yield(c->alpha, c->f, harder, &limit, &x, &y) == RWEDGE_OK;
    return before != after || with_less != with_more;
}

/* Maxima that are not on the branch from the axis. */
static long at_corner;
static double highest_at_corner; /* J2 over that of the surface */

static void check_corner(const contact_case *c, const place *p)
{
    const double r = exp(p->log_r) / c->alpha,
                 distance = hypot(r * cos(p->angle) - 1, r * sin(p->angle));
    double limit, x;
    if (rwedge_surface_yield(c->alpha, c->f, c->nu, &limit, &x) != RWEDGE_OK || c->f < 0.25 ||
        distance > 0.5)
        contradict(c, "a maximum off the branch and off the corner, distance in a", distance, 0.5);
    else {
        const double height = p->J2 / pow(rwedge_load(c->alpha) / limit, 2);
        if (height > 0.95)
            contradict(c, "J2 of a maximum next to the corner, over that of the surface", height,
                       0.95);
        highest_at_corner = fmax(highest_at_corner, height);
    }
    at_corner++;
}

static void check_below(const contact_case *c, const survey *s)
{
    double limit, x, y;
    const bool exists = rwedge_subsurface_yield(c->alpha, c->f, c->nu, &limit, &x, &y) == RWEDGE_OK;
    if (s->count > 0 && c->f > 0.6)
        contradict(c, "largest friction with a maximum below the surface", c->f, 0.6);
    for (int i = 0; i < s->count; i++) {
        const double found = rwedge_load(c->alpha) / sqrt(s->inside[i].J2);
        if (!(exists && fabs(found - limit) < 1e-7 * limit) && !is_next_to_fold(c))
            check_corner(c, &s->inside[i]);
    }
    if (exists) {
        const double here = J2_at(c, x, y), step = 1e-3 * y;
        for (int i = 0; i < 8; i++)
            if (!is_next_to_fold(c) &&
                J2_at(c, x + step * cos(i * PI / 4), y + step * sin(i * PI / 4)) > here)
                contradict(c, "the point below the surface is a maximum", 0, 1);
    }
}

static double surface_J2(const contact_case *c, int i, int n)
{
    return J2_at(c, fmin(c->alpha, 1) * sin(PI / 2 * i / n), 0);
}

static void check_surface(const contact_case *c)
{
    enum { NODES = 300 };
    double limit, x;
    if (rwedge_surface_yield(c->alpha, c->f, c->nu, &limit, &x) != RWEDGE_OK)
        return;
    /* J2 is made of differences */
    const double p0 = rwedge_peak_pressure(c->alpha), rounding = 1e-15 * (1 + p0 * p0);
    int maxima = 0;
    double highest = fmax(surface_J2(c, 0, NODES), surface_J2(c, NODES, NODES));
    for (int i = 1; i < NODES; i++) {
        const double here = surface_J2(c, i, NODES);
        highest = fmax(highest, here);
        maxima += here > surface_J2(c, i - 1, NODES) + rounding &&
                  here > surface_J2(c, i + 1, NODES) + rounding;
    }
    if (maxima > 1)
        contradict(c, "number of maxima on the surface", maxima, 1);
    const double claimed = pow(rwedge_load(c->alpha) / limit, 2);
    if (highest > claimed * (1 + 1e-13) + rounding)
        contradict(c, "maximum on the surface", highest, claimed);
}

/* The smallest tips may begin at the surface, at f = 0. */
static void check_overtaking(double alpha, double nu)
{
    bool was_below = false, overtaken = false;
    for (double f = 0; f < 0.7; f += 0.02) {
        double limit, x, y;
        const bool is_below =
            rwedge_yield_point(alpha, f, nu, &limit, &x, &y) == RWEDGE_OK && y > 0;
        if (is_below && overtaken)
            contradict(&(contact_case){alpha, f, nu}, "yield returns below the surface", 1, 0);
        overtaken = overtaken || (was_below && !is_below);
        was_below = is_below;
    }
}

static contact_case draw(uint64_t *seed)
{
    const double kind = random_fraction(seed), u = random_fraction(seed), v = random_fraction(seed);
    contact_case c = {
        .alpha = kind < 0.1    ? pow(10, -14 * u)
                 : kind < 0.45 ? pow(10, -6 * u)
                 : kind < 0.9  ? u
                 : kind < 0.95 ? 1 - pow(10, -12 * u)
                               : 1 + 4 * u,
        .f = kind < 0.5 ? 0.5 * v : 2 * v,
        .nu = 0.5 * random_fraction(seed),
    };
    const double special = random_fraction(seed);
    if (special < 0.1)
        c.f = 0;
    else if (special < 0.15)
        c.nu = 0.5;
    else if (special < 0.25)
        c.nu = 0.5 - 0.3 * pow(10, -8 * v);
    else if (special < 0.3)
        c.nu = 0;
    return c;
}

int main(int argc, char **argv)
{
    const long cases = argc > 1 ? strtol(argv[1], NULL, 10) : 0;
    uint64_t seed = argc > 2 ? strtoull(argv[2], NULL, 10) : 1;
    if (cases < 1) {
        fprintf(stderr, "usage: strength_survey CASES [SEED]\n");
        return 2;
    }
    gsl_multimin_fminimizer *minimizer =
        gsl_multimin_fminimizer_alloc(gsl_multimin_fminimizer_nmsimplex2, 2);
    long below = 0, governed_below = 0;
    double worst = 0;
    for (long i = 0; i < cases; i++) {
        const contact_case c = draw(&seed);
        const survey s = search(&c, minimizer);
        double limit = 0, x = 0, y = 0;
        if (rwedge_yield_point(c.alpha, c.f, c.nu, &limit, &x, &y) != RWEDGE_OK)
            contradict(&c, "the limit exists", 0, 1);
        const double claimed = pow(rwedge_load(c.alpha) / limit, 2);
        worst = fmax(worst, s.highest / claimed - 1);
        if (s.highest > claimed * (1 + 1e-12))
            contradict(&c, "global maximum of J2", s.highest, claimed);
        if (!(fabs(J2_at(&c, x, y) - claimed) < 1e-12 * claimed))
            contradict(&c, "J2 at the yield point", J2_at(&c, x, y), claimed);
        check_below(&c, &s);
        check_surface(&c);
        check_overtaking(c.alpha, c.nu);
        below += s.count > 0;
        governed_below += y > 0;
    }
    gsl_multimin_fminimizer_free(minimizer);
    printf("%ld cases, %ld with a maximum below the surface, %ld that yield there; highest J2 "
           "found over claimed, less 1: "
           "%.1e; %ld maxima next to the corner, at most %.3f of the surface; %d contradictions\n",
           cases, below, governed_below, worst, at_corner, highest_at_corner, contradictions);
    return contradictions ? 1 : 0;
}
