/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The fully worn pad. Its wear step by step is in tests/proof/test_worn_pad.c. */
#include "histories.h"
#include "quadrature.h"

typedef struct {
    double left, right, worn_left, worn_right, area;
} worn;

static worn worn_of(const rwedge_contact *contact, double Q_a)
{
    worn w = {0};
    assert_ok(rwedge_contact_worn_zone(contact, Q_a, &w.left, &w.right, &w.worn_left, &w.worn_right,
                                       &w.area));
    return w;
}

static double pressure_left(const rwedge_contact *contact, double Q_a, double x)
{
    double depth, p;
    assert_ok(rwedge_contact_full_wear(contact, Q_a, 1, &x, &depth, &p));
    return p;
}

static double depth_left(const rwedge_contact *contact, double Q_a, double x)
{
    double depth, p;
    assert_ok(rwedge_contact_full_wear(contact, Q_a, 1, &x, &depth, &p));
    return depth;
}

/* The reference has theta = A = a = 1, f = 0.5. */
CLAIM(the_worn_wedge_is_the_reference_values)
{
    reference rows = reference_open("full_wear.csv");
    while (reference_next(&rows)) {
        const double *c = rows.cell, P = c[0], Q_a = c[1] * 0.5 * P;
        rwedge_contact *contact = NULL;
        assert_ok(rwedge_contact_create(1, 1, 1, 0.5, &contact));
        assert_ok(rwedge_contact_load(contact, P, 0));
        const worn w = worn_of(contact, Q_a);
        double depth, x;
        assert_close(w.right, c[3], 1e-10);
        assert_close(w.left, -c[3], 1e-10);
        assert_close(-pressure_left(contact, Q_a, 0), c[5], 1e-10);
        assert_close(-pressure_left(contact, Q_a, c[3] / 2), c[6], 1e-10);
        assert_ok(rwedge_contact_deepest_wear(contact, Q_a, &depth, &x));
        assert_close(depth, c[7], 1e-10);
        assert_close(x, c[8], 1e-7); /* a top is flat */
        assert_close(depth_left(contact, Q_a, c[8]), c[7], 1e-10);
        assert_close(w.worn_right, c[9], 1e-10);
        assert_close(w.worn_left, -c[9], 1e-10);
        assert_close(w.area, 2 * c[10], 1e-10);
        assert_true(depth_left(contact, Q_a, 1.001 * c[9]) == 0);
        rwedge_contact_destroy(contact);
    }
}

/* ---- Off the centre ---- */

typedef struct {
    const rwedge_contact *contact;
    double Q_a, left, right, at;
} view;

/* By the angle of the zone, which takes away the root at its edges. */
static double place_at(const view *v, double angle)
{
    return (v->left + v->right) / 2 + (v->right - v->left) / 2 * sin(angle);
}

static double weight_at(const view *v, double angle)
{
    return (v->right - v->left) / 2 * cos(angle);
}

static double load_by_angle(double angle, void *of)
{
    const view *v = of;
    return -pressure_left(v->contact, v->Q_a, place_at(v, angle)) * weight_at(v, angle);
}

static double sinking_by_angle(double angle, void *of)
{
    const view *v = of;
    return load_by_angle(angle, of) / (v->at - place_at(v, angle));
}

static double by_quadrature(const view *v, integrand f)
{
    const double ends[] = {-PI / 2, -PI / 4, 0, PI / 4, PI / 2};
    return integral(f, v, 4, ends);
}

/* A rounded wedge and an asymmetric pad under a moment. */
static rwedge_contact *tilted(int which)
{
    rwedge_contact *contact = NULL;
    const double x[] = {-3, -1, -0.2, 0.1, 0.9, 4}, slope[] = {-0.5, -0.1, 0, 0, 0.05, 0.6};
    if (which == 0)
        assert_ok(rwedge_contact_create(0.2, 1, 0.1, 0.5, &contact));
    else
        assert_ok(rwedge_contact_create_profile(6, x, slope, 0.1, 0.5, &contact));
    assert_ok(rwedge_contact_apply(contact, 3, 0.7, 0, 0));
    return contact;
}

static double slope_of(int which, double x)
{
    const double places[] = {-3, -1, -0.2, 0.1, 0.9, 4}, slopes[] = {-0.5, -0.1, 0, 0, 0.05, 0.6};
    if (which == 0)
        return 0.2 * fmax(-1, fmin(1, x));
    for (int i = 0; i < 5; i++)
        if (x < places[i + 1])
            return slopes[i] +
                   (x - places[i]) / (places[i + 1] - places[i]) * (slopes[i + 1] - slopes[i]);
    return NAN;
}

