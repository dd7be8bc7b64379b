/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Derivatives of the stresses by the place and by the contact. G has no dimension: z dG/dz + a
 * dG/da + c dG/dc = 0, and c dG/dc is the flat punch (2/pi) (phi0/alpha)/X. */
#include <math.h>

#include "rows/rows.hpp"
#include "rwedge.h"

namespace
{

/* Not on the surface at an edge. */
bool is_smooth(const probe &call)
{
    const double *v = call.value, place = fabs(v[3]);
    return v[4] > 0 || (place != 1 && place != v[0] && (place != v[2] || v[2] == 0));
}

double some_stick_zone(probe *call)
{
    return chance(call, 0.3) ? 0 : some_c(call);
}

potentials along_x(const patch &p, const complex_ball &z)
{
    return by_x(p, z).first;
}

potentials along_y(const patch &p, const complex_ball &z)
{
    return turned(along_x(p, z));
}

potentials by_rounding(const patch &p, const complex_ball &z)
{
    const potentials x = along_x(p, z), width = by_half_width(p, z);
    const ball y = im(z);
    return {-width.G - z * x.G, -width.H - y * x.G - z * x.H};
}

/* The fields that add up, and what their parts have in magnitude. */
struct fields {
    potentials N, T;
    ball size;
};

ball size_of(const potentials &c)
{
    return abs(c.G) + abs(c.H);
}

typedef potentials (*derivative)(const patch &p, const complex_ball &z);

/* Of the patch pressed to the half-width c, if that is not 0. */
potentials rate_of(const probe &call, derivative by, double c)
{
    const double *v = call.value;
    return c > 0 ? by(patch(v[0], c), {v[3], v[4]}) : potentials();
}

fields changed(const probe &call, derivative by, const ball &factor)
{
    const double f = call.value[1], c = call.value[2];
    const potentials N = factor * rate_of(call, by, 1), stick = factor * rate_of(call, by, c);
    return {N, ball(f) * (N - stick), fmax(1, f) * size_of(N) + f * size_of(stick)};
}

fields by_friction(const probe &call)
{
    const derivative none = [](const patch &p, const complex_ball &z) { return p.at(z); };
    const potentials N = rate_of(call, none, 1), stick = rate_of(call, none, call.value[2]);
    return {{}, N - stick, size_of(N) + size_of(stick)};
}

/* c = 0: a force f times the rate of the load, 2 for the sharp wedge. */
fields by_stick_zone(const probe &call)
{
    const double *v = call.value;
    const complex_ball z(v[3], v[4]);
    potentials stick;
    if (v[2] > 0)
        stick = ball(v[1]) / v[2] * rate_of(call, by_half_width, v[2]);
    else if (v[0] == 0)
        stick = 2 / pi() * v[1] * potentials{inv(z), -im(z) * inv(sqr(z))};
    return {{}, potentials{} - stick, size_of(stick)};
}

/* The largest of the components' errors, over the size; 0 where all rightly are. */
ball error_of(const double *result, const fields &exact)
{
    if (is_zero(exact.size) && result[0] == 0 && result[1] == 0 && result[2] == 0)
        return 0;
    return error_over(result, tensor_of(superposed(exact.N, exact.T)), exact.size);
}

ball judge_gradient(const probe &call)
{
    return max(error_of(call.result, changed(call, along_x, 1)),
               error_of(call.result + 3, changed(call, along_y, 1)));
}

/* How fast the load of a patch grows with the rounding, but for a factor; over the distance. */
ball rate_of_force(const probe &call, double c)
{
    const double alpha = call.value[0] / c;
    return (alpha < 1 ? alpha : 1 / alpha / alpha) /
           (c + abs(complex_ball(call.value[3], call.value[4])));
}

/* At an edge the parts by alpha are 0: there it is the rates of the forces that count. */
fields by_alpha(const probe &call)
{
    const double *v = call.value;
    fields tip = changed(call, by_rounding, 1 / ball(v[0]));
    tip.size += fmax(1, v[1]) * rate_of_force(call, 1);
    if (v[2] > 0)
        tip.size += v[1] * rate_of_force(call, v[2]);
    return tip;
}

ball judge_sensitivity(const probe &call)
{
    const fields tip = call.value[0] > 0 ? by_alpha(call) : fields{};
    return max(error_of(call.result, tip), max(error_of(call.result + 3, by_friction(call)),
                                               error_of(call.result + 6, by_stick_zone(call))));
}

/* The results one by one, which are next to each other. */
int32_t sensitivity(double alpha, double f, double c, double x, double y, double *by_alpha,
                    double *, double *, double *by_f, double *, double *, double *by_c, double *,
                    double *)
{
    return rwedge_stress_sensitivity(alpha, f, c, x, y, by_alpha, by_f, by_c);
}

const drawn alpha = {"alpha", some_alpha}, f = {"f", some_friction}, c = {"c", some_stick_zone};
const std::vector<drawn> PLACE = {alpha, f, c, some_point};

#define PLACES "as for `stress`, but not the edges themselves"

} // namespace

const row GRADIENT_ROWS[] = {
    {"stress_gradient", PLACES, "of the parts", 1e-12, "1e-12", 1,
     calling(rwedge_stress_gradient, PLACE, is_smooth), judge_gradient},
    {"stress_sensitivity", PLACES, "of the parts", 1e-12, "1e-12", 1,
     calling(sensitivity, PLACE, is_smooth), judge_sensitivity},
    {},
};
