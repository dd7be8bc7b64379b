/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Contacts of a cylinder, a flat pad with rounded edges, and any convex profile. */
#include "histories.h"

static const double F = 0.5, R = 10;

static rwedge_contact *flat(double a)
{
    rwedge_contact *contact;
    assert_ok(rwedge_contact_create_flat(a, R, A, F, &contact));
    return owned(contact);
}

static rwedge_contact *profile(size_t n, const double x[], const double slope[])
{
    rwedge_contact *contact;
    assert_ok(rwedge_contact_create_profile(n, x, slope, A, F, &contact));
    return owned(contact);
}

/* The load of a flat that is in contact up to b: Ciavarella, Hills and Monno (1998). */
static double flat_load(double a, double b)
{
    const double alpha = a / b;
    return b * b / (A * R) * (acos(alpha) - alpha * sqrt(1 - alpha * alpha));
}

CLAIM(a_flat_pad_has_its_edge_tension)
{
    const double known[][2] = {{0.5, 1.6282}, {0.9, 3.4057}, {0.99, 10.6226}};
    for (int i = 0; i < 3; i++) {
        const double a = known[i][0], P = flat_load(a, 1);
        rwedge_contact *contact = APPLY(flat(a), {P, 0, F * P, 0});
        double left, right;
        assert_close(edges_of(contact).right, 1, 1e-14);
        assert_ok(rwedge_contact_beyond_flat(contact, &left, &right));
        assert_close(left, 1 - a, 1e-13);
        assert_true(left == right);
        assert_close(stress_at(contact, edges_of(contact).left, 0).xx / (F * P), known[i][1], 2e-5);
        const double exact = 2 * (1 - a) / (acos(a) - a * sqrt(1 - a * a));
        assert_close(stress_at(contact, edges_of(contact).left, 0).xx / (F * P), exact, 1e-12);
    }
}

/* Under a moment, and of a profile that has no flat: from the edges themselves. */
CLAIM(edges_off_the_centre_are_counted_from_the_corners)
{
    const double x[] = {-1, 1}, slope[] = {-THETA, THETA}, a = 0.4;
    rwedge_contact *pads[] = {flat(a), profile(2, x, slope), flat(a)};
    for (int i = 0; i < 3; i++) {
        const double corner = i == 1 ? 0 : a;
        double left, right;
        apply(pads[i], 0.1, i == 2 ? -0.01 : 0.01, 0, 0);
        assert_ok(rwedge_contact_beyond_flat(pads[i], &left, &right));
        assert_true(left == -corner - edges_of(pads[i]).left);
        assert_true(right == edges_of(pads[i]).right - corner);
    }
    assert_true(edges_of(pads[0]).left == -edges_of(pads[2]).right);
}

/* Steps of P, M, Q, sigma that all have a closed form. */
static const double STEPS[][4] = {{0.2, 0.03, 0, 0},         {0.2, 0.03, 0.06, 0.002},
                                  {0.2, 0.03, -0.02, -0.01}, {0.2, 0.03, 0.01, 0},
                                  {0.3, 0.045, 0.01, 0},     {0.3, 0.045, 0.09, 0.02}};
enum { COUNT = sizeof STEPS / sizeof *STEPS };

static void assert_same(const rwedge_contact *first, const rwedge_contact *second)
{
    const rw_patch edge = edges_of(first), stuck = stick_zone_of(first);
    double k[2][4];
    assert_within(edges_of(second).left, edge.left, 1e-15);
    assert_within(edges_of(second).right, edge.right, 1e-15);
    assert_within(stick_zone_of(second).left, stuck.left, 2e-15);
    assert_within(stick_zone_of(second).right, stuck.right, 2e-15);
    assert_close(rwedge_contact_tilt(second), rwedge_contact_tilt(first), 1e-13);
    for (int i = 0; i < 2; i++)
        assert_ok(rwedge_contact_edge_asymptotes(i ? second : first, &k[i][0], &k[i][1], &k[i][2],
                                                 &k[i][3]));
    for (int i = 0; i < 4; i++)
        assert_close(k[1][i], k[0][i], 1e-13);
    for (double x = -2; x < 2; x += 0.17) {
        const double y = fabs(x) < 0.5 ? 0 : 0.1;
        const stresses s = stress_at(first, x, y), t = stress_at(second, x, y);
        const double norm = fmax(fabs(s.xx) + fabs(s.yy) + fabs(s.xy), THETA / A / (1 + fabs(x)));
        assert_within(apart(s, t), 0, 3e-14 * norm);
    }
}

