/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Contacts of a flat pad with rounded edges and of a worn, asymmetric one against the incremental
 * boundary-element solver, along a history with moment and bulk tension. */
#include "boundary_element.h"
#include "histories.h"

#include <stdio.h>

static const double F = 0.5, FLAT = 0.4, RADIUS = 4;

/* The slope of the worn pad: linear between the places. */
static const double X[] = {-1, -0.4, 0.1, 0.5, 0.9}, SLOPE[] = {-0.12, -0.02, -0.01, 0.05, 0.15};

static double flat_height(double x)
{
    const double beyond = fmax(0, fabs(x) - FLAT);
    return beyond * beyond / (2 * RADIUS);
}

/* From X[0] on. */
static double worn_height(double x)
{
    double sum = SLOPE[0] * (x - X[0]);
    for (int i = 1; i < 5; i++) {
        const double length = X[i] - X[i - 1], in = fmin(fmax(0, x - X[i - 1]), length);
        const double rise = (SLOPE[i] - SLOPE[i - 1]) / length;
        sum += rise * (in * in / 2 + in * fmax(0, x - X[i]));
    }
    return sum;
}

static const boundary_loads LOADS[] = {{0.08, 0.006, 0, 0},
                                       {0.08, 0.006, 0.03, 0.012},
                                       {0.08, 0.006, -0.02, -0.01},
                                       {0.08, 0.006, 0.01, 0.005},
                                       {0.1, 0.0075, 0.01, 0.005}};

/* The tension lags behind Q, and the contact rocks: there is no closed form. */
static const boundary_loads LAGGING[] = {{0.08, 0.006, 0, 0},
                                         {0.08, 0.006, 0.01, 0.05},
                                         {0.08, 0.006, 0.03, 0.02},
                                         {0.09, 0.002, 0.01, -0.04},
                                         {0.08, 0.006, -0.02, -0.02}};
enum { LEGS = sizeof LOADS / sizeof *LOADS };

static difference along(const boundary_loads loads[LEGS], rwedge_contact *contact,
                        double (*height)(double), size_t n)
{
    static boundary_element solver;
    difference sum = {0};
    boundary_element_start(&solver, THETA, 1, A, F, n, 1);
    solver.height = height;
    for (int leg = 0; leg < LEGS; leg++) {
        const boundary_loads to = loads[leg];
        apply(contact, to.P, to.M, to.Q, to.sigma);
        assert_int_equal(boundary_element_go(&solver, leg == 0 ? 1 : 20, to), 0);
        add_difference(contact, &solver, F, &sum);
    }
    printf("%3d elements: pressure %.1e shear %.1e slip %.1e energy %.1e\n", (int)n,
           sum.pressure / LEGS, sum.shear / LEGS, sum.slip / LEGS, sum.energy);
    return sum;
}

static void assert_limit(difference coarse, difference fine)
{
    assert_true(coarse.legs == LEGS && fine.legs == coarse.legs);
    assert_true(fine.pressure < LEGS * 2e-3 && fine.pressure < 0.5 * coarse.pressure);
    assert_true(fine.shear < LEGS * 5e-3 && fine.shear < 0.6 * coarse.shear);
    assert_true(fine.slip < LEGS * 1e-4 && fine.energy < 0.1);
}

static rwedge_contact *flat(void)
{
    rwedge_contact *contact;
    assert_ok(rwedge_contact_create_flat(FLAT, RADIUS, A, F, &contact));
    return owned(contact);
}

static rwedge_contact *worn(void)
{
    rwedge_contact *contact;
    assert_ok(rwedge_contact_create_profile(5, X, SLOPE, A, F, &contact));
    return owned(contact);
}

CLAIM(a_flat_pad_is_the_limit_of_boundary_elements)
{
    assert_limit(along(LOADS, flat(), flat_height, 60), along(LOADS, flat(), flat_height, 180));
}

CLAIM(a_worn_pad_is_the_limit_of_boundary_elements)
{
    assert_limit(along(LOADS, worn(), worn_height, 60), along(LOADS, worn(), worn_height, 180));
}

static rwedge_contact *computed(rwedge_contact *contact)
{
    assert_ok(rwedge_contact_allow_error(contact, 1e-4));
    return contact;
}

CLAIM(what_is_computed_is_the_limit_of_boundary_elements)
{
    assert_limit(along(LAGGING, computed(flat()), flat_height, 60),
                 along(LAGGING, computed(flat()), flat_height, 180));
    assert_limit(along(LAGGING, computed(worn()), worn_height, 60),
                 along(LAGGING, computed(worn()), worn_height, 180));
}
