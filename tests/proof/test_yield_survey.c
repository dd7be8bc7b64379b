/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Whether the yield factor of a contact with a history, or the elastic limit in full sliding,
 * misses the maximum of J2. The library climbs from those points of its grids alone that may lie
 * below the highest top. Here nothing is left out: grids three times as fine around every mark,
 * both sides apart, and a climb from every maximum of them that reaches 0.8 of the highest.
 * Stresses come from the public function, so that nothing of the search is shared.
 *
 *     test_yield_survey HISTORIES [SEED]
 *
 * Random loads of P and Q, and of moment and tension; sharp, rounded and Hertz; nu 0 to 0.5. Then
 * as many contacts in full sliding. There the survey also checks what the search rests on:
 *   - A maximum below the surface is the one that rwedge_subsurface_yield() gives, or a second one
 *     next to the corner x = a, at f > 0.25, lower than the surface's. None is left at f > 0.6.
 *   - On the surface there is one local maximum, and rwedge_surface_yield() finds it.
 *   - As f grows, yield moves from below to the surface once, and stays there. */
#include "claims.h"
#include "contact/contact.h"

#include <stdio.h>

enum { ANGLES = 25, RADII = 190, MARKS_MAX = 40, TURNS = 5000 };
static const double FALL = 0.83, COARSE = 0.04, FINE = 1e-8, WORTH = 0.8;

static const double THETA = 0.1, A = 0.1;

/* In full sliding, in natural units. */
typedef struct {
    double alpha, f, nu;
} sliding;

typedef struct {
    const rwedge_contact *contact;
    double kappa, highest;
    const sliding *slides; /* NULL with a history */
} search;

static double J2_of(const search *s, double sxx, double syy, double txy)
{
    const double difference = (sxx - syy) / 2, mean = (sxx + syy) / 2;
    return difference * difference + txy * txy + s->kappa * mean * mean;
}

typedef struct {
    double log_r, angle, J2;
} place;

/* In polar coordinates around a mark, at most ANGLES; beyond the surface is the surface. */
static void evaluate(search *s, double mark, int count, place at[])
{
    double x[ANGLES], y[ANGLES], sxx[ANGLES], syy[ANGLES], txy[ANGLES];
    for (int i = 0; i < count; i++) {
        const double r = exp(at[i].log_r), up = fmax(0, fmin(PI, at[i].angle));
        x[i] = mark + r * cos(up);
        y[i] = up == 0 || up == PI ? 0 : r * sin(up);
    }
    const bool done =
        rwedge_contact_stresses(s->contact, (size_t)count, x, y, sxx, syy, txy) == RWEDGE_OK;
    for (int i = 0; i < count; i++) { /* not at the apex */
        at[i].J2 = done ? J2_of(s, sxx[i], syy[i], txy[i]) : 0;
        s->highest = fmax(s->highest, at[i].J2);
    }
}

/* The highest of eight places around. */
static place highest_around(search *s, double mark, place top, double step)
{
    enum { AROUND = 8 };
    place at[AROUND], best;
    for (int i = 0; i < AROUND; i++)
        at[i] = (place){top.log_r + step * cos(PI / 4 * i), top.angle + step * sin(PI / 4 * i), 0};
    evaluate(s, mark, AROUND, at);
    best = at[0];
    for (int i = 1; i < AROUND; i++)
        if (at[i].J2 > best.J2)
            best = at[i];
    return best;
}

/* To the highest place around, at ever smaller distances. A climb along a narrow ridge would take
 * hours: it ends after TURNS turns. */
static place climb(search *s, double mark, place top)
{
    double step = COARSE;
    for (int turn = 0; turn < TURNS && step > FINE; turn++) {
        const place next = highest_around(s, mark, top, step);
        step *= next.J2 > top.J2 * (1 + 1e-15) ? 1.5 : 0.4;
        top = next.J2 > top.J2 ? next : top;
    }
    return top;
}

typedef place polar_grid[RADII][ANGLES];

