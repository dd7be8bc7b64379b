/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The end of wear against Archard's law, cycle by cycle, by boundary elements: in the middle, and
 * off the centre under a held tilt. What is left between them falls with the elements' width. */
#include "boundary_element.h"

#include <stdio.h>

enum { LEVELS = 3, COARSEST = 40, STUCK = 18 }; /* STUCK: elements of the zone that sticks */

typedef struct {
    double theta, a, P, M, share; /* share: Q_a over f P */
} worn_case;

/* In the middle Hertz' contact and a wedge whose flanks touch; off the centre the same. */
static const worn_case CASES[] = {{1, 1, 1.2, 0, 0.6},
                                  {0.2, 0.5, 0.6, 0, 0.4},
                                  {1, 2, 1.2, 0.2, 0.6},
                                  {0.2, 0.5, 0.6, 0.05, 0.3}};

/* Relative: area and largest depth that are worn, too large, and the mean difference of the
 * pressures, but beside the edges of the zone. */
typedef struct {
    double area, depth, pressure;
} gap;

/* The profile of a case, with the middle of the zone at 0: its edges are edges of elements. */
static const worn_case *present;
static double middle;

static double height(double x)
{
    const double from_apex = fabs(x + middle), a = present->a;
    return present->theta * (from_apex < a ? from_apex * from_apex / (2 * a) : from_apex - a / 2);
}

/* Larger rates overshoot: what is worn too deep stays so. */
static double rate_for(const rwedge_contact *contact, size_t n)
{
    double pressure, x;
    assert_ok(rwedge_contact_peak_pressure(contact, &pressure, &x));
    return 16 / (pressure * (double)n);
}

static gap difference_of(const worn_case *c, int level)
{
    const double f = 0.5, Q_a = c->share * f * c->P;
    static boundary_element solver;
    rwedge_contact *contact = NULL;
    double left, right, worn_left, worn_right, area, depth, x;
    assert_ok(rwedge_contact_create(c->theta, c->a, 1, f, &contact));
    assert_ok(rwedge_contact_apply(contact, c->P, c->M, 0, 0));
    assert_ok(
        rwedge_contact_worn_zone(contact, Q_a, &left, &right, &worn_left, &worn_right, &area));
    assert_ok(rwedge_contact_deepest_wear(contact, Q_a, &depth, &x));
    const size_t n = (size_t)COARSEST << level;
    present = c;
    middle = (left + right) / 2;
    const double half = (right - left) / 2 * COARSEST / STUCK;
    assert_true(worn_right - middle < half && middle - worn_left < half);
    boundary_element_start(&solver, c->theta, c->a, 1, f, n, half);
    solver.height = height;
    assert_int_equal(boundary_element_wear(&solver, c->P, rwedge_contact_tilt(contact), Q_a,
                                           rate_for(contact, n)),
                     0);
    double sum = 0, deepest = 0, off = 0, limit = 0;
    for (size_t i = 0; i < n; i++) {
        const double at = solver.x[i] + middle;
        double expected, p;
        sum += solver.width * solver.worn[i];
        deepest = fmax(deepest, solver.worn[i]);
        if (fabs(solver.x[i]) > 0.4 * (right - left))
            continue;
        assert_ok(rwedge_contact_full_wear(contact, Q_a, 1, &at, &expected, &p));
        off += fabs(p - solver.p.value[i]);
        limit += fabs(p);
    }
    rwedge_contact_destroy(contact);
    return (gap){sum / area - 1, deepest / depth - 1, off / limit};
}

/* It is of the first order: two meshes tell where it goes. */
CLAIM(cycle_by_cycle_wear_ends_as_the_closed_form_has_it)
{
    for (size_t i = 0; i < sizeof CASES / sizeof CASES[0]; i++) {
        gap at[LEVELS];
        for (int level = 0; level < LEVELS; level++) {
            at[level] = difference_of(&CASES[i], level);
            print_message("case %d, %3d elements: area %.4f, largest depth %.4f, pressure %.4f\n",
                          (int)i, COARSEST << level, at[level].area, at[level].depth,
                          at[level].pressure);
        }
        const gap before = at[LEVELS - 2], last = at[LEVELS - 1];
        assert_true(last.area < 0.6 * before.area && last.depth < 0.6 * before.depth &&
                    last.pressure < 0.65 * before.pressure);
        assert_within(2 * last.area - before.area, 0, 0.005);
        assert_true(last.depth < 0.02 && last.pressure < 0.02);
    }
}
