/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The contact law of unlike bodies that slide, in natural units: the half-width is 1. */
#include "unlike/sliding_law.h"

#include "base/always.h"
#include "base/domain.h"
#include "base/root.h"
#include "rwedge.h"

#include <float.h>

typedef struct {
    rw_arcs arcs;
    rw_sliding_way slides;
    bool is_held;
} wedge;

static rw_patch patch_at(double middle)
{
    return (rw_patch){middle - 1, middle + 1};
}

/* The tilt that the contact has too much, or the moment. */
static double excess(double middle, const void *context)
{
    const wedge *w = context;
    const rw_pressing p = rw_sliding_pressing(&w->arcs, w->slides, patch_at(middle));
    return w->is_held ? p.tilt : p.moment;
}

/* The middle of a contact is within a half-width of the apex. */
rw_sliding_law rw_sliding_law_of(const rw_unlike *unlike, double alpha, bool is_held)
{
    const wedge w = {{1, rw_rounding(alpha), NULL}, {unlike, 1}, is_held};
    const double middle = unlike->mu == 0 ? 0 : rw_root(excess, &w, -0.999, 0.999, DBL_EPSILON / 4);
    if (isnan(middle))
        return (rw_sliding_law){NAN, NAN, NAN, NAN};
    const rw_pressing p = rw_sliding_pressing(&w.arcs, w.slides, patch_at(middle));
    const double left = middle - 1, slope = alpha > 0 ? fmax(left / alpha, -1) : -1;
    const double tilt = is_held ? 0 : p.tilt;
    return (rw_sliding_law){p.load, middle, tilt, 2 * fabs(slope - tilt) / p.load};
}

static bool is_case(double alpha, double beta_f)
{
    return rw_is_magnitude(alpha) && (alpha == 0 || (alpha >= 1e-3 && alpha <= 1e3)) &&
           rw_is_signed(beta_f) && fabs(beta_f) <= 1;
}

int32_t rwedge_sliding_law(double alpha, double beta_f, int32_t held, double *AP_over_theta_b,
                           double *middle, double *tilt, double *tension)
{
    if (!AP_over_theta_b || !middle || !tilt || !tension)
        return RWEDGE_ENULL;
    if (!is_case(alpha, beta_f) || held < 0 || held > 1)
        return RWEDGE_EDOMAIN;
    rw_unlike unlike;
    rw_unlike_init(&unlike, -beta_f);
    const rw_sliding_law law = rw_sliding_law_of(&unlike, alpha, held);
    if (NEVER(isnan(law.load))) /* the excess has both signs */
        return RWEDGE_ENOCONV;
    *AP_over_theta_b = law.load;
    *middle = law.middle;
    *tilt = law.tilt;
    *tension = law.tension;
    return RWEDGE_OK;
}

/* ---- What neglecting the coupling costs ---- */

/* sxx at a place beside the contact, over f. */
static double tension_at(const rw_arcs *arcs, rw_sliding_way slides, rw_patch patch, double x)
{
    const double surface = 0;
    rw_fields fields;
    rw_sliding_fields(arcs, slides, patch, 1, &x, &surface, &fields);
    return -2 * fields.G_re[0];
}

int32_t rwedge_coupling(double alpha, double beta, double f, double Q_over_fP, int32_t held,
                        double *swing, double *tension)
{
    static const double BESIDE = 0.06; /* of the half-width */
    if (!swing || !tension)
        return RWEDGE_ENULL;
    if (!rw_is_signed(beta) || fabs(beta) > 0.5 || !rw_is_friction(f) ||
        !rw_is_fraction(Q_over_fP) || held < 0 || held > 1)
        return RWEDGE_EDOMAIN;
    const double mu = -beta * f * Q_over_fP;
    if (!is_case(alpha, mu))
        return RWEDGE_EDOMAIN;
    rw_unlike unlike;
    rw_unlike_init(&unlike, mu);
    const rw_arcs arcs = {1, rw_rounding(alpha), NULL};
    const rw_sliding_way slides = {&unlike, 1}, similar = {NULL, 1};
    const rw_patch plain = {-1, 1};
    const double P = rw_sliding_pressing(&arcs, similar, plain).load;
    const rw_patch patch = held ? rw_sliding_patch_of_tilt(&arcs, slides, P, 0)
                                : rw_sliding_patch_of_moment(&arcs, slides, P, 0);
    if (NEVER(isnan(patch.left)))
        return RWEDGE_ENOCONV;
    const double x = fmin(patch.left, -1) - BESIDE;
    *swing = rw_patch_middle(patch);
    *tension = tension_at(&arcs, slides, patch, x) / tension_at(&arcs, similar, plain, x) - 1;
    return RWEDGE_OK;
}