CLAIM(the_rounded_wedge_is_a_profile)
{
    const double a = 0.7, x[] = {-a, 0, a}, slope[] = {-THETA, 0, THETA};
    const double ends[] = {-a, a}, outer[] = {-THETA, THETA};
    rwedge_contact *wedge = create(a, F), *pads[] = {profile(3, x, slope), profile(2, ends, outer)};
    for (int i = 0; i < COUNT; i++) {
        const double *to = STEPS[i];
        apply(wedge, to[0], to[1], to[2], to[3]);
        double factor[3];
        assert_ok(rwedge_contact_yield_factor(wedge, 0.3, 1, &factor[2], NULL, NULL));
        for (int k = 0; k < 2; k++) {
            apply(pads[k], to[0], to[1], to[2], to[3]);
            assert_same(wedge, pads[k]);
            assert_close(rwedge_contact_dissipated_energy(pads[k]),
                         rwedge_contact_dissipated_energy(wedge), 1e-11);
            assert_ok(rwedge_contact_yield_factor(pads[k], 0.3, 1, &factor[k], NULL, NULL));
            assert_close(factor[k], factor[2], 1e-13);
            const double at = edges_of(wedge).right * 0.9;
            if (i < COUNT - 1)
                assert_within(slip(pads[k], at), slip(wedge, at), 1e-12 * THETA);
        }
    }
}

/* The arcs beside it, of which one is longer, are out of contact: they have no part in anything. */
CLAIM(a_pad_is_a_cylinder_where_one_arc_touches)
{
    const double x[] = {-2, -1, 1, 3, 3}, slope[] = {-0.2, -0.1, 0.1, 0.2, 0.2}, P = 0.2;
    rwedge_contact *pad = profile(5, x, slope), *cylinder = flat(0);
    const double Q[] = {0, 0.05, -0.04};
    for (int i = 0; i < 3; i++) {
        double factor[2], k[2][4];
        apply(pad, P, 0, Q[i], 0);
        apply(cylinder, P, 0, Q[i], 0);
        assert_close(edges_of(pad).right, edges_of(cylinder).right, 1e-14);
        assert_close(rw_patch_under_tilt(&pad->geometry, P, 0).right, edges_of(pad).right, 1e-14);
        assert_close(stick_zone_of(pad).right, stick_zone_of(cylinder).right, 1e-14);
        assert_close(pressure(pad, 0.3), pressure(cylinder, 0.3), 1e-13);
        assert_within(shear(pad, 0.3), shear(cylinder, 0.3), 1e-13 * P);
        assert_ok(rwedge_contact_edge_asymptotes(pad, &k[0][0], &k[0][1], &k[0][2], &k[0][3]));
        assert_ok(rwedge_contact_edge_asymptotes(cylinder, &k[1][0], &k[1][1], &k[1][2], &k[1][3]));
        for (int j = 0; j < 4; j++)
            assert_within(k[0][j], k[1][j], 1e-13 * P);
        assert_within(slip(pad, 0.7), slip(cylinder, 0.7), 1e-12 * THETA);
        assert_within(rwedge_contact_dissipated_energy(pad),
                      rwedge_contact_dissipated_energy(cylinder), 1e-12 * P * THETA);
        assert_ok(rwedge_contact_yield_factor(pad, 0.3, 1, &factor[0], NULL, NULL));
        assert_ok(rwedge_contact_yield_factor(cylinder, 0.3, 1, &factor[1], NULL, NULL));
        assert_close(factor[0], factor[1], 1e-12);
    }
    const double energy = rwedge_contact_dissipated_energy(pad);
    load(pad, 0, 0);
    assert_nan(rwedge_contact_dissipated_energy(pad)); /* what slips on the way is not known */
    load(pad, P, 0);
    assert_close(rwedge_contact_dissipated_energy(pad), energy, 1e-15);
}

