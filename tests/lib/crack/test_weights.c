/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Stress intensities of a crack at the surface, against closed forms, energy and another rule. */
#include "crack/weights.h"
#include "histories.h"
#include "quadrature.h"

#include <stdlib.h>

/* The weights of an angle, to the end of the claim. */
typedef struct {
    double angle;
    size_t m;
    double *place, *normal[2], *shear[2]; /* of K_I and of K_II */
} crack;

static crack crack_at(double degrees)
{
    crack c = {.angle = degrees * PI / 180};
    c.m = rwedge_crack_points(c.angle);
    c.place = malloc(5 * c.m * sizeof *c.place);
    assert_non_null(c.place);
    free_after_claim(c.place, free);
    for (size_t mode = 0; mode < 2; mode++) {
        c.normal[mode] = c.place + (1 + 2 * mode) * c.m;
        c.shear[mode] = c.normal[mode] + c.m;
    }
    assert_ok(rwedge_crack_weights(c.angle, c.m, c.place, c.normal[0], c.shear[0], c.normal[1],
                                   c.shear[1]));
    return c;
}

/* A stress on the line at the distance r from the mouth, in the length of the crack. */
typedef double (*stress_on_line)(double r, double context);

static double weighted(const crack *c, const double weight[], stress_on_line stress, double context)
{
    double sum = 0;
    for (size_t k = 0; k < c->m; k++)
        sum += weight[k] * stress(c->place[k], context);
    return sum;
}

static double uniform(double r, double value)
{
    (void)r;
    return value;
}

/* K/(sigma sqrt(pi l)) under a tension along the surface. */
static void under_tension(const crack *c, double K[2])
{
    const double across = cos(c->angle) * cos(c->angle), along = cos(c->angle) * sin(c->angle);
    for (size_t mode = 0; mode < 2; mode++)
        K[mode] = (weighted(c, c->normal[mode], uniform, across) +
                   weighted(c, c->shear[mode], uniform, along)) /
                  sqrt(PI);
}

/* From a rule of Legendre polynomials on panels, and the density at the tip. At 75 degrees that
 * errs by 6e-10. */
CLAIM(tension_along_the_surface_gives_what_another_rule_gives)
{
    static const double known[][4] = {
        {0, 1.1215222552310553, 0, 1e-14},
        {15, 1.06854607829572, 0.17380745173783, 2e-13},
        {30, 0.92009953782828, 0.30579996049594, 2e-13},
        {45, 0.70491015402640, 0.36449119122272, 1e-12},
        {60, 0.462430743937, 0.336139802095, 1e-9},
        {75, 0.2317288369, 0.2260879580, 1e-6},
    };
    for (size_t i = 0; i < sizeof known / sizeof *known; i++)
        for (int side = -1; side <= 1; side += 2) {
            const crack c = crack_at(side * known[i][0]);
            double K[2];
            under_tension(&c, K);
            assert_within(K[0], known[i][1], known[i][3]);
            assert_within(K[1], side * known[i][2], known[i][3]);
        }
}

/* ln(1 - h^2/sinh^2(pi h/2))/((1+q)^2 + h^2) */
static double wiener_hopf(double h, void *q)
{
    const double ratio = h / sinh(PI * h / 2), reach = 1 + *(const double *)q;
    return log1p(-ratio * ratio) / (reach * reach + h * h);
}

static double of_power(double q)
{
    const double ends[] = {0, 0.5, 1, 2, 4, 8, 16};
    const double sum = integral(wiener_hopf, &q, 6, ends);
    return tgamma((1 + q) / 2) / tgamma(1 + q / 2) * exp(-(1 + q) / PI * sum);
}

static double power(double r, double q)
{
    return pow(r, q);
}

CLAIM(loads_that_are_powers_of_the_distance_have_the_closed_form_of_wiener_and_hopf)
{
    static const double known[][2] = {{0, 1.9878464401605229}, {0.5, 1.4754993475353518},
                                      {1, 1.2103429371972804}, {1.5, 1.0454029897225192},
                                      {2, 0.9314039654265364}, {3, 0.7816108897708046}};
    const crack c = crack_at(0);
    for (size_t i = 0; i < sizeof known / sizeof *known; i++) {
        const double q = known[i][0], exact = of_power(q);
        assert_close(exact, known[i][1], 1e-13);
        assert_close(weighted(&c, c.normal[0], power, q), exact, 1e-12);
        assert_close(weighted(&c, c.shear[1], power, q), exact, 1e-12);
        assert_within(weighted(&c, c.shear[0], power, q), 0, 1e-14);
        assert_within(weighted(&c, c.normal[1], power, q), 0, 1e-14);
    }
}

