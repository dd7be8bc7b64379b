/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Criteria of the smallest sphere around a path, against closed forms and a search of its
 * centre. */
#include "claims.h"
#include "planes/smallest_ball.h"
#include "rwedge.h"

static const double TENSION[2] = {100, -100}, NOTHING[2] = {0, 0};

static double measured(int32_t criterion, size_t n, const double *sxx, const double *syy,
                       const double *txy, double nu, double alpha)
{
    double value, angle = 1, out_of_plane = 1;
    assert_ok(rwedge_criterion(criterion, &alpha, n, sxx, syy, txy, nu, 0, &value, &angle,
                               &out_of_plane));
    assert_true(angle == 0 && out_of_plane == 0);
    return value;
}

CLAIM(spheres_around_textbook_paths_are_exact)
{
    enum { N = 48 };
    double sxx[N], syy[N], txy[N], value;
    const double zero[1] = {0}, shear[1] = {123};
    value = measured(RWEDGE_MEASURE_CROSSLAND, 2, NOTHING, NOTHING, TENSION, 0.3, 0.2);
    assert_close(value, 100, 1e-15);
    value = measured(RWEDGE_MEASURE_CROSSLAND, 1, zero, zero, shear, 0.3, 0.2);
    assert_within(value, 0, 0);
    for (int axis = 100; axis >= 40; axis -= 60) { /* a circle, an ellipse */
        for (int i = 0; i < N; i++) {
            const double t = 2 * PI * i / N;
            syy[i] = axis * cos(t), sxx[i] = -syy[i], txy[i] = 100 * sin(t);
        }
        value = measured(RWEDGE_MEASURE_CROSSLAND, N, sxx, syy, txy, 0.3, 0.2);
        assert_close(value, 100, 1e-14);
    }
    /* uniaxial tension +-s: sqrt(J2) is s/sqrt(3), the hydrostatic stress s/3 */
    value = measured(RWEDGE_MEASURE_CROSSLAND, 2, TENSION, NOTHING, NOTHING, 0, 0.2);
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
        radius = measured(RWEDGE_MEASURE_CROSSLAND, N, sxx, syy, txy, 0, 0);
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
    value = measured(RWEDGE_MEASURE_DANG_VAN, 2, TENSION, NOTHING, NOTHING, 0, 0.3);
    assert_close(value, 50 + 0.3 * 100 / 3, 1e-14);
    value = measured(RWEDGE_MEASURE_DANG_VAN, 2, pulse, NOTHING, NOTHING, 0, 0.3);
    assert_close(value, 50 + 0.3 * 200 / 3, 1e-14);
    value = measured(RWEDGE_MEASURE_DANG_VAN, 2, crush, NOTHING, NOTHING, 0, 0.3);
    assert_close(value, 50, 1e-14);
    value = measured(RWEDGE_MEASURE_DANG_VAN, 2, NOTHING, NOTHING, TENSION, 0, 0.3);
    assert_close(value, 100, 1e-14);
}
