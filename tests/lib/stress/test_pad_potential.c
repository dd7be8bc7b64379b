/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The pressure of a patch of any pad, prepared or not. */
#include "claims.h"
#include "stress/pad_potential.h"

static const double X[] = {-2, -0.91, -0.3, 0.04, 0.6, 1.19, 1.3};
enum { PLACES = sizeof X / sizeof *X };

static const rw_patch PATCH = {-0.9, 1.2};

static void prepared(const rw_arcs *arcs, double p[PLACES])
{
    rw_pad_potential potential;
    double again[PLACES];
    assert_true(rw_pad_potential_create(&potential, arcs, PATCH));
    rw_pad_pressures(arcs, PATCH, PLACES, X, again);
    for (int i = 0; i < PLACES; i++) {
        p[i] = rw_pad_pressure(&potential, X[i]);
        assert_true(p[i] == again[i]);
        assert_true((p[i] > 0) == (X[i] > PATCH.left && X[i] < PATCH.right));
    }
    rw_pad_potential_destroy(&potential);
}

/* One of them is not in contact. */
CLAIM(a_wedge_is_the_sum_of_parts_of_its_rounding)
{
    rw_arc all[] = {{-1, -0.95}, {-0.95, 0.2}, {0.2, 0.7}, {0.7, 1}};
    double weights[] = {0.025, 0.575, 0.25, 0.15}, whole[PLACES], sum[PLACES];
    const rw_pad pad = {.count = 4, .arcs = all, .weights = weights};
    const rw_arcs wedge = {.count = 1, .rounding = rw_rounding(1)};
    const rw_arcs parts = {.count = 4, .pad = &pad};
    prepared(&wedge, whole);
    prepared(&parts, sum);
    for (int i = 0; i < PLACES; i++)
        assert_close(sum[i], whole[i], 4e-15);
}