static void fill(search *s, polar_grid g, double mark, double reach)
{
    for (int i = 0; i < RADII; i++) {
        for (int j = 0; j < ANGLES; j++)
            g[i][j] = (place){log(reach) + i * log(FALL),
                              j == ANGLES - 1 ? PI : PI * j / (ANGLES - 1), 0};
        evaluate(s, mark, ANGLES, g[i]);
    }
}

static bool is_top(polar_grid g, int i, int j)
{
    for (int k = -1; k <= 1; k++)
        for (int l = -1; l <= 1; l++)
            if (i + k >= 0 && i + k < RADII && j + l >= 0 && j + l < ANGLES &&
                g[i + k][j + l].J2 > g[i][j].J2)
                return false;
    return true;
}

/* ---- Full sliding ---- */

static int contradictions;

static void claim(bool holds, const sliding *c, const char *meaning, double number)
{
    if (holds)
        return;
    contradictions++;
    printf("a/b = %.17g, f = %.17g, nu = %.17g: %s: %.17g\n", c->alpha, c->f, c->nu, meaning,
           number);
}

static bool has_branch(double alpha, double f, double nu)
{
    double limit, x, y;
    return rwedge_subsurface_yield(alpha, f, nu, &limit, &x, &y) == RWEDGE_OK;
}

/* Within 1e-3 of f or nu the maximum is too flat for a search by values to tell it from a slope. */
static bool is_next_to_fold(const sliding *c)
{
    const double f = 1e-3 * c->f, softer = fmax(0, c->nu - 1e-3), harder = fmin(0.5, c->nu + 1e-3);
    return has_branch(c->alpha, c->f - f, c->nu) != has_branch(c->alpha, c->f + f, c->nu) ||
           has_branch(c->alpha, c->f, softer) != has_branch(c->alpha, c->f, harder);
}

/* Higher than a ring around it. */
static bool is_below_surface(search *s, double mark, place top)
{
    return highest_around(s, mark, top, 3e-3).J2 < top.J2 && top.angle > 1e-2 &&
           top.angle < PI - 1e-2;
}

static double surface_J2(const sliding *c)
{
    double limit = 0, x;
    return rwedge_surface_yield(c->alpha, c->f, c->nu, &limit, &x) == RWEDGE_OK
               ? pow(rwedge_load(c->alpha) / limit, 2)
               : 0;
}

static void check_below_surface(const sliding *c, place top)
{
    double limit = 0, x, y;
    const int32_t status = rwedge_subsurface_yield(c->alpha, c->f, c->nu, &limit, &x, &y);
    const bool is_branch =
        status == RWEDGE_OK && fabs(rwedge_load(c->alpha) / sqrt(top.J2) - limit) < 1e-7 * limit;
    claim(c->f < 0.6, c, "friction with a maximum below the surface", c->f);
    if (is_branch || is_next_to_fold(c))
        return;
    const double r = exp(top.log_r) / c->alpha,
                 distance = hypot(r * cos(top.angle) - 1, r * sin(top.angle));
    claim(c->f > 0.25 && distance < 0.5, c, "a maximum off the branch and off the corner, by a",
          distance);
    claim(top.J2 < 0.95 * surface_J2(c), c, "J2 next to the corner", top.J2);
}

static void survey_mark(search *s, double mark, double reach)
{
    static polar_grid grid;
    /* closer to the apex J2 is level */
    const double least = s->slides && mark == 0 ? 1e-3 * fmin(1, s->slides->alpha) : HUGE_VAL;
    fill(s, grid, mark, reach);
    for (int i = 0; i < RADII; i++)
        for (int j = 0; j < ANGLES; j++) {
            const bool is_inside = reach * pow(FALL, i) > least && j > 0 && j < ANGLES - 1;
            if (!(grid[i][j].J2 > WORTH * s->highest || is_inside) || !is_top(grid, i, j))
                continue;
            const place top = climb(s, mark, grid[i][j]);
            if (s->slides && mark == 0 && is_below_surface(s, mark, top))
                check_below_surface(s->slides, top);
        }
}

