/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The bits of many results, for comparison between compilers. The fit of the series is left out: its bits are LAPACK's. */
#include "rwedge.h"

#include <inttypes.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

static void print(const char *what, double value)
{
    uint64_t bits;
    memcpy(&bits, &value, sizeof bits);
    printf("%s %016" PRIx64 "\n", what, bits);
}

static void print_formulas(double alpha, double v)
{
    print("load", rwedge_load(alpha));
    print("a_over_b", rwedge_a_over_b(alpha * 3 + 1e-3));
    print("pressure", rwedge_pressure(alpha, v));
    print("peak", rwedge_peak_pressure(alpha));
    print("transition", rwedge_transition_pressure(alpha));
    print("coefficient", rwedge_coefficient(alpha, (int32_t)(1000 * v)));
    print("stick", rwedge_stick_width(alpha, v));
    print("ratio", rwedge_shear_ratio(alpha, v));
    print("shear", rwedge_shear(alpha, v, v / 2));
    print("tension", rwedge_max_tension(alpha));
}

static void print_fields(double alpha, double v, double w)
{
    double s[3];
    if (rwedge_stress(alpha, v, w, 3 * v - 1.5, w * w * 3, &s[0], &s[1], &s[2]) == RWEDGE_OK)
        for (int i = 0; i < 3; i++)
            print("stress", s[i]);
    double limit, x, y;
    if (rwedge_yield_point(alpha, v * w, w / 2, &limit, &x, &y) == RWEDGE_OK) {
        print("limit", limit);
        print("x", x);
        print("y", y);
    }
}

int main(void)
{
    for (int i = 0; i < 2000; i++) {
        const double u = fmod(i * 0.6180339887498949, 1), v = fmod(i * 0.7548776662466927, 1);
        const double w = fmod(i * 0.5698402909980532, 1), alpha = i % 2 ? u * 1.2 : u * u * u * u * 1e-2 + 1e-9;
        print_formulas(alpha, v);
        print_fields(alpha, v, w);
    }
    return 0;
}
