/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "sliding.h"

#include <math.h>

static const double SQRT_3 = 1.7320508075688772;

/* What a load does that slides to the side of Q. */
typedef struct {
    double P, b, tension;
    double excess; /* logarithm of the yield factor: 0 at first yield; -inf at a kink */
    double x, y;
} sliding;

static int32_t look(const contact_case *setup, double k, const rwedge_contact *contact, sliding *at)
{
    double edge[2], sxx[2], syy[2], txy[2], factor = 0;
    const double surface[2] = {0, 0};
    int32_t status = rwedge_contact_edges(contact, &edge[0], &edge[1]);
    if (status == RWEDGE_OK)
        status = rwedge_contact_stresses(contact, 2, edge, surface, sxx, syy, txy);
    if (status == RWEDGE_OK)
        status = rwedge_contact_yield_factor(contact, setup->nu1, k, &factor, &at->x, &at->y);
    if (status != RWEDGE_OK)
        return status;
    at->b = rwedge_contact_half_width(contact);
    at->tension = fmax(sxx[0], sxx[1]);
    at->excess = log(factor);
    return RWEDGE_OK;
}

static int32_t slide(const contact_case *setup, double k, double P, sliding *at)
{
    rwedge_contact *contact = NULL;
    int32_t status = case_contact(setup, &contact);
    at->P = P;
    if (status == RWEDGE_OK)
        status = rwedge_contact_load(contact, P, copysign(setup->f * P, setup->Q));
    if (status == RWEDGE_OK)
        status = look(setup, k, contact, at);
    rwedge_contact_destroy(contact);
    return status;
}

/* Of Hertz' contact the stress grows with the root of P. */
static double next_load(const sliding *at)
{
    const double STEP_LEAST = 0.2, STEP_MOST = 6;
    const double step = fmin(STEP_MOST, fmax(STEP_LEAST, 2.2 * fabs(at->excess)));
    return at->P * exp(copysign(step, at->excess));
}

static bool bracket(const contact_case *setup, sliding *from, sliding *to)
{
    enum { STEPS_MOST = 60 };
    for (int i = 0; i < STEPS_MOST; i++) {
        if (slide(setup, setup->k, next_load(from), to) != RWEDGE_OK)
            return false;
        if (to->excess * from->excess <= 0)
            return true;
        *from = *to;
    }
    return false;
}

/* The rule of the false position, by Illinois, in the logarithms. P is NAN where there is no such
 * load as far as the pad is known. */
static sliding first_yield(const contact_case *setup, const sliding *present)
{
    enum { ROUNDS = 60 };
    const double CLOSE = 1e-12;
    sliding from = *present, to, next = *present;
    if (isinf(from.excess) || !bracket(setup, &from, &to)) {
        next.P = isinf(from.excess) ? 0 : NAN;
        return next;
    }
    for (int i = 0; i < ROUNDS && fabs(to.excess) > CLOSE; i++) {
        const double ratio = log(to.P / from.P);
        const double P = to.P * exp(-ratio * to.excess / (to.excess - from.excess));
        if (P == to.P || slide(setup, setup->k, P, &next) != RWEDGE_OK)
            break;
        if (next.excess * to.excess < 0)
            from = to;
        else
            from.excess /= 2;
        to = next;
    }
    return to;
}

int32_t results_of_sliding(const contact_case *setup, cell row[])
{
    sliding now;
    const bool strong = !isnan(setup->k);
    const double k = strong ? setup->k : 1 / setup->A;
    const int32_t status = slide(setup, k, setup->P, &now);
    if (status != RWEDGE_OK)
        return status;
    row[RESULT_TENSION_SLIDING] = cell_number(now.tension);
    row[RESULT_VON_MISES_SLIDING] = cell_number(SQRT_3 * k * exp(-now.excess));
    row[RESULT_P_OVER_BK] = cell_number(setup->P / now.b / k * exp(now.excess));
    if (!strong)
        return RWEDGE_OK;
    const sliding yield = first_yield(setup, &now);
    row[RESULT_P_YIELD] = cell_number(yield.P);
    row[RESULT_SAFETY] = cell_number(yield.P / setup->P);
    if (isnan(yield.P))
        return RWEDGE_OK;
    row[RESULT_YIELD_X] = cell_number(yield.x);
    row[RESULT_YIELD_Y] = cell_number(yield.y);
    row[RESULT_YIELD_BRANCH] = cell_text(yield.y > 0 ? "subsurface" : "surface");
    return RWEDGE_OK;
}
