/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The potential of patches off the centre. */
#include "claims.h"
#include "quadrature.h"
#include "potential/eccentric.h"

static const struct {
    double a;
    rw_patch patch;
} CASES[] = {{0.3, {-0.8, 1.2}}, {0.3, {-0.2, 1.8}}, {3, {-0.8, 1.2}}};

/* G = (1/pi) int p/(t-z) dt, along t = m + s sin(v). */
typedef struct {
    const rw_eccentric *potential;
    double x, y;
    bool imaginary;
} cauchy;

static double kernel(double v, const void *context)
{
    const cauchy *c = context;
    const double s = c->potential->half_width, t = c->potential->middle + s * sin(v);
    const double dx = t - c->x, r2 = dx * dx + c->y * c->y;
    const double p = rw_eccentric_at(c->potential, t, 0).G_im * s * cos(v) / PI;
    return p * (c->imaginary ? c->y : dx) / r2;
}

CLAIM(is_the_integral_of_the_pressure)
{
    for (size_t i = 0; i < sizeof CASES / sizeof *CASES; i++) {
        rw_eccentric p;
        rw_eccentric_init_arc(&p, rw_rounding(CASES[i].a), CASES[i].patch);
        const double points[][2] = {{0.4, 0.7}, {-1.3, 0.5}, {1.2, 0.9}, {3, 2}};
        for (size_t k = 0; k < sizeof points / sizeof *points; k++) {
            cauchy c = {&p, points[k][0], points[k][1], false};
            const rw_field is = rw_eccentric_at(&p, c.x, c.y);
            const double s = p.half_width, m = p.middle, a = CASES[i].a;
            const double v[] = {-PI / 2, asin(fmax(-1, (-a - m) / s)), asin(fmin(1, (a - m) / s)),
                                PI / 2};
            assert_within(is.G_re, integral(kernel, &c, 3, v), 1e-12);
            c.imaginary = true;
            assert_within(is.G_im, integral(kernel, &c, 3, v), 1e-12);
        }
    }
}

CLAIM(a_centred_patch_has_the_bits_of_the_contact)
{
    rw_eccentric patch;
    rw_potential contact;
    rw_eccentric_init_arc(&patch, rw_rounding(0.3), (rw_patch){-1.1, 1.1});
    rw_potential_init_patch(&contact, 0.3, 1.1);
    for (double x = -3; x < 3; x += 0.17) {
        const rw_field of_patch = rw_eccentric_at(&patch, x, 0.4),
                       of_contact = rw_potential_at(&contact, x, 0.4);
        assert_memory_equal(&of_patch, &of_contact, sizeof of_patch);
    }
}
