/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Criteria of the smallest sphere around a path, against closed forms and a search of its centre;
 * every criterion by its number. */
#include "claims.h"
#include "planes/smallest_ball.h"
#include "rwedge.h"

#include <string.h>

static const double TENSION[2] = {100, -100}, NOTHING[2] = {0, 0};

CLAIM(spheres_around_textbook_paths_are_exact)
{
    enum { N = 48 };
    double sxx[N], syy[N], txy[N], value;
    const double zero[1] = {0}, shear[1] = {123};
    assert_ok(rwedge_crossland(2, NOTHING, NOTHING, TENSION, 0.3, 0.2, &value));
    assert_close(value, 100, 1e-15);
    assert_ok(rwedge_crossland(1, zero, zero, shear, 0.3, 0.2, &value));
    assert_within(value, 0, 0);
    for (int axis = 100; axis >= 40; axis -= 60) { /* a circle, an ellipse */
        for (int i = 0; i < N; i++) {
            const double t = 2 * PI * i / N;
            syy[i] = axis * cos(t), sxx[i] = -syy[i], txy[i] = 100 * sin(t);
        }
        assert_ok(rwedge_crossland(N, sxx, syy, txy, 0.3, 0.2, &value));
        assert_close(value, 100, 1e-14);
    }
    /* uniaxial tension +-s: sqrt(J2) is s/sqrt(3), the hydrostatic stress s/3 */
    assert_ok(rwedge_crossland(2, TENSION, NOTHING, NOTHING, 0, 0.2, &value));
    assert_close(value, 100 / sqrt(3) + 0.2 * 100 / 3, 1e-15);
}

static double some_stress(uint64_t *seed)
{
    return 2 * random_fraction(seed) - 1;
}

static double farthest(size_t n, double p[][3], const double from[3], size_t *which)
{
    double most = -1;
    for (size_t i = 0; i < n; i++) {
        const double square =
            pow(p[i][0] - from[0], 2) + pow(p[i][1] - from[1], 2) + pow(p[i][2] - from[2], 2);
        *which = square > most ? i : *which;
        most = fmax(most, square);
    }
    return sqrt(most);
}

/* A centre that goes to the farthest point, less and less far, is soon the best. Of the first
 * points five are in one plane. */
CLAIM(spheres_around_random_paths_are_the_smallest)
{
    enum { N = 40, STEPS = 20000, FLAT = 7 };
    static const double d[FLAT] = {0.7495, 0.6819, 0.675, 0.7052, 0.6728, 0.7707, 0.7566},
                        s[FLAT] = {0, 1.2811, 0, 1.3418},
                        t[FLAT] = {-0.095, -0.0261, -0.0242, -0.0215, -0.0817, -0.0418, -0.0419};
    uint64_t seed = 11;
    for (int turn = 0; turn < 8; turn++) {
        double sxx[N], syy[N], txy[N], p[N][3], centre[3] = {0}, radius;
        size_t which = 0;
        for (int i = 0; i < N; i++) {
            sxx[i] = some_stress(&seed), syy[i] = some_stress(&seed), txy[i] = some_stress(&seed);
            if (turn == 0) {
                const int k = i % FLAT;
                sxx[i] = s[k] - d[k], syy[i] = s[k] + d[k], txy[i] = t[k];
            }
            p[i][0] = (syy[i] - sxx[i]) / 2, p[i][1] = txy[i];
            p[i][2] = (sxx[i] + syy[i]) / 2 / sqrt(3); /* of nu = 0 */
        }
        for (int k = 1; k <= STEPS; k++) {
            (void)farthest(N, p, centre, &which);
            for (int j = 0; j < 3; j++)
                centre[j] += (p[which][j] - centre[j]) / (k + 1);
        }
        const double around = farthest(N, p, centre, &which);
        assert_ok(rwedge_crossland(N, sxx, syy, txy, 0, 0, &radius));
        assert_true(radius <= around * (1 + 1e-14));
        assert_close(radius, around, 1e-3);
    }
}

/* Through (0, 1, -1), (1, -1, 2) and (-2, -1, -1), whose circle is around the others. On the way to
 * it edges are tried that depend on each other exactly. */
