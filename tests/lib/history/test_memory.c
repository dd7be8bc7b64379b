/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The memory diagram, apart from any geometry, and the displacement of a patch. */
#include "claims.h"
#include "history/memory.h"
#include "rwedge.h"
#include "history/gap.h"

#include <float.h>
#include <stdlib.h>

static void destroy(void *path)
{
    rw_memory_destroy(path);
    free(path);
}

static rw_memory *new_path(void)
{
    rw_memory *path = malloc(sizeof *path);
    assert_true(path && rw_memory_create(path));
    free_after_claim(path, destroy);
    return path;
}

static void advance(rw_memory *path, double load, double shear)
{
    assert_true(rw_memory_reserve(path, 2));
    const rw_memory_loads to = {.load = load, .shear = shear};
    const rw_departure departure = rw_memory_departure(path, to);
    rw_memory_advance(path, &departure, to);
}

static double shear_at(const rw_memory *path, double load)
{
    const rw_path all = rw_memory_path(path);
    return rw_path_shear(&all, load);
}

static void assert_corner(const rw_memory *path, size_t i, double load, double shear)
{
    assert_true(i < path->count);
    assert_within(path->corners[i].load, load, 1e-15);
    assert_within(path->corners[i].shear, shear, 1e-15);
}

/* After a first load in proportion, Q goes through a cycle. P is constant but for rounding. What
 * slips must have |D| = 1 to the last bit; else the stick zone would end at the edge. */
CLAIM(rounding_of_the_load_hides_no_slip)
{
    static const double ROUNDINGS[][8] = {
        {17, 0, -8, -3, 0, 19, 0, 0}, {0, -8, -16, -1, 3, 0, -11, 2}, {0, 5, -7, 0, 0, 0, 0, 0}};
    for (size_t i = 0; i < sizeof ROUNDINGS / sizeof *ROUNDINGS; i++)
        for (double T = 0.0131; T < 1; T += 0.0131) {
            rw_memory *path = new_path();
            for (int j = 0; j < 40; j++) {
                const double *off = &ROUNDINGS[i][j % 4], shear = T * (1 + off[4] * DBL_EPSILON);
                advance(path, 1 + off[0] * DBL_EPSILON, j % 2 ? shear : -shear);
                if (j == 0)
                    continue;
                assert_true(rw_memory_end(path)->ratio == (j % 2 ? 1 : -1));
                assert_true(path->corners[path->count - 2].load <= 1 - T + 1e-14);
            }
        }
}

/* A load goes back to a corner of the path, and slips by rounding alone. The path then ends at that
 * corner. */
CLAIM(a_slip_of_a_rounding_ends_at_the_corner)
{
    rw_memory *path = new_path();
    advance(path, 0.5, 0.5);
    advance(path, 0.99999999999999911, 0);
    advance(path, 0.5, 0.5);
    assert_int_equal(path->count, 2);
    assert_corner(path, 1, 0.5, 0.5);
}

CLAIM(collinear_steps_are_one)
{
    rw_memory *line = new_path(), *steep = new_path();
    advance(steep, 0.3, 0.1);
    const int steps = 30000;
    for (int i = 1; i <= steps; i++) {
        const double load = (double)i / steps;
        advance(line, load, 0.3 * load);
        advance(steep, 0.3 + load, 0.1 - load);
        /* exactly: it says where friction is exhausted */
        assert_true(rw_memory_end(steep)->ratio == -1);
    }
    assert_int_equal(line->count, 2);
    assert_int_equal(steep->count, 3);
}

/* Each step differs from a straight one by less than rounding; all together do not. */
CLAIM(a_slow_bend_is_not_straightened)
{
    for (int sign = -1; sign <= 1; sign += 2) {
        rw_memory *bend = new_path();
        advance(bend, 1, 0);
        const int steps = 30000;
        for (int i = 1; i <= steps; i++)
            advance(bend, 1 + 1e-9 * i, sign * 0.5e-18 * i * (double)i);
        assert_true(bend->count < 1000);
        for (int i = 1; i <= steps; i += 7)
            assert_within(shear_at(bend, 1 + 1e-9 * i), sign * 0.5e-18 * i * (double)i,
                          8 * DBL_EPSILON);
    }
}

