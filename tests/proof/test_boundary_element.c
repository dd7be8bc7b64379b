/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The memory diagram is compared with the incremental boundary-element solver along random
 * histories. They must approach each other as mesh and step shrink. */
#include "boundary_element.h"
#include "histories.h"

#include <stdio.h>

enum { LEVELS = 3, COARSEST = 30, LEGS = 10 };

/* Mean differences over a history, relative to friction's limit, to the largest slip there could
 * be, and to the energy. */
typedef struct {
    double shear, slip, energy;
} difference;

static void compare(const rwedge_contact *contact, const boundary_element *solver, double f,
                    difference *sum)
{
    const double b = rwedge_contact_half_width(contact);
    double shear_off = 0, limit = 0, slip_off = 0, touching = 0;
    for (size_t i = 0; i < solver->n; i++) {
        const double x = solver->x[i];
        shear_off += fabs(shear(contact, x) - solver->q[i]);
        limit += f * fabs(pressure(contact, x));
        if (x < b && i < solver->end) {
            slip_off += fabs(slip(contact, x) - solver->slip[i]);
            touching++;
        }
    }
    const double energy = rwedge_contact_dissipated_energy(contact);
    sum->shear += shear_off / limit / LEGS;
    sum->slip += slip_off / touching / (f * THETA * b) / LEGS;
    sum->energy = fabs(solver->energy / energy - 1); /* that of the whole history */
}

/* One leg of a history: every third under a constant load. */
static void draw_leg(uint64_t *seed, int leg, double P_max, double f, double *P, double *Q)
{
    if (leg % 3 != 2)
        *P = P_max * (0.2 + 0.8 * random_fraction(seed));
    *Q = 0.95 * f * *P * (2 * random_fraction(seed) - 1);
}

static difference along_a_history(uint64_t number, double a, double f, int level)
{
    static boundary_element solver;
    const double widest = 1.1;
    boundary_element_start_even(&solver, THETA, a, A, f, (size_t)COARSEST << level, 1.2 * widest);
    rwedge_contact *contact = create(a, f);
    difference mean = {0, 0, 0};
    uint64_t seed = number;
    double P = 0, Q = 0;
    for (int leg = 0; leg < LEGS; leg++) {
        const double from_P = P, from_Q = Q;
        draw_leg(&seed, leg, rwedge_normal_load(THETA, a, A, widest), f, &P, &Q);
        load(contact, P, Q);
        const int steps = 10 << level;
        for (int i = 1; i <= steps; i++) {
            const double t = (double)i / steps;
            const boundary_loads to = {.P = from_P + t * (P - from_P),
                                       .Q = from_Q + t * (Q - from_Q)};
            assert_int_equal(boundary_element_step(&solver, to), 0);
        }
        compare(contact, &solver, f, &mean);
    }
    return mean;
}

/* The mean over the histories; halving mesh and step must take a third off at least, and does
 * about halve it. */
CLAIM(the_memory_diagram_is_the_limit_of_boundary_elements)
{
    static const double ROUNDINGS[] = {0, 0.1, 0.4, 0.8, 2};
    enum { HISTORIES = sizeof ROUNDINGS / sizeof *ROUNDINGS };
    difference mean[LEVELS] = {{0, 0, 0}};
    for (int level = 0; level < LEVELS; level++)
        for (int i = 0; i < HISTORIES; i++) {
            const difference d =
                along_a_history(101 + (uint64_t)i, ROUNDINGS[i], 0.3 + 0.1 * i, level);
            mean[level].shear += d.shear / HISTORIES;
            mean[level].slip += d.slip / HISTORIES;
            mean[level].energy += d.energy / HISTORIES;
        }
    for (int level = 0; level < LEVELS; level++)
        printf("%3d elements: shear %.5f slip %.6f energy %.5f\n", COARSEST << level,
               mean[level].shear, mean[level].slip, mean[level].energy);
    for (int level = 1; level < LEVELS; level++) {
        assert_true(mean[level].shear < 0.67 * mean[level - 1].shear);
        assert_true(mean[level].slip < 0.67 * mean[level - 1].slip);
        assert_true(mean[level].energy < 0.67 * mean[level - 1].energy);
    }
    assert_true(mean[LEVELS - 1].shear < 0.02);
    assert_true(mean[LEVELS - 1].slip < 0.003);
    assert_true(mean[LEVELS - 1].energy < 0.006);
}