CLAIM(a_sphere_around_whole_numbers_is_exact)
{
    const rw_point points[] = {
        {{0, 1, -1}}, {{-1, -1, 2}}, {{1, -1, -1}}, {{1, -1, 2}}, {{-2, -1, -1}}};
    assert_close(rw_smallest_ball(5, points).radius, sqrt(14.0 / 3), 1e-15);
}

/* A cycle between 0 and p has the centre p/2: its shear is p/4 about it, whatever the mean, and
 * compression takes from it. */
CLAIM(dang_van_counts_from_shakedown)
{
    double value;
    const double pulse[2] = {0, 200}, crush[2] = {0, -200};
    assert_ok(rwedge_dang_van(2, TENSION, NOTHING, NOTHING, 0, 0.3, &value));
    assert_close(value, 50 + 0.3 * 100 / 3, 1e-14);
    assert_ok(rwedge_dang_van(2, pulse, NOTHING, NOTHING, 0, 0.3, &value));
    assert_close(value, 50 + 0.3 * 200 / 3, 1e-14);
    assert_ok(rwedge_dang_van(2, crush, NOTHING, NOTHING, 0, 0.3, &value));
    assert_close(value, 50, 1e-14);
    assert_ok(rwedge_dang_van(2, NOTHING, NOTHING, TENSION, 0, 0.3, &value));
    assert_close(value, 100, 1e-14);
}

/* As the functions that are named, to the bit. */
CLAIM(a_criterion_by_its_number_is_that_by_its_name)
{
    const double sxx[4] = {300, 20, -80, 45}, syy[4] = {-40, 5, 60, -10}, txy[4] = {10, 30, -90, 2};
    double v[8][2], by[8][2], a[8][2], angle[2], o[8][2], out[2];
    const int32_t measures[8] = {RWEDGE_MEASURE_STRESS_RANGE,    RWEDGE_MEASURE_SWT,
                                 RWEDGE_MEASURE_FATEMI_SOCIE,    RWEDGE_MEASURE_FINDLEY,
                                 RWEDGE_MEASURE_MODIFIED_WOHLER, RWEDGE_MEASURE_MCDIARMID,
                                 RWEDGE_MEASURE_CROSSLAND,       RWEDGE_MEASURE_DANG_VAN};
    memset(a, 0, sizeof a);
    memset(o, 0, sizeof o);
    rwedge_smith_watson_topper_planes_field(2, 2, sxx, syy, txy, 7e4, 0.3, 1, v[1], a[1], o[1]);
    rwedge_fatemi_socie_planes_field(2, 2, sxx, syy, txy, 7e4, 0.3, 1, 0.4, v[2], a[2], o[2]);
    rwedge_findley_field(2, 2, sxx, syy, txy, 0, 0.4, v[3], a[3], o[3]);
    rwedge_modified_wohler_field(2, 2, sxx, syy, txy, 0, 0.4, v[4], a[4], o[4]);
    rwedge_mcdiarmid_field(2, 2, sxx, syy, txy, 0, 0.4, 500, v[5], a[5], o[5]);
    rwedge_crossland_field(2, 2, sxx, syy, txy, 0, 0.4, v[6]);
    rwedge_dang_van_field(2, 2, sxx, syy, txy, 0, 0.4, v[7]);
    v[0][0] = 300 - -80;
    v[0][1] = 45 - 20;
    for (int i = 0; i < 8; i++) {
        assert_ok(rwedge_criterion_field(measures[i], 2, 2, sxx, syy, txy, 7e4, 0.3, 1, 0.4, 500,
                                         by[i], angle, out));
        assert_memory_equal(by[i], v[i], sizeof v[i]);
        assert_memory_equal(angle, a[i], sizeof angle);
        assert_memory_equal(out, o[i], sizeof out);
    }
    for (int32_t m = -1; m <= 12; m++)
        if (m < 0 || m > 11 || (m >= RWEDGE_MEASURE_SLIP_RANGE && m < RWEDGE_MEASURE_FINDLEY))
            assert_int_equal(rwedge_criterion_field(m, 2, 2, sxx, syy, txy, 7e4, 0.3, 1, 0.4, 500,
                                                    by[0], angle, out),
                             RWEDGE_EDOMAIN);
    assert_int_equal(
        rwedge_criterion_field(0, 2, 2, sxx, syy, txy, 7e4, 0.3, 1, 0.4, 500, by[0], NULL, out),
        RWEDGE_ENULL);
}
