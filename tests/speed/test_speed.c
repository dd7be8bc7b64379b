/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The library is as fast as it says. What is tested are ratios of times within one run: to a plain
 * evaluation of the series, and to other calls of the library. A busy machine disturbs both sides
 * alike, and one good attempt of several is enough. A loop that is no longer made of vector
 * instructions fails every attempt, and so does a search that takes twice the steps. */
#include "claims.h"
#include "stopwatch.h"
#include "works.h"

#include <stdio.h>

/* OPTIMISED_BUILD is 1 in a release build. */
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define IS_SANITIZED 1
#elif defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
#define IS_SANITIZED 1
#endif
#endif
#ifndef IS_SANITIZED
#define IS_SANITIZED 0
#endif

enum { POINTS = 20000, MANY = 1000000, LIMITS = 130, RUNS = 4, ATTEMPTS = 9 };

static void assert_ratio(const char *name, work slow, long slow_n, work fast, long fast_n,
                         double least)
{
    double best = 0;
    for (int attempt = 0; attempt < ATTEMPTS && best < least; attempt++)
        best = fmax(best, fastest(slow, slow_n, RUNS) / fastest(fast, fast_n, RUNS));
    printf("%-52s %8.2g, at least %g\n", name, best, least);
    if (best < least)
        fail_msg("%s: the ratio of times is %.2f, not %g", name, best, least);
}

static const work ARRAY_SLIDING = {NULL, array_of_points, 0, 0},
                  ARRAY_PARTIAL_SLIP = {NULL, array_of_points, 0.4, 0},
                  POINTS_SLIDING = {NULL, points_one_by_one, 0, 0},
                  POINTS_PARTIAL_SLIP = {NULL, points_one_by_one, 0.4, 0};

/* Vectors of four numbers, where the library has them; those of two are what every x86-64 has. */
static bool has_long_vectors(void)
{
#if defined(__GNUC__) && defined(__x86_64__) && !defined(_WIN32)
    return __builtin_cpu_supports("avx2");
#else
    return false;
#endif
}

/* Seen: 8.4 and 4.8, from gcc 16 6.0 and 3.6; with vectors of two 4.3 and 2.3; without vectors
 * 2.7. */
CLAIM(arrays_beat_the_series)
{
    const bool four = has_long_vectors();
    assert_ratio("series / array, full sliding", (work){.plain = plain_points}, POINTS,
                 ARRAY_SLIDING, POINTS, four ? 4.8 : 3.2);
    assert_ratio("series / array, partial slip", (work){.plain = plain_points}, POINTS,
                 ARRAY_PARTIAL_SLIP, POINTS, four ? 2.8 : 1.7);
}

/* Seen: 5.2 and 4.5, from gcc 16, whose single points are quicker, 3.1; with vectors of two 2.4
 * and 2.1; without vectors 1.5. */
CLAIM(arrays_beat_single_points)
{
    const bool four = has_long_vectors();
    assert_ratio("points one by one / array, full sliding", POINTS_SLIDING, POINTS, ARRAY_SLIDING,
                 POINTS, four ? 2.5 : 1.8);
    assert_ratio("points one by one / array, partial slip", POINTS_PARTIAL_SLIP, POINTS,
                 ARRAY_PARTIAL_SLIP, POINTS, four ? 2.5 : 1.7);
}

/* Seen: 1.8. */
CLAIM(single_points_beat_the_series)
{
    assert_ratio("series / one point, full sliding", (work){.plain = plain_points}, POINTS,
                 POINTS_SLIDING, POINTS, 1);
}

static double points_of_fifty_wedges(long n)
{
    double sum = 0;
    for (int i = 0; i < 50; i++)
        sum += points_of_a_wedge(n);
    return sum;
}

