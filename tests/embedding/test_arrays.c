/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Every function of arrays of points gives each of them the bits that it gives it alone, and that
 * the function of one point gives. Its results may be written where its arguments are. */
#include "calls.h"
#include "claims.h"

#include <stdio.h>
#include <string.h>

enum { POINTS = 45, LOADS = 5, MOST = POINTS * LOADS, CALLS = 4, DRAWS = 100 };

typedef double arrays[ENTRY_ARGUMENTS][MOST];

/* Which of the sizes is that of the points; -1 where there are none. */
static int points_of(const entry *e)
{
    int last = e->sizes - 1;
    while (last >= 0 && e->size[last].count != NULL)
        last--;
    const bool is_whole = strcmp(e->name, "rainflow") == 0 || strncmp(e->name, "profile_", 8) == 0;
    if (last < 0 || e->results == 0 || is_whole ||
        e->size[0].teller) /* an array of loads, which are a history or those of the object */
        return -1;
    const signed char *of_result = e->result[0].sizes;
    return e->pointwise || (last > 0 && (of_result[0] == last || of_result[1] == last)) ? last : -1;
}

static size_t count_of(const signed char sizes[2], const size_t n[])
{
    return (sizes[0] < 0 ? 1 : n[(int)sizes[0]]) * (sizes[1] < 0 ? 1 : n[(int)sizes[1]]);
}

static int32_t call(const entry *e, void *object, const size_t n[], double *const v[],
                    double *const r[])
{
    const double *in[ENTRY_ARGUMENTS];
    memcpy(in, v, sizeof in);
    if (!e->changes_object)
        return e->call(object, n, in, r, NULL);
    rwedge_contact *copy = NULL;
    assert_ok(rwedge_contact_copy(object, &copy));
    const int32_t status = e->call(copy, n, in, r, NULL);
    rwedge_contact_destroy(copy);
    return status;
}

static void set_implied(const entry *e, size_t n[])
{
    for (int j = 0; j < e->sizes; j++)
        n[j] = e->size[j].count != NULL ? implied_count(e, j) : n[j];
}

static void point_to(arrays a, double *pointer[ENTRY_ARGUMENTS])
{
    for (int j = 0; j < ENTRY_ARGUMENTS; j++)
        pointer[j] = a[j];
}

/* Of one point: its numbers stand in the array of all at i POINTS + point. */
static void take_point(const signed char sizes[2], int dimension, int point, const double all[],
                       double alone[])
{
    const bool has_points = sizes[0] == dimension || sizes[1] == dimension;
    for (int i = 0; i < (has_points ? LOADS : POINTS); i++)
        alone[i] = has_points ? all[i * POINTS + point] : all[i];
}

/* By the function itself, or by that of one point. */
static void assert_alone(const entry *e, const entry *single, void *object, arrays in, arrays out)
{
    static arrays v, got, expected;
    double *to_v[ENTRY_ARGUMENTS], *to_got[ENTRY_ARGUMENTS];
    const int dimension = points_of(e);
    size_t n[ENTRY_SIZES] = {LOADS, 1};
    n[dimension] = 1;
    set_implied(e, n);
    point_to(v, to_v);
    point_to(got, to_got);
    for (int point = 0; point < POINTS; point++) {
        for (int j = 0; j < e->arguments; j++)
            take_point(e->argument[j].sizes, dimension, point, in[j], v[j]);
        assert_ok(call(single, object, n, to_v, to_got));
        for (int j = 0; j < e->results; j++) {
            take_point(e->result[j].sizes, dimension, point, out[j], expected[j]);
            assert_memory_equal(got[j], expected[j],
                                count_of(e->result[j].sizes, n) * sizeof(double));
        }
    }
}