/* 1e6 steps of half an epsilon each: none may be lost, nor may they pile up. */
CLAIM(creep_below_rounding_is_not_lost)
{
    rw_memory *path = new_path();
    advance(path, 1, 0);
    for (int i = 1; i <= 1000000; i++)
        advance(path, 1, i * DBL_EPSILON / 2);
    double shear = 0;
    for (size_t i = 1; i < path->count; i++)
        shear += path->corners[i].ratio * (path->corners[i].load - path->corners[i - 1].load);
    assert_within(shear, 1e6 * DBL_EPSILON / 2, 8 * DBL_EPSILON);
    assert_true(path->count <= 4);
}

/* Loads around a point, as far from it as any number of roundings: a corner stays only if it is the
 * highest or lowest of all since, so that there are about as many as digits in their number. */
CLAIM(dithering_leaves_few_corners)
{
    uint64_t seed = 21;
    for (double far = DBL_EPSILON; far < 1e-8; far *= 4)
        for (int kind = 0; kind < 3; kind++) {
            rw_memory *path = new_path();
            advance(path, 1, 0);
            advance(path, 1, 0.3);
            for (int i = 0; i < 100000; i++) {
                const double by = kind == 1 ? 0 : far * (2 * random_fraction(&seed) - 1);
                const double shear = kind == 2 ? 0 : far * (2 * random_fraction(&seed) - 1);
                advance(path, 1 + by, 0.3 + shear);
                assert_true(path->count < 45);
            }
        }
}

/* A load that grows by roundings, and dithers. Two layers together are thicker than the tolerance:
 * a path of slopes up to 1 is straight to within its length. */
CLAIM(growth_by_roundings_leaves_no_more_than_it_is_long)
{
    uint64_t seed = 22;
    for (double step = DBL_EPSILON / 4; step < 2 * DBL_EPSILON; step *= 2) {
        rw_memory *path = new_path();
        advance(path, 1, 0);
        enum { STEPS = 30000 };
        for (int i = 0; i < STEPS; i++)
            advance(path, 1 + i * step, step * (2 * random_fraction(&seed) - 1));
        assert_true((double)path->count < 4 + 2 * STEPS * step / rw_memory_tolerance(1));
    }
}

CLAIM(each_load_adds_two_corners_at_most)
{
    rw_memory *path = new_path();
    advance(path, 1, 0);
    for (int i = 1; i < 1000; i++) { /* ever smaller reversals: the worst there is */
        const size_t before = path->count;
        advance(path, 1, (i % 2 ? 0.9 : -0.9) * (1 - i / 1001.0));
        assert_true(path->count <= before + 1); /* two with the load itself rising */
    }
    assert_int_equal(path->count, 1001);
    advance(path, 1, 0.95);
    assert_int_equal(path->count, 3);
}

/* ---- The displacement of a patch ---- */

/* Seen from far away the patch is a point. x^2 would overflow there, and the deformation is a part
 * log(x)/x of the profile. */
CLAIM(far_from_its_patch_the_gap_is_the_profile)
{
    static const double ALPHAS[] = {0, 0.3, 1, 100, 1e190, 1e250},
                        XS[] = {1e20, 1e154, 1e200, 1e280};
    for (size_t i = 0; i < sizeof ALPHAS / sizeof *ALPHAS; i++)
        for (size_t j = 0; j < sizeof XS / sizeof *XS; j++) {
            const rw_geometry wedge = {.a = ALPHAS[i]};
            assert_close(rw_patch_gap(&wedge, (rw_patch){-1, 1}, XS[j]),
                         rw_wedge_height(ALPHAS[i], XS[j]), 1e-15);
        }
}