/* P and Q alone: slip is then known along all of a history. */
CLAIM(a_profile_slips_as_its_wedge)
{
    const double a = 0.7, x[] = {-a, -0.2, 0.2, a}, k = THETA / a;
    const double slope[] = {-THETA, -0.2 * k, 0.2 * k, THETA};
    const double loads[][2] = {{0.2, 0}, {0.2, 0.08}, {0.3, 0.05}, {0.25, -0.1}, {0.4, 0.15}};
    const double kink[] = {0, 0}, sides[] = {-THETA, THETA};
    rwedge_contact *wedges[] = {create(a, F), create(0, F)},
                   *pads[] = {profile(4, x, slope), profile(2, kink, sides)};
    for (int i = 0; i < 10; i++) {
        rwedge_contact *wedge = wedges[i / 5], *pad = pads[i / 5];
        load(wedge, loads[i % 5][0], loads[i % 5][1]);
        load(pad, loads[i % 5][0], loads[i % 5][1]);
        const double b = edges_of(wedge).right;
        for (int j = -4; j < 5; j++)
            assert_within(slip(pad, 0.24 * j * b), slip(wedge, 0.24 * j * b), 1e-12 * THETA);
        assert_close(rwedge_contact_displacement(pad, b), rwedge_contact_displacement(wedge, b),
                     1e-4);
    }
}

/* P and Q change together, up and down, to full sliding and to separation. */
CLAIM(a_symmetric_pad_dissipates_as_its_wedge_while_P_changes)
{
    const double a = 0.7, x[] = {-a, -0.2, 0.2, a}, k = THETA / a;
    const double slope[] = {-THETA, -0.2 * k, 0.2 * k, THETA};
    const double loads[][2] = {{0.2, 0},     {0.2, 0.04},  {0.14, 0.05}, {0.3, -0.05}, {0.25, 0.03},
                               {0.4, -0.02}, {0.1, 0.045}, {0.1, 0.05},  {0.08, 0.04}, {0.3, 0.1},
                               {0.2, 0.02},  {0.2, 0.02},  {0, 0}};
    rwedge_contact *wedge = create(a, F), *pad = profile(4, x, slope);
    for (int i = 0; i < 13; i++) {
        load(wedge, loads[i][0], loads[i][1]);
        load(pad, loads[i][0], loads[i][1]);
        assert_close(rwedge_contact_dissipated_energy(pad), rwedge_contact_dissipated_energy(wedge),
                     1e-10);
    }
}

/* Over a closed cycle of P and Q it is the area of the loop of Q over the displacement. */
CLAIM(a_flat_pads_loop_encloses_its_energy)
{
    enum { A_CYCLE = 100 };
    rwedge_contact *contact = APPLY(flat(0.7), {0.5, 0, 0, 0});
    double before = 0, area = 0, last = 0, Q_last = 0;
    for (int i = 0; i <= 2 * A_CYCLE; i++) {
        const double phase = 2 * PI * i / A_CYCLE, Q = 0.15 * sin(phase);
        load(contact, 0.5 + 0.1 * cos(phase), Q);
        const double now = rwedge_contact_displacement(contact, 10);
        if (i > A_CYCLE)
            area += (Q + Q_last) / 2 * (now - last);
        if (i == A_CYCLE)
            before = rwedge_contact_dissipated_energy(contact);
        last = now;
        Q_last = Q;
    }
    assert_close(area, rwedge_contact_dissipated_energy(contact) - before, 1e-3);
}

CLAIM(the_sharp_wedge_is_a_kink)
{
    const double x[] = {0, 0}, slope[] = {-THETA, THETA}, y = 0;
    rwedge_contact *wedge = create(0, F), *pad = profile(2, x, slope);
    for (int i = 0; i < COUNT; i++) {
        apply(wedge, STEPS[i][0], STEPS[i][1], STEPS[i][2], STEPS[i][3]);
        apply(pad, STEPS[i][0], STEPS[i][1], STEPS[i][2], STEPS[i][3]);
        assert_same(wedge, pad);
    }
    double s[3];
    assert_int_equal(rwedge_contact_stresses(pad, 1, x, &y, &s[0], &s[1], &s[2]), RWEDGE_EDOMAIN);
}

static const double WORN_X[] = {-1, -0.4, 0.1, 0.5, 0.8};
static const double WORN[] = {-0.1, -0.02, -0.02, 0.05, 0.12};

