/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A fretting test: a rounded pad is pressed on a specimen and shaken. What happens at the
 * trailing edge in one cycle, and the Smith-Watson-Topper parameter of the plane across the
 * surface: largest stress times strain amplitude. N, mm. */
#include <math.h>
#include <rwedge.h>
#include <stdio.h>
#include <stdlib.h>

enum { STEPS = 12 };

static void check(int32_t status)
{
    if (status != RWEDGE_OK) {
        fprintf(stderr, "%s\n", rwedge_strerror(status));
        exit(EXIT_FAILURE);
    }
}

int main(void)
{
    /* an aluminium alloy */
    const double E = 72e3, nu = 0.33, theta = 0.005, radius = 20, f = 0.6, k = 190;
    const double P = 60, Q_max = 0.8 * f * P;
    const double A = rwedge_compliance(E, nu, E, nu), a = rwedge_rounding(theta, radius);

    rwedge_contact *pad;
    check(rwedge_contact_create(theta, a, A, f, &pad));
    check(rwedge_contact_load(pad, P, 0));
    /* the first loading differs from the cycles after it */
    check(rwedge_contact_load(pad, P, Q_max));
    const double b = rwedge_contact_half_width(pad), edge = -b, depth = 0;
    const double before = rwedge_contact_dissipated_energy(pad);
    printf("contact %.4f mm, stick zone %.4f mm\n", b, rwedge_contact_stick_half_width(pad));

    printf("%8s %10s %12s\n", "Q", "sxx", "slip at .9 b");
    double stress_max = -HUGE_VAL, strain_max = -HUGE_VAL, strain_min = HUGE_VAL,
           factor_min = HUGE_VAL;
    for (int i = 0; i <= STEPS; i++) {
        const double Q = Q_max * (i <= STEPS / 2 ? 1 - 4.0 * i / STEPS : 4.0 * i / STEPS - 3);
        check(rwedge_contact_load(pad, P, Q));
        double sxx, syy, txy, slip, factor;
        const double inside = 0.9 * edge;
        check(rwedge_contact_stresses(pad, 1, &edge, &depth, &sxx, &syy, &txy));
        check(rwedge_contact_slip(pad, 1, &inside, &slip));
        check(rwedge_contact_yield_factor(pad, nu, k, &factor, NULL, NULL));
        const double strain = (1 + nu) / E * ((1 - nu) * sxx - nu * syy); /* plane strain */
        stress_max = fmax(stress_max, sxx);
        strain_max = fmax(strain_max, strain);
        strain_min = fmin(strain_min, strain);
        factor_min = fmin(factor_min, factor);
        printf("%8.2f %10.4f %12.4e\n", Q, sxx, slip);
    }
    printf("Smith-Watson-Topper %.6f MPa\n", stress_max * (strain_max - strain_min) / 2);
    printf("dissipated per cycle %.6e N\n", rwedge_contact_dissipated_energy(pad) - before);
    printf("yield factor %.4f, yield load when sliding %.2f N/mm\n", factor_min,
           rwedge_yield_load(theta, a, A, f, nu, k));
    rwedge_contact_destroy(pad);
    return EXIT_SUCCESS;
}