/* What overlaps beside the zone has the slope of the pad, tilted, less that of the surface under
 * the pressure: A/pi times its integral over x - s. */
CLAIM(beside_the_zone_the_surface_is_that_of_the_pressure_that_is_left)
{
    for (int which = 0; which < 2; which++) {
        rwedge_contact *contact = tilted(which);
        const double Q_a = 0.9, tilt = rwedge_contact_tilt(contact), step = 1e-4;
        const worn w = worn_of(contact, Q_a);
        view v = {contact, Q_a, w.left, w.right, 0};
        assert_close(by_quadrature(&v, load_by_angle), 3, 1e-9);
        assert_true(fabs(w.left + w.right) > 0.01 * (w.right - w.left));
        for (int i = 1; i < 10; i++) {
            const double share = i / 10., x = i % 2 ? w.right + share * (w.worn_right - w.right)
                                                    : w.left - share * (w.left - w.worn_left);
            const double change =
                (depth_left(contact, Q_a, x + step) - depth_left(contact, Q_a, x - step)) /
                (2 * step);
            v.at = x;
            assert_within(
                change, 0.1 / PI * by_quadrature(&v, sinking_by_angle) - slope_of(which, x) + tilt,
                2e-5);
        }
        rwedge_contact_destroy(contact);
    }
}

CLAIM(the_zone_is_what_never_slips_under_constant_loads)
{
    for (int which = 0; which < 2; which++) {
        rwedge_contact *contact = tilted(which);
        double left, right;
        assert_ok(rwedge_contact_permanent_stick(contact, 3, 0.7, -0.9, 0, 3, 0.7, 0.9, 0, &left,
                                                 &right));
        const worn w = worn_of(contact, 0.9);
        assert_close(w.left, left, 1e-12);
        assert_close(w.right, right, 1e-12);
        rwedge_contact_destroy(contact);
    }
}

/* Both edges just stick: next to them the pressure times f is Q_a/(pi root). With the moment held
 * in place of the tilt this would hold at none of them. */
CLAIM(at_both_edges_friction_is_just_enough)
{
    rwedge_contact *contact = tilted(0);
    const double Q_a = 0.9, f = 0.5;
    const worn w = worn_of(contact, Q_a);
    const double width = w.right - w.left;
    for (int side = 0; side < 2; side++) {
        const double from_edge = 1e-5 * width, x = side ? w.right - from_edge : w.left + from_edge;
        const double shear = Q_a / (PI * sqrt(from_edge * (width - from_edge)));
        assert_close(-f * pressure_left(contact, Q_a, x), shear, 1e-3);
        assert_true(-f * pressure_left(contact, Q_a, x) > shear);
    }
    rwedge_contact_destroy(contact);
}

CLAIM(the_mirrored_pad_wears_as_the_mirror_image)
{
    const double x[] = {-3, -1, -0.2, 0.1, 0.9, 4}, slope[] = {-0.5, -0.1, 0, 0, 0.05, 0.6};
    double mirrored[6], mirrored_slope[6], depth[2], at[2];
    for (int i = 0; i < 6; i++) {
        mirrored[i] = -x[5 - i];
        mirrored_slope[i] = -slope[5 - i];
    }
    rwedge_contact *contact = tilted(1), *mirror = NULL;
    assert_ok(rwedge_contact_create_profile(6, mirrored, mirrored_slope, 0.1, 0.5, &mirror));
    assert_ok(rwedge_contact_apply(mirror, 3, -0.7, 0, 0));
    const worn w = worn_of(contact, 0.9), m = worn_of(mirror, 0.9);
    assert_close(w.worn_left, -m.worn_right, 1e-12);
    assert_close(w.worn_right, -m.worn_left, 1e-12);
    assert_close(w.area, m.area, 1e-11);
    assert_ok(rwedge_contact_deepest_wear(contact, 0.9, &depth[0], &at[0]));
    assert_ok(rwedge_contact_deepest_wear(mirror, 0.9, &depth[1], &at[1]));
    assert_close(depth[0], depth[1], 1e-12);
    assert_close(at[0], -at[1], 1e-6);
    rwedge_contact_destroy(contact);
    rwedge_contact_destroy(mirror);
}

/* The area by quadrature of the depth, for pads with corners inside and outside the zone. */
static double depth_by_place(double x, void *of)
{
    const view *v = of;
    return depth_left(v->contact, v->Q_a, x);
}

