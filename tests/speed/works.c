/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "works.h"

#include "plain.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

double *xs, *ys, *out[3];
int plain_terms = PLAIN_TERMS;

static double **const arrays[] = {&xs, &ys, &out[0], &out[1], &out[2]};
enum { ARRAYS = sizeof arrays / sizeof arrays[0] };

bool reserve_points(long n)
{
    for (int i = 0; i < ARRAYS; i++)
        if ((*arrays[i] = malloc((size_t)n * sizeof **arrays[i])) == NULL)
            return false;
    for (long i = 0; i < n; i++) {
        xs[i] = 4 * fmod((double)i * 0.6180339887498949, 1) - 2;
        ys[i] = 2 * fmod((double)i * 0.7548776662466927, 1) + 1e-3;
    }
    return true;
}

void release_points(void)
{
    for (int i = 0; i < ARRAYS; i++)
        free(*arrays[i]);
}

void must(int32_t status)
{
    if (status == RWEDGE_OK)
        return;
    fprintf(stderr, "a call whose time was to be taken: %s\n", rwedge_strerror(status));
    exit(1);
}

/* ---- Stresses ---- */

double array_of_points(double c, double unused, long n)
{
    (void)unused;
    must(rwedge_stresses(0.3, 0.4, c, (size_t)n, xs, ys, out[0], out[1], out[2]));
    return out[0][0] + out[2][n - 1];
}

double points_one_by_one(double c, double unused, long n)
{
    (void)unused;
    double sum = 0;
    for (long i = 0; i < n; i++) {
        double sxx, syy, txy;
        rwedge_stress(0.3, 0.4, c, xs[i], ys[i], &sxx, &syy, &txy);
        sum += sxx + syy + txy;
    }
    return sum;
}

double plain_points(long n)
{
    plain_series s;
    double sum = 0;
    plain_coefficients(&s, 0.3, plain_terms);
    for (long i = 0; i < n; i++)
        sum += plain_J2(&s, 0.4, 0.3, xs[i], ys[i]);
    return sum;
}

/* ---- Elastic limits ---- */

double case_of(long i, double *f)
{
    enum { FRICTIONS = 65, STEP = 77 }; /* the step has no divisor of 650 */
    const long k = STEP * i % PAPER_LIMITS;
    *f = 0.0125 * (double)(k % FRICTIONS);
    return (double)(k / FRICTIONS + 1) / 10;
}

double limits_one_by_one(long n)
{
    double sum = 0, f;
    for (long i = 0; i < n; i++) {
        const double alpha = case_of(i, &f);
        sum += rwedge_elastic_limit(alpha, f, 0.3);
    }
    return sum;
}

double plain_limits(long n)
{
    double sum = 0;
    for (long i = 0; i < n; i++)
        sum += plain_limit(0.5, 0.05 * (double)i, 0.3, plain_terms);
    return sum;
}

/* ---- Contacts ---- */

rwedge_contact *new_contact(void)
{
    rwedge_contact *contact;
    must(rwedge_contact_create(0.05, 1, 1.82e-5, 0.6, &contact));
    return contact;
}

rwedge_contact *worn_contact(double corners, double M)
{
    rwedge_contact *contact = new_contact();
    must(rwedge_contact_apply(contact, 20000, M, 0, 0));
    for (int i = 1; i < corners; i++)
        must(rwedge_contact_load(contact, 20000,
                                 (i % 2 ? 0.9 : -0.9) * 12000 * (1 - i / (corners + 1))));
    return contact;
}

/* The contact is destroyed. */
static double points_of(rwedge_contact *contact, double P, long n)
{
    must(rwedge_contact_load(contact, P, 0));
    must(rwedge_contact_load(contact, P, 0.3 * P));
    must(rwedge_contact_stresses(contact, (size_t)n, xs, ys, out[0], out[1], out[2]));
    rwedge_contact_destroy(contact);
    return out[0][0] + out[2][n - 1];
}

double points_of_a_wedge(long n)
{
    return points_of(new_contact(), 20000, n);
}

double points_of_a_flat_pad(long n)
{
    rwedge_contact *contact;
    must(rwedge_contact_create_flat(0.5, 20, 1.82e-5, 0.6, &contact));
    return points_of(contact, 2000, n);
}

static rwedge_contact *new_profile(void)
{
    enum { PLACES = 100 };
    rwedge_contact *contact;
    double x[PLACES], slope[PLACES] = {-0.1};
    for (int i = 0; i < PLACES; i++) {
        x[i] = 2.0 * i / (PLACES - 1) - 1;
        slope[i] = i == 0 ? -0.1 : slope[i - 1] + 0.004 * fmod(i * 0.6180339887498949, 1);
    }
    must(rwedge_contact_create_profile(PLACES, x, slope, 1.82e-5, 0.6, &contact));
    return contact;
}

double points_of_a_profile(long n)
{
    return points_of(new_profile(), 20000, n);
}

double yield_factors(double corners, double M, long n)
{
    rwedge_contact *contact = worn_contact(corners, M);
    double sum = 0, factor;
    for (long i = 0; i < n; i++) {
        must(rwedge_contact_yield_factor(contact, 0.3, 100, &factor, NULL, NULL));
        sum += factor;
    }
    rwedge_contact_destroy(contact);
    return sum;
}

/* ---- Loads without a closed form ---- */

/* The contact is destroyed. M goes with Q, so many mm from it. */
static double follow(rwedge_contact *contact, double tolerance, double arm, double scatter, long n)
{
    must(rwedge_contact_allow_error(contact, tolerance));
    must(rwedge_contact_load(contact, 20000, 0));
    for (long i = 1; i <= n; i++) {
        const double phase = TURN * (double)i / 48;
        const double noise = scatter * (fmod((double)i * 0.6180339887498949, 1) - 0.5);
        const double Q = 9000 * (sin(phase) - noise);
        must(rwedge_contact_apply(contact, 20000 * (1 + noise), arm * Q, Q,
                                  2000 * (sin(phase - TURN / 8) + noise)));
    }
    const double error = rwedge_contact_error(contact);
    rwedge_contact_destroy(contact);
    return error;
}

double lagging(double tolerance, double scatter, long n)
{
    return follow(new_contact(), tolerance, 0, scatter, n);
}

double rocking(double tolerance, double scatter, long n)
{
    return follow(new_contact(), tolerance, 0.5, scatter, n);
}

double lagging_profile(double tolerance, double scatter, long n)
{
    return follow(new_profile(), tolerance, 0, scatter, n);
}
