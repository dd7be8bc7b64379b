/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The pressure of a patch of any pad. */
#include "claims.h"
#include "potential/pad_potential.h"

static const double X[] = {-2, -0.91, -0.3, 0.04, 0.6, 1.19, 1.3};
enum { PLACES = sizeof X / sizeof *X };

static const rw_patch PATCH = {-0.9, 1.2};

static void pressures(const rw_arcs *arcs, double p[PLACES])
{
    rw_pad_pressures(arcs, PATCH, PLACES, X, p);
    for (int i = 0; i < PLACES; i++)
        assert_true((p[i] > 0) == (X[i] > PATCH.left && X[i] < PATCH.right));
}

/* One of them is not in contact. */
CLAIM(a_wedge_is_the_sum_of_parts_of_its_rounding)
{
    rw_arc all[] = {{-1, -0.95}, {-0.95, 0.2}, {0.2, 0.7}, {0.7, 1}};
    double weights[] = {0.025, 0.575, 0.25, 0.15}, whole[PLACES], sum[PLACES];
    const rw_pad pad = {.count = 4, .arcs = all, .weights = weights};
    const rw_arcs wedge = {.count = 1, .rounding = rw_rounding(1)};
    const rw_arcs parts = {.count = 4, .pad = &pad};
    pressures(&wedge, whole);
    pressures(&parts, sum);
    for (int i = 0; i < PLACES; i++)
        assert_close(sum[i], whole[i], 4e-15);
}

static void fields_are_sums(size_t count, rw_arc all[], double weights[], double tolerance)
{
    const rw_pad pad = {.count = count, .arcs = all, .weights = weights};
    const rw_arcs arcs = {.count = count, .pad = &pad};
    double x[RW_BATCH], y[RW_BATCH];
    rw_fields fields;
    for (int i = 0; i < RW_BATCH; i++) {
        x[i] = i < 6 ? all[i].left + 1e-13 : -1.5 + 0.1 * i;
        y[i] = i % 3 == 0 ? 0 : pow(10, i % 15 - 12);
    }
    rw_pad_fields(&arcs, PATCH, RW_BATCH, x, y, &fields);
    for (int i = 0; i < RW_BATCH; i++) {
        rw_field sum = {0, 0, 0, 0};
        for (size_t k = 0; k < arcs.count; k++) {
            rw_eccentric of_arc;
            rw_eccentric_init_arc(&of_arc, all[k], PATCH);
            const rw_field part =
                rw_field_multiple(weights[k], rw_eccentric_at(&of_arc, x[i], y[i]));
            sum = (rw_field){sum.G_re + part.G_re, sum.G_im + part.G_im, sum.H_re + part.H_re,
                             sum.H_im + part.H_im};
        }
        const rw_field shared = rw_field_in(&fields, i);
        const double limit = tolerance / (1 + y[i]);
        assert_within(shared.G_re, sum.G_re, limit);
        assert_within(shared.G_im, sum.G_im, limit);
        assert_within(shared.H_re, sum.H_re, limit);
        assert_within(shared.H_im, sum.H_im, limit);
        assert_true((shared.G_im == 0) == (sum.G_im == 0));
    }
}

/* Neighbouring arcs share a logarithm, but for the third and the last one, which are almost kinks;
 * of many, some at a time. */
CLAIM(the_fields_are_the_sums_over_the_arcs)
{
    enum { MANY = 100 };
    rw_arc all[] = {{-1, -0.6}, {-0.6, -0.2}, {-0.2, -0.2 + 1e-9}, {0, 0.3},
                    {0.3, 0.5}, {0.5, 1},     {1, 1 + 1e-9}},
           many[MANY];
    double weights[] = {0.2, 0.1, 0.2, 0.2, 0.1, 0.1, 0.1}, of_many[MANY];
    for (int i = 0; i < MANY; i++) {
        many[i] = (rw_arc){-0.89 + 0.02 * i, -0.89 + 0.02 * (i + 1)};
        of_many[i] = (1 + i % 3) / 199.0;
    }
    fields_are_sums(7, all, weights, 1e-14);
    fields_are_sums(MANY, many, of_many, 1e-13);
}
