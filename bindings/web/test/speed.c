/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Processor time of calls of the library, in ns a point or call: what speed.mjs does. */
#include <rwedge.h>
#include <stdio.h>
#include <time.h>

enum { POINTS = 20000, CALLS = 1000, TRIALS = 15 };
static double x[POINTS], y[POINTS], sxx[POINTS], syy[POINTS], txy[POINTS];
static rwedge_contact *contact;

static void sliding(void)
{
    rwedge_stresses(0.25, 0.3, 0, POINTS, x, y, sxx, syy, txy);
}

static void partial_slip(void)
{
    rwedge_stresses(0.25, 0.3, 0.5, POINTS, x, y, sxx, syy, txy);
}

static void of_contact(void)
{
    rwedge_contact_stresses(contact, POINTS, x, y, sxx, syy, txy);
}

static void limits(void)
{
    for (int i = 0; i < CALLS; i++)
        sxx[i] = rwedge_elastic_limit(0.25, 0.1 + 1e-4 * i, 0.3);
}

static void pressures(void)
{
    for (int i = 0; i < POINTS; i++)
        sxx[i] = rwedge_pressure(0.25, x[i] / 3);
}

static double now(void)
{
    struct timespec t;
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
    return 1e9 * (double)t.tv_sec + (double)t.tv_nsec;
}

static void report(const char *what, void (*run)(void), int count)
{
    double best = 1e300;
    for (int trial = 0; trial < TRIALS; trial++) {
        const double began = now();
        run();
        const double took = now() - began;
        best = took < best ? took : best;
    }
    printf("%s: %.2f\n", what, best / count);
}

int main(void)
{
    for (int i = 0; i < POINTS; i++) {
        x[i] = -2 + 4.0 * i / POINTS;
        y[i] = 0.01 + 2.0 * ((i * 7919) % POINTS) / POINTS;
    }
    if (rwedge_contact_create(0.01, 0.5, 1.8e-5, 0.3, &contact) ||
        rwedge_contact_load(contact, 1000, 0) || rwedge_contact_load(contact, 1000, 200))
        return 1;
    report("stresses in an array, full sliding", sliding, POINTS);
    report("stresses in an array, partial slip", partial_slip, POINTS);
    report("stresses of a contact in an array", of_contact, POINTS);
    report("elastic limit", limits, CALLS);
    report("pressure at many points", pressures, POINTS);
    rwedge_contact_destroy(contact);
    return 0;
}
