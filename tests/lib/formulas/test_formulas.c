/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Results in the domain, or none. That the formulas are right, proof/accuracy shows. */
#include "claims.h"
#include "formulas/pad.h"
#include "rwedge.h"

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

/* A tilt of 1 is a flank on the surface: it has no edges. */
CLAIM(a_flank_on_the_surface_has_no_patch)
{
    const rw_arcs wedge = {.count = 1, .rounding = rw_rounding(1)};
    assert_nan(rw_arcs_patch_of_moment(&wedge, 1e-3, 1e40).left);
}
