/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Contours of fields whose contours are known. */
#include "picture/contour.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stdint.h>
#include <stdlib.h>

#include <cmocka.h>

enum { SIDE = 101 };
static double axis_values[SIDE], field_values[SIDE * SIDE];
static const contour_grid grid = {SIDE, SIDE, axis_values, axis_values, field_values};

/* On the square |x|, |y| <= 1. */
static void sample(double (*field)(double x, double y))
{
    for (int i = 0; i < SIDE; i++)
        axis_values[i] = (2.0 * i - (SIDE - 1)) / (SIDE - 1);
    for (int j = 0; j < SIDE; j++)
        for (int i = 0; i < SIDE; i++)
            field_values[j * SIDE + i] = field(axis_values[i], axis_values[j]);
}

static contour_loops trace(double height, int level)
{
    contour_loops loops = {NULL, 0};
    assert_true(contour_trace(&grid, height, level, &loops));
    return loops;
}

static void assert_area(const contour_loop *one, double twice_expected)
{
    assert_true(fabs(one->area - twice_expected) <= 2e-3 * twice_expected);
}

static double hill(double x, double y)
{
    return 1 - hypot(x, y);
}

static double bowl(double x, double y)
{
    return hypot(x, y);
}

static double slope(double x, double y)
{
    return x + 0 * y;
}

static double two_hills(double x, double y)
{
    return fmax(hill(2 * x - 1, 2 * y - 1), hill(2 * x + 1, 2 * y + 1));
}

/* Its saddle point is in the middle of a cell. */
static double saddle(double x, double y)
{
    return (x - 1.0 / (SIDE - 1)) * (y - 1.0 / (SIDE - 1));
}

static void contour_of_a_hill_is_a_circle(void **state)
{
    (void)state;
    sample(hill);
    contour_loops loops = trace(0.4, 3);
    assert_int_equal(loops.count, 1);
    assert_int_equal(loops.loop[0].level, 3);
    assert_false(loops.loop[0].hole);
    assert_area(&loops.loop[0], 2 * 3.14159265 * 0.36);
    for (size_t i = 0; i < loops.loop[0].count; i++) {
        const contour_point *p = &loops.loop[0].point[i];
        assert_true(fabs(hypot(p->x, p->y) - 0.6) < 1e-3);
        assert_false(p->on_border);
    }
    contour_free(&loops);
}

static void contour_of_a_bowl_is_the_border_with_a_hole(void **state)
{
    (void)state;
    sample(bowl);
    contour_loops loops = trace(0.5, 0);
    contour_sort(&loops);
    assert_int_equal(loops.count, 2);
    assert_false(loops.loop[0].hole);
    assert_area(&loops.loop[0], 2 * 4);
    assert_true(loops.loop[0].point[0].on_border);
    assert_true(loops.loop[1].hole);
    assert_area(&loops.loop[1], 2 * 3.14159265 * 0.25);
    contour_free(&loops);
}

static void contour_closes_along_the_border(void **state)
{
    (void)state;
    sample(slope);
    contour_loops loops = trace(0.25, 0);
    assert_int_equal(loops.count, 1);
    assert_area(&loops.loop[0], 2 * 2 * 0.75);
    size_t inside = 0;
    for (size_t i = 0; i < loops.loop[0].count; i++) {
        const contour_point *p = &loops.loop[0].point[i];
        inside += p->on_border ? 0 : 1;
        assert_true(p->on_border || fabs(p->x - 0.25) < 1e-12);
    }
    assert_int_equal(inside, SIDE);
    contour_free(&loops);
}

static void every_hill_has_its_loop_and_larger_ones_come_first(void **state)
{
    (void)state;
    sample(two_hills);
    contour_loops loops = trace(0.5, 5);
    assert_int_equal(loops.count, 2);
    assert_true(contour_trace(&grid, 0.2, 2, &loops));
    contour_sort(&loops);
    assert_int_equal(loops.count, 4);
    assert_int_equal(loops.loop[0].level, 2);
    assert_int_equal(loops.loop[3].level, 5);
    contour_free(&loops);
}

static void saddle_is_cut_one_way_or_the_other(void **state)
{
    (void)state;
    sample(saddle);
    contour_loops apart = trace(1e-5, 0), together = trace(-1e-5, 0);
    assert_int_equal(apart.count, 2);
    assert_int_equal(together.count, 1);
    contour_free(&apart);
    contour_free(&together);
}

static void level_above_all_has_no_loop(void **state)
{
    (void)state;
    sample(hill);
    contour_loops loops = trace(1.5, 0);
    assert_int_equal(loops.count, 0);
    contour_sort(&loops);
    contour_free(&loops);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(contour_of_a_hill_is_a_circle),
        cmocka_unit_test(contour_of_a_bowl_is_the_border_with_a_hole),
        cmocka_unit_test(contour_closes_along_the_border),
        cmocka_unit_test(every_hill_has_its_loop_and_larger_ones_come_first),
        cmocka_unit_test(saddle_is_cut_one_way_or_the_other),
        cmocka_unit_test(level_above_all_has_no_loop),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
