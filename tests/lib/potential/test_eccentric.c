/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The potential of patches off the centre. */
#include "claims.h"
#include "quadrature.h"
#include "potential/eccentric.h"

static const struct {
    double a;
    rw_patch patch;
} CASES[] = {{0, {-0.8, 1.2}}, {0.3, {-0.8, 1.2}},  {0.3, {-0.2, 1.8}},
             {3, {-0.8, 1.2}}, {1e-9, {-0.7, 0.9}}, {1, {-0.95, 1.001}}};
enum { COUNT = sizeof CASES / sizeof *CASES };

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
    for (int i = 1; i < 4; i++) {
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

CLAIM(a_batch_has_the_bits_of_its_points)
{
    for (int i = 0; i < COUNT; i++) {
        rw_eccentric potential;
        rw_eccentric_init_arc(&potential, rw_rounding(CASES[i].a), CASES[i].patch);
        uint64_t seed = 11;
        double x[RW_BATCH], y[RW_BATCH];
        for (int k = 0; k < RW_BATCH; k++) {
            x[k] = 8 * random_fraction(&seed) - 4;
            y[k] = k % 5 ? 3 * random_fraction(&seed) : 0;
        }
        for (int n = 1; n <= RW_BATCH; n += 7) {
            rw_fields fields;
            rw_eccentric_fields(&potential, n, x, y, &fields);
            for (int k = 0; k < n; k++) {
                const rw_field alone = rw_eccentric_at(&potential, x[k], y[k]),
                               of_batch = rw_field_in(&fields, k);
                assert_memory_equal(&alone, &of_batch, sizeof alone);
            }
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