static double highest_of(const rwedge_contact *contact, double nu, const sliding *slides)
{
    search s = {contact, (1 - 2 * nu) * (1 - 2 * nu) / 3, 0, slides};
    const rw_memory *memory = &contact->memory;
    const double b = fmax(-rw_memory_end(memory)->patch.left, rw_memory_end(memory)->patch.right);
    double marks[MARKS_MAX] = {0, -contact->geometry.a, contact->geometry.a};
    size_t count = 3;
    for (size_t i = memory->count; i-- > 1 && count + 2 <= MARKS_MAX;) {
        marks[count++] = memory->corners[i].patch.left;
        marks[count++] = memory->corners[i].patch.right;
    }
    for (size_t i = 0; i < count; i++)
        if (fabs(marks[i]) <= b)
            survey_mark(&s, marks[i], 3 * b);
    return s.highest;
}

/* ---- What is drawn ---- */

static void go_on(rwedge_contact *contact, uint64_t *seed, double f, bool is_centred)
{
    double P, M, Q, sigma;
    rwedge_contact_loads(contact, &P, &M, &Q, &sigma);
    const double arm = P > 0 ? M / P : 0, kind = random_fraction(seed);
    if (kind < 0.4 || P == 0)
        P = P == 0 ? 1 : P * random_between(seed, 0.5, 1.5);
    Q = f * P * (kind > 0.95 ? 1 : random_between(seed, -1, 1));
    if (!is_centred && kind >= 0.4) /* within what slips one way */
        sigma += random_between(seed, -0.5, 0.5) * rwedge_contact_largest_tension_step(contact, Q);
    (void)rwedge_contact_apply(contact, P, arm * P, Q, sigma); /* or stays as it is */
}

static rwedge_contact *draw(uint64_t *seed, double *nu)
{
    const double kind = random_fraction(seed), P = 1;
    const double a = kind < 0.1 ? 0 : pow(10, random_between(seed, -5, 1));
    const double f = random_fraction(seed) < 0.1 ? 0 : pow(10, random_between(seed, -2, 0.3));
    const bool is_centred = random_fraction(seed) < 0.6;
    *nu = random_fraction(seed) < 0.1 || a == 0 ? 0.5 : random_between(seed, 0, 0.5);
    rwedge_contact *contact;
    assert_ok(rwedge_contact_create(THETA, a, A, f, &contact));
    const double b = rwedge_half_width(THETA, a, A, P);
    const double arm = is_centred ? 0 : random_between(seed, -0.4, 0.4) * b;
    if (rwedge_contact_apply(contact, P, arm * P, 0, 0) != RWEDGE_OK)
        assert_ok(rwedge_contact_apply(contact, P, 0, 0, 0));
    const int loads = (int)random_between(seed, 0, 9);
    for (int i = 0; i < loads; i++)
        go_on(contact, seed, f, is_centred);
    return contact;
}

/* ---- Contacts in full sliding, b = 1 and theta/A = 1 ---- */

static sliding draw_sliding(uint64_t *seed)
{
    const double kind = random_fraction(seed), u = random_fraction(seed), v = random_fraction(seed);
    const double special = random_fraction(seed);
    return (sliding){
        .alpha = kind < 0.1    ? pow(10, -14 * u)
                 : kind < 0.45 ? pow(10, -6 * u)
                 : kind < 0.9  ? u
                 : kind < 0.95 ? 1 - pow(10, -12 * u)
                               : 1 + 4 * u,
        .f = special < 0.1 ? 0
             : kind < 0.5  ? 0.5 * v
                           : 2 * v,
        .nu = special < 0.15   ? 0.5
              : special < 0.25 ? 0.5 - 0.3 * pow(10, -8 * v)
                               : 0.5 * random_fraction(seed),
    };
}

static double sliding_J2(const sliding *c, double x, double y)
{
    const search s = {NULL, (1 - 2 * c->nu) * (1 - 2 * c->nu) / 3, 0, c};
    double sxx, syy, txy;
    assert_ok(rwedge_stress(c->alpha, c->f, 0, x, y, &sxx, &syy, &txy));
    return J2_of(&s, sxx, syy, txy);
}