/* The elastic energy under a fixed stress grows with l^2, and (K_I^2 + K_II^2)/E' is what it grows
 * by: the opening tells of K without the tip. The opening of a place stands for what lies between
 * the dislocations beside it, at cos^14(u/2). */
CLAIM(the_energy_that_is_released_is_that_of_the_opening)
{
    for (double degrees = -60; degrees < 65; degrees += 30) {
        const crack c = crack_at(degrees);
        const size_t n = c.m - 1, sides = 2 + n;
        size_t at[512];
        double *row = malloc(sides * 2 * c.m * sizeof *row), work = 0;
        assert_non_null(row);
        free_after_claim(row, free);
        for (size_t k = 0; k < n; k++)
            at[k] = k + 1;
        assert_ok(rw_crack_rows(c.angle, c.m, n, at, row));
        for (size_t k = 0; k < n; k++) {
            const double *opening = row + (2 + k) * 2 * c.m, half = PI / (4 * (double)c.m - 2);
            double opened = 0;
            for (size_t i = 0; i < c.m; i++)
                opened += opening[i];
            const double before = (double)(2 * k + 1) * half, after = (double)(2 * k + 3) * half;
            work += opened * (pow(cos(before), 14) - (k + 1 < n ? pow(cos(after), 14) : 0));
        }
        const double K_I = weighted(&c, c.normal[0], uniform, 1),
                     K_II = weighted(&c, c.normal[1], uniform, 1);
        assert_close(work, K_I * K_I + K_II * K_II, fabs(degrees) < 45 ? 1e-11 : 1e-9);
    }
}

/* exp(-r/e)/e is a force at the mouth when e goes to 0. */
static double near_mouth(double r, double e)
{
    return exp(-r / e) / e;
}

/* The compliance of a wedge to a force at its apex, over the angles a to b from the surface: of the
 * radial stress alone (Flamant). N, of the components along x and y. */
static void inverse_of_wedge(double a, double b, double inverse[2][2])
{
    const double xx = (b - a) / 2 + (sin(2 * b) - sin(2 * a)) / 4,
                 yy = (b - a) / 2 - (sin(2 * b) - sin(2 * a)) / 4,
                 xy = -(cos(2 * b) - cos(2 * a)) / 4, determinant = xx * yy - xy * xy;
    inverse[0][0] += yy / determinant;
    inverse[1][1] += xx / determinant;
    inverse[0][1] -= xy / determinant;
    inverse[1][0] -= xy / determinant;
}

/* Half of e' (N1^-1 + N2^-1) f for the unit vectors e and f. */
static double released(const crack *c, const double e[2], const double f[2])
{
    const double line = PI / 2 - c->angle;
    double sum[2][2] = {{0}}, product = 0;
    inverse_of_wedge(0, line, sum);
    inverse_of_wedge(line, PI, sum);
    for (int i = 0; i < 2; i++)
        for (int j = 0; j < 2; j++)
            product += e[i] * sum[i][j] * f[j] / 2;
    return product;
}

/* A pair of forces at the mouth leaves the M-integral of two Flamant wedges far away, and that of K
 * at the tip: no length, and all weights of the mouth. */
CLAIM(forces_at_the_mouth_release_what_the_m_integral_says)
{
    for (double degrees = -45; degrees < 50; degrees += 15) {
        const crack c = crack_at(degrees);
        const double axis[2][2] = {{cos(c.angle), -sin(c.angle)}, {sin(c.angle), cos(c.angle)}};
        const double size = released(&c, axis[0], axis[0]) + released(&c, axis[1], axis[1]);
        double K[2][2]; /* mode, and whether across or along */
        for (int mode = 0; mode < 2; mode++)
            for (int way = 0; way < 2; way++) {
                const double *weight = way ? c.shear[mode] : c.normal[mode], e = 1e-4;
                K[mode][way] = 2 * weighted(&c, weight, near_mouth, e) -
                               weighted(&c, weight, near_mouth, 2 * e);
            }
        for (int i = 0; i < 2; i++)
            for (int j = 0; j < 2; j++)
                assert_within(K[0][i] * K[0][j] + K[1][i] * K[1][j], released(&c, axis[i], axis[j]),
                              3e-8 * size);
    }
}

/* ---- Contacts ---- */

enum { X = 17, DEGREES, LENGTH, K_I, K_II };

