/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Rainflow against examples of the standard and of a book, by how much each range is counted. */
#include "claims.h"
#include "rwedge.h"

#include <float.h>

enum { MAX = 24 };

typedef struct {
    size_t n;
    double value[MAX];
} history;

/* A cycle's ends, and how often it is counted. */
typedef struct {
    double from, to, count;
} counted;

/* How often cycles between these two values are counted. */
static double counts_between(const history *h, int32_t repeats, double from, double to)
{
    double range[MAX], mean[MAX], count[MAX], sum = 0;
    assert_ok(rwedge_rainflow(h->n, h->value, repeats, range, mean, count));
    for (size_t i = 0; i < h->n; i++)
        if (range[i] == fabs(to - from) && mean[i] == (from + to) / 2)
            sum += count[i];
    return sum;
}

static double all_counts(const history *h, int32_t repeats)
{
    double range[MAX], mean[MAX], count[MAX], sum = 0;
    assert_ok(rwedge_rainflow(h->n, h->value, repeats, range, mean, count));
    for (size_t i = 0; i < h->n; i++)
        sum += count[i];
    return sum;
}

static void assert_counted(const history *h, int32_t repeats, size_t n, const counted expected[])
{
    double sum = 0;
    for (size_t i = 0; i < n; i++) {
        assert_close(counts_between(h, repeats, expected[i].from, expected[i].to),
                     expected[i].count, 0);
        sum += expected[i].count;
    }
    assert_close(all_counts(h, repeats), sum, 0);
}

#define ASSERT_COUNTED(h, repeats, ...)                                                            \
    assert_counted(h, repeats, sizeof((counted[]){__VA_ARGS__}) / sizeof(counted),                 \
                   (const counted[]){__VA_ARGS__})

/* ASTM E1049-85, Fig. 6 (once) and Fig. 7 (repeated). */
static const history EXAMPLE = {9, {-2, 1, -3, 5, -1, 3, -4, 4, -2}};

CLAIM(the_example_of_the_standard)
{
    ASSERT_COUNTED(&EXAMPLE, 0, {-2, 1, 0.5}, {1, -3, 0.5}, {-1, 3, 1}, {-3, 5, 0.5}, {5, -4, 0.5},
                   {-4, 4, 0.5}, {4, -2, 0.5});
    ASSERT_COUNTED(&EXAMPLE, 1, {5, -4, 1}, {4, -3, 1}, {-1, 3, 1}, {-2, 1, 1});
}

/* E. Haibach, "Betriebsfestigkeit", fig. 3.3-30, as pyLife's tests have it: what they call the
 * residuals is counted half, range by range. ../../others/published.py counts random histories by
 * pyLife itself. */
CLAIM(the_example_of_haibach)
{
    ASSERT_COUNTED((&(history){19, {2, 5, 3, 6, 2, 3, 1, 6, 1, 4, 2, 3, 1, 4, 2, 5, 3, 4, 2}}), 0,
                   {5, 3, 1}, {2, 3, 2}, {1, 6, 1.5}, {1, 4, 1}, {4, 2, 1}, {3, 4, 1}, {2, 6, 0.5},
                   {1, 5, 0.5}, {5, 2, 0.5});
}

CLAIM(what_stands_still_has_no_cycles)
{
    for (int32_t repeats = 0; repeats <= 1; repeats++) {
        assert_true(all_counts(&(history){1, {7}}, repeats) == 0);
        assert_true(all_counts(&(history){4, {7, 7, 7, 7}}, repeats) == 0);
    }
    assert_true(all_counts(&(history){4, {0, 1, 1, 3}}, 0) == 0.5);
    assert_true(all_counts(&(history){4, {0, 1, 1, 3}}, 1) == 1);
}

/* 1.2.0 left half cycles over, of the ranges 0.5, 5.6e-17, 4.4e-16: it compared rounded ranges. */
CLAIM(values_that_differ_by_rounding_leave_no_half_cycle_over)
{
    const double above = 0.30000000000000004, low = -499.9999999999999, end = -20.000000000000004;
    ASSERT_COUNTED((&(history){3, {1, -1e17, 0.5}}), 1, {1, -1e17, 1});
    ASSERT_COUNTED((&(history){3, {above, -20, 0.3}}), 1, {above, -20, 1});
    ASSERT_COUNTED((&(history){6, {0.006, low, 2.9999999999999996, 3, 0.005, end}}), 1, {3, low, 1},
                   {0.006, end, 1});
}

/* Values one or two roundings apart, drawn at random. */
CLAIM(a_history_that_repeats_has_whole_cycles_alone)
{
    uint64_t seed = 5;
    for (int i = 0; i < 2000; i++) {
        history h = {.n = 12};
        double range[MAX], mean[MAX], count[MAX];
        for (size_t j = 0; j < h.n; j++)
            h.value[j] = floor(3 * random_fraction(&seed)) - 1 +
                         floor(4 * random_fraction(&seed)) * DBL_EPSILON / 2;
        assert_ok(rwedge_rainflow(h.n, h.value, 1, range, mean, count));
        for (size_t j = 0; j < h.n; j++)
            assert_true(count[j] == 0 || count[j] == 1);
    }
}

CLAIM(refusals_leave_the_counts_alone)
{
    double range[2] = {5, 6}, mean[2] = {7, 8}, count[2] = {9, 10};
    const double good[2] = {0, 1}, bad[2] = {0, NAN};
    assert_int_equal(rwedge_rainflow(2, bad, 0, range, mean, count), RWEDGE_EDOMAIN);
    assert_int_equal(rwedge_rainflow(2, good, 2, range, mean, count), RWEDGE_EDOMAIN);
    assert_int_equal(rwedge_rainflow(0, good, 0, range, mean, count), RWEDGE_ERANGE);
    assert_int_equal(rwedge_rainflow(SIZE_MAX / 8, good, 0, range, mean, count), RWEDGE_ERANGE);
    assert_true(range[0] == 5 && mean[1] == 8 && count[1] == 10);
}