CLAIM(the_area_is_the_integral_of_the_depth)
{
    for (int which = 0; which < 2; which++)
        for (double Q_a = 0.02; Q_a < 1.5; Q_a *= 4) {
            rwedge_contact *contact = tilted(which);
            const worn w = worn_of(contact, Q_a);
            const view v = {contact, Q_a, w.left, w.right, 0};
            double ends[16] = {w.worn_left, w.left}, corners[] = {-1, -0.2, 0.1, 0.9, 1};
            size_t n = 2;
            for (int i = 0; i < 5; i++)
                if (corners[i] > w.worn_left && corners[i] < w.left)
                    ends[n++] = corners[i];
            const double left = integral(depth_by_place, &v, n - 1, ends);
            n = 2;
            ends[0] = w.right, ends[1] = w.worn_right;
            for (int i = 0; i < 5; i++)
                if (corners[i] > w.right && corners[i] < w.worn_right)
                    ends[n++] = corners[i];
            assert_close(left + integral(depth_by_place, &v, n - 1, ends), w.area, 1e-10);
            rwedge_contact_destroy(contact);
        }
}

CLAIM(without_a_range_of_Q_nothing_wears)
{
    rwedge_contact *contact = tilted(0);
    double left, right, depth, p, q, x;
    assert_ok(rwedge_contact_edges(contact, &left, &right));
    const worn w = worn_of(contact, 0);
    assert_true(w.left == left && w.worn_left == left && w.right == right && w.area == 0);
    x = left;
    assert_ok(rwedge_contact_full_wear(contact, 0, 1, &x, &depth, &p));
    assert_true(p == 0 && depth == 0);
    x = (left + right) / 2;
    assert_ok(rwedge_contact_full_wear(contact, 0, 1, &x, &depth, &p));
    assert_ok(rwedge_contact_tractions(contact, 1, &x, &left, &q));
    assert_true(p == left && depth == 0);
    rwedge_contact_destroy(contact);
}

CLAIM(what_slides_or_is_apart_or_not_known_is_refused)
{
    rwedge_contact *contact = tilted(1), *apart = NULL;
    double l = 7, r = 7, wl = 7, wr = 7, area = 7;
    const worn w = worn_of(contact, 0.9);
    assert_int_equal(rwedge_contact_worn_zone(contact, 1.5, &l, &r, &wl, &wr, &area),
                     RWEDGE_ESLIDING);
    assert_int_equal(rwedge_contact_worn_zone(contact, -1, &l, &r, &wl, &wr, &area),
                     RWEDGE_EDOMAIN);
    assert_int_equal(rwedge_contact_worn_zone(contact, 1, &l, &r, &wl, &wr, NULL), RWEDGE_ENULL);
    assert_int_equal(rwedge_contact_deepest_wear(contact, 1, NULL, &l), RWEDGE_ENULL);
    assert_int_equal(rwedge_contact_deepest_wear(contact, 2, &l, &r), RWEDGE_ESLIDING);
    assert_int_equal(rwedge_contact_full_wear(contact, 2, 0, NULL, NULL, NULL), RWEDGE_ESLIDING);
    assert_int_equal(rwedge_contact_full_wear(contact, 1, 1, &w.left, NULL, &r), RWEDGE_ENULL);
    assert_int_equal(rwedge_contact_full_wear(contact, 0.9, 1, &w.left, &l, &r), RWEDGE_EDOMAIN);
    assert_int_equal(rwedge_contact_full_wear(contact, 0.9, 1, &w.right, &l, &r), RWEDGE_EDOMAIN);
    assert_ok(rwedge_contact_create(0.2, 0, 0.1, 0.5, &apart));
    assert_int_equal(rwedge_contact_worn_zone(apart, 0, &l, &r, &wl, &wr, &area), RWEDGE_EABSENT);
    assert_ok(rwedge_contact_load(apart, 3, 0)); /* a sharp wedge */
    const double apex = 0;
    assert_int_equal(rwedge_contact_full_wear(apart, 0.9, 1, &apex, &l, &r), RWEDGE_EDOMAIN);
    assert_true(l == 7 && r == 7 && wl == 7 && wr == 7 && area == 7);
    rwedge_contact_destroy(contact);
    rwedge_contact_destroy(apart);
    rwedge_contact *flat = NULL; /* known as far as its radius */
    assert_ok(rwedge_contact_create_flat(1, 1, 1e-3, 0.5, &flat));
    assert_ok(rwedge_contact_load(flat, 2000, 0)); /* to 1.9; it would wear beyond 2 */
    assert_int_equal(rwedge_contact_worn_zone(flat, 990, &l, &r, &wl, &wr, &area), RWEDGE_ERANGE);
    rwedge_contact_destroy(flat);
}
