/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Unlike bodies in full sliding. Expected values: exact formulas in 30 digits by another program
 * (tests/data/sliding_unlike.csv), Hertz' contact, and quadrature of the equation that they
 * solve. */
#include "histories.h"
#include "quadrature.h"

#include <complex.h>
#include <fenv.h>

static const double F = 0.5;

static rwedge_contact *unlike(rwedge_contact *contact, double beta)
{
    assert_ok(rwedge_contact_set_beta(contact, beta));
    return contact;
}

/* A pad of the unit theta/A = 1 that slides with mu under P and M. */
static rwedge_contact *sliding(rwedge_contact *contact, double mu, double P, double M)
{
    return APPLY(unlike(contact, -mu / F), {P, M, F * P, 0});
}

static rwedge_contact *wedge(double a, double f)
{
    return create_wedge(0.01, a, 0.01, f);
}

/* ---- Values ---- */

CLAIM(wedges_have_the_reference_values)
{
    reference rows = reference_open("sliding_unlike.csv");
    while (reference_next(&rows)) {
        const double *c = rows.cell, b = 1 / c[0], m = c[3], tight = 1e-13;
        rwedge_contact *contact = sliding(wedge(1, F), c[1], c[5], c[6]);
        const rw_patch edges = edges_of(contact);
        assert_within(edges.left, m - b, tight * b);
        assert_within(edges.right, m + b, tight * b);
        assert_within(rwedge_contact_tilt(contact) / 0.01, c[4], tight);
        assert_close(pressure(contact, m - 0.6 * b), -c[7], tight);
        assert_close(pressure(contact, m), -c[8], tight);
        assert_close(pressure(contact, m + 0.5 * b), -c[9], tight);
        /* next to the edge the pressure is below its root of the distance */
        assert_within(stress_at(contact, edges.left - 1e-30 * b, 0).xx, c[10], 1e-12);
        const stresses s = stress_at(contact, m + 0.3 * b, 0.4 * b);
        assert_close(s.xx, c[11], tight);
        assert_close(s.yy, c[12], tight);
        assert_close(s.xy, c[13], tight);
    }
}

/* P = (pi/2) d^2 (1 - 4 lambda^2), the middle at -2 lambda d, without tilt; slope 1, theta/A = 1.
 */
CLAIM(a_cylinder_slides_as_hertz)
{
    for (double mu = -0.24; mu < 0.3; mu += 0.08) {
        const double lambda = atan(mu) / PI, d = 0.7;
        const double P = PI / 2 * d * d * (1 - 4 * lambda * lambda);
        rwedge_contact *contact = create_flat(0, 100, 0.01, F);
        double M = 0;
        for (int i = 0; i < 2; i++) { /* M about x = 0 of a contact that is not tilted */
            contact = sliding(create_flat(0, 100, 0.01, F), mu, P, M);
            M -= P * rwedge_contact_tilt(contact) * 100; /* a tilt rolls it along */
        }
        const rw_patch edges = edges_of(contact);
        assert_within(rwedge_contact_tilt(contact), 0, 1e-13);
        assert_within(edges.left, -2 * lambda * d - d, 1e-12);
        assert_within(edges.right, -2 * lambda * d + d, 1e-12);
    }
}

/* ---- The equation ---- */

typedef struct {
    const rwedge_contact *contact;
    double x, y, left, right, at, end;
    bool wants_imaginary;
} place;

/* N/(z - s), in u with s = end + (at - end) u^4: smooth at an edge. */
static double kernel_at(double u, void *context)
{
    const place *k = context;
    const double s = k->end + (k->at - k->end) * u * u * u * u;
    const double complex g = -pressure(k->contact, s) / (k->x + k->y * I - s) * 4 * u * u * u *
                             fabs(k->at - k->end) / PI;
    return k->wants_imaginary ? cimag(g) : creal(g);
}

