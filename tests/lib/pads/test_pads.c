/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Contacts of a cylinder, a flat pad with rounded edges, and any convex profile; with loads that
 * have a closed form and with others. */
#include "histories.h"

static const double F = 0.5;

/* R = 10 */
static rwedge_contact *flat(double a)
{
    return create_flat(a, 10, A, F);
}

static rwedge_contact *profile(size_t n, const double x[], const double slope[])
{
    return create_profile(n, x, slope, F);
}

/* The load of a flat that is in contact up to b: Ciavarella, Hills and Monno (1998). */
static double flat_load(double a, double b)
{
    const double alpha = a / b;
    return b * b / (A * 10) * (acos(alpha) - alpha * sqrt(1 - alpha * alpha));
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

/* ---- What a contact is ---- */

static void assert_pad(const rwedge_contact *contact, int32_t kind, double theta, double a,
                       double R)
{
    double told[5];
    assert_int_equal(rwedge_contact_kind(contact), kind);
    assert_ok(rwedge_contact_pad(contact, &told[0], &told[1], &told[2], &told[3], &told[4]));
    assert_true(told[0] == theta && told[1] == a && told[2] == R && told[3] == A && told[4] == F);
}

CLAIM(a_contact_tells_its_pad)
{
    const double x[] = {-1, 1}, slope[] = {-THETA, THETA};
    assert_pad(create_wedge(0.1, 0.7, A, F), RWEDGE_PAD_WEDGE, 0.1, 0.7, 0);
    assert_pad(flat(0), RWEDGE_PAD_CYLINDER, 0, 0, 10);
    assert_pad(APPLY(flat(0.4), {0.1, 0.01, 0, 0}), RWEDGE_PAD_FLAT, 0, 0.4, 10);
    assert_pad(profile(2, x, slope), RWEDGE_PAD_PROFILE, 0, 0, 0);
    assert_int_equal(rwedge_contact_kind(NULL), -1);
}

/* Places inside a part of one slope are left out, kinks are not. */
CLAIM(a_contact_tells_its_places)
{
    const double x[] = {-1, -0.4, -0.2, 0.1, 0.1, 0.5, 0.6, 0.8},
                 slope[] = {-0.1, -0.02, -0.02, -0.02, 0.01, 0.05, 0.05, 0.12},
                 kept_x[] = {-1, -0.4, 0.1, 0.1, 0.5, 0.6, 0.8},
                 kept_slope[] = {-0.1, -0.02, -0.02, 0.01, 0.05, 0.05, 0.12};
    double told_x[7], told_slope[7];
    const rwedge_contact *contact = profile(8, x, slope);
    assert_int_equal(rwedge_contact_place_count(contact), 7);
    assert_int_equal(rwedge_contact_places(contact, 6, told_x, told_slope), RWEDGE_ERANGE);
    assert_ok(rwedge_contact_places(contact, 7, told_x, told_slope));
    for (int i = 0; i < 7; i++) {
        assert_true(told_x[i] == kept_x[i]);
        assert_within(told_slope[i], kept_slope[i], 7e-15 * 0.11);
    }
    assert_int_equal(rwedge_contact_place_count(NULL), 0);
}

/* A wedge and a flat as profiles touch as they do. */
CLAIM(the_places_of_any_pad_make_a_profile_like_it)
{
    rwedge_contact *pads[] = {create_wedge(0.1, 0.7, A, F), create_wedge(0.1, 0, A, F), flat(0),
                              flat(0.4)};
    for (int i = 0; i < 4; i++) {
        double x[4], slope[4];
        const size_t n = rwedge_contact_place_count(pads[i]);
        assert_int_equal(n, i == 3 ? 4 : 2);
        assert_ok(rwedge_contact_places(pads[i], n, x, slope));
        rwedge_contact *like = APPLY(profile(n, x, slope), {0.2, 0.01, 0, 0});
        apply(pads[i], 0.2, 0.01, 0, 0);
        const rw_patch edges = edges_of(pads[i]);
        assert_close(edges_of(like).left, edges.left, 1e-13);
        assert_close(edges_of(like).right, edges.right, 1e-13);
    }
}

/* The others are told as they were given, on a copy too. */
CLAIM(a_contact_tells_its_strain_and_its_tolerance)
{
    rwedge_contact *contact = allowing(flat(0.4), 1e-3);
    assert_close(rwedge_contact_strain(contact), A / 4, 1e-15);
    assert_ok(rwedge_contact_set_strain(contact, 0.3 * A));
    contact = copy_of(contact);
    assert_close(rwedge_contact_strain(contact), 0.3 * A, 1e-15);
    assert_true(rwedge_contact_tolerance(contact) == 1e-3);
    assert_nan(rwedge_contact_strain(NULL));
    assert_nan(rwedge_contact_tolerance(NULL));
}

/* ---- Pads that are the same ---- */

/* With a moment and a tension, in closed form. */
static const rw_loads STEPS[] = {{0.2, 0.03, 0, 0},         {0.2, 0.03, 0.06, 0.002},
                                 {0.2, 0.03, -0.02, -0.01}, {0.2, 0.03, 0.01, 0},
                                 {0.3, 0.045, 0.01, 0},     {0.3, 0.045, 0.09, 0.02}};
/* P and Q change together, up and down, to full sliding and to separation. */
static const rw_loads TURNS[] = {{0.2, 0, 0, 0},     {0.2, 0, 0.04, 0},  {0.14, 0, 0.05, 0},
                                 {0.3, 0, -0.05, 0}, {0.25, 0, 0.03, 0}, {0.4, 0, -0.02, 0},
                                 {0.1, 0, 0.045, 0}, {0.1, 0, 0.05, 0},  {0.08, 0, 0.04, 0},
                                 {0.3, 0, 0.1, 0},   {0.2, 0, 0.02, 0},  {0.2, 0, 0.02, 0},
                                 {0, 0, 0, 0}};
/* A tension that lags behind Q, which is computed. */
static const rw_loads LAG[] = {
    {0.5, 0, 0, 0}, {0.5, 0, 0.02, 0.06}, {0.5, 0, 0.12, 0.02}, {0.45, 0.02, 0.05, -0.05}};

#define COUNT(array) (sizeof(array) / sizeof *(array))

/* What may not be known, but then of both. */
static void assert_alike(double actual, double expected, double relative, double absolute)
{
    if (isnan(expected))
        assert_nan(actual);
    else
        assert_within(actual, expected, relative * fabs(expected) + absolute);
}

static double known_slip(const rwedge_contact *contact, double x)
{
    double s;
    return rwedge_contact_slip(contact, 1, &x, &s) == RWEDGE_OK ? s : NAN;
}

static void assert_same_patches(const rwedge_contact *first, const rwedge_contact *second,
                                double tolerance)
{
    const rw_patch edge = edges_of(first), other = edges_of(second);
    double stick[2][2] = {{NAN, NAN}, {NAN, NAN}};
    assert_within(other.left, edge.left, 0.01 * tolerance);
    assert_within(other.right, edge.right, 0.01 * tolerance);
    assert_int_equal(rwedge_contact_stick_zone(first, &stick[0][0], &stick[0][1]),
                     rwedge_contact_stick_zone(second, &stick[1][0], &stick[1][1]));
    for (int i = 0; i < 2; i++)
        assert_alike(stick[1][i], stick[0][i], 0, 0.02 * tolerance);
    assert_int_equal(rwedge_contact_zone_count(first), rwedge_contact_zone_count(second));
    assert_alike(rwedge_contact_tilt(second), rwedge_contact_tilt(first), tolerance,
                 tolerance * THETA);
}

static void assert_same_stresses(const rwedge_contact *first, const rwedge_contact *second,
                                 double tolerance)
{
    double k[2][4], factor[2];
    for (int i = 0; i < 2; i++) {
        const rwedge_contact *contact = i ? second : first;
        assert_ok(rwedge_contact_edge_asymptotes(contact, &k[i][0], &k[i][1], &k[i][2], &k[i][3]));
        factor[i] = 0; /* its search takes long where the shear is computed */
        if (rwedge_contact_error(contact) == 0)
            assert_ok(rwedge_contact_yield_factor(contact, 0.3, 1, &factor[i], NULL, NULL));
    }
    for (int i = 0; i < 4; i++)
        assert_within(k[1][i], k[0][i], tolerance * fmax(fabs(k[0][i]), 0.1));
    assert_close(factor[1], factor[0], tolerance);
    for (double x = -2; x < 2; x += 0.17) {
        const double y = fabs(x) < 0.5 ? 0 : 0.1;
        const stresses s = stress_at(first, x, y), t = stress_at(second, x, y);
        const double norm = fmax(fabs(s.xx) + fabs(s.yy) + fabs(s.xy), THETA / A / (1 + fabs(x)));
        assert_within(apart(s, t), 0, 0.3 * tolerance * norm);
    }
}

static void assert_same(const rwedge_contact *first, const rwedge_contact *second, double tolerance)
{
    assert_alike(rwedge_contact_dissipated_energy(second), rwedge_contact_dissipated_energy(first),
                 tolerance, 0.01 * tolerance * THETA);
    if (first->loads.P == 0)
        return;
    const rw_patch edge = edges_of(first);
    assert_same_patches(first, second, tolerance);
    assert_same_stresses(first, second, tolerance);
    for (int i = 1; i < 10; i++) {
        const double x = edge.left + (edge.right - edge.left) * i / 10;
        assert_alike(known_slip(second, x), known_slip(first, x), 0, tolerance * THETA);
    }
    assert_alike(rwedge_contact_displacement(second, edge.right),
                 rwedge_contact_displacement(first, edge.right), 1e-4, 0);
}

static void assert_same_history(rwedge_contact *first, rwedge_contact *second, size_t count,
                                const rw_loads loads[], double tolerance)
{
    for (size_t i = 0; i < count; i++) {
        apply_all(first, 1, &loads[i]);
        apply_all(second, 1, &loads[i]);
        assert_same(first, second, tolerance);
    }
}

CLAIM(a_wedge_is_a_profile)
{
    const double a = 0.7, k = THETA / a, y = 0;
    const struct {
        double a;
        size_t n;
        double x[4], slope[4];
    } pads[] = {{a, 2, {-a, a}, {-THETA, THETA}},
                {a, 3, {-a, 0, a}, {-THETA, 0, THETA}},
                {a, 4, {-a, -0.2, 0.2, a}, {-THETA, -0.2 * k, 0.2 * k, THETA}},
                {0, 2, {0, 0}, {-THETA, THETA}}};
    for (int i = 0; i < 4; i++) {
        rwedge_contact *wedges[3], *profiles[3];
        for (int j = 0; j < 3; j++) {
            wedges[j] = create(pads[i].a, F);
            profiles[j] = profile(pads[i].n, pads[i].x, pads[i].slope);
        }
        assert_same_history(wedges[0], profiles[0], COUNT(STEPS), STEPS, 1e-13);
        assert_same_history(wedges[1], profiles[1], COUNT(TURNS), TURNS, 1e-12);
        allowing(wedges[2], 1e-4);
        allowing(profiles[2], 1e-4);
        assert_same_history(wedges[2], profiles[2], COUNT(LAG), LAG, 1e-7);
        assert_in_range(1e6 * rwedge_contact_error(wedges[2]), 1, 10000);
        assert_true(isfinite(rwedge_contact_dissipated_energy(wedges[2])));
        assert_true(isfinite(known_slip(wedges[2], 0.1)));
    }
    const rwedge_contact *kink =
        APPLY(profile(2, pads[3].x, pads[3].slope), {0.2, 0, 0, 0}, {0.2, 0, 0.05, 0});
    double s[3];
    assert_int_equal(rwedge_contact_stresses(kink, 1, &y, &y, &s[0], &s[1], &s[2]), RWEDGE_EDOMAIN);
}

/* The arc that ends in the middle counted on both sides. Hertz: -f x^2/(2 R) where all slides. */
CLAIM(a_profile_with_a_place_in_its_middle_slides_like_another)
{
    const double x[] = {-1, 0, 1}, slope[] = {-THETA, 0, THETA};
    rwedge_contact *pad = APPLY(profile(3, x, slope), {0.1, 0, 0, 0}, {0.1, 0, F * 0.1, 0});
    for (double at = -0.5; at < 0.6; at += 0.25)
        assert_within(slip(pad, at), -F * THETA * at * at / 2, 1e-15);
}

/* The arcs beside it, of which one is longer, are out of contact: they have no part in anything. */
CLAIM(a_pad_is_a_cylinder_where_one_arc_touches)
{
    const double x[] = {-2, -1, 1, 3, 3}, slope[] = {-0.2, -0.1, 0.1, 0.2, 0.2}, P = 0.2;
    const rw_loads loads[] = {{P, 0, 0, 0}, {P, 0, 0.05, 0}, {P, 0, -0.04, 0}};
    rwedge_contact *pad = profile(5, x, slope), *cylinder = flat(0);
    assert_same_history(cylinder, pad, 3, loads, 1e-12);
    assert_close(rw_patch_under_tilt(&pad->geometry, P, 0).right, edges_of(pad).right, 1e-14);
    const double energy = rwedge_contact_dissipated_energy(pad);
    load(pad, 0, 0);
    assert_nan(rwedge_contact_dissipated_energy(pad)); /* what slips on the way is not known */
    load(pad, P, 0);
    assert_close(rwedge_contact_dissipated_energy(pad), energy, 1e-15);
}

static const double WORN_X[] = {-1, -0.4, 0.1, 0.5, 0.8};
static const double WORN[] = {-0.1, -0.02, -0.02, 0.05, 0.12};

/* Seen in a mirror, M and Q turn and the tension does not. */
static void assert_mirrored(rwedge_contact *pad, rwedge_contact *reflected, rw_loads to,
                            double tolerance)
{
    apply(pad, to.P, to.M, to.Q, to.sigma);
    apply(reflected, to.P, -to.M, -to.Q, to.sigma);
    const rw_patch edge = edges_of(pad), mirrored = edges_of(reflected);
    assert_within(edge.left, -mirrored.right, 0.01 * tolerance);
    assert_within(edge.right, -mirrored.left, 0.01 * tolerance);
    assert_within(stick_zone_of(pad).left, -stick_zone_of(reflected).right, tolerance);
    assert_close(rwedge_contact_tilt(pad), -rwedge_contact_tilt(reflected), tolerance);
    for (double at = -1.5; at < 1.5; at += 0.21) {
        const stresses s = stress_at(pad, at, 0.03), t = stress_at(reflected, -at, 0.03);
        assert_within(s.xx, t.xx, tolerance);
        assert_within(s.xy, -t.xy, tolerance);
    }
}

CLAIM(a_mirrored_profile_mirrors_everything)
{
    double x[5], slope[5];
    for (int i = 0; i < 5; i++) {
        x[i] = -WORN_X[4 - i];
        slope[i] = -WORN[4 - i];
    }
    rwedge_contact *pad = profile(5, WORN_X, WORN), *reflected = profile(5, x, slope);
    const rw_loads closed[] = {{0.2, 0.03, 0, 0},
                               {0.2, 0.03, 0.06, 2e-4},
                               {0.2, 0.03, -0.02, -1e-3},
                               {0.2, 0.03, 0.01, 0}},
                   computed[] = {{0.1, 0, 0.01, 0.02},
                                 {0.1, 0, 0.01, 0.06},
                                 {0.1, 0, 0.04, 0.02},
                                 {0.09, 0.01, 0.02, -0.04}};
    for (int i = 0; i < 4; i++)
        assert_mirrored(pad, reflected, closed[i], 1e-12);
    load(pad, 0, 0);
    load(reflected, 0, 0);
    assert_mirrored(pad, reflected, (rw_loads){0.2, 0.3, 0, 0}, 1e-12);
    pad = allowing(profile(5, WORN_X, WORN), 1e-4);
    reflected = allowing(profile(5, x, slope), 1e-4);
    for (int i = 0; i < 4; i++)
        assert_mirrored(pad, reflected, computed[i], 2e-5);
    assert_true(rwedge_contact_error(pad) > 0 && rwedge_contact_error(pad) < 1e-2);
    const double even[] = {-1, 0, 1}, left[] = {-0.3, 0, 0.1}, right[] = {-0.1, 0, 0.3};
    const rw_patch edge = edges_of(APPLY(profile(3, even, left), {0.1, 0, 0, 0})),
                   mirrored = edges_of(APPLY(profile(3, even, right), {0.1, 0, 0, 0}));
    assert_within(edge.left, -mirrored.right, 1e-14);
    assert_within(edge.right, -mirrored.left, 1e-14);
    assert_true(fabs(edge.left + edge.right) > 0.01);
}

/* ---- What they are by themselves ---- */

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

/* The loads of the contact that is asked have no part in it. */
CLAIM(what_never_slips_is_the_same_whatever_was_before)
{
    static const rw_loads first = {0.1, 0.004, -0.02, 0}, second = {0.12, 0.005, 0.02, 0.001};
    const rwedge_contact *contacts[] = {
        flat(0.4), APPLY(flat(0.4), {0.1, 0.01, 0, 0}, {0.1, 0.01, 0.02, 0.001}),
        APPLY(flat(0.4), {0.1, 0, 0, 0}, {0.1, 0, F * 0.1, 0}),
        APPLY(allowing(flat(0.4), 1e-3), {0.5, 0, 0, 0}, {0.5, 0, 0.02, 0.06})};
    assert_true(rwedge_contact_error(contacts[3]) > 0);
    rw_patch stuck[4];
    for (int i = 0; i < 4; i++) {
        assert_ok(rwedge_contact_permanent_stick(contacts[i], first.P, first.M, first.Q,
                                                 first.sigma, second.P, second.M, second.Q,
                                                 second.sigma, &stuck[i].left, &stuck[i].right));
        assert_memory_equal(&stuck[i], &stuck[0], sizeof stuck[0]);
    }
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
        refuse(pads[i], 50, 0, 0, 0, RWEDGE_ERANGE);
        apply(pads[i], 1, 0, 0, 0);
        refuse(pads[i], 1, 12, 0, 0, RWEDGE_ERANGE);
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
    assert_int_equal(rwedge_contact_create_flat(-1, 10, A, F, &contact), RWEDGE_EDOMAIN);
    assert_int_equal(rwedge_contact_create_flat(1, 0, A, F, &contact), RWEDGE_EDOMAIN);
    assert_int_equal(rwedge_contact_create_flat(1e60, 1e60, A, F, &contact), RWEDGE_EDOMAIN);
    assert_null(contact);
    contact = profile(3, x, slope);
    assert_int_equal(rwedge_contact_beyond_flat(contact, &left, &right), RWEDGE_EABSENT);
    assert_true(rwedge_contact_tilt(contact) == 0);
    refuse(contact, 0.1, 1e30, 0, 0, RWEDGE_EDOMAIN);
    refuse(contact, 0.1, -1e30, 0, 0, RWEDGE_EDOMAIN);
}
