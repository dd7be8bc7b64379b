/* SPDX-License-Identifier: GPL-3.0-or-later */
/* J2 is evaluated on a grid of the half-plane, polar and logarithmic in the radius. Next to a
 * maximum of the grid a stationary point is enclosed, and then the Hessian over the enclosure. */
#include "references/absence.hpp"

#include <math.h>

#include "rwedge.h"
#include "references/strength.hpp"

namespace
{

enum { RADII = 64, ANGLES = 33, NODES = RADII * ANGLES, PROOF_BITS = 192 };

typedef struct {
    double x[NODES], y[NODES], J2[NODES];
} grid;

void lay_out(grid *g, double alpha)
{
    static const double PI = 3.14159265358979323846;
    const double lo = log(0.01 * alpha), hi = log(4);
    for (int i = 0; i < RADII; i++) {
        const double r = exp(lo + (hi - lo) * i / (RADII - 1));
        for (int j = 0; j < ANGLES; j++) {
            const double angle = PI * j / (ANGLES - 1);
            g->x[i * ANGLES + j] = 2 * j == ANGLES - 1 ? 0 : r * cos(angle);
            g->y[i * ANGLES + j] = j == 0 || j == ANGLES - 1 ? 0 : r * sin(angle);
        }
    }
}

bool fill(grid *g, double alpha, double f, double nu)
{
    double sxx[NODES], syy[NODES], txy[NODES];
    if (rwedge_stresses(alpha, f, 0, NODES, g->x, g->y, sxx, syy, txy) != RWEDGE_OK)
        return false;
    const double kappa = (1 - 2 * nu) * (1 - 2 * nu) / 3;
    for (int i = 0; i < NODES; i++) {
        const double mean = (sxx[i] + syy[i]) / 2, half = (sxx[i] - syy[i]) / 2;
        g->J2[i] = half * half + txy[i] * txy[i] + kappa * mean * mean;
    }
    return true;
}

bool is_grid_maximum(const grid *g, int i, int j)
{
    const double *here = g->J2 + i * ANGLES + j;
    for (int di = -1; di <= 1; di++)
        for (int dj = -1; dj <= 1; dj++)
            if (here[di * ANGLES + dj] > *here)
                return false;
    return true;
}

bool is_concave(const traction &t, const extremum &at)
{
    const J2_jet J = J2_at(t, {at.x, at.y}, 2);
    return J.xx < 0 && J.xx * J.yy - sqr(J.xy) > 0;
}

bool is_second_maximum(double alpha, double f, const extremum &at)
{
    return f > 0.25 && hypot(middle(at.x) - alpha, middle(at.y)) < 0.5 * alpha;
}

bool is_proved_next_to(const traction &t, double alpha, double f, double x, double y)
{
    extremum at;
    return find_stationary(&at, t, x, y) && is_concave(t, at) && !is_second_maximum(alpha, f, at);
}

} // namespace

bool has_maximum_below(double alpha, double f, double nu)
{
    const precision here(PROOF_BITS);
    const double tip = fmin(alpha, 1);
    grid g;
    lay_out(&g, tip);
    if (!fill(&g, tip, f, nu))
        return true;
    const traction t = sliding_contact(tip, f, nu);
    for (int i = 1; i < RADII - 1; i++)
        for (int j = 1; j < ANGLES - 1; j++)
            if (is_grid_maximum(&g, i, j) &&
                is_proved_next_to(t, tip, f, g.x[i * ANGLES + j], g.y[i * ANGLES + j]))
                return true;
    return false;
}
