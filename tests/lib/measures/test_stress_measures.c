/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Measures of a stress, against tractions resolved on planes and textbook cases. */
#include "claims.h"
#include "rwedge.h"

#include <float.h>
#include <string.h>

static double some_stress(uint64_t *seed)
{
    return 2 * random_fraction(seed) - 1;
}

/* The traction on the plane whose normal is (sin(angle), cos(angle)). */
static void resolve(const double s[3], double angle, double *along_normal, double *across)
{
    const double x = sin(angle), y = cos(angle);
    const double tx = s[0] * x + s[2] * y, ty = s[2] * x + s[1] * y;
    *along_normal = tx * x + ty * y;
    *across = tx * y - ty * x;
}

CLAIM(the_plane_of_s1_carries_s1_and_no_shear)
{
    uint64_t seed = 1;
    for (int i = 0; i < 1000; i++) {
        const double s[3] = {some_stress(&seed), some_stress(&seed), some_stress(&seed)};
        double s1, s2, angle, normal, shear;
        assert_ok(rwedge_principal_stresses(s[0], s[1], s[2], &s1, &s2, &angle));
        assert_true(s1 >= s2 && angle > -PI / 2 && angle <= PI / 2);
        resolve(s, angle, &normal, &shear);
        assert_within(normal, s1, 8 * DBL_EPSILON);
        assert_within(shear, 0, 8 * DBL_EPSILON);
        resolve(s, angle + PI / 2, &normal, &shear);
        assert_within(normal, s2, 8 * DBL_EPSILON);
    }
}

static double angle_of(double sxx, double syy, double txy)
{
    double s1, s2, angle = NAN;
    assert_ok(rwedge_principal_stresses(sxx, syy, txy, &s1, &s2, &angle));
    return angle;
}

/* From the surface's normal +y, positive towards +x. */
CLAIM(angles_turn_from_the_normal_towards_x)
{
    assert_within(angle_of(0, 1, 0), 0, 0);
    assert_close(angle_of(1, 0, 0), PI / 2, DBL_EPSILON);
    assert_close(angle_of(1, 0, -0.0), PI / 2, DBL_EPSILON);
    assert_close(angle_of(0, 0, 1), PI / 4, DBL_EPSILON);
    assert_close(angle_of(0, 0, -1), -PI / 4, DBL_EPSILON);
    assert_within(angle_of(3, 3, 0), 0, 0);
    assert_within(angle_of(0, 0, 0), 0, 0);
}

static double largest_of(double a, double b, double c)
{
    return fmax(fabs(a), fmax(fabs(b), fabs(c)));
}

/* From the three principal stresses, in long double. */
CLAIM(invariants_are_those_of_the_principal_stresses)
{
    uint64_t seed = 2;
    for (int i = 0; i < 1000; i++) {
        const double xx = some_stress(&seed), yy = some_stress(&seed), xy = some_stress(&seed);
        const double nu = i % 5 == 0 ? 0 : i % 5 == 1 ? 0.5 : 0.5 * random_fraction(&seed);
        const long double s = ((long double)xx + yy) / 2, d = ((long double)yy - xx) / 2;
        const long double R = sqrtl(d * d + (long double)xy * xy), zz = 2 * nu * s;
        const double a = (double)(2 * R), b = (double)(s + R - zz), c = (double)(s - R - zz);
        assert_close(rwedge_von_mises(xx, yy, xy, nu), sqrt((a * a + b * b + c * c) / 2),
                     8 * DBL_EPSILON);
        assert_close(rwedge_largest_shear(xx, yy, xy, nu), largest_of(a, b, c) / 2,
                     4 * DBL_EPSILON);
        assert_close(rwedge_out_of_plane_stress(xx, yy, nu), (double)zz, 4 * DBL_EPSILON);
    }
}

CLAIM(textbook_stresses)
{
    assert_close(rwedge_von_mises(-7, 0, 0, 0), 7, 4 * DBL_EPSILON);
    assert_close(rwedge_von_mises(0, 0, 2, 0.3), 2 * sqrt(3), 4 * DBL_EPSILON);
    assert_within(rwedge_von_mises(5, 5, 0, 0.5), 0, 0); /* a fluid's pressure */
    assert_close(rwedge_largest_shear(5, 0, 0, 0), 2.5, 4 * DBL_EPSILON);
    assert_close(rwedge_largest_shear(5, 5, 0, 0), 2.5, 4 * DBL_EPSILON); /* out of the plane */
    assert_close(rwedge_largest_shear(5, 5, 0, 0.3), 1, 4 * DBL_EPSILON); /* szz = 3 */
    assert_close(rwedge_out_of_plane_stress(2, 4, 0.25), 1.5, DBL_EPSILON);
}

/* The sharp edges of a difference: stresses that are nearly a fluid's pressure. */
CLAIM(small_differences_keep_their_digits)
{
    const double off = ldexp(1, -50);
    assert_close(rwedge_von_mises(1, 1 + off, 0, 0.5), sqrt(3) * off / 2, 4 * DBL_EPSILON);
    assert_close(rwedge_largest_shear(1, 1 + off, 0, 0.5), off / 2, 4 * DBL_EPSILON);
    assert_close(angle_of(1, 1 + off, off), atan2(1, 0.5) / 2, 4 * DBL_EPSILON);
    assert_close(angle_of(1, 1, 1e-20), atan(1), 4 * DBL_EPSILON); /* s1 and s2 round to one */
    assert_true(angle_of(1, 1, 0) == 0);
}

/* The domain is that of the arguments. */
CLAIM(measures_may_leave_the_domain_of_stresses)
{
    assert_close(rwedge_von_mises(1e60, -1e60, 1e60, 0.3), sqrt(6) * 1e60, 4 * DBL_EPSILON);
}