/* G by quadrature from the pressure at the surface, in pieces between the edges and places. */
static double complex potential_by_quadrature(const rwedge_contact *contact, double x, double y,
                                              size_t n, const double kinks[])
{
    const rw_patch edges = edges_of(contact);
    double at[8] = {edges.left};
    size_t count = 1;
    for (size_t i = 0; i < n; i++)
        if (kinks[i] > at[count - 1] && kinks[i] < edges.right)
            at[count++] = kinks[i];
    at[count++] = edges.right;
    double complex sum = 0;
    const double ends[] = {0, 1};
    for (size_t i = 0; i + 1 < count; i++)
        for (int half = 0; half < 2; half++) {
            place k = {contact, x, y, 0, 0, (at[i] + at[i + 1]) / 2, at[i + (size_t)half], false};
            sum += integral(kernel_at, &k, 1, ends);
            k.wants_imaginary = true;
            sum += I * integral(kernel_at, &k, 1, ends);
        }
    return sum;
}

/* Stresses of Flamant: mean = Im G - f Re G, and y G' from neighbours. */
static void assert_field(const rwedge_contact *contact, double f, double x, double y, size_t n,
                         const double kinks[])
{
    const double unit = rw_unit_stress(&contact->geometry), h = 1e-3 * y;
    const double complex G = potential_by_quadrature(contact, x, y, n, kinks) / unit,
                         more = potential_by_quadrature(contact, x + h, y, n, kinks) / unit,
                         less = potential_by_quadrature(contact, x - h, y, n, kinks) / unit;
    const double complex H = y * (more - less) / (2 * h);
    const stresses s = stress_at(contact, x, y);
    assert_within((s.xx + s.yy) / 2 / unit, cimag(G) - f * creal(G), 1e-10);
    assert_within((s.yy - s.xx) / 2 / unit, f * creal(G) - f * cimag(H) - creal(H), 1e-5);
    assert_within(s.xy / unit, f * cimag(G) + f * creal(H) - cimag(H), 1e-5);
}

static const double KINKS[] = {-1, -0.2, 0.3, 0.5, 1.4}, SLOPES[] = {-0.02, -0.004, 0, 0, 0.03};

/* A flat pad; an asymmetric profile; a tip much smaller than the contact, near and far from it. */
CLAIM(stresses_are_those_of_the_tractions)
{
    for (double mu = -0.24; mu < 0.3; mu += 0.24) {
        const double corners[] = {-0.5, 0.5}, tip[] = {-1e-3, 1e-3};
        const rwedge_contact *flat = sliding(create_flat(0.5, 100, 0.01, F), mu, 0.02, 0.003),
                             *any = sliding(create_profile(5, KINKS, SLOPES, F), mu, 0.02, 0.001),
                             *sharp = sliding(wedge(1e-3, F), mu, 1, 0.02);
        for (double x = -1.4; x < 1.5; x += 0.35) {
            assert_field(flat, F, x, 0.3, 2, corners);
            assert_field(any, F, x, 0.2, 5, KINKS);
            assert_field(sharp, F, x, 0.1, 2, tip);
        }
        assert_field(sharp, F, 2e-3, 1e-3, 2, tip);
        assert_field(flat, F, 6, 3, 2, corners); /* the series far away */
    }
}

/* (1/pi) PV int N/(x - s) ds - mu N = slope - tilt: Re G of the stresses is the first term. */
CLAIM(the_equation_of_sliding_holds)
{
    for (int i = -2; i <= 2; i++) {
        const double mu = 0.12 * i;
        const rwedge_contact *flat = sliding(create_flat(0.5, 100, 0.01, F), mu, 0.02, 0.002);
        const rw_patch edges = edges_of(flat);
        for (double x = edges.left + 0.01; x < edges.right; x += 0.1) {
            const stresses s = stress_at(flat, x, 0); /* sxx = p - 2 f Re G */
            const double slope = (fabs(x) > 0.5 ? copysign(fabs(x) - 0.5, x) : 0) / 100;
            const double principal = (s.yy - s.xx) / 2 / F;
            assert_within(0.01 * (principal + mu * s.yy), slope - rwedge_contact_tilt(flat), 1e-13);
        }
    }
}

typedef struct {
    const rwedge_contact *contact;
    double end, other;
    bool wants_moment;
} share;

static double load_at(double u, void *context)
{
    const share *k = context;
    const double x = k->end + (k->other - k->end) * u * u * u * u;
    return -pressure(k->contact, x) * 4 * u * u * u * fabs(k->other - k->end) *
           (k->wants_moment ? x : 1);
}

