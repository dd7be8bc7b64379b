/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Contacts with a load history: equilibrium, Coulomb's law, what is refused. */
#include "histories.h"
#include "quadrature.h"

#include <float.h>

/* ---- Equilibrium and Coulomb's law ---- */

static double pressing(double x, void *contact)
{
    return -pressure(contact, x);
}

static double turning(double x, void *contact)
{
    return -x * pressure(contact, x);
}

/* Between the edges and the places where the slope of the pad bends. */
CLAIM(the_pressure_carries_the_load_and_the_moment)
{
    const double x[] = {-1, -0.4, 0.1, 0.5, 0.8}, slope[] = {-0.1, -0.02, -0.02, 0.05, 0.12};
    rwedge_contact *contacts[] = {create(0.4, 0.5), create(0, 0.5), create(9, 0.5),
                                  create_flat(0.4, 10, A, 0.5), create_profile(5, x, slope, 0.5)};
    const double bends[] = {-0.4, 0, 0.1, 0.4, 0.5, 0.8};
    for (int i = 0; i < 15; i++) {
        rwedge_contact *contact = contacts[i / 3];
        const double P = 0.2, M = 0.04 * (i % 3 - 1);
        apply(contact, P, M, 0, 0);
        const rw_patch edges = edges_of(contact);
        double points[8] = {edges.left, edges.right};
        for (int k = 0; k < 6; k++)
            points[k + 2] = fmax(edges.left, fmin(edges.right, bends[k]));
        assert_close(integral(pressing, contact, 7, points), P, 1e-11);
        assert_within(integral(turning, contact, 7, points), M, 1e-10);
    }
}

CLAIM(what_slips_is_at_the_limit_and_slips_with_the_traction)
{
    int slipped = 0;
    for (int number = 1; number <= 60; number++) {
        random_history h;
        rwedge_contact *contact = begin(&h, number);
        go_on(&h, contact);
        for (int step = 0; step < 12; step++) {
            const rwedge_contact *before = copy_of(contact);
            const double b = rwedge_contact_half_width(before);
            go_on(&h, contact);
            for (int i = 0; i < 40; i++) {
                const double x = b * (i + 0.5) / 40;
                if (x >= rwedge_contact_half_width(contact))
                    break;
                const double moved = slip(contact, x) - slip(before, x), q = shear(contact, x);
                if (fabs(moved) <= 1e-13 * h.f * THETA * b)
                    continue;
                slipped++;
                assert_close(fabs(q), h.f * fabs(pressure(contact, x)), 1e-13);
                assert_true(moved * q > 0);
            }
        }
    }
    assert_true(slipped > 1000);
}

CLAIM(pressing_without_slip_gives_no_slip)
{
    rwedge_contact *contact = APPLY(create(0.1, 0.5), {0.1, 0, 0.02, 0}, {0.2, 0, -0.01, 0});
    load(contact, 0.15, 0.005); /* back along the last step */
    for (double x = 0; x < 0.37; x += 0.01)
        assert_true(slip(contact, x) == 0);
    assert_true(rwedge_contact_dissipated_energy(contact) < 1e-30);
}

/* ---- Arguments ---- */

/* In one load from 1e12 to 1e-3, the rounding of 1e12 would decide what slips. In two loads nothing
 * is lost. */
CLAIM(a_steep_fall_of_the_load_is_refused)
{
    rwedge_contact *contact = APPLY(create_wedge(0.05, 1, 1e-5, 0.5), {1e9, 0, 0, 0});
    refuse(contact, 1, 0, 0.1, 0, RWEDGE_ERANGE);
    refuse(contact, 1, 0, 8, 0, RWEDGE_ERANGE);
    APPLY(contact, {3e4, 0, 0, 0}, {1, 0, 0, 0}, {1, 0, 0.1, 0});
    /* Q = 0.2 f P in the Hertz regime */
    assert_close(rwedge_contact_stick_half_width(contact) / rwedge_contact_half_width(contact),
                 sqrt(0.8), 1e-9);
    load(contact, 0, 0); /* separation is no fall */
}

/* Of half-width, rounding over half-width, and pressure: a sharp wedge has b = A P/(2 theta), a
 * cylinder b^2 = (2/pi) A P a/theta. */
CLAIM(results_beyond_the_domain_are_refused)
{
    static const struct {
        double theta, a, A, P;
    } CASES[] = {
        {0.1, 0, 1e-50, 1e-50},      /* b = 5e-100 */
        {0.1, 0, 1e50, 1e50},        /* b = 5e100 */
        {0.1, 1e50, 1e-40, 1e-50},   /* a/b = 4e69 */
        {0.1, 1e-50, 1e30, 1},       /* a/b = 2e-81 */
        {1, 1e-3, 1e-60, 1e59},      /* the pressure is 3e60 */
        {1e-8, 1e20, 1e40, 1.6e-58}, /* the pressure is 1e-63 */
    };
    for (size_t i = 0; i < sizeof CASES / sizeof *CASES; i++)
        refuse(create_wedge(CASES[i].theta, CASES[i].a, CASES[i].A, 0.5), CASES[i].P, 0, 0, 0,
               RWEDGE_ERANGE);
}

/* Many steps of slope f, each of it to rounding. Together they bend the path by more than rounding,
 * so that it has corners with the same slope on both sides. All that was added slips. */
CLAIM(steps_of_the_steepest_slope_may_bend)
{
    const double f = 0.5;
    rwedge_contact *contact = create(0.1, f);
    double P = 0.1, ratio = 0;
    load(contact, P, 0);
    const double inner = rwedge_contact_half_width(contact);
    for (int i = 0; i < 400; i++) {
        P += 1e-4;
        ratio += 1e-4 + (i < 200 ? -2 : 2) * DBL_EPSILON * P;
        load(contact, P, f * ratio);
    }
    assert_true(rwedge_contact_memory(contact) > 2);
    const double b = rwedge_contact_half_width(contact);
    for (double x = inner; x < b; x += b / 50)
        assert_close(shear(contact, x), f * pressure(contact, x), 1e-12);
    const double x = b / 3, y = b / 4, Q = f * ratio, none = 0;
    const stresses before = stress_at(contact, x, y); /* corners of one slope add nothing */
    stresses after;
    assert_ok(rwedge_contact_stress_history(contact, 1, &P, &none, &Q, &none, 1, &x, &y, &after.xx,
                                            &after.yy, &after.xy));
    assert_memory_equal(&after, &before, sizeof after);
}