/* One result is written over one argument that is as long: all pairs in turn, which it counts. */
static int assert_in_place(const entry *e, void *object, const size_t n[], arrays in)
{
    static arrays v, out, own;
    double *to_v[ENTRY_ARGUMENTS], *to_out[ENTRY_ARGUMENTS], *over[ENTRY_ARGUMENTS];
    int pairs = 0;
    point_to(v, to_v);
    point_to(out, to_out);
    memcpy(v, in, sizeof v);
    assert_ok(call(e, object, n, to_v, to_out));
    for (int k = 0; k < e->results; k++)
        for (int j = 0; j < e->arguments; j++) {
            const size_t length = count_of(e->result[k].sizes, n);
            if (e->argument[j].sizes[0] < 0 || count_of(e->argument[j].sizes, n) != length)
                continue;
            memcpy(v, in, sizeof v);
            point_to(own, over);
            over[k] = v[j];
            assert_ok(call(e, object, n, to_v, over));
            for (int i = 0; i < e->results; i++)
                assert_memory_equal(over[i], out[i],
                                    count_of(e->result[i].sizes, n) * sizeof(double));
            pairs++;
        }
    return pairs;
}

/* No points need no arrays, unless their loads are arrays of stresses. */
static void assert_none(const entry *e, void *object, arrays in, arrays out)
{
    const bool is_field = !e->pointwise && !e->takes_object;
    size_t n[ENTRY_SIZES] = {LOADS, 0};
    double *v[ENTRY_ARGUMENTS], *none[ENTRY_ARGUMENTS];
    n[points_of(e)] = 0;
    set_implied(e, n);
    for (int j = 0; j < ENTRY_ARGUMENTS; j++) {
        const bool is_empty = j < e->arguments && count_of(e->argument[j].sizes, n) == 0;
        v[j] = is_empty && !is_field ? NULL : in[j];
        none[j] = is_field ? out[j] : NULL;
    }
    assert_ok(call(e, object, n, v, none));
}

/* The function of one point, or the function itself. */
static const entry *of_one_point(const entry *e)
{
    char name[64];
    const char *end = strstr(e->name, "_field");
    snprintf(name, sizeof name, "%.*s", end != NULL ? (int)(end - e->name) : 0, e->name);
    const entry *single = entry_named(e->array_of != NULL ? e->array_of : name);
    return single != NULL ? single : e;
}

static bool try_arrays(const entry *e, void *object, uint64_t *seed, int *pairs)
{
    static arrays in, out;
    double *to_in[ENTRY_ARGUMENTS], *to_out[ENTRY_ARGUMENTS];
    const int dimension = points_of(e);
    size_t n[ENTRY_SIZES] = {LOADS, POINTS};
    n[dimension] = POINTS;
    set_implied(e, n);
    for (int j = 0; j < e->arguments; j++) {
        for (int i = 0; i < MOST; i++)
            in[j][i] = draw_argument(e, j, seed);
        if (e->argument[j].sizes[0] >= 0)
            draw_constants(e, j, n[e->argument[j].sizes[0]], in[j]);
    }
    point_to(in, to_in);
    point_to(out, to_out);
    if (call(e, object, n, to_in, to_out) != RWEDGE_OK)
        return false;
    assert_none(e, object, in, out);
    assert_alone(e, e, object, in, out);
    assert_alone(e, of_one_point(e), object, in, out);
    for (int i = 0; i <= dimension; i++) { /* one load at many points, many loads at one */
        size_t many[ENTRY_SIZES] = {i < dimension ? 1 : n[0], i < dimension ? POINTS : 1};
        set_implied(e, many);
        *pairs += assert_in_place(e, object, dimension == 0 ? n : many, in);
    }
    return true;
}

CLAIM(arrays_have_the_bits_of_their_points)
{
    int functions = 0;
    for (int i = 0; i < ENTRY_COUNT; i++) {
        const entry *e = &entries[i];
        uint64_t seed = 1;
        int done = 0, pairs = 0;
        for (int k = 0; points_of(e) >= 0 && k < DRAWS && done < CALLS; k++)
            done += try_arrays(e, e->takes_object ? object_of(e, k) : NULL, &seed, &pairs);
        if (points_of(e) >= 0 && done < CALLS)
            fail_msg("%s: %d calls", e->name, done);
        if (done > 0 && pairs == 0)
            fail_msg("%s: no result is as long as an argument", e->name);
        functions += done > 0;
    }
    assert_in_range(functions, 9, ENTRY_COUNT);
}