/* Slopes x/R (1 + (x/w)^2) at 41 places from -2 w to 2 w. */
static rwedge_contact *create_bowl(double R, double w, double f)
{
    double x[41], slope[41];
    for (int i = 0; i < 41; i++) {
        x[i] = (i - 20) * w / 10;
        slope[i] = x[i] / R * (1 + x[i] * x[i] / (w * w));
    }
    return create_profile(41, x, slope, f);
}

static rwedge_contact *contact_of(const double cell[])
{
    rwedge_contact *contact = cell[0] == 0   ? create_flat(cell[1], cell[2], cell[3], cell[4])
                              : cell[0] == 1 ? create_wedge(cell[1], cell[2], cell[3], cell[4])
                                             : create_bowl(cell[1], cell[2], cell[4]);
    for (int i = 5; i < X && isfinite(cell[i]); i += 4)
        apply(contact, cell[i], cell[i + 1], cell[i + 2], cell[i + 3]);
    return contact;
}

static double intensity(const rwedge_contact *contact, const crack *c, double x, double length,
                        int mode)
{
    const double cosine = cos(c->angle), sine = sin(c->angle);
    double sum = 0;
    for (size_t k = 0; k < c->m; k++) {
        const double r = length * c->place[k];
        const stresses s = stress_at(contact, x + r * sine, r * cosine);
        const double normal =
            cosine * cosine * s.xx - 2 * cosine * sine * s.xy + sine * sine * s.yy;
        const double shear = sine * cosine * (s.xx - s.yy) + (cosine * cosine - sine * sine) * s.xy;
        sum += c->normal[mode][k] * normal + c->shear[mode][k] * shear;
    }
    return sqrt(length) * sum;
}

/* Two rules, which agree to 3e-12; at 60 degrees to 7e-10. */
CLAIM(cracks_under_contacts_have_their_reference_values)
{
    reference table = reference_open("crack.csv");
    while (reference_next(&table)) {
        const double *cell = table.cell;
        const rwedge_contact *contact = contact_of(cell);
        const crack c = crack_at(cell[DEGREES]);
        const double size = hypot(cell[K_I], cell[K_II]),
                     tolerance = fabs(cell[DEGREES]) < 50 ? 1e-10 : 1e-8;
        assert_within(intensity(contact, &c, cell[X], cell[LENGTH], 0), cell[K_I],
                      tolerance * size);
        assert_within(intensity(contact, &c, cell[X], cell[LENGTH], 1), cell[K_II],
                      tolerance * size);
    }
    assert_int_equal(table.row, 15);
}

/* Random pads of all kinds, loads, places and lengths. The other rule differs by up to 7e-12. */
CLAIM(cracks_under_random_histories_have_the_k_of_another_rule)
{
    reference table = reference_open("crack_random.csv");
    size_t pads[3] = {0};
    while (reference_next(&table)) {
        const double *cell = table.cell, size = hypot(cell[K_I], cell[K_II]);
        const rwedge_contact *contact = contact_of(cell);
        const crack c = crack_at(cell[DEGREES]);
        for (int mode = 0; mode < 2; mode++)
            assert_within(intensity(contact, &c, cell[X], cell[LENGTH], mode), cell[K_I + mode],
                          5e-11 * size);
        pads[(int)cell[0]]++;
    }
    assert_int_equal(pads[0], 16);
    assert_int_equal(pads[1], 8);
    assert_int_equal(pads[2], 8);
}

/* ---- Refusals ---- */

CLAIM(the_number_of_places_grows_with_the_angle)
{
    assert_int_equal(rwedge_crack_points(0), 97);
    assert_int_equal(rwedge_crack_points(-45 * PI / 180), 187);
    assert_int_equal(rwedge_crack_points(0.51 * PI / 180), 99);
    assert_int_equal(rwedge_crack_points(1.32), 0);
    assert_int_equal(rwedge_crack_points(NAN), 0);
}

static int32_t weights_of(double angle, size_t m, double *place)
{
    static double other[4][8];
    return rwedge_crack_weights(angle, m, place, other[0], other[1], other[2], other[3]);
}

CLAIM(weights_that_cannot_be_are_refused)
{
    double place[8] = {7};
    assert_int_equal(weights_of(1.32, 8, place), RWEDGE_EDOMAIN);
    assert_int_equal(weights_of(NAN, 8, place), RWEDGE_EDOMAIN);
    assert_int_equal(weights_of(0, 1, place), RWEDGE_ERANGE);
    assert_int_equal(weights_of(0, 513, place), RWEDGE_ERANGE);
    assert_int_equal(weights_of(0, 8, NULL), RWEDGE_ENULL);
    assert_true(place[0] == 7);
    assert_ok(weights_of(0, 8, place));
    assert_true(place[0] == 1);
}
