/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A specimen of finite thickness: rwedge_contact_set_thickness() against the whole kernel of a
 * layer, by collocation. */
#include "base/linear.h"
#include "histories.h"

enum { NODES = 60, HALF = NODES / 2, STEPS = 4000 };

/* The slope beside a force is 1/u + k(u): k(u) = int (M(x) - 1) sin(x u) dx, by Simpson's rule. */
static double beyond_half_plane(double u)
{
    static const double END = 40;
    double sum = 0;
    for (int i = 1; i < STEPS; i++) {
        const double x = END * i / STEPS, M = (cosh(2 * x) - 1) / (sinh(2 * x) + 2 * x);
        sum += (i % 2 ? 4 : 2) * (M - 1) * sin(x * u);
    }
    return sum * END / STEPS / 3;
}

/* The load at which the symmetric pad of these slopes has the half-width b, on a layer of the
 * thickness t whose share of the compliance is given. The pressure is sqrt(1 - s^2) times a
 * function that Gauss's nodes know. */
static double load_of(double (*slope)(double), double b, double t, double share)
{
    static double matrix[HALF * HALF], value[HALF];
    double weight[HALF], P = 0;
    for (int k = 0; k < HALF; k++) {
        const double x = cos(PI * (2 * k + 1) / (2. * (NODES + 1)));
        for (int i = 0; i < HALF; i++) {
            const double s = cos(PI * (i + 1) / (NODES + 1.));
            weight[i] = PI * (1 - s * s) / (NODES + 1);
            matrix[k * HALF + i] = 0;
            for (int side = -1; side <= 1; side += 2) {
                const double u = x - side * s;
                matrix[k * HALF + i] +=
                    weight[i] * (1 / u + share * (b / t) * beyond_half_plane(u * b / t));
            }
        }
        value[k] = slope(b * x);
    }
    assert_true(rw_solve(HALF, 1, matrix, value));
    for (int i = 0; i < HALF; i++)
        P += 2 * weight[i] * value[i];
    return b * P * PI / A;
}

static const double R = 10;

static double slope_of_cylinder(double x)
{
    return x / R;
}

static double slope_of_wedge(double x)
{
    return THETA * fmax(-1, fmin(1, x / 0.6));
}

static double half_width(rwedge_contact *contact, double P, double t)
{
    assert_ok(rwedge_contact_set_thickness(contact, t, P));
    load(contact, P, 0);
    return rwedge_contact_half_width(contact);
}

CLAIM(a_layer_of_no_thickness_to_speak_of_is_a_half_plane)
{
    const double b = 0.5, P = load_of(slope_of_cylinder, b, 1e6, 1);
    assert_close(P, PI * b * b / (2 * A * R), 1e-10);
    assert_close(half_width(create_flat(0, R, A, 0.5), P, 1e6), b, 1e-10);
}

/* Both bodies share the compliance, or the specimen has all of it. */
CLAIM(the_first_correction_errs_by_the_fourth_power)
{
    static const double T_OVER_B[] = {8, 4, 3, 2.1};
    for (int share = 1; share <= 2; share++)
        for (int i = 0; i < 4; i++) {
            const double b = 0.5, t = T_OVER_B[i] * b,
                         P = load_of(slope_of_cylinder, b, t, share / 2.);
            rwedge_contact *contact = create_flat(0, R, A, 0.5);
            assert_ok(rwedge_contact_set_strain(contact, share * A / 4));
            const double error = half_width(contact, P, t) / b - 1;
            assert_within(error / (share / 2. * pow(T_OVER_B[i], -4)), -0.185, 0.0165);
        }
}

/* On the flanks of a wedge the pressure has a logarithm, which costs the collocation 1e-4. */
CLAIM(a_wedge_on_a_layer_is_that_of_the_whole_kernel)
{
    const double b = 1, t = 4, P = load_of(slope_of_wedge, b, t, 0.5);
    const double thick = rwedge_half_width(THETA, 0.6, A, P) / b - 1;
    assert_within(half_width(create(0.6, 0.5), P, t) / b, 1, 8e-4);
    assert_within(thick, 0.0138, 2e-4); /* of a half-plane */
}

/* The parabola is about x = 0, where P acts: the profile with its slopes added is the same pad. */
CLAIM(a_profile_off_the_centre_has_the_parabola_too)
{
    const double x[] = {-1, 0.2, 2}, slope[] = {-0.02, 0.01, 0.05}, t = 6, P = 0.06 / A,
                 rate = 1.0420749174684513 / PI * A / 2 * P / (t * t), wide[] = {-7, -1, 0.2, 2, 8},
                 more[] = {-0.02 - 7 * rate, -0.02 - rate, 0.01 + 0.2 * rate, 0.05 + 2 * rate,
                           0.05 + 8 * rate};
    rwedge_contact *layer = create_profile(3, x, slope, 0.5),
                   *pad = create_profile(5, wide, more, 0.5);
    apply(layer, 0, 0, 0, 1); /* a tension before contact stays */
    apply(pad, 0, 0, 0, 1);
    assert_ok(rwedge_contact_set_thickness(layer, t, P));
    for (int i = 0; i < 2; i++) {
        apply(layer, P, 0, i * 0.2 * P, 1);
        apply(pad, P, 0, i * 0.2 * P, 1);
    }
    assert_close(edges_of(layer).left, edges_of(pad).left, 1e-12);
    assert_close(edges_of(layer).right, edges_of(pad).right, 1e-12);
    assert_true(fabs(edges_of(layer).right + edges_of(layer).left) > 0.01);
    assert_int_equal(rwedge_contact_kind(layer), RWEDGE_PAD_PROFILE);
}

CLAIM(a_thin_layer_is_refused_and_changes_nothing)
{
    rwedge_contact *contact = create_flat(0, R, A, 0.5);
    const double b = 0.5, P = load_of(slope_of_cylinder, b, 2 * b, 0.5);
    assert_int_equal(rwedge_contact_set_thickness(contact, 1.9 * b, P), RWEDGE_ERANGE);
    assert_int_equal(rwedge_contact_set_thickness(contact, 0, P), RWEDGE_EDOMAIN);
    assert_int_equal(rwedge_contact_set_thickness(contact, NAN, P), RWEDGE_EDOMAIN);
    assert_int_equal(rwedge_contact_set_thickness(contact, 3 * b, 0), RWEDGE_EDOMAIN);
    assert_int_equal(rwedge_contact_set_thickness(NULL, 3 * b, P), RWEDGE_ENULL);
    assert_int_equal(rwedge_contact_kind(contact), RWEDGE_PAD_CYLINDER);
    load(contact, P, 0);
    assert_int_equal(rwedge_contact_set_thickness(contact, 3 * b, P), RWEDGE_EDOMAIN);
}
