/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Results in the domain, or none. That the formulas are right, proof/accuracy shows. */
#include "claims.h"
#include "formulas/arcs.h"
#include "rwedge.h"

#include <fenv.h>

/* Where c is lost beside 1 the ratio was sometimes 1 + 2 epsilon, outside the domain of its
 * inverse. */
CLAIM(round_trips_stay_in_the_domain)
{
    uint64_t seed = 13;
    for (int i = 0; i < 20000; i++) {
        const double alpha =
            i % 2 ? random_fraction(&seed) : 1 - pow(10, -12 * random_fraction(&seed));
        const double ratio = rwedge_shear_ratio(alpha, pow(10, -60 * random_fraction(&seed)));
        assert_true(ratio >= 0 && ratio <= 1);
        assert_true(rwedge_stick_width(alpha, ratio) >= 0);
    }
}

CLAIM(the_shear_of_a_sharp_wedge_that_slides_is_its_pressure)
{
    assert_close(rwedge_shear(0, 0, 0.5), -2 / PI * acosh(2), 1e-15);
}

/* Of one modulus it is (nu1 - nu2)/4; a rigid half-plane leaves (1 - nu2)/2; and plane stress is
 * plane strain with E (1 + 2 nu)/(1 + nu)^2 and nu/(1 + nu). */
CLAIM(plane_stress_has_its_own_coupling)
{
    assert_close(rwedge_dundurs_beta_plane_stress(70e3, 0.4, 70e3, 0.2), 0.05, 1e-14);
    assert_close(rwedge_dundurs_beta_plane_stress(HUGE_VAL, 0, 70e3, 0.2), 0.4, 1e-15);
    for (double nu = -0.4; nu < 0.5; nu += 0.1) {
        const double E1 = 72e3, E2 = 210e3, strain = 1 + nu, other = 1.3;
        assert_close(rwedge_dundurs_beta_plane_stress(E1, nu, E2, 0.3),
                     rwedge_dundurs_beta(E1 * (1 + 2 * nu) / (strain * strain), nu / strain,
                                         E2 * 1.6 / (other * other), 0.3 / other),
                     1e-13);
    }
    assert_nan(rwedge_dundurs_beta_plane_stress(70e3, 0.6, 70e3, 0.2));
    assert_nan(rwedge_dundurs_beta_plane_stress(HUGE_VAL, 0.3, HUGE_VAL, 0.3));
}

/* No half-width of which a/b is outside. */
CLAIM(a_load_has_its_contact_in_the_domain)
{
    assert_nan(rwedge_normal_load(0.1, 1e40, 1, 1e-40));
    assert_true(rwedge_normal_load(0.1, 1e40, 1, 0) == 0);
}

/* A tilt of 1 is a flank on the surface: it has no edges. */
CLAIM(a_flank_on_the_surface_has_no_patch)
{
    const rw_arcs wedge = {.count = 1, .rounding = rw_rounding(1)};
    assert_nan(rw_arcs_patch_of_moment(&wedge, 1e-3, 1e40).left);
}

/* ---- Other rounding modes ---- */

static rw_patch patch_in_mode(int mode, const rw_arcs *arcs, double P, double M)
{
    fesetround(mode);
    const rw_patch patch = rw_arcs_patch_of_moment(arcs, P, M);
    fesetround(FE_TONEAREST);
    return patch;
}

static void assert_patch(rw_patch patch, double left, double right)
{
    assert_within(patch.left, left, 1e-12 * (right - left));
    assert_within(patch.right, right, 1e-12 * (right - left));
}

/* The ends of the searches were where they are when all is rounded to the nearest. There was no
 * edge, and the edge that goes with it was searched without end. */
CLAIM(a_patch_is_found_in_every_rounding_mode)
{
    static const int modes[] = {FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO};
    rw_arc apex;
    double all = 1;
    const rw_pad alone = {1, true, &apex, &all};
    const rw_arcs pad = {.count = 1, .pad = &alone}; /* that is a wedge */
    for (int i = 0; i < 3; i++) {
        for (double a = 1e-15, P = 1.7; a < 10; a *= 1.3) {
            const rw_arcs wedge = {.count = 1, .rounding = rw_rounding(a)};
            const double b = rwedge_half_width(1, a, 1, P);
            apex = wedge.rounding;
            assert_patch(patch_in_mode(modes[i], &wedge, P, 0), -b, b);
            assert_patch(patch_in_mode(modes[i], &pad, P, 0), -b, b);
        }
        for (double M = 1e-13, P = 1.7; M < 10; M *= 1.3) {
            const rw_arcs wedge = {.count = 1, .rounding = rw_rounding(1e-13 * M)};
            const double m = 2 * M / P, s = hypot(m, P / 2); /* patch.h, with a = 0 */
            assert_patch(patch_in_mode(modes[i], &wedge, P, M), m - s, m + s);
        }
    }
}
