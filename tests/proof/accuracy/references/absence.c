/* SPDX-License-Identifier: GPL-3.0-or-later */
/* J2 is evaluated on a grid of the half-plane, polar and logarithmic in the radius. Next to a
 * maximum of the grid a stationary point is enclosed, and then the Hessian over the enclosure. */
#include "references/absence.h"

#include <math.h>

#include "rwedge.h"
#include "references/strength.h"

enum { RADII = 64, ANGLES = 33, NODES = RADII * ANGLES, PROOF_BITS = 192 };

typedef struct {
    double x[NODES], y[NODES], J2[NODES];
} grid;

static void lay_out(grid *g, double alpha)
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

static bool fill(grid *g, double alpha, double f, double nu)
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

static bool is_grid_maximum(const grid *g, int i, int j)
{
    const double *here = g->J2 + i * ANGLES + j;
    for (int di = -1; di <= 1; di++)
        for (int dj = -1; dj <= 1; dj++)
            if (here[di * ANGLES + dj] > *here)
                return false;
    return true;
}

static bool is_concave(const traction *t, const arb_t x, const arb_t y)
{
    arb_ptr J2 = _arb_vec_init(J2_COUNT + 1);
    arb_ptr determinant = J2 + J2_COUNT;
    acb_t z;
    acb_init(z);
    acb_set_arb_arb(z, x, y);
    ball_J2(J2, 2, t, z, PROOF_BITS);
    arb_mul(determinant, J2 + J2_XX, J2 + J2_YY, PROOF_BITS);
    arb_submul(determinant, J2 + J2_XY, J2 + J2_XY, PROOF_BITS);
    const bool result = arb_is_negative(J2 + J2_XX) && arb_is_positive(determinant);
    acb_clear(z);
    _arb_vec_clear(J2, J2_COUNT + 1);
    return result;
}

static bool is_second_maximum(double alpha, double f, const arb_t x, const arb_t y)
{
    const double from_corner = arf_get_d(arb_midref(x), ARF_RND_NEAR) - alpha,
                 depth = arf_get_d(arb_midref(y), ARF_RND_NEAR);
    return f > 0.25 && hypot(from_corner, depth) < 0.5 * alpha;
}

static bool is_proved_next_to(const traction *t, double alpha, double f, double x, double y)
{
    arb_ptr w = _arb_vec_init(3);
    acb_t z;
    acb_init(z);
    acb_set_d_d(z, x, y);
    const bool proved = ball_stationary(w, w + 1, w + 2, NULL, t, z, PROOF_BITS) &&
                        is_concave(t, w, w + 1) && !is_second_maximum(alpha, f, w, w + 1);
    acb_clear(z);
    _arb_vec_clear(w, 3);
    return proved;
}

bool has_maximum_below(double alpha, double f, double nu)
{
    const double tip = fmin(alpha, 1);
    grid g;
    lay_out(&g, tip);
    if (!fill(&g, tip, f, nu))
        return true;
    traction t;
    arb_t a, friction;
    arb_init(a), arb_init(friction);
    arb_set_d(a, tip);
    arb_set_d(friction, f);
    ball_contact(&t, a, friction, nu, PROOF_BITS);
    bool found = false;
    for (int i = 1; i < RADII - 1 && !found; i++)
        for (int j = 1; j < ANGLES - 1 && !found; j++)
            if (is_grid_maximum(&g, i, j))
                found = is_proved_next_to(&t, tip, f, g.x[i * ANGLES + j], g.y[i * ANGLES + j]);
    traction_clear(&t);
    arb_clear(a), arb_clear(friction);
    return found;
}