CLAIM(the_pressure_carries_load_and_moment)
{
    for (double mu = -0.24; mu < 0.3; mu += 0.16)
        for (int moment = 0; moment < 2; moment++) {
            const rwedge_contact *any =
                sliding(create_profile(5, KINKS, SLOPES, F), mu, 0.02, 0.004);
            const rw_patch edges = edges_of(any);
            double at[6] = {edges.left}, sum = 0;
            int count = 1;
            for (int i = 0; i < 5; i++)
                if (KINKS[i] > edges.left && KINKS[i] < edges.right)
                    at[count++] = KINKS[i];
            at[count] = edges.right;
            const double ends[] = {0, 1};
            for (int i = 0; i < count; i++)
                for (int side = 0; side < 2; side++) {
                    const share k = {any, at[i + side], (at[i] + at[i + 1]) / 2, moment};
                    sum += integral(load_at, &k, 1, ends);
                }
            assert_close(sum, moment ? 0.004 : 0.02, 1e-11);
        }
}

/* 2 f (theta/A) |slope - tilt| at the trailing edge, whatever mu is. */
CLAIM(the_edge_has_the_tension_of_similar_bodies)
{
    for (double mu = -0.24; mu < 0.3; mu += 0.12) {
        const rwedge_contact *contact = sliding(wedge(0.2, F), mu, 2, 0.3);
        const double left = edges_of(contact).left;
        assert_true(left < -0.2);
        assert_within(stress_at(contact, left * (1 + 1e-15), 0).xx,
                      2 * F * (1 + rwedge_contact_tilt(contact) / 0.01), 1e-5);
    }
}

/* ---- Symmetry and limits ---- */

CLAIM(the_mirror_image_slides_the_other_way)
{
    for (double M = -0.2; M < 0.3; M += 0.2) {
        rwedge_contact *here = APPLY(unlike(wedge(0.3, F), -0.25), {1.3, M, F * 1.3, 0}),
                       *there = APPLY(unlike(wedge(0.3, F), -0.25), {1.3, -M, -F * 1.3, 0});
        const rw_patch a = edges_of(here), b = edges_of(there);
        assert_within(a.left, -b.right, 1e-14);
        assert_within(a.right, -b.left, 1e-14);
        assert_within(rwedge_contact_tilt(here), -rwedge_contact_tilt(there), 1e-16);
        for (double x = -1.5; x < 1.6; x += 0.25)
            for (double y = 0; y < 1; y += 0.24) {
                const stresses s = stress_at(here, x, y), t = stress_at(there, -x, y);
                assert_within(s.xx, t.xx, 1e-12);
                assert_within(s.yy, t.yy, 1e-12);
                assert_within(s.xy, -t.xy, 1e-12);
            }
    }
}

/* With the bodies' roles exchanged and Q turned round the pressure is the same. */
CLAIM(the_opposite_pair_has_the_pressure_of_the_opposite_shear)
{
    rwedge_contact *here = APPLY(unlike(wedge(0.3, F), -0.25), {1.3, 0.2, F * 1.3, 0}),
                   *there = APPLY(unlike(wedge(0.3, F), 0.25), {1.3, 0.2, -F * 1.3, 0});
    for (double x = -1.5; x < 1.6; x += 0.25) {
        assert_within(pressure(here, x), pressure(there, x), 1e-15);
        assert_within(shear(here, x), -shear(there, x), 1e-15);
    }
}

CLAIM(similar_bodies_are_the_limit)
{
    const rw_loads slides = {1, 0.1, F, 0};
    rwedge_contact *similar = APPLY(wedge(0.3, F), slides),
                   *nearly = APPLY(unlike(wedge(0.3, F), 1e-9), slides);
    assert_within(edges_of(similar).left, edges_of(nearly).left, 2e-9);
    for (double x = -1.5; x < 1.6; x += 0.25)
        for (double y = 0; y < 1; y += 0.24) {
            const stresses s = stress_at(similar, x, y), t = stress_at(nearly, x, y);
            assert_within(s.xx, t.xx, 3e-8);
            assert_within(s.yy, t.yy, 3e-8);
            assert_within(s.xy, t.xy, 3e-8);
        }
}

