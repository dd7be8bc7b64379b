/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What the doors do not ask: errors, and the fit by LAPACK. Says nothing and returns 0, or says
 * what is wrong. */
#include "rwedge.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

static int failures;

static void expect(int truth, const char *claim)
{
    if (truth)
        return;
    printf("FAILED: %s\n", claim);
    failures++;
}

static void errors_are_those_of_the_header(void)
{
    double sxx = 1, syy = 2, txy = 3;
    expect(rwedge_stress(0.25, -1, 0, 0, 1, &sxx, &syy, &txy) == RWEDGE_EDOMAIN,
           "negative friction is refused");
    expect(sxx == 1 && syy == 2 && txy == 3, "outputs are untouched on error");
    expect(isnan(rwedge_load(-1)), "a formula gives NaN outside its domain");
    expect(strcmp(rwedge_version(), RWEDGE_VERSION) == 0, "the DLL has the header's version");
    expect(strlen(rwedge_strerror(RWEDGE_ESLIDING)) > 0, "a status has a text");
    rwedge_contact *contact = NULL;
    expect(rwedge_contact_create(0.01, 0.5, 1.8e-5, 0.6, &contact) == RWEDGE_OK,
           "a contact is made");
    expect(rwedge_contact_load(contact, 1000, 601) == RWEDGE_ESLIDING, "Q above f P is refused");
    rwedge_contact_destroy(contact);
}

/* p = -sqrt(1-x^2) sum a_k U_k(x) is -sum a_k sin (k+1)t at x = cos t. */
static void fit_finds_the_coefficients(void)
{
    enum { SAMPLES = 400, TERMS = 30 };
    double x[SAMPLES], p[SAMPLES];
    for (int i = 0; i < SAMPLES; i++) {
        const double t = 3.14159265358979324 * (i + 0.5) / SAMPLES;
        x[i] = cos(t);
        p[i] = 0;
        for (int k = 0; k < TERMS; k++)
            p[i] -= sin((k + 1) * t) / (k + 1);
    }
    rwedge_series *series = NULL;
    expect(rwedge_series_fit(SAMPLES, x, p, TERMS, &series) == RWEDGE_OK, "the fit succeeds");
    for (int k = 0; k < TERMS; k++)
        expect(fabs(rwedge_series_coefficient(series, k) * (k + 1) - 1) < 1e-12,
               "the fit finds the coefficients");
    rwedge_series_destroy(series);
    for (int i = 0; i < SAMPLES; i++)
        x[i] = 0.5;
    expect(rwedge_series_fit(SAMPLES, x, p, TERMS, &series) == RWEDGE_ERANK,
           "samples at one point are too few");
}

int main(void)
{
    errors_are_those_of_the_header();
    fit_finds_the_coefficients();
    return failures > 0;
}
