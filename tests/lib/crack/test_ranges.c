/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What a cycle changes of K, and the threshold of short cracks. */
#include "claims.h"
#include "rwedge.h"

enum { LOADS = 5, CRACKS = 40, FINE = 2000 };

typedef struct {
    double I, II, K_max, R;
} ranges;

static ranges ranges_of(size_t loads, const double K_I[], const double K_II[], int32_t shear)
{
    ranges r;
    assert_ok(rwedge_crack_ranges(loads, 1, K_I, K_II, shear, &r.I, &r.II, &r.K_max, &r.R));
    return r;
}

/* The loads with FINE parts of each step; K of the crack j is random. */
static void refine(const double coarse[], size_t cracks, size_t j, double fine[])
{
    for (size_t i = 0; i < LOADS; i++)
        for (size_t part = 0; part < FINE; part++) {
            const double share = (double)part / FINE;
            fine[i * FINE + part] =
                (1 - share) * coarse[i * cracks + j] + share * coarse[(i + 1) % LOADS * cracks + j];
        }
}

static double range_while(size_t n, const double K_I[], const double K_II[], double above)
{
    double most = -HUGE_VAL, least = HUGE_VAL;
    for (size_t i = 0; i < n; i++)
        if (K_I[i] > above) {
            most = fmax(most, K_II[i]);
            least = fmin(least, K_II[i]);
        }
    return most > least ? most - least : 0;
}

CLAIM(ranges_are_those_of_the_straight_way_between_loads)
{
    static double I[LOADS * CRACKS], II[LOADS * CRACKS], fine_I[LOADS * FINE],
        fine_II[LOADS * FINE];
    static double range_I[CRACKS], range_II[3][CRACKS], K_max[CRACKS], R[CRACKS];
    uint64_t state = 5;
    for (size_t i = 0; i < LOADS * CRACKS; i++) {
        I[i] = random_between(&state, -1, 1.2);
        II[i] = random_between(&state, -1, 1);
    }
    for (int32_t shear = RWEDGE_FACES_MODE_I; shear <= RWEDGE_FACES_FREE; shear++)
        assert_ok(
            rwedge_crack_ranges(LOADS, CRACKS, I, II, shear, range_I, range_II[shear], K_max, R));
    for (size_t j = 0; j < CRACKS; j++) {
        refine(I, CRACKS, j, fine_I);
        refine(II, CRACKS, j, fine_II);
        double most = 0, least = HUGE_VAL, largest = 0;
        for (size_t i = 0; i < LOADS * FINE; i++) {
            most = fmax(most, fine_I[i]);
            least = fmin(least, fine_I[i]);
            if (fine_I[i] > 0)
                largest = fmax(largest, hypot(fine_I[i], fine_II[i]));
        }
        assert_within(range_I[j], most - fmax(least, 0), 1e-14);
        assert_within(range_II[RWEDGE_FACES_MODE_I][j], 0, 0);
        assert_within(range_II[RWEDGE_FACES_LOCKED][j],
                      range_while(LOADS * FINE, fine_I, fine_II, 0), 4.0 / FINE);
        assert_within(range_II[RWEDGE_FACES_FREE][j],
                      range_while(LOADS * FINE, fine_I, fine_II, -HUGE_VAL), 1e-14);
        assert_within(K_max[j], largest, 4.0 / FINE);
        assert_within(R[j], most > 0 ? least / most : 0, 1e-12);
    }
}