CLAIM(a_mirrored_profile_mirrors_everything)
{
    double x[5], slope[5];
    for (int i = 0; i < 5; i++) {
        x[i] = -WORN_X[4 - i];
        slope[i] = -WORN[4 - i];
    }
    rwedge_contact *pad = profile(5, WORN_X, WORN), *reflected = profile(5, x, slope);
    const double far[] = {0.2, 0.3, 0, 0};
    for (int i = 0; i < 5; i++) {
        const double *to = i < 4 ? STEPS[i] : far;
        if (i == 4) {
            load(pad, 0, 0);
            load(reflected, 0, 0);
        }
        apply(pad, to[0], to[1], to[2], to[3] / 10);
        apply(reflected, to[0], -to[1], -to[2], to[3] / 10);
        const rw_patch edge = edges_of(pad), mirrored = edges_of(reflected);
        assert_within(edge.left, -mirrored.right, 1e-14);
        assert_within(edge.right, -mirrored.left, 1e-14);
        assert_within(stick_zone_of(pad).left, -stick_zone_of(reflected).right, 1e-12);
        assert_close(rwedge_contact_tilt(pad), -rwedge_contact_tilt(reflected), 1e-12);
        for (double at = -1.5; at < 1.5; at += 0.21) {
            const stresses s = stress_at(pad, at, 0.03), t = stress_at(reflected, -at, 0.03);
            assert_within(s.xx, t.xx, 1e-12);
            assert_within(s.xy, -t.xy, 1e-12);
        }
    }
    const double even[] = {-1, 0, 1}, left[] = {-0.3, 0, 0.1}, right[] = {-0.1, 0, 0.3};
    rwedge_contact *steep_left = profile(3, even, left), *steep_right = profile(3, even, right);
    load(steep_left, 0.1, 0);
    load(steep_right, 0.1, 0);
    const rw_patch edge = edges_of(steep_left), mirrored = edges_of(steep_right);
    assert_within(edge.left, -mirrored.right, 1e-14);
    assert_within(edge.right, -mirrored.left, 1e-14);
    assert_true(fabs(edge.left + edge.right) > 0.01);
}

CLAIM(a_pad_is_stored_and_restored)
{
    rwedge_contact *pads[] = {flat(0), flat(0.4), profile(5, WORN_X, WORN)};
    for (int i = 0; i < 3; i++) {
        apply(pads[i], 0.2, 0.01, 0, 0);
        apply(pads[i], 0.2, 0.01, 0.05, 0);
        rwedge_contact *twins[] = {copy_of(pads[i]), restored(state_of(pads[i]))};
        apply(pads[i], 0.2, 0.01, -0.02, 0);
        for (int k = 0; k < 2; k++) {
            apply(twins[k], 0.2, 0.01, -0.02, 0);
            assert_state(twins[k], state_of(pads[i]));
        }
    }
}

/* What sticks for good under P, Q between -1 and 1 of a half is the contact of the load P - Q/f. */
CLAIM(what_never_slips_on_a_flat)
{
    rwedge_contact *contact = flat(0.4), *smaller = flat(0.4);
    double left, right;
    apply(smaller, 0.1 - 0.02 / F, 0, 0, 0);
    assert_ok(
        rwedge_contact_permanent_stick(contact, 0.1, 0, -0.02, 0, 0.1, 0, 0.02, 0, &left, &right));
    assert_close(right, edges_of(smaller).right, 1e-13);
    assert_close(left, edges_of(smaller).left, 1e-13);
}

/* The factor against J2 on a fine grid of the surface and below. */
CLAIM(the_yield_factor_misses_no_place)
{
    rwedge_contact *pads[] = {flat(0.4), profile(5, WORN_X, WORN)};
    for (int i = 0; i < 2; i++) {
        double factor, highest = 0;
        apply(pads[i], 0.1, 0, 0, 0);
        apply(pads[i], 0.1, 0, 0.03, 0);
        assert_ok(rwedge_contact_yield_factor(pads[i], 0.3, 1, &factor, NULL, NULL));
        for (double x = -1.2; x < 1.2; x += 0.002)
            for (double y = 0; y < 0.4; y = y == 0 ? 1e-4 : 1.15 * y) {
                const stresses s = stress_at(pads[i], x, y);
                const double mean = (s.xx + s.yy) / 2, half = (s.xx - s.yy) / 2;
                const double J2 = half * half + s.xy * s.xy + mean * mean * 0.16 / 3;
                highest = fmax(highest, J2);
            }
        assert_true(1 / sqrt(highest) > factor * (1 - 1e-12));
        assert_close(1 / sqrt(highest), factor, 5e-3);
    }
}

/* On one arc the middle of the patch is M/P, however narrow it is. */
CLAIM(a_narrow_patch_far_from_the_origin_is_where_its_moment_is)
{
    const double x[] = {-1, 0.5, 0.7, 1.5}, slope[] = {-0.04, -0.03, -0.02, 0};
    for (double P = 1e-4; P > 1e-12; P /= 10) {
        rwedge_contact *pad = profile(4, x, slope);
        const double s = sqrt(2 * P * A / PI * 20), M = 0.617 * P;
        apply(pad, P, M, 0, 0);
        assert_within(edges_of(pad).left, M / P - s, 1e-15);
        assert_within(edges_of(pad).right, M / P + s, 1e-15);
    }
}