/* Not a bit changes where beta or friction is 0. */
CLAIM(without_coupling_all_is_as_before)
{
    const rw_loads loads[] = {{1, 0, 0, 0}, {1, 0, 0.3, 0}, {1.2, 0, 0.1, 0}};
    rwedge_contact *plain = apply_all(wedge(0.3, F), 3, loads),
                   *set = apply_all(unlike(wedge(0.3, F), 0), 3, loads);
    assert_state(set, state_of(plain));
    rwedge_contact *smooth = APPLY(wedge(0.3, 0), {1, 0.1, 0, 0}),
                   *other = APPLY(unlike(wedge(0.3, 0), 0.2), {1, 0.1, 0, 0});
    const stresses s = stress_at(smooth, 0.2, 0.1), t = stress_at(other, 0.2, 0.1);
    assert_memory_equal(&s, &t, sizeof s);
}

/* Near and far, at an edge and next to it, at the ends of the rounding, on the surface. */
static void points_of_all_kinds(int n, const double marks[4], double x[], double y[])
{
    uint64_t seed = 5;
    for (int i = 0; i < n; i++) {
        const double r = pow(10, random_between(&seed, -17, i % 9 == 0 ? 40 : 0.5));
        const double angle = random_between(&seed, 0, PI);
        x[i] = marks[i % 4] + (i % 11 == 0 ? 0 : r * cos(angle));
        y[i] = i % 11 == 0 || i % 7 == 0 ? 0 : r * sin(angle);
    }
}

/* For every length, and without an exception on which a host may trap. */
CLAIM(arrays_have_the_bits_of_single_points)
{
    enum { N = 75 };
    for (double a = 1e-3; a < 2; a *= 5)
        for (double mu = -0.2; mu < 0.3; mu += 0.4) {
            const rwedge_contact *contact = sliding(wedge(a, F), mu, 1, 0.05);
            const rw_patch edges = edges_of(contact);
            double x[N], y[N], xx[N], yy[N], xy[N];
            points_of_all_kinds(N, (double[]){edges.left, -a, a, edges.right}, x, y);
            for (size_t n = 1; n < N; n += n < 10 ? 1 : 16) {
                feclearexcept(FE_ALL_EXCEPT);
                assert_ok(rwedge_contact_stresses(contact, n, x, y, xx, yy, xy));
                assert_int_equal(fetestexcept(FE_INVALID | FE_DIVBYZERO | FE_OVERFLOW), 0);
                for (size_t i = 0; i < n; i++) {
                    const stresses of_array = {xx[i], yy[i], xy[i]},
                                   alone = stress_at(contact, x[i], y[i]);
                    assert_memory_equal(&of_array, &alone, sizeof alone);
                }
            }
        }
}

/* ---- What such a contact does ---- */

CLAIM(loads_that_do_not_slide_are_refused)
{
    rwedge_contact *contact = unlike(wedge(0.3, F), 0.2);
    refuse(contact, 1, 0, 0.2, 0, RWEDGE_EPATH);
    apply(contact, 1, 0, F, 0);
    refuse(contact, 1, 0, 0.2, 0, RWEDGE_EPATH);
    refuse(contact, 2, 0, 0, 0.1, RWEDGE_EPATH);
    refuse(contact, 1, 0, 0.6, 0, RWEDGE_ESLIDING);
    apply(contact, 2, 0.1, -2 * F, 0.3);
    double x = 0, value = 7, other, left, right;
    assert_int_equal(rwedge_contact_slip(contact, 1, &x, &value), RWEDGE_EPATH);
    assert_true(value == 7);
    assert_nan(rwedge_contact_dissipated_energy(contact));
    assert_nan(rwedge_contact_displacement(contact, 10));
    assert_int_equal(rwedge_contact_edge_asymptotes(contact, &x, &value, &left, &right),
                     RWEDGE_EABSENT);
    assert_int_equal(
        rwedge_contact_permanent_stick(contact, 1, 0, 0.1, 0, 1, 0, 0, 0, &left, &right),
        RWEDGE_EPATH);
    assert_int_equal(rwedge_contact_set_beta(contact, 0.1), RWEDGE_EDOMAIN);
    assert_int_equal(rwedge_contact_stick_zone(contact, &value, &other), RWEDGE_EABSENT);
    apply(contact, 0, 0, 0, 0);
    assert_ok(rwedge_contact_set_beta(contact, 0));
    apply(contact, 1, 0, 0.2, 0);
    assert_true(rwedge_contact_dissipated_energy(contact) >= 0);
}