/* Seen: 0.44 and 1.35. */
CLAIM(a_pad_takes_less_than_its_arcs)
{
    const work wedge = {.plain = points_of_a_wedge}, flat = {.plain = points_of_a_flat_pad},
               fifty = {.plain = points_of_fifty_wedges}, profile = {.plain = points_of_a_profile};
    assert_ratio("a wedge / a flat pad", wedge, POINTS, flat, POINTS, 1 / 2.8);
    assert_ratio("fifty wedges / a profile of 100 places", fifty, POINTS, profile, POINTS, 1);
}

/* The time of a point is the same in an array a hundred times as long. */
CLAIM(time_grows_linearly)
{
    assert_ratio("a point of 10^4 / a point of 10^6", ARRAY_SLIDING, MANY / 100, ARRAY_SLIDING,
                 MANY, 0.6);
    assert_ratio("a limit of 130 / a limit of 2600", (work){.plain = limits_one_by_one}, LIMITS,
                 (work){.plain = limits_one_by_one}, 20 * LIMITS, 0.7);
}

/* Seen: 280. */
CLAIM(limits_beat_the_search)
{
    assert_ratio("search / elastic limit", (work){.plain = plain_limits}, 3,
                 (work){.plain = limits_one_by_one}, LIMITS, 200);
}

/* Stresses at 10000 points, n times. */
static double points_of(double corners, double M, long n)
{
    rwedge_contact *contact = worn_contact(corners, M);
    double sum = 0;
    for (long i = 0; i < n; i++) {
        must(rwedge_contact_stresses(contact, POINTS / 2, xs, ys, out[0], out[1], out[2]));
        sum += out[0][0];
    }
    rwedge_contact_destroy(contact);
    return sum;
}

/* Seen: 1.6, 0.9 and 0.5, once 0.5, 0.014 and 0.024. */
CLAIM(yield_factors_take_few_points)
{
    assert_ratio("10000 points / a yield factor, one load", (work){NULL, points_of, 2, 0}, 3,
                 (work){NULL, yield_factors, 2, 0}, 20, 1);
    assert_ratio("10000 points / a yield factor, 250 corners", (work){NULL, points_of, 250, 0}, 1,
                 (work){NULL, yield_factors, 250, 0}, 1, 0.4);
    assert_ratio("10000 points / a yield factor, off the centre",
                 (work){NULL, points_of, 250, 8000}, 1, (work){NULL, yield_factors, 250, 8000}, 1,
                 0.25);
}

/* Seen: 4e-5 and 2e-5; once 2e-5 and 0.5e-5. */
CLAIM(a_computed_load_takes_as_long_as_some_ten_thousand_points)
{
    assert_ratio("a point / a load whose tension lags", ARRAY_SLIDING, POINTS,
                 (work){NULL, lagging, 1e-3, 0}, 96, 2e-5);
    assert_ratio("a point / a load of a noisy log", ARRAY_SLIDING, POINTS,
                 (work){NULL, lagging, 1e-3, 0.03}, 96, 1e-5);
}

/* ---- Many loads ---- */

/* Reversals under one P; `falling` makes each smaller than the last, so that all are remembered. */
static rwedge_contact *reversals(long loads, bool falling, double P[], double Q[])
{
    rwedge_contact *contact = new_contact();
    for (long i = 0; i < loads; i++) {
        P[i] = 20000;
        Q[i] =
            (i % 2 ? 0.9 : -0.9) * (falling ? 12000 * (1 - (double)i / ((double)loads + 1)) : 6000);
    }
    return contact;
}

enum { LOADS = 2000 };

/* Stresses at two points after each load. */
static double history_of(double falling, double unused, long loads)
{
    (void)unused;
    static double P[LOADS], Q[LOADS], zero[LOADS];
    rwedge_contact *contact = reversals(loads, falling > 0, P, Q);
    assert_ok(rwedge_contact_stress_history(contact, (size_t)loads, P, zero, Q, zero, 2, xs, ys,
                                            out[0], out[1], out[2]));
    rwedge_contact_destroy(contact);
    return out[0][0];
}

