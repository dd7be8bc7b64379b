/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Heights that were measured: their hull, their slopes, and the convex profile nearest to them. */
#include "claims.h"
#include "rwedge.h"

#include <float.h>
#include <math.h>

enum { MANY = 749, PLACES = 17 };

/* Of the standard deviation 1, nearly normal: twelve uniform numbers. */
static double noise(uint64_t *state)
{
    double sum = -6;
    for (int i = 0; i < 12; i++)
        sum += random_fraction(state);
    return sum;
}

typedef double shape(double x);

static double cylinder(double x)
{
    return x * x / 100;
}

static double flat(double x)
{
    const double beyond = fmax(fabs(x) - 2, 0);
    return beyond * beyond / 10;
}

static double wedge(double x)
{
    return fabs(x) < 0.5 ? 0.05 * x * x : 0.05 * (fabs(x) - 0.25);
}

typedef struct {
    double x[MANY], height[MANY];
} heights;

static heights scan_of(shape *pad, double rms, uint64_t seed)
{
    heights all;
    for (int i = 0; i < MANY; i++) {
        all.x[i] = -3.137 + 6.048 * i / (MANY - 1);
        all.height[i] = pad(all.x[i]) + rms * noise(&seed);
    }
    return all;
}

typedef struct {
    int32_t status;
    int arcs;
    double place[PLACES], slope[PLACES], level, rms;
} fit;

static fit fit_of(const heights *all, int32_t arcs)
{
    fit to;
    to.status = rwedge_profile_fit(MANY, all->x, all->height, arcs, PLACES, to.place, to.slope,
                                   &to.level, &to.rms);
    to.arcs = 0;
    while (to.status == RWEDGE_OK && to.arcs + 1 < PLACES &&
           to.place[to.arcs + 1] > to.place[to.arcs])
        to.arcs++;
    return to;
}

/* The largest pressure of a profile under a load that has no moment, at many places. */
static double peak(rwedge_contact *contact, double P)
{
    double left, right, most = 0;
    assert_ok(rwedge_contact_load(contact, P, 0));
    assert_ok(rwedge_contact_edges(contact, &left, &right));
    for (int i = 1; i < 8000; i++) {
        const double x = left + (right - left) * i / 8000;
        double p, q;
        assert_ok(rwedge_contact_tractions(contact, 1, &x, &p, &q));
        most = fmax(most, -p);
    }
    rwedge_contact_destroy(contact);
    return most;
}

static double peak_of(const fit *of, double A, double P)
{
    rwedge_contact *contact;
    assert_ok(rwedge_contact_create_profile(PLACES, of->place, of->slope, A, 0.3, &contact));
    return peak(contact, P);
}

/* ---- Hull and slopes ---- */

CLAIM(convex_heights_are_their_own_hull)
{
    const heights all = scan_of(wedge, 0, 1);
    double hull[MANY];
    assert_ok(rwedge_profile_hull(MANY, all.x, all.height, hull));
    for (int i = 0; i < MANY; i++)
        assert_close(hull[i], all.height[i], 4 * DBL_EPSILON);
}

/* By the definition: at every place the highest line below all heights, found by trying all pairs.
 * */
CLAIM(the_hull_is_the_largest_convex_profile_below)
{
    enum { FEW = 40 };
    uint64_t seed = 7;
    for (int round = 0; round < 50; round++) {
        double x[FEW], height[FEW], hull[FEW];
        for (int i = 0; i < FEW; i++) {
            x[i] = i + 0.4 * noise(&seed) / 6;
            height[i] = (x[i] - 17) * (x[i] - 17) / 100 + 0.3 * noise(&seed);
        }
        assert_ok(rwedge_profile_hull(FEW, x, height, hull));
        for (int k = 0; k < FEW; k++) {
            double lowest = height[k];
            for (int i = 0; i < k; i++)
                for (int j = k + 1; j < FEW; j++)
                    lowest = fmin(lowest, height[i] + (height[j] - height[i]) * (x[k] - x[i]) /
                                                          (x[j] - x[i]));
            assert_within(hull[k], lowest, 1e-13);
        }
    }
}

CLAIM(slopes_are_those_of_lines_between_the_places)
{
    const double x[] = {-2, -1, 0.5, 1, 4}, height[] = {3, 1, 0, 0.5, 5};
    double place[5], slope[5];
    const double middles[] = {-1.5, -0.25, 0.75, 2.5, 4}, rises[] = {-2, -2.0 / 3, 1, 1.5, 1.5};
    assert_ok(rwedge_profile_slopes(5, x, height, place, slope));
    for (int i = 0; i < 5; i++) {
        assert_close(place[i], middles[i], 1e-15);
        assert_close(slope[i], rises[i], 1e-15);
    }
}