static void check_surface(const sliding *c)
{
    enum { NODES = 300 };
    /* J2 is made of differences */
    const double p0 = rwedge_peak_pressure(c->alpha), rounding = 1e-15 * (1 + p0 * p0);
    const double highest = surface_J2(c);
    double J2[NODES + 1];
    int maxima = 0;
    for (int i = 0; i <= NODES; i++) {
        J2[i] = sliding_J2(c, fmin(c->alpha, 1) * sin(PI / 2 * i / NODES), 0);
        claim(highest == 0 || J2[i] <= highest * (1 + 1e-13) + rounding, c, "the surface", J2[i]);
    }
    for (int i = 1; i < NODES; i++)
        maxima += J2[i] > J2[i - 1] + rounding && J2[i] > J2[i + 1] + rounding;
    claim(maxima <= 1, c, "maxima on the surface", maxima);
}

/* The smallest tips may begin at the surface, at f = 0. */
static void check_overtaking(const sliding *c)
{
    bool was_below = false, overtaken = false;
    for (double f = 0; f < 0.7; f += 0.02) {
        double limit, x, y = 0;
        assert_ok(rwedge_yield_point(c->alpha, f, c->nu, &limit, &x, &y));
        claim(y == 0 || !overtaken, c, "yield returns below the surface at f", f);
        overtaken = overtaken || (was_below && y == 0);
        was_below = y > 0;
    }
}

/* J2 over that of the elastic limit, less 1. */
static double survey_sliding(uint64_t *seed)
{
    const sliding c = draw_sliding(seed);
    rwedge_contact *contact;
    const double P = rwedge_normal_load(THETA, c.alpha, A, 1);
    assert_ok(rwedge_contact_create(THETA, c.alpha, A, c.f, &contact));
    assert_ok(rwedge_contact_load(contact, P, c.f * P));
    double limit, x, y;
    assert_ok(rwedge_yield_point(c.alpha, c.f, c.nu, &limit, &x, &y));
    const double claimed = pow(rwedge_load(c.alpha) / limit, 2);
    const double above = highest_of(contact, c.nu, &c) / claimed - 1;
    claim(above < 2e-12, &c, "J2 is higher by", above);
    claim(fabs(sliding_J2(&c, x, y) / claimed - 1) < 1e-12, &c, "J2 at the yield point", y);
    check_surface(&c);
    check_overtaking(&c);
    rwedge_contact_destroy(contact);
    return above;
}

CLAIM(no_yield_factor_misses_a_maximum)
{
    long missed = 0, searched = 0;
    double worst = -1;
    uint64_t seed = seed_or(1);
    for (long i = 0; i < cases_or(60); i++) {
        const uint64_t drawn = seed;
        double nu, factor, x, y;
        rwedge_contact *contact = draw(&seed, &nu);
        const int32_t status = rwedge_contact_yield_factor(contact, nu, 1, &factor, &x, &y);
        if (status == RWEDGE_OK && factor > 0) {
            const double above = highest_of(contact, nu, NULL) * factor * factor - 1;
            searched++;
            worst = fmax(worst, above);
            if (above > 2e-12) {
                printf("history of seed %llu: J2 is higher by %.3g\n", (unsigned long long)drawn,
                       above);
                missed++;
            }
        }
        rwedge_contact_destroy(contact);
    }
    printf("%ld histories with a finite stress; highest J2 found over that of the yield factor, "
           "less 1: %.1e\n",
           searched, worst);
    assert_int_equal(missed, 0);
}

CLAIM(no_elastic_limit_misses_a_maximum)
{
    double worst = -1;
    uint64_t seed = seed_or(1);
    for (long i = 0; i < cases_or(60); i++)
        worst = fmax(worst, survey_sliding(&seed));
    printf("in full sliding: at most %.1e\n", worst);
    assert_int_equal(contradictions, 0);
}