static double calls_of(double falling, double unused, long loads)
{
    (void)unused;
    static double P[LOADS], Q[LOADS];
    rwedge_contact *contact = reversals(loads, falling > 0, P, Q);
    for (long i = 0; i < loads; i++) {
        assert_ok(rwedge_contact_apply(contact, P[i], 0, Q[i], 0));
        assert_ok(rwedge_contact_stresses(contact, 2, xs, ys, out[0], out[1], out[2]));
    }
    rwedge_contact_destroy(contact);
    return out[0][0];
}

/* Loads that grow, each remembered because Q/f bends. */
static double growing_loads(long loads)
{
    rwedge_contact *contact;
    assert_ok(rwedge_contact_create(0.01, 1, 1e-5, 0.3, &contact));
    for (long i = 1; i <= loads; i++)
        assert_ok(rwedge_contact_load(contact, (double)i, 0.1 * (double)(i + i % 2)));
    const double memory = (double)rwedge_contact_memory(contact);
    rwedge_contact_destroy(contact);
    return memory;
}

/* Seen: 0.5; once 0.06, because each load went through all of the memory. */
CLAIM(a_load_takes_the_same_time_however_many_were_before)
{
    assert_ratio("a load of 2000 / a load of 40000", (work){.plain = growing_loads}, LOADS,
                 (work){.plain = growing_loads}, 20 * LOADS, 0.2);
}

/* Seen: 15 and 2; once 0.04, because each load was noted with all of its memory. */
CLAIM(a_stress_history_is_not_slower_than_its_calls)
{
    assert_ratio("calls / history, growing memory", (work){NULL, calls_of, true, 0}, LOADS,
                 (work){NULL, history_of, true, 0}, LOADS, 1 / 1.2);
    assert_ratio("calls / history, a cycle", (work){NULL, calls_of, false, 0}, LOADS,
                 (work){NULL, history_of, false, 0}, LOADS, 1 / 1.2);
}

/* ---- Criteria over all planes ---- */

enum { CYCLE = 48, PLACES = 400 };

/* The stresses of a cycle of Q and tension in phase, from within the contact to twice its width. */
static void stress_a_field(void)
{
    double P[CYCLE], Q[CYCLE], sigma[CYCLE], zero[CYCLE] = {0};
    rwedge_contact *contact = new_contact();
    assert_ok(rwedge_contact_load(contact, 20000, 0));
    for (int i = 0; i < CYCLE; i++) {
        P[i] = 20000;
        Q[i] = 9000 * sin(6.283185307 * i / CYCLE);
        sigma[i] = Q[i] / 150;
    }
    assert_ok(rwedge_contact_stress_history(contact, CYCLE, P, zero, Q, sigma, PLACES, xs, ys,
                                            out[0], out[1], out[2]));
    rwedge_contact_destroy(contact);
}

static double planes_with_z(long n)
{
    static double value[PLACES], angle[PLACES];
    for (long i = 0; i < n; i++)
        rwedge_smith_watson_topper_field(CYCLE, PLACES, out[0], out[1], out[2], 7e4, 0.3, value,
                                         angle);
    return value[0];
}

static double all_planes(long n)
{
    static double value[PLACES], angle[PLACES], azimuth[PLACES];
    for (long i = 0; i < n; i++)
        rwedge_smith_watson_topper_planes_field(CYCLE, PLACES, out[0], out[1], out[2], 7e4, 0.3, 0,
                                                value, angle, azimuth);
    return value[0];
}

/* Seen: 0.5 to 0.55. It was 0.06, as all arcs were searched for what may be above them. */
CLAIM(all_planes_take_a_few_times_those_with_z)
{
    stress_a_field();
    assert_ratio("SWT, planes with z / all planes", (work){.plain = planes_with_z}, 1,
                 (work){.plain = all_planes}, 1, 0.3);
}

int main(void)
{
    if (!OPTIMISED_BUILD || IS_SANITIZED) {
        printf("SKIPPED: this is not a release build, or one under a sanitizer\n");
        return 77;
    }
    if (!reserve_points(MANY))
        return 1;
    const int status = run_claims();
    release_points();
    return status;
}
