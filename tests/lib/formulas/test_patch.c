/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Patches off the centre: what they carry, and which patch carries what. */
#include "claims.h"
#include "formulas/patch.h"
#include "quadrature.h"
#include "rwedge.h"

/* The same in 60 digits. Near a tilt of 1 the loads of a patch are as badly determined. */
CLAIM(laws_agree_with_60_digits)
{
    reference rows = reference_open("off_centre.csv");
    while (reference_next(&rows)) {
        const double *c = rows.cell, a = c[0], left = c[1], right = c[2], tilt = c[11];
        const rw_pressing is = rw_patch_pressing(a, (rw_patch){left, right});
        const double reach = fmax(-left, right), less = 1 - fabs(tilt);
        assert_close(is.load, c[9], 2e-15);
        assert_within(is.moment, c[10], 2e-15 * c[9] * reach);
        assert_within(is.tilt, tilt, 1e-15);
        const rw_patch by_moment = rw_patch_of_moment(a, c[9], c[10]);
        const rw_patch by_tilt = rw_patch_of_tilt(a, c[9], tilt);
        assert_within(by_moment.left, left, 1e-14 * reach / less);
        assert_within(by_moment.right, right, 1e-14 * reach / less);
        assert_within(by_tilt.left, left, 1e-14 * reach / less);
        assert_within(by_tilt.right, right, 1e-14 * reach / less);
    }
    assert_int_equal(rows.row, 150);
}

typedef struct {
    double a;
    rw_patch patch;
} pressed;

/* Along x = m + s sin(v): the load is the mean of 2 s cos(phi) over the rounding, as all that the
 * slope's rise 1/a at x weighs is the load of a sharp wedge there; likewise tilt and moment. */
static double load_of_rise(double x, const void *context)
{
    const pressed *p = context;
    const double inside = (x - p->patch.left) * (p->patch.right - x);
    return inside > 0 ? 2 * sqrt(inside) / (2 * p->a) : 0;
}

static double moment_of_rise(double x, const void *context)
{
    const pressed *p = context;
    return (rw_patch_middle(p->patch) + x) / 2 * load_of_rise(x, context);
}

static double tilt_of_rise(double x, const void *context)
{
    const pressed *p = context;
    const double t = (x - rw_patch_middle(p->patch)) / rw_patch_half_width(p->patch);
    return -2 / PI * asin(fmax(-1, fmin(1, t))) / (2 * p->a);
}

CLAIM(laws_are_means_over_the_rounding)
{
    uint64_t seed = 3;
    for (int i = 0; i < 40; i++) {
        const double a = 0.2 + random_fraction(&seed), middle = 2 * random_fraction(&seed) - 1;
        const double half = fabs(middle) - a + 0.05 + 2 * random_fraction(&seed);
        if (half <= 0.05)
            continue;
        const pressed p = {a, {middle - half, middle + half}};
        const rw_pressing is = rw_patch_pressing(a, p.patch);
        const double ends[] = {fmax(-a, p.patch.left), fmin(a, p.patch.right)};
        assert_close(is.load, integral(load_of_rise, &p, 1, ends), 1e-12);
        assert_within(is.moment, integral(moment_of_rise, &p, 1, ends), 1e-12 * is.load);
        const double beyond = (ends[0] + a) - (a - ends[1]); /* what is held at +-pi/2 */
        assert_within(is.tilt, integral(tilt_of_rise, &p, 1, ends) + beyond / (2 * a), 1e-12);
    }
}

/* dP = u dr - v dl and pi s d(delta) = u dr + v dl, dM = (m + s/2) u dr - (m - s/2) v dl. */
CLAIM(edges_move_at_their_rates)
{
    static const rw_patch patches[] = {{-0.8, 1.7}, {0.2, 1.9}, {-2.5, 0.1}, {-1, 4}};
    for (size_t i = 0; i < sizeof patches / sizeof *patches; i++) {
        const rw_patch p = patches[i];
        const rw_arc_ends ends = rw_arc_ends_of(rw_rounding(1), p);
        const rw_edge_rates rates = rw_patch_edge_rates(&ends);
        const double s = rw_patch_half_width(p), m = rw_patch_middle(p), h = 1e-5;
        const rw_pressing wider = rw_patch_pressing(1, (rw_patch){p.left, p.right + h}),
                          narrower = rw_patch_pressing(1, (rw_patch){p.left, p.right - h});
        assert_close((wider.load - narrower.load) / (2 * h), rates.at_right, 1e-8);
        assert_close((wider.tilt - narrower.tilt) / (2 * h), rates.at_right / (PI * s), 1e-8);
        assert_close((wider.moment - narrower.moment) / (2 * h), (m + s / 2) * rates.at_right,
                     1e-8);
    }
}

/* A tilt of 1 is a flank on the surface: it has no edges. */
CLAIM(a_flank_on_the_surface_has_no_patch)
{
    assert_nan(rw_patch_of_moment(1, 1e-3, 1e40).left);
}
