/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Time per call, beside that of the plain way: the paper's series with 60 terms and a search on a grid. Both are timed in one
 * run, several times over, and the fastest counts, so that the ratio holds on a busy machine too. Not a test.
 *
 *     build/tests/bench [TERMS]     TERMS of the plain series, 60 if not given */
#define _POSIX_C_SOURCE 199309L

#include "rwedge.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <time.h>

static const double PI = 3.14159265358979323846;

static double seconds(void)
{
    struct timespec now;
    clock_gettime(CLOCK_MONOTONIC, &now);
    return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

/* ---- The plain way ---- */

typedef struct {
    int terms;
    double b[1000];
} plain_series;

static void plain_coefficients(plain_series *s, double alpha)
{
    const double phi0 = asin(fmin(alpha, 1));
    for (int n = 0; n < s->terms; n++) {
        const double m = 2 * n + 1;
        s->b[n] = n == 0 ? 2 / PI * (phi0 + alpha * cos(phi0)) / alpha
                         : 4 / PI * (n % 2 ? -1 : 1) * (m * sin(m * phi0) / tan(phi0) - cos(m * phi0)) / (m * (m * m - 1));
    }
}

/* Eq. (30), (32), (33) as they stand; J2 for plane strain. */
static double plain_J2(const plain_series *s, double f, double nu, double x, double y)
{
    /* sqrt(z^2-1) with the branch that is z at infinity */
    const double a = x * x - y * y - 1, b = 2 * x * y, r = sqrt(hypot(a, b)), angle = atan2(b, a) / 2;
    double X = r * cos(angle), Y = r * sin(angle);
    if (Y < 0 || (Y == 0 && X * x < 0)) {
        X = -X;
        Y = -Y;
    }
    const double R = x - X, I = y - Y;
    double G = 0, H = 0, U = 0, V = 0;
    for (int n = s->terms - 1; n >= 0; n--) {
        const double R2 = R * R - I * I, I2 = 2 * R * I, g = G * R2 - H * I2, u = U * R2 - V * I2;
        H = G * I2 + H * R2;
        G = g + s->b[n];
        V = U * I2 + V * R2;
        U = u + (2 * n + 1) * s->b[n];
    }
    const double Gr = G * R - H * I, Gi = G * I + H * R, Wr = U * R - V * I, Wi = U * I + V * R;
    const double X2 = fmax(X * X + Y * Y, 1e-300), dr = -(Wr * X + Wi * Y) / X2, di = -(Wi * X - Wr * Y) / X2;
    const double D = -y * dr - y * f * di + f * Gr, E = -y * di + y * f * dr + f * Gi, mean = Gi - f * Gr;
    return D * D + E * E + (1 - 2 * nu) * (1 - 2 * nu) / 3 * mean * mean;
}

/* A grid of 121 x 61 points and a pattern search from the best. */
static double plain_limit(double alpha, double f, double nu, int terms)
{
    plain_series s = {.terms = terms};
    plain_coefficients(&s, alpha);
    double best = 0, at_x = 0, at_y = 0;
    for (int i = 0; i <= 120; i++)
        for (int j = 0; j <= 60; j++) {
            const double x = -1.2 + 0.02 * i, y = 0.02 * j, J2 = plain_J2(&s, f, nu, x, y);
            if (J2 > best) {
                best = J2;
                at_x = x;
                at_y = y;
            }
        }
    for (double step = 0.01; step > 1e-9; step /= 2)
        for (int k = 0; k < 4; k++) {
            const double x = at_x + (k == 0 ? step : k == 1 ? -step : 0);
            const double y = fmax(0, at_y + (k == 2 ? step : k == 3 ? -step : 0)), J2 = plain_J2(&s, f, nu, x, y);
            if (J2 > best) {
                best = J2;
                at_x = x;
                at_y = y;
            }
        }
    return (asin(fmin(alpha, 1)) / alpha + sqrt(fmax(0, 1 - alpha * alpha))) / sqrt(best);
}

/* ---- What is timed; each returns a number that depends on all of its work ---- */

enum { POINTS = 100000, LIMITS = 650 };
static double xs[POINTS], ys[POINTS], out[3][POINTS];
static int terms = 60;

static double point_by_point(double c)
{
    double sum = 0;
    for (int i = 0; i < POINTS; i++) {
        double sxx, syy, txy;
        rwedge_stress(0.3, 0.4, c, xs[i], ys[i], &sxx, &syy, &txy);
        sum += sxx + syy + txy;
    }
    return sum;
}

static double one_by_one(void)
{
    return point_by_point(0);
}

static double one_by_one_partial_slip(void)
{
    return point_by_point(0.4);
}

static double as_array(void)
{
    rwedge_stresses(0.3, 0.4, 0, POINTS, xs, ys, out[0], out[1], out[2]);
    return out[0][0] + out[2][POINTS - 1];
}

static double as_array_partial_slip(void)
{
    rwedge_stresses(0.3, 0.4, 0.4, POINTS, xs, ys, out[0], out[1], out[2]);
    return out[0][0] + out[2][POINTS - 1];
}

static double plain_points(void)
{
    plain_series s = {.terms = terms};
    double sum = 0;
    plain_coefficients(&s, 0.3);
    for (int i = 0; i < POINTS; i++)
        sum += plain_J2(&s, 0.4, 0.3, xs[i], ys[i]);
    return sum;
}

/* The paper's table: a/b = 0.1 ... 1, f = 0 ... 0.8; every call is cold. */
static double table_of_limits(void)
{
    double sum = 0;
    for (int i = 1; i <= 10; i++)
        for (int j = 0; j < LIMITS / 10; j++)
            sum += rwedge_elastic_limit(i / 10.0, 0.0125 * j, 0.3);
    return sum;
}

/* The same with both branches, as `rwedge table` writes it. */
static double table_of_branches(void)
{
    double sum = 0;
    for (int i = 1; i <= 10; i++)
        for (int j = 0; j < LIMITS / 10; j++) {
            double limit, x, y;
            if (rwedge_subsurface_yield(i / 10.0, 0.0125 * j, 0.3, &limit, &x, &y) == RWEDGE_OK)
                sum += limit;
            rwedge_surface_yield(i / 10.0, 0.0125 * j, 0.3, &limit, &x);
            sum += limit;
        }
    return sum;
}

enum { FEW = 13 };
static double plain_limits(void)
{
    double sum = 0;
    for (int j = 0; j < FEW; j++)
        sum += plain_limit(0.5, 0.05 * j, 0.3, terms);
    return sum;
}

static double inverses(void)
{
    double sum = 0;
    for (int i = 0; i < POINTS; i++)
        sum += rwedge_a_over_b(1 + 1e-4 * i);
    return sum;
}

static double pressures(void)
{
    double sum = 0;
    for (int i = 0; i < POINTS; i++)
        sum += rwedge_pressure(0.3, (double)i / POINTS);
    return sum;
}

enum { STEPS = 1000, POINTS_A_STEP = 100 };

/* A fretting test: constant P, Q up and down, and each time the stresses at a hundred points. */
static double load_steps(void)
{
    rwedge_contact *contact;
    double sum = 0;
    if (rwedge_contact_create(0.05, 1, 1.82e-5, 0.6, &contact) != RWEDGE_OK || rwedge_contact_load(contact, 20000, 0) != RWEDGE_OK)
        return NAN;
    for (int i = 0; i < STEPS; i++) {
        rwedge_contact_load(contact, 20000, 9000 * sin(0.3 * i));
        rwedge_contact_stresses(contact, POINTS_A_STEP, xs, ys, out[0], out[1], out[2]);
        sum += out[0][0];
    }
    rwedge_contact_destroy(contact);
    return sum;
}

static volatile double sink; /* keeps the work from being optimised away */

static double fastest(double (*work)(void), int calls)
{
    double best = HUGE_VAL;
    for (int run = 0; run < 7; run++) {
        const double start = seconds();
        sink = work();
        best = fmin(best, seconds() - start);
    }
    return best / calls;
}

int main(int argc, char **argv)
{
    if (argc > 1)
        terms = atoi(argv[1]);
    if (terms < 1 || terms > 1000) {
        fprintf(stderr, "usage: bench [TERMS]   1 <= TERMS <= 1000\n");
        return 2;
    }
    for (int i = 0; i < POINTS; i++) {
        xs[i] = 4 * fmod(i * 0.6180339887498949, 1) - 2;
        ys[i] = 2 * fmod(i * 0.7548776662466927, 1) + 1e-3;
    }
    const double series = fastest(plain_points, POINTS), search = fastest(plain_limits, FEW);
    const struct {
        const char *what;
        double (*work)(void);
        int calls;
        double plain;
    } rows[] = {
        {"stress at a point, full sliding", one_by_one, POINTS, series},
        {"stress at a point, partial slip", one_by_one_partial_slip, POINTS, 2 * series},
        {"stress in an array, full sliding", as_array, POINTS, series},
        {"stress in an array, partial slip", as_array_partial_slip, POINTS, 2 * series},
        {"elastic limit, cold", table_of_limits, LIMITS, search},
        {"both branches, cold", table_of_branches, LIMITS, search},
        {"half-width from the load", inverses, POINTS, 0},
        {"pressure", pressures, POINTS, 0},
        {"load step and 100 stress points", load_steps, STEPS, 0},
    };
    printf("%-34s %12s %12s\n", "", "ns a call", "plain / this");
    for (size_t i = 0; i < sizeof rows / sizeof rows[0]; i++) {
        const double time = fastest(rows[i].work, rows[i].calls);
        printf("%-34s %12.1f ", rows[i].what, 1e9 * time);
        if (rows[i].plain > 0)
            printf("%12.1f", rows[i].plain / time);
        printf("\n");
    }
    printf("%-34s %12.1f\n", "plain series, a point", 1e9 * series);
    printf("%-34s %12.1f\n", "plain grid search, an elastic limit", 1e9 * search);
    printf("The paper's table of %d elastic limits: %.2f ms; by the plain search: %.0f ms.\n", LIMITS,
           1e3 * LIMITS * fastest(table_of_limits, LIMITS), 1e3 * LIMITS * search);
    printf("Error of the plain elastic limit at a/b = 0.5, f = 0.6: %.1e\n",
           plain_limit(0.5, 0.6, 0.3, terms) / rwedge_elastic_limit(0.5, 0.6, 0.3) - 1);
    return 0;
}