CLAIM(a_state_is_restored_to_the_bit)
{
    rwedge_contact *contact = APPLY(unlike(create_flat(0.5, 100, 0.01, F), 0.2),
                                    {0.02, 0.001, 0.01, 0}, {0.03, 0, -0.015, 0.2});
    rwedge_contact *again = restored(state_of(contact)), *same = copy_of(contact);
    assert_true(rwedge_contact_beta(again) == 0.2);
    for (int i = 0; i < 2; i++) {
        const rwedge_contact *other = i == 0 ? again : same;
        const stresses s = stress_at(contact, 0.3, 0.2), t = stress_at(other, 0.3, 0.2);
        assert_memory_equal(&s, &t, sizeof s);
    }
    apply(contact, 0.01, 0, 0.005, 0);
    apply(again, 0.01, 0, 0.005, 0);
    assert_state(again, state_of(contact));
}

CLAIM(a_cycle_has_the_stresses_of_its_loads)
{
    const double P[] = {1, 1.5, 1}, M[] = {0, 0.1, 0}, Q[] = {-F, 1.5 * F, F},
                 sigma[] = {0, 0.3, 0};
    const double x[] = {-1.2, 0.1, 2}, y[] = {0, 0.3, 1};
    rwedge_contact *contact = unlike(wedge(0.3, F), -0.2);
    rwedge_cycle *cycle;
    assert_ok(rwedge_cycle_create(contact, 3, P, M, Q, sigma, &cycle));
    double xx[9], yy[9], xy[9], history[9];
    assert_ok(rwedge_cycle_stresses(cycle, 3, 3, x, y, xx, yy, xy));
    assert_int_equal(rwedge_cycle_friction(cycle, 3, x, history, history, history, history),
                     RWEDGE_EPATH);
    rwedge_cycle_destroy(cycle);
    assert_ok(rwedge_contact_stress_history(copy_of(contact), 3, P, M, Q, sigma, 3, x, y, history,
                                            yy, xy));
    assert_memory_equal(xx, history, sizeof xx);
    for (int i = 0; i < 3; i++) {
        apply(contact, P[i], M[i], Q[i], sigma[i]);
        for (int j = 0; j < 3; j++) {
            const stresses s = stress_at(contact, x[j], y[j]);
            assert_memory_equal(&s.xx, &xx[3 * i + j], sizeof s.xx);
        }
    }
}

CLAIM(bodies_set_beta_and_strain)
{
    const double compliance = rwedge_compliance(72e3, 0.33, 210e3, 0.3);
    rwedge_contact *contact = create_wedge(0.01, 1, compliance, F),
                   *other = create_wedge(0.01, 1, 1.01 * compliance, F);
    assert_ok(rwedge_contact_set_bodies(contact, 72e3, 0.33, 210e3, 0.3));
    assert_true(rwedge_contact_beta(contact) == rwedge_dundurs_beta(72e3, 0.33, 210e3, 0.3));
    assert_close(rwedge_contact_strain(contact), (1 - 0.33 * 0.33) / 72e3, 1e-15);
    assert_int_equal(rwedge_contact_set_bodies(other, 72e3, 0.33, 210e3, 0.3), RWEDGE_EDOMAIN);
    assert_int_equal(rwedge_contact_set_bodies(contact, 72e3, 0.7, 210e3, 0.3), RWEDGE_EDOMAIN);
    assert_int_equal(rwedge_contact_set_beta(contact, 0.6), RWEDGE_EDOMAIN);
    assert_int_equal(rwedge_contact_set_beta(contact, NAN), RWEDGE_EDOMAIN);
    assert_int_equal(rwedge_contact_set_beta(NULL, 0), RWEDGE_ENULL);
}

/* ---- Strength ---- */