CLAIM(slopes_of_dented_heights_are_those_of_their_hull)
{
    const double x[] = {0, 1, 2, 3}, height[] = {0, 5, 1, 4};
    double place[4], slope[4];
    assert_ok(rwedge_profile_slopes(4, x, height, place, slope));
    assert_close(slope[0], 0.5, 1e-15);
    assert_close(slope[1], 0.5, 1e-15);
    assert_close(slope[2], 3, 1e-15);
}

/* ---- Fits ---- */

/* The radius comes back, and the noise; Hertz' pressure to what the radius is uncertain by. */
CLAIM(a_cylinder_is_one_arc)
{
    const double A = 1.7e-5, P = 200, hertz = sqrt(2 * P / (PI * 50 * A));
    for (uint64_t seed = 1; seed <= 5; seed++)
        for (double rms = 0.05e-3; rms < 1e-3; rms *= 10) {
            const heights all = scan_of(cylinder, rms, seed);
            const fit to = fit_of(&all, 0);
            assert_int_equal(to.status, RWEDGE_OK);
            assert_int_equal(to.arcs, 1);
            assert_close(to.rms, rms, 0.08);
            assert_close(peak_of(&to, A, P), hertz, rms); /* 0.05 % at 0.5 um */
        }
}

/* Of 100 other scans each, with 0.05 and 0.5 um of noise, the pressure erred by 0.04 and 0.30 % at
 * most, where the flat is straight. Noise bends it once in 100 times. */
CLAIM(a_flat_pad_with_rounded_edges_is_three_arcs)
{
    const double A = 1.7333333333333333e-05, P = 400;
    rwedge_contact *contact;
    assert_ok(rwedge_contact_create_flat(2, 5, A, 0.3, &contact));
    const double exact = peak(contact, P);
    for (uint64_t seed = 1; seed <= 4; seed++)
        for (double rms = 0.05e-3; rms < 1e-3; rms *= 10) {
            const heights all = scan_of(flat, rms, seed);
            const fit to = fit_of(&all, 0);
            assert_int_equal(to.arcs, 3);
            assert_close(peak_of(&to, A, P), exact, rms < 1e-4 ? 0.001 : 0.005);
            assert_close(to.slope[1], to.slope[2], 1e-15); /* the flat is straight */
        }
}

/* Its knots have to move far: where they did not, it took six arcs, and a flat pad five, whose
 * pressure erred by 77 %. */
CLAIM(a_rounded_wedge_takes_three_arcs)
{
    const double A = 1.7333333333333333e-05, P = 2000;
    rwedge_contact *contact;
    assert_ok(rwedge_contact_create(0.05, 0.5, A, 0.3, &contact));
    const double exact = peak(contact, P);
    for (uint64_t seed = 1; seed <= 4; seed++) {
        const heights all = scan_of(wedge, 0.05e-3, seed);
        const fit to = fit_of(&all, 0);
        assert_true(to.arcs == 3 || to.arcs == 4);
        assert_close(peak_of(&to, A, P), exact, 0.002);
    }
}

/* So many arcs as are asked for; more leave less, but for what straight arcs may cost: Schwarz's
 * criterion gives ln(n)/n of the squares for a parameter. The fit is convex. */
CLAIM(more_arcs_leave_less)
{
    const heights all = scan_of(wedge, 0.5e-3, 3);
    double before = HUGE_VAL;
    for (int32_t arcs = 1; arcs <= 12; arcs++) {
        const fit to = fit_of(&all, arcs);
        assert_int_equal(to.arcs, arcs);
        assert_true(to.rms <= before * (1 + log(MANY) / MANY));
        before = to.rms;
        for (int i = 1; i < PLACES; i++)
            assert_true(to.place[i] >= to.place[i - 1] && to.slope[i] >= to.slope[i - 1]);
    }
}

CLAIM(a_fit_has_one_place_more_than_arcs)
{
    for (int32_t arcs = 1; arcs <= 16; arcs++)
        assert_int_equal(rwedge_profile_places(arcs), arcs + 1);
    assert_int_equal(rwedge_profile_places(0), 17);
    assert_int_equal(rwedge_profile_places(-1), 17);
    assert_int_equal(rwedge_profile_places(17), 17);
}

