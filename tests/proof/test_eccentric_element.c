/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The boundary-element solver under moment and bulk tension is compared with the closed forms of
 * patches off the centre. The differences fall with the size of the elements. Units are those of
 * eccentric_patch.h, theta = A = a = 1; f = 1/2. */
#include "boundary_element.h"
#include "claims.h"
#include "eccentric_patch.h"

#include <stdio.h>

static const double PI = 3.14159265358979323846, F = 0.5;

enum { LEVELS = 3, COARSEST = 50 };

/* The normal load that a tangential one corresponds to: Q/f for the load, -sigma/(4 f) for the
 * tilt. */
typedef struct {
    double P, tilt;
} pair;

static pair as_pair(double Q, double sigma)
{
    return (pair){Q / F, -sigma / (4 * F)};
}

/* The front that slip of the sign +1, over `weight`, has reached from the edges of the contact. */
static eccentric_patch front(patch_loads contact, pair change, double weight)
{
    return patch_of_tilt(contact.P - change.P / weight, contact.tilt - change.tilt / weight);
}

static void begin(boundary_element *solver, int level, double P, double M, double half)
{
    boundary_element_start(solver, 1, 1, 1, F, (size_t)COARSEST << level, half);
    assert_int_equal(boundary_element_step(solver, (boundary_loads){.P = P, .M = M}), 0);
}

static void go(boundary_element *solver, int steps, double P, double M, double Q, double sigma)
{
    const boundary_loads from = solver->loads;
    for (int i = 1; i <= steps; i++) {
        const double t = (double)i / steps;
        const boundary_loads to = {from.P + t * (P - from.P), from.M + t * (M - from.M),
                                   from.Q + t * (Q - from.Q),
                                   from.sigma + t * (sigma - from.sigma)};
        assert_int_equal(boundary_element_step(solver, to), 0);
    }
}

/* A sum of pressures of patches. */
typedef struct {
    int count;
    eccentric_patch patch[4];
    double weight[4];
} traction;

static double traction_at(const traction *t, double x)
{
    double sum = 0;
    for (int i = 0; i < t->count; i++)
        sum += t->weight[i] * eccentric_pressure(t->patch[i], x);
    return sum;
}

/* The sum of the differences over the elements, as forces, over P. */
static double off(const boundary_element *s, double P, const double field[],
                  const traction *expected)
{
    double sum = 0;
    for (size_t i = 0; i < s->n; i++)
        sum += fabs(field[i] - traction_at(expected, s->x[i])) * s->width;
    return sum / P;
}

/* The ends of the elements that stuck in the last step. */
static void zone_of(const boundary_element *s, double *left, double *right)
{
    *left = HUGE_VAL, *right = -HUGE_VAL;
    for (size_t i = s->first; i < s->end; i++)
        if (s->moves[i] == STICKS) {
            *left = fmin(*left, s->x[i] - s->width / 2);
            *right = fmax(*right, s->x[i] + s->width / 2);
        }
}

static void assert_zone(const boundary_element *s, eccentric_patch patch)
{
    double left, right;
    zone_of(s, &left, &right);
    assert_within(left, patch.middle - patch.half, 1.5 * s->width);
    assert_within(right, patch.middle + patch.half, 1.5 * s->width);
}

static void assert_falls(const char *what, const double difference[LEVELS], double finest)
{
    printf("%s:", what);
    for (int level = 0; level < LEVELS; level++)
        printf(" %.2e", difference[level]);
    printf("\n");
    for (int level = 1; level < LEVELS; level++)
        assert_true(difference[level] < 0.67 * difference[level - 1]);
    assert_true(difference[LEVELS - 1] < finest);
}

static boundary_element solver;

/* Centred, tilted, and so far tilted that an edge has passed the rounding's end. */
CLAIM(a_moment_moves_the_patch)
{
    static const double loads[][2] = {{4, 0}, {4, 1.2}, {4, -3}, {1, 0.2}};
    enum { CASES = sizeof loads / sizeof *loads };
    double difference[LEVELS] = {0};
    for (int level = 0; level < LEVELS; level++)
        for (int i = 0; i < CASES; i++) {
            const double P = loads[i][0], M = loads[i][1];
            const eccentric_patch patch = patch_of_moment(P, M);
            const traction p = {1, {patch}, {1}};
            begin(&solver, level, P, M, 1.2 * (fabs(patch.middle) + patch.half));
            difference[level] += off(&solver, P, solver.p, &p) / CASES;
            assert_within(solver.tilt, eccentric_loads(patch).tilt, 0.5 * solver.width);
            assert_within(solver.x[solver.first], patch.middle - patch.half, 1.5 * solver.width);
            assert_within(solver.x[solver.end - 1], patch.middle + patch.half, 1.5 * solver.width);
        }
    assert_falls("pressure", difference, 2e-3);
}

/* From no Q and no tension in one step, at most to |sigma| = 4 |Q|/(pi s). The stick zone is the
 * patch of the load P - Q/f and of the tilt + sigma/(4 f). Then back, over half of that. */