static double J2_at(const rwedge_contact *contact, double nu, double x, double y)
{
    const stresses s = stress_at(contact, x, y);
    const double von_mises = rwedge_von_mises(s.xx, s.yy, s.xy, nu);
    return von_mises * von_mises / 3;
}

/* The factor is that of the stress at its place, and no place of a fine grid has a higher one. */
CLAIM(the_yield_factor_is_of_the_highest_place)
{
    for (double mu = -0.2; mu < 0.3; mu += 0.2)
        for (double a = 0.05; a < 1; a *= 4) {
            const rwedge_contact *contact = sliding(wedge(a, F), mu, 2, 0);
            double factor, at_x, at_y, most = 0;
            assert_ok(rwedge_contact_yield_factor(contact, 0.3, 1, &factor, &at_x, &at_y));
            assert_close(1 / sqrt(J2_at(contact, 0.3, at_x, at_y)), factor, 1e-12);
            for (int i = -150; i <= 150; i++)
                for (int j = 0; j <= 40; j++)
                    most = fmax(most, J2_at(contact, 0.3, i * i * i / 2e6, j * j / 1000.0));
            assert_true(most * factor * factor <= 1 + 1e-12);
        }
}

/* The first yield is below shakedown; at a depth the path of the pass lies in a ball that is no
 * larger than that of the factor. */
CLAIM(the_shakedown_factor_is_above_first_yield)
{
    for (double mu = -0.2; mu < 0.3; mu += 0.2)
        for (double a = 0.05; a < 1; a *= 4) {
            rwedge_contact *contact = sliding(wedge(a, 0.5), mu, 2, 0);
            double yields, shakes, y, mirrored;
            assert_ok(rwedge_contact_yield_factor(contact, 0.3, 1, &yields, NULL, NULL));
            assert_ok(rwedge_contact_shakedown_factor(contact, 0.3, 1, &shakes, &y));
            assert_true(shakes > yields && shakes < 2 * yields);
            contact = APPLY(unlike(wedge(a, F), -mu / F), {2, 0, -2 * F, 0});
            assert_ok(rwedge_contact_shakedown_factor(contact, 0.3, 1, &mirrored, &y));
            assert_close(mirrored, shakes, 1e-9);
        }
}

CLAIM(the_largest_pressure_is_at_its_place)
{
    for (double mu = -0.2; mu < 0.3; mu += 0.1) {
        const rwedge_contact *contact = sliding(wedge(0.3, F), mu, 2, 0);
        double most, x;
        assert_ok(rwedge_contact_peak_pressure(contact, &most, &x));
        assert_close(pressure(contact, x), -most, 1e-14);
        for (double at = -1; at < 1; at += 0.001)
            assert_true(-pressure(contact, at) <= most * (1 + 1e-12));
    }
}

/* A held pad keeps its tilt whichever way it slides; the loads tell the moment that holds it. */
CLAIM(a_held_pad_keeps_its_tilt)
{
    rwedge_contact *held = unlike(wedge(0.3, F), -0.25);
    assert_ok(rwedge_contact_set_rotation(held, 1));
    for (int way = -1; way <= 1; way += 2) {
        apply(held, 1.3, 7, way * F * 1.3, 0);
        double P, M, Q, sigma;
        assert_true(rwedge_contact_tilt(held) == 0);
        assert_ok(rwedge_contact_loads(held, &P, &M, &Q, &sigma));
        rwedge_contact *free = APPLY(unlike(wedge(0.3, F), -0.25), {1.3, M, way * F * 1.3, 0});
        assert_within(rwedge_contact_tilt(free), 0, 1e-16);
        assert_within(edges_of(free).left, edges_of(held).left, 1e-14);
        assert_true(way * M < -0.05); /* the contact swings to the trailing edge */
        assert_state(restored(state_of(held)), state_of(held));
    }
    assert_ok(rwedge_contact_guide(held, 1.3, 2e-3, F * 1.3, 0));
    assert_close(rwedge_contact_tilt(held), 2e-3, 1e-14);
    const rw_patch edges = edges_of(held);
    assert_close(stress_at(held, edges.left * (1 + 1e-15), 0).xx, 2 * F * (1 + 0.2), 1e-5);
}