/* P/(bk) without friction. Hertz' is 4.880036 for nu = 0.3: lib/README.md, "Strength". */
CLAIM(a_flat_pad_is_stronger_than_hertz_unless_its_edges_are_sharp)
{
    const double alphas[] = {0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.8, 0.95};
    double last = INFINITY;
    for (int i = 0; i < 8; i++) {
        const double a = alphas[i], P = flat_load(a, 1);
        double factor;
        rwedge_contact *pad = APPLY(flat(a), {P, 0, 0, 0});
        assert_ok(rwedge_contact_yield_factor(pad, 0.3, 1, &factor, NULL, NULL));
        assert_true((P * factor > 4.880036) == (a <= 0.5));
        if (a >= 0.4)
            assert_true(P * factor < last);
        last = P * factor;
    }
}

CLAIM(a_contact_that_reaches_too_far_is_refused)
{
    rwedge_contact *pads[] = {flat(0), flat(0.4)};
    for (int i = 0; i < 2; i++) {
        assert_int_equal(rwedge_contact_load(pads[i], 50, 0), RWEDGE_ERANGE);
        apply(pads[i], 1, 0, 0, 0);
        assert_int_equal(rwedge_contact_apply(pads[i], 1, 12, 0, 0), RWEDGE_ERANGE);
    }
}

CLAIM(profiles_that_are_none_are_refused)
{
    rwedge_contact *contact = NULL;
    const double x[] = {0, 1, 2}, back[] = {0, 2, 1}, slope[] = {-0.1, 0, 0.1};
    const double hollow[] = {-0.1, 0.1, 0}, even[] = {0.1, 0.1, 0.1}, steep[] = {-1.6, 0, 0.1};
    const double tiny[] = {-1e-30, 0, 1e-30},
                 least[] = {0, 0, 1e-60}; /* half of it is too little */
    double left, right, many[1001] = {0};
    many[1000] = 0.1;
    assert_int_equal(rwedge_contact_create_profile(1001, many, many, A, F, &contact),
                     RWEDGE_EDOMAIN);
    assert_int_equal(rwedge_contact_create_profile(3, x, slope, 0, F, &contact), RWEDGE_EDOMAIN);
    assert_int_equal(rwedge_contact_create_profile(3, x, slope, A, -1, &contact), RWEDGE_EDOMAIN);
    assert_int_equal(rwedge_contact_create_profile(3, x, least, A, F, &contact), RWEDGE_EDOMAIN);
    assert_int_equal(rwedge_contact_create_profile(3, x, tiny, 1e60, F, &contact), RWEDGE_EDOMAIN);
    assert_int_equal(rwedge_contact_create_profile(3, back, slope, A, F, &contact), RWEDGE_EDOMAIN);
    assert_int_equal(rwedge_contact_create_profile(3, x, hollow, A, F, &contact), RWEDGE_EDOMAIN);
    assert_int_equal(rwedge_contact_create_profile(3, x, even, A, F, &contact), RWEDGE_EDOMAIN);
    assert_int_equal(rwedge_contact_create_profile(3, x, steep, A, F, &contact), RWEDGE_EDOMAIN);
    assert_int_equal(rwedge_contact_create_profile(1, x, slope, A, F, &contact), RWEDGE_EDOMAIN);
    assert_int_equal(rwedge_contact_create_flat(-1, R, A, F, &contact), RWEDGE_EDOMAIN);
    assert_int_equal(rwedge_contact_create_flat(1, 0, A, F, &contact), RWEDGE_EDOMAIN);
    assert_int_equal(rwedge_contact_create_flat(1e60, 1e60, A, F, &contact), RWEDGE_EDOMAIN);
    assert_null(contact);
    contact = profile(3, x, slope);
    assert_int_equal(rwedge_contact_beyond_flat(contact, &left, &right), RWEDGE_EABSENT);
    assert_true(rwedge_contact_tilt(contact) == 0);
    assert_int_equal(rwedge_contact_apply(contact, 0.1, 1e30, 0, 0), RWEDGE_EDOMAIN);
    assert_int_equal(rwedge_contact_apply(contact, 0.1, -1e30, 0, 0), RWEDGE_EDOMAIN);
}