CLAIM(monotonic_and_reversed_slip)
{
    static const double moments[] = {0, 1.2}, tensions[] = {0, 0.5, -0.9};
    enum { CASES = 6 };
    const double P = 4, Q = 0.6 * F * P, back = -0.1 * F * P;
    double forth[LEVELS] = {0}, and_back[LEVELS] = {0};
    for (int level = 0; level < LEVELS; level++)
        for (int i = 0; i < CASES; i++) {
            const double M = moments[i / 3];
            const eccentric_patch contact = patch_of_moment(P, M);
            const patch_loads loads = eccentric_loads(contact);
            const double ratio = tensions[i % 3] * 4 / (PI * contact.half);
            const eccentric_patch stick = front(loads, as_pair(Q, ratio * Q), 1);
            const pair change = as_pair(Q - back, ratio * (Q - back));
            const eccentric_patch reversed = front(loads, change, 2);
            const traction there = {2, {contact, stick}, {F, -F}};
            const traction again = {3, {contact, stick, reversed}, {-F, -F, 2 * F}};
            begin(&solver, level, P, M, 1.2 * (fabs(contact.middle) + contact.half));
            go(&solver, 2, P, M, Q, ratio * Q);
            forth[level] += off(&solver, P, solver.q, &there) / CASES;
            assert_zone(&solver, stick);
            go(&solver, 2, P, M, back, ratio * back);
            and_back[level] += off(&solver, P, solver.q, &again) / CASES;
            assert_zone(&solver, reversed);
        }
    assert_falls("shear, loading", forth, 2e-3);
    assert_falls("shear, unloading", and_back, 2e-3);
}

/* Nowell and Hills' numbers of a cylinder: half-width a, stick half-width c, eccentricity e. The
 * wedge's rounding is wider than the contact. E = 72.1 GPa, nu = 0.33, 543 N and 155 N on 4 mm, R =
 * 10 mm, f = 0.3, sigma = 100 MPa. */
CLAIM(nowell_and_hills_cylinder)
{
    const double A = 4 * (1 - 0.33 * 0.33) / 72.1e3, theta = 0.1, P = 543 / 4.0, Q = 155 / 4.0;
    for (int level = 0; level < LEVELS; level++) {
        boundary_element_start(&solver, theta, 10 * theta, A, 0.3, (size_t)COARSEST << level, 0.25);
        assert_int_equal(boundary_element_step(&solver, (boundary_loads){.P = P}), 0);
        go(&solver, 4, P, 0, Q, 100);
        double left, right, peak = 0;
        zone_of(&solver, &left, &right);
        for (size_t i = 0; i < solver.n; i++)
            peak = fmax(peak, -solver.p[i]);
        assert_within(solver.x[solver.end - 1], 0.206698, solver.width);
        assert_within(peak, 418.104, 418.104 * solver.width / 0.206698 / 4);
        assert_within((right - left) / 2, 0.045519, solver.width);
        assert_within((right + left) / 2, 0.041197, solver.width);
    }
}

/* What never slips in the fourth cycle between two loads is the patch of half of N1 + N2 - (T2 -
 * T1), P and M constant or not. */
CLAIM(the_permanent_stick_zone)
{
    static const boundary_loads cycles[][2] = {
        {{4, 0, -0.6, 0.1}, {4, 0, 0.9, 0.5}},
        {{4, 1.2, -0.6, 0.1}, {4, 1.2, 0.9, 0.5}},
        {{4, 0.4, 0.2, 0}, {4.4, 0.5, 1.4, 0.3}},
    };
    for (size_t i = 0; i < sizeof cycles / sizeof *cycles; i++) {
        const boundary_loads one = cycles[i][0], two = cycles[i][1];
        const patch_loads N1 = eccentric_loads(patch_of_moment(one.P, one.M));
        const patch_loads N2 = eccentric_loads(patch_of_moment(two.P, two.M));
        const pair change = as_pair(two.Q - one.Q, two.sigma - one.sigma);
        const eccentric_patch stick =
            patch_of_tilt((N1.P + N2.P - change.P) / 2, (N1.tilt + N2.tilt - change.tilt) / 2);
        const eccentric_patch contact = patch_of_moment(two.P, two.M);
        begin(&solver, 1, one.P, one.M, 1.2 * (fabs(contact.middle) + contact.half));
        go(&solver, 4, one.P, one.M, one.Q, one.sigma);
        bool stuck[BOUNDARY_ELEMENTS_MAX];
        for (int cycle = 0; cycle < 4; cycle++) {
            for (size_t j = 0; j < solver.n; j++)
                stuck[j] = true;
            for (int step = 0; step < 24; step++) {
                const boundary_loads to = step < 12 ? two : one;
                go(&solver, 1, solver.loads.P + (to.P - solver.loads.P) / (12 - step % 12),
                   solver.loads.M + (to.M - solver.loads.M) / (12 - step % 12),
                   solver.loads.Q + (to.Q - solver.loads.Q) / (12 - step % 12),
                   solver.loads.sigma + (to.sigma - solver.loads.sigma) / (12 - step % 12));
                for (size_t j = 0; j < solver.n; j++)
                    stuck[j] &= j >= solver.first && j < solver.end && solver.moves[j] == STICKS;
            }
        }
        double left = HUGE_VAL, right = -HUGE_VAL;
        for (size_t j = 0; j < solver.n; j++)
            if (stuck[j]) {
                left = fmin(left, solver.x[j] - solver.width / 2);
                right = fmax(right, solver.x[j] + solver.width / 2);
            }
        assert_within(left, stick.middle - stick.half, 1.5 * solver.width);
        assert_within(right, stick.middle + stick.half, 1.5 * solver.width);
    }
}