CLAIM(more_loads_on_the_same_way_change_nothing)
{
    const double I[] = {3, -1, 2}, II[] = {1, 4, -2};
    const double I_parts[] = {3, 2, 0.5, -1, -0.25, 1.25, 2},
                 II_parts[] = {1, 1.75, 2.875, 4, 2.5, -0.5, -2};
    for (int32_t shear = RWEDGE_FACES_MODE_I; shear <= RWEDGE_FACES_FREE; shear++) {
        const ranges coarse = ranges_of(3, I, II, shear),
                     fine = ranges_of(7, I_parts, II_parts, shear);
        assert_close(fine.I, coarse.I, 1e-14);
        assert_within(fine.II, coarse.II, 1e-14);
        assert_close(fine.K_max, coarse.K_max, 1e-14);
        assert_close(fine.R, coarse.R, 1e-14);
    }
    assert_close(ranges_of(3, I, II, RWEDGE_FACES_LOCKED).II, 1 + 0.75 * 3 + 2, 1e-14);
}

CLAIM(a_crack_that_is_closed_all_the_time_has_no_range)
{
    const double I[] = {-3, -1}, II[] = {1, 4};
    const ranges locked = ranges_of(2, I, II, RWEDGE_FACES_LOCKED),
                 free_faces = ranges_of(2, I, II, RWEDGE_FACES_FREE);
    assert_true(locked.I == 0 && locked.II == 0 && locked.K_max == 0 && locked.R == 0);
    assert_true(free_faces.I == 0 && free_faces.II == 3);
}

CLAIM(ranges_that_cannot_be_are_refused)
{
    const double K[] = {1, 2}, wrong[] = {1, NAN};
    double kept = 7;
    assert_int_equal(rwedge_crack_ranges(2, 1, K, wrong, 0, &kept, &kept, &kept, &kept),
                     RWEDGE_EDOMAIN);
    assert_int_equal(rwedge_crack_ranges(2, 1, wrong, K, 0, &kept, &kept, &kept, &kept),
                     RWEDGE_EDOMAIN);
    assert_int_equal(rwedge_crack_ranges(2, 1, K, K, 3, &kept, &kept, &kept, &kept),
                     RWEDGE_EDOMAIN);
    assert_int_equal(rwedge_crack_ranges(2, 1, K, K, -1, &kept, &kept, &kept, &kept),
                     RWEDGE_EDOMAIN);
    assert_int_equal(rwedge_crack_ranges(0, 1, K, K, 0, &kept, &kept, &kept, &kept), RWEDGE_ERANGE);
    assert_int_equal(rwedge_crack_ranges(SIZE_MAX, 2, K, K, 0, &kept, &kept, &kept, &kept),
                     RWEDGE_ERANGE);
    assert_int_equal(rwedge_crack_ranges(2, 1, K, K, 0, &kept, &kept, &kept, NULL), RWEDGE_ENULL);
    assert_true(kept == 7);
}

/* ---- The threshold ---- */

/* The edge crack of a plain specimen at its limit has K = 1.1215 ds0 sqrt(pi l). */
CLAIM(a_plain_specimen_at_its_limit_stands_on_the_threshold)
{
    const double dK_th = 66.4, ds0 = 248, a0 = pow(dK_th / (1.1215222552310553 * ds0), 2) / PI;
    for (double length = 1e-30; length < 1e30; length *= 1000) {
        const double threshold = rwedge_short_crack_threshold(length, dK_th, ds0);
        const double specimen = 1.1215222552310553 * ds0 * sqrt(PI * length);
        assert_close(threshold, dK_th * sqrt(length / (length + a0)), 1e-14);
        assert_true(threshold < specimen * (1 + 1e-14));
        if (length < 1e-12)
            assert_close(threshold, specimen, 1e-9);
    }
    assert_close(rwedge_critical_distance(dK_th, ds0) / a0, pow(1.1215222552310553, 2), 1e-14);
    assert_true(rwedge_short_crack_threshold(1e-9, dK_th, HUGE_VAL) == dK_th);
    assert_true(rwedge_short_crack_threshold(1e-9, 0, ds0) == 0);
    assert_nan(rwedge_short_crack_threshold(0, dK_th, ds0));
    assert_nan(rwedge_short_crack_threshold(1, -1, ds0));
    assert_nan(rwedge_short_crack_threshold(1, dK_th, 0));
}