/* What is left is that of the profile, walked through apart from the library. */
CLAIM(level_places_and_slopes_give_the_heights)
{
    const heights all = scan_of(wedge, 0.5e-3, 5);
    const fit to = fit_of(&all, 0);
    double square = 0;
    for (int i = 0; i < MANY; i++) {
        double height = to.level;
        for (int k = 0; k < to.arcs; k++) {
            const double end = fmin(fmax(all.x[i], to.place[k]), to.place[k + 1]);
            const double u = end - to.place[k], length = to.place[k + 1] - to.place[k];
            height += u * to.slope[k] + (to.slope[k + 1] - to.slope[k]) / length * u * u / 2;
        }
        square += (all.height[i] - height) * (all.height[i] - height);
    }
    assert_close(to.rms, sqrt(square / MANY), 1e-9);
}

/* Neither the unit nor the place nor the order of magnitude matters. */
CLAIM(a_fit_does_not_depend_on_the_unit)
{
    heights all = scan_of(flat, 0.5e-3, 6);
    const fit mm = fit_of(&all, 0);
    for (int i = 0; i < MANY; i++) {
        all.x[i] = 1e3 * all.x[i] + 7e3;
        all.height[i] = 1e3 * all.height[i] - 12;
    }
    const fit um = fit_of(&all, 0);
    assert_int_equal(um.arcs, mm.arcs);
    for (int i = 0; i <= mm.arcs; i++) {
        assert_within(um.place[i], 1e3 * mm.place[i] + 7e3, 1e-6);
        assert_within(um.slope[i], mm.slope[i], 1e-9);
    }
}

/* A hollow of 5 noises, that leaves two contacts; one that the curvature fills is none. */
CLAIM(two_contacts_are_told)
{
    heights all = scan_of(cylinder, 0.2e-3, 2);
    for (int i = 0; i < MANY; i++)
        all.height[i] += 5e-3 * exp(-all.x[i] * all.x[i] / 0.09);
    assert_int_equal(fit_of(&all, 0).status, RWEDGE_EABSENT);
    all = scan_of(cylinder, 0.2e-3, 2);
    for (int i = 0; i < MANY; i++)
        all.height[i] += 2e-3 * exp(-all.x[i] * all.x[i] / 0.36);
    assert_int_equal(fit_of(&all, 0).status, RWEDGE_OK);
}

CLAIM(planes_and_heights_that_point_down_are_no_pads)
{
    heights all = scan_of(cylinder, 0, 1);
    for (int i = 0; i < MANY; i++)
        all.height[i] = -all.height[i];
    assert_int_equal(fit_of(&all, 0).status, RWEDGE_EABSENT);
    for (int i = 0; i < MANY; i++)
        all.height[i] = 3;
    assert_int_equal(fit_of(&all, 0).status, RWEDGE_EDOMAIN);
}

CLAIM(what_is_outside_the_domain_is_refused_and_changes_nothing)
{
    const double x[] = {0, 1, 2, 3, 4, 5, 6, 7}, back[] = {0, 1, 2, 3, 4, 5, 6, 5};
    const double height[] = {3, 2, 1, 0, 0, 1, 2, 3};
    double place[PLACES] = {42}, slope[PLACES] = {42}, level = 42, rms = 42;
    assert_int_equal(rwedge_profile_hull(8, back, height, place), RWEDGE_EDOMAIN);
    assert_int_equal(rwedge_profile_hull(1, x, height, place), RWEDGE_EDOMAIN);
    assert_int_equal(rwedge_profile_slopes(8, back, height, place, slope), RWEDGE_EDOMAIN);
    assert_int_equal(rwedge_profile_fit(8, back, height, 0, PLACES, place, slope, &level, &rms),
                     RWEDGE_EDOMAIN);
    assert_int_equal(rwedge_profile_fit(7, x, height, 0, PLACES, place, slope, &level, &rms),
                     RWEDGE_EDOMAIN);
    assert_int_equal(rwedge_profile_fit(8, x, height, 17, PLACES, place, slope, &level, &rms),
                     RWEDGE_EDOMAIN);
    assert_int_equal(rwedge_profile_fit(8, x, height, 2, 2, place, slope, &level, &rms),
                     RWEDGE_EDOMAIN);
    assert_int_equal(rwedge_profile_fit(8, x, height, 0, PLACES, place, NULL, &level, &rms),
                     RWEDGE_ENULL);
    assert_int_equal(rwedge_profile_hull(8, x, NULL, place), RWEDGE_ENULL);
    assert_int_equal(rwedge_profile_slopes(8, x, height, NULL, slope), RWEDGE_ENULL);
    assert_true(place[0] == 42 && slope[0] == 42 && level == 42 && rms == 42);
}
