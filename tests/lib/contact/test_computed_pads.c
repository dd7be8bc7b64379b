/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Loads without a closed form, of other pads than the wedge. */
#include "histories.h"

static const double F = 0.5;

static rwedge_contact *allowing(rwedge_contact *contact, double tolerance)
{
    assert_ok(rwedge_contact_allow_error(contact, tolerance));
    return contact;
}

static rwedge_contact *profile(size_t n, const double x[], const double slope[])
{
    rwedge_contact *contact;
    assert_ok(rwedge_contact_create_profile(n, x, slope, A, F, &contact));
    return allowing(owned(contact), 1e-4);
}

static void lag(rwedge_contact *contact)
{
    const double loads[][4] = {
        {0.5, 0, 0, 0}, {0.5, 0, 0.02, 0.06}, {0.5, 0, 0.12, 0.02}, {0.45, 0.02, 0.05, -0.05}};
    for (int i = 0; i < 4; i++)
        apply(contact, loads[i][0], loads[i][1], loads[i][2], loads[i][3]);
    assert_true(rwedge_contact_error(contact) > 0);
    assert_true(rwedge_contact_error(contact) < 1e-2);
}

static void assert_same(rwedge_contact *wedge, rwedge_contact *pad, double tolerance)
{
    const rw_patch edges = edges_of(wedge);
    const double peak = fabs(pressure(wedge, edges.left / 2 + edges.right / 2));
    for (int i = 1; i < 40; i++) {
        const double x = edges.left + (edges.right - edges.left) * (i + 0.01) / 40;
        assert_within(shear(wedge, x), shear(pad, x), tolerance * peak);
        assert_within(slip(wedge, x), slip(pad, x), tolerance * THETA);
    }
    assert_close(rwedge_contact_dissipated_energy(wedge), rwedge_contact_dissipated_energy(pad),
                 tolerance);
    assert_int_equal(rwedge_contact_zone_count(wedge), rwedge_contact_zone_count(pad));
}

CLAIM(the_rounded_wedge_is_computed_as_a_profile)
{
    const double x[] = {-0.4, 0.1, 0.4}, slope[] = {-THETA, THETA / 4, THETA};
    rwedge_contact *wedge = allowing(create(0.4, F), 1e-4), *pad = profile(3, x, slope);
    lag(wedge);
    lag(pad);
    assert_same(wedge, pad, 1e-7);
}

CLAIM(the_sharp_wedge_is_computed_as_a_kink)
{
    const double x[] = {0, 0}, slope[] = {-THETA, THETA};
    rwedge_contact *wedge = allowing(create(0, F), 1e-4), *pad = profile(2, x, slope);
    lag(wedge);
    lag(pad);
    assert_same(wedge, pad, 1e-7);
}

CLAIM(a_mirrored_pad_has_the_mirror_image)
{
    const double x[] = {-1.2, -0.4, 0.1, 0.5, 1}, slope[] = {-0.12, -0.02, -0.01, 0.05, 0.15};
    double back[5], falling[5];
    for (int i = 0; i < 5; i++) {
        back[i] = -x[4 - i];
        falling[i] = -slope[4 - i];
    }
    rwedge_contact *pad = profile(5, x, slope), *mirrored = profile(5, back, falling);
    const double loads[][4] = {{0.1, 0, 0.01, 0.02},
                               {0.1, 0, 0.01, 0.06},
                               {0.1, 0, 0.04, 0.02},
                               {0.09, 0.01, 0.02, -0.04}};
    for (int i = 0; i < 4; i++) { /* seen in a mirror, Q turns and the tension does not */
        apply(pad, loads[i][0], loads[i][1], loads[i][2], loads[i][3]);
        apply(mirrored, loads[i][0], -loads[i][1], -loads[i][2], loads[i][3]);
    }
    assert_true(rwedge_contact_error(pad) > 0 && rwedge_contact_error(pad) < 1e-2);
    const double limit = 2e-4 * F * fabs(pressure(pad, 0.1));
    for (int i = -9; i <= 9; i++)
        assert_within(shear(pad, i / 10.0), -shear(mirrored, -i / 10.0), limit);
}
