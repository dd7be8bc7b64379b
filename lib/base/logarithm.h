/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Logarithms of quotients and angles of points: the two parts of a complex logarithm. They use only
 * additions, multiplications, divisions and selections (select.h). Their bits are the same
 * everywhere; those of the math library's log() and atan2() differ between machines. Compilers
 * make vector instructions of a loop over them. No divisor is 0.
 *
 * Both reduce their quotient to |s| <= 0.2 and sum the one series of atanh and atan. Each can be
 * divided by a parameter `over`, whose reciprocal is `per`. Where the quotient is near 1, or the
 * angle small, the result has a small relative error however small the parameter is; with over =
 * per = 0 it is the limit. The error is below 3 units of the last digit, divided below 4. */
#ifndef RW_LOGARITHM_H
#define RW_LOGARITHM_H

#include "base/select.h"

#include <float.h>
#include <math.h>

#define RW_LN2 0.69314718055994530942

/* atanh(s)/s for t = s^2, atan(s)/s for t = -s^2: 1 + t/3 + t^2/5 + ... What is left out is
 * below 2e-17 for |t| <= 0.0402. Even and odd powers are summed apart: a processor does both at
 * the same time. */
RW_INLINE double rw_arc_series(double t)
{
    const double u = t * t;
    const double even = 1.0 / 5 + u * (1.0 / 9 + u * (1.0 / 13 + u * (1.0 / 17 + u * (1.0 / 21))));
    const double odd = 1.0 / 3 + u * (1.0 / 7 + u * (1.0 / 11 + u * (1.0 / 15 + u * (1.0 / 19))));
    return 1 + (t * odd + u * even);
}

/* ln(p/q)/over, p and q normal numbers > 0 whose quotient is within 2^+-1000; difference is (p -
 * q)/over. The bits of a double, read as an integer, are its logarithm to base 2, to within 0.09.
 * The difference of those of p and q is rounded to an exponent k. With it p/(2^k q) lies between
 * 0.66 and 1.51. */
RW_INLINE double rw_log_of_quotient_over(double p, double q, double difference, double over,
                                         double per)
{
    const uint64_t one = 0x3ff0000000000000, half = 0x0008000000000000,
                   exponent = 0xfff0000000000000;
    const uint64_t power = (rw_bits_of(p) - rw_bits_of(q) + one + half) & exponent;
    const double scale = rw_double_of(power); /* 2^k */
    /* k + 1023 as the last bits of a number of the size 2^52 */
    const double k = rw_double_of(power >> 52 | 0x4330000000000000) - (0x1p52 + 1023);
    const double scaled = scale * q, general = (p - scaled) * per;
    const double numerator = rw_if_negative(fabs(k) - 0.5, difference, general);
    const double s_over = numerator / (p + scaled), s = over * s_over;
    return k * (RW_LN2 * per) + 2 * s_over * rw_arc_series(s * s);
}

/* The angle of (x, over y_over)/over, -pi to pi; 0 for the origin. The point is mirrored into the
 * first octant, and turned back there by 0, about pi/8 or pi/4. */
RW_INLINE double rw_angle_over(double x, double y_over, double over, double per)
{
    const double TURN = 0.4140625, TURN_ANGLE = 0.39257013501182859516,
                 HALF_TURN = 3.14159265358979323846;
    const double width = fabs(x), height = fabs(y_over), y = over * height;
    const double steep = width - y, large = rw_if_negative(steep, y, width),
                 small = rw_if_negative(steep, width, y);
    const double some = 0.2 * large - small, most = 0.667 * large - small;
    const double turn = rw_if_negative(most, 1, rw_if_negative(some, TURN, 0));
    const double turned = rw_if_negative(most, HALF_TURN / 4, rw_if_negative(some, TURN_ANGLE, 0));
    const double general = (small - turn * large) * per;
    /* DBL_MIN is lost in rounding, except at the origin, whose length would be 0 */
    const double length = large + turn * small + DBL_MIN;
    const double rise = rw_if_negative(steep, general, rw_if_negative(some, general, height));
    const double s_over = rise / length, s = over * s_over;
    const double in_octant = turned * per + s_over * rw_arc_series(-s * s);
    const double in_quadrant = rw_if_negative(steep, HALF_TURN / 2 * per - in_octant, in_octant);
    const double above = rw_if_negative(x + 0.0, HALF_TURN * per - in_quadrant, in_quadrant);
    return rw_if_negative(y_over + 0.0, -above, above);
}

/* ln(p/q), as above. */
RW_INLINE double rw_log_of_quotient(double p, double q)
{
    return rw_log_of_quotient_over(p, q, p - q, 1, 1);
}

/* The angle of (x, y). */
RW_INLINE double rw_angle(double x, double y)
{
    return rw_angle_over(x, y, 1, 1);
}

#endif
