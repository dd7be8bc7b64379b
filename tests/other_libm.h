/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Included before each source of the library by tests/reproducible.sh: another math library, whose results differ in the last
 * bit here and there. Each function is that of long double, rounded. */
#ifndef OTHER_LIBM_H
#define OTHER_LIBM_H

#include <math.h>

static inline double other_asin(double x) { return (double)asinl(x); }
static inline double other_asinh(double x) { return (double)asinhl(x); }
static inline double other_atan2(double y, double x) { return (double)atan2l(y, x); }
static inline double other_atanh(double x) { return (double)atanhl(x); }
static inline double other_cos(double x) { return (double)cosl(x); }
static inline double other_exp(double x) { return (double)expl(x); }
static inline double other_hypot(double x, double y) { return (double)hypotl(x, y); }
static inline double other_log(double x) { return (double)logl(x); }
static inline double other_log1p(double x) { return (double)log1pl(x); }
static inline double other_sin(double x) { return (double)sinl(x); }

#define asin other_asin
#define asinh other_asinh
#define atan2 other_atan2
#define atanh other_atanh
#define cos other_cos
#define exp other_exp
#define hypot other_hypot
#define log other_log
#define log1p other_log1p
#define sin other_sin

#endif
