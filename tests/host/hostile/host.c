/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A host with its own GSL and its own error handler. It prints the bits of what the library
 * computes by GSL (roots) and by LAPACK (fits, good and bad). It fails if its handler was called
 * or exchanged. */
#include "rwedge.h"

#include <gsl/gsl_errno.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

enum { SAMPLES = 40, TERMS = 12 };

static int calls;

static void own_handler(const char *reason, const char *file, int line, int gsl_errno)
{
    (void)reason;
    (void)file;
    (void)line;
    (void)gsl_errno;
    calls++;
}

static void print_bits(const char *what, double value)
{
    uint64_t bits;
    memcpy(&bits, &value, sizeof bits);
    printf("%s %016llx\n", what, (unsigned long long)bits);
}

/* Samples of the rounded wedge's pressure; all at one place where they are not spread. */
static void fit(const char *what, double spread)
{
    double x[SAMPLES], p[SAMPLES];
    rwedge_series *series = NULL;
    for (int i = 0; i < SAMPLES; i++) {
        x[i] = 0.1 + spread * cos((i + 0.5) * 3.14159265358979312 / SAMPLES);
        p[i] = rwedge_pressure(0.3, x[i]);
    }
    const int32_t status = rwedge_series_fit(SAMPLES, x, p, TERMS, &series);
    printf("%s: %s\n", what, rwedge_strerror(status));
    for (int32_t k = 0; status == RWEDGE_OK && k < TERMS; k++)
        print_bits("coefficient", rwedge_series_coefficient(series, k));
    rwedge_series_destroy(series);
}

int main(void)
{
    gsl_set_error_handler(own_handler);
    for (double alpha = 0.01; alpha < 1; alpha += 0.09) {
        print_bits("a/b", rwedge_a_over_b(rwedge_load(alpha) / alpha));
        print_bits("stick width", rwedge_stick_width(alpha, 0.7));
        print_bits("elastic limit", rwedge_elastic_limit(alpha, 0.3, 0.3));
        print_bits("critical friction", rwedge_critical_friction(alpha, 0.3));
    }
    fit("spread", 0.89);
    fit("at one place", 0);
    fflush(stdout);
    if (gsl_set_error_handler(own_handler) != own_handler || calls != 0) {
        fprintf(stderr, "the host's GSL error handler was called or exchanged\n");
        return 1;
    }
    return 0;
}
