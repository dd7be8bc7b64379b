/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef PROBE_HPP
#define PROBE_HPP
#include "references/complex_ball.hpp"
extern "C" {
#include "probe.h"
}
template <ball (*exact)(const probe &)> void judged(arb_t error, const probe *call, slong prec)
{
    const precision here(prec);
    arb_set(error, exact(*call).arb());
}
inline ball error_over(double result, const ball &exact, const ball &scale)
{
    const ball difference = result - exact;
    return is_zero(difference) ? 0 : abs(difference / scale);
}
inline ball relative_error(double result, const ball &exact)
{
    return error_over(result, exact, exact);
}
#endif
