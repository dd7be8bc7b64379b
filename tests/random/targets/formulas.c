/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Any public function with any arguments. It keeps the header's rules for errors; symmetries and
 * inverses hold. */
#include "calls.h"
#include "input.h"
#include "rwedge.h"

/* Any number of terms; but those that are allowed and take seconds are made fewer. */
static double take_whole(input *in)
{
    const int32_t n = (int32_t)take_bytes(in, 4);
    return n > 65536 && n <= 1 << 24 ? n % 65536 : n;
}

/* At an edge, any double, or in between. */
static double take_argument(input *in, const entry_argument *a)
{
    const uint8_t choice = take_byte(in);
    if (choice < 64)
        return edge(a, take_byte(in) % edge_count(a));
    if (choice < 128)
        return a->whole ? take_whole(in) : take_double(in);
    if (a->whole)
        return (double)take_bytes(in, 1);
    const double v = take_fraction(in) * (choice < 192 ? 1 : 0.5);
    return choice % 2 == 0 ? v : exp(40 * v - 20);
}

static void check_even(double alpha, double x)
{
    if (alpha == 0 || isnan(rwedge_pressure(alpha, x)))
        return;
    CLAIM(rwedge_pressure(alpha, -x) == rwedge_pressure(alpha, x), "alpha %.17g, x %.17g", alpha,
          x);
    CLAIM(rwedge_pressure(alpha, x) <= 0, "alpha %.17g, x %.17g", alpha, x);
}

static void check_inverses(double alpha, double c)
{
    if (!(alpha > 1e-59 && alpha < 1e59))
        return;
    const double load = rwedge_load(alpha);
    CLAIM(are_close(rwedge_a_over_b(load / alpha), alpha, 1e-13), "alpha %.17g", alpha);
    CLAIM(load <= 2 && load > 0 && rwedge_load(alpha * 1.01) <= load * (1 + 1e-15), "alpha %.17g",
          alpha);
    if (!(c >= 1e-60 && c <= 1))
        return;
    const double ratio = rwedge_shear_ratio(alpha, c);
    CLAIM(ratio >= 0 && ratio <= 1, "alpha %.17g, c %.17g", alpha, c);
    const double again = rwedge_shear_ratio(alpha, rwedge_stick_width(alpha, ratio));
    CLAIM(fabs(again - ratio) <= 1e-14, "alpha %.17g, c %.17g", alpha, c);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    input in = {data, size};
    size_t count;
    const public_call *calls = public_calls(&count), *call = &calls[take_byte(&in) % count];
    double v[CALL_ARGUMENTS] = {0}, out[CALL_OUTPUTS];
    for (int i = 0; i < call->arguments; i++)
        v[i] = take_argument(&in, call->argument[i]);
    int32_t status;
    const char *complaint = complaint_of(call, v, out, &status);
    CLAIM(complaint == NULL,
          "%s(%.17g, %.17g, %.17g, %.17g, %.17g, %.17g, %.17g, %.17g, %.17g, %.17g): %s",
          call->name, v[0], v[1], v[2], v[3], v[4], v[5], v[6], v[7], v[8], v[9], complaint);
    check_even(v[0], v[1]);
    check_inverses(v[0], v[1]);
    return 0;
}
