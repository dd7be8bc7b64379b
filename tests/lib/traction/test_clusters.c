/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Clusters of elements: the field and the displacement of a partial slip, t = sqrt(1 - x^2) less
 * that of a narrower patch, off the centre. Each has Hertz' transform Omega = -z + X. */
#include "claims.h"
#include "base/complex.h"
#include "traction/clusters.h"
#include "traction/transform.h"

static const double MIDDLE = 0.13, HALF = 0.61;

static double hertz(double x)
{
    return sqrt(fmax(0, (1 - x) * (1 + x)));
}

static void slipping(const double x[], const void *context, double value[])
{
    (void)context;
    for (int i = 0; i < RW_TERMS; i++)
        value[i] = hertz(x[i]) - HALF * hertz((x[i] - MIDDLE) / HALF);
}

/* With kinks that are none, next to a front, as loads leave them. */
static rw_traction fitted(void)
{
    const double at[] = {-1,  MIDDLE - HALF - 1e-4, MIDDLE - HALF, MIDDLE - HALF + 1e-6,
                         0.5, MIDDLE + HALF,        0.9,           1};
    rw_traction t = {0};
    assert_true(rw_traction_fit(&t, slipping, NULL, sizeof at / sizeof at[0], at, 1e-12, 0));
    return t;
}

/* Omega and y Omega' of sqrt(1 - x^2). */
static rw_field of_hertz(double x, double y)
{
    const rw_complex X = rw_product(rw_complex_root((rw_complex){x - 1, y}),
                                    rw_complex_root((rw_complex){x + 1, y}));
    const rw_complex R = rw_quotient((rw_complex){1, 0}, (rw_complex){x + X.re, y + X.im});
    const rw_complex over = rw_quotient(R, X);
    return (rw_field){-R.re, -R.im, y * over.re, y * over.im};
}

static rw_field exact(double x, double y)
{
    const rw_field all = of_hertz(x, y), inner = of_hertz((x - MIDDLE) / HALF, y / HALF);
    return (rw_field){all.G_re - HALF * inner.G_re, all.G_im - HALF * inner.G_im,
                      all.H_re - HALF * inner.H_re, all.H_im - HALF * inner.H_im};
}

/* Places in a row of the i-th depth. Through it |R| = 1/4 is passed for all clusters. */
static void set_places(int i, double x[], double y[])
{
    const double depth[] = {1e-9, 1e-6, 1e-4, 3e-3, 0.03, 0.1, 0.3, 0.7, 1.5, 1.9, 2.5, 30, 1e3};
    for (int k = 0; k < RW_BATCH; k++) {
        x[k] = 2.5 * sin(0.7 + 13 * i + 1.9 * k) + (k % 4 == 0 ? 0.0 : 1e-3 * k);
        y[k] = depth[i];
    }
}
enum { DEPTHS = 13 };

static void assert_fields_within(rw_field is, rw_field wanted, double allowed, double of_H)
{
    assert_within(is.G_re, wanted.G_re, allowed);
    assert_within(is.G_im, wanted.G_im, allowed);
    assert_within(is.H_re, wanted.H_re, of_H);
    assert_within(is.H_im, wanted.H_im, of_H);
}

/* Next to the surface the elements themselves err by 4e-11, of y Omega' 1.3e-10. Where clusters
 * stand in for them the field changes by 3e-12, 3e-11. */
CLAIM(the_field_by_clusters_is_the_potential)
{
    rw_traction plain = fitted(), t = fitted();
    assert_true(rw_traction_cluster(&t));
    assert_true(t.cluster_count > 5 && t.cluster_count < 2 * t.count);
    for (int i = 0; i < DEPTHS; i++) {
        double x[RW_BATCH], y[RW_BATCH];
        rw_fields fields, by_elements;
        set_places(i, x, y);
        rw_traction_fields(&t, RW_BATCH, x, y, &fields);
        rw_traction_fields(&plain, RW_BATCH, x, y, &by_elements);
        for (int k = 0; k < RW_BATCH; k++) {
            const rw_field is = rw_field_in(&fields, k);
            assert_fields_within(is, exact(x[k], y[k]), 1e-10, 3e-10);
            assert_fields_within(is, rw_field_in(&by_elements, k), 1e-11, 6e-11);
        }
    }
    rw_traction_destroy(&plain);
    rw_traction_destroy(&t);
}

/* Far away little is left: relative to it. */
CLAIM(the_field_far_away_has_all_its_digits)
{
    rw_traction t = fitted();
    assert_true(rw_traction_cluster(&t));
    for (double y = 10; y < 1e9; y *= 10) {
        const double x = 0.3 * y;
        rw_fields fields;
        rw_traction_fields(&t, 1, &x, &y, &fields);
        const rw_field wanted = exact(x, y);
        assert_fields_within(rw_field_in(&fields, 0), wanted, 1e-12 / y, 1e-12 / y);
    }
    rw_traction_destroy(&t);
}

/* Threads share out the places: each must have the same bits, whatever the others are. */
CLAIM(what_a_place_has_does_not_depend_on_the_others)
{
    rw_traction t = fitted();
    assert_true(rw_traction_cluster(&t));
    for (int i = 0; i < DEPTHS; i++) {
        double x[RW_BATCH], y[RW_BATCH];
        rw_fields all, alone;
        set_places(i, x, y);
        y[3] = y[4] = 0;
        rw_traction_fields(&t, RW_BATCH, x, y, &all);
        for (int k = 0; k < RW_BATCH; k++) {
            rw_traction_fields(&t, 1, x + k, y + k, &alone);
            const rw_field in_row = rw_field_in(&all, k), own = rw_field_in(&alone, 0);
            assert_memory_equal(&in_row, &own, sizeof own);
        }
    }
    rw_traction_destroy(&t);
}

/* The sums over all elements, and over clusters. */
CLAIM(clusters_change_no_displacement_and_no_surface)
{
    rw_traction plain = fitted(), t = fitted();
    assert_true(rw_traction_cluster(&t));
    for (int i = -300; i <= 300; i++) {
        const double x = i / 100.0 + 1e-4, y = 0;
        rw_fields is, wanted;
        assert_within(rw_traction_displacement(&t, x), rw_traction_displacement(&plain, x), 1e-12);
        rw_traction_fields(&t, 1, &x, &y, &is);
        rw_traction_fields(&plain, 1, &x, &y, &wanted);
        assert_within(is.G_re[0], wanted.G_re[0], 5e-12);
        assert_true(is.G_im[0] == wanted.G_im[0] && is.H_re[0] == 0 && is.H_im[0] == 0);
        assert_close(rw_traction_slope(&plain, x), wanted.G_re[0], 1e-12);
    }
    assert_close(rw_traction_displacement(&t, 1e7), rw_traction_displacement(&plain, 1e7), 1e-14);
    rw_traction_destroy(&plain);
    rw_traction_destroy(&t);
}

/* They would belong to what was there before. */
CLAIM(a_traction_that_changes_loses_its_clusters)
{
    rw_traction t = fitted();
    const rw_element last = t.elements[t.count - 1];
    for (int i = 0; i < 3; i++) {
        assert_true(rw_traction_cluster(&t) && t.cluster_count > 0);
        if (i == 0)
            rw_traction_simplify(&t, 1e-9);
        else if (i == 1)
            rw_traction_raise(&t, -1, 1, 0.1);
        else
            assert_true(rw_traction_append(&t, &last));
        assert_int_equal(t.cluster_count, 0);
    }
    rw_traction_destroy(&t);
}
