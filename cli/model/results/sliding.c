/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "results.h"

#include <math.h>

/* The case with another value of an input, P, f or a size, that slides to the side of Q under
 * so many times P. */
typedef struct {
    const contact_case *setup;
    int input;
    double k, times;
} search;

/* The state of a sliding contact. */
typedef struct {
    double value, b, tension;
    double excess; /* logarithm of the factor: 0 at first yield; -inf at a kink */
} sliding;

static int32_t look(const contact_case *setup, const search *s, const rwedge_contact *contact,
                    sliding *at)
{
    double edge[2], sxx[2], factor = 0;
    int32_t status = edge_tensions(contact, edge, sxx);
    if (status == RWEDGE_OK)
        status = rwedge_contact_yield_factor(contact, setup->nu1, s->k, &factor, NULL, NULL);
    if (status != RWEDGE_OK)
        return status;
    at->b = rwedge_contact_half_width(contact);
    at->tension = fmax(sxx[0], sxx[1]);
    at->excess = log(factor);
    return RWEDGE_OK;
}

static pad with_size(pad shape, int input, double value)
{
    if (shape.kind == PAD_WEDGE)
        return pad_wedge(shape.theta,
                         input == INPUT_A ? value : rwedge_rounding(shape.theta, value));
    if (shape.kind == PAD_CYLINDER)
        return pad_cylinder(value);
    shape.radius = value;
    return shape;
}

static int32_t slide(const search *s, double value, sliding *at)
{
    contact_case changed = *s->setup;
    if (s->input == INPUT_P)
        changed.P = value;
    else if (s->input == INPUT_F)
        changed.f = value;
    else
        changed.shape = with_size(changed.shape, s->input, value);
    const double P = s->times * changed.P;
    rwedge_contact *contact = NULL;
    int32_t status = case_contact(&changed, &contact);
    at->value = value;
    if (status == RWEDGE_OK)
        status = rwedge_contact_load(contact, P, copysign(changed.f * P, changed.Q));
    if (status == RWEDGE_OK)
        status = look(&changed, s, contact, at);
    rwedge_contact_destroy(contact);
    return status;
}

/* The stress of Hertz' contact grows with the root of P, and falls with that of the radius. */
static bool bracket(const search *s, sliding *from, sliding *to)
{
    enum { STEPS_MOST = 60 };
    const double STEP_LEAST = 0.2, STEP_MOST = 6;
    for (int i = 0; i < STEPS_MOST; i++) {
        const double way =
            s->input == INPUT_RADIUS || s->input == INPUT_A ? -from->excess : from->excess;
        const double step = fmin(STEP_MOST, fmax(STEP_LEAST, 2.2 * fabs(from->excess)));
        if (slide(s, from->value * exp(copysign(step, way)), to) != RWEDGE_OK)
            return false;
        if (to->excess * from->excess <= 0)
            return true;
        *from = *to;
    }
    return false;
}

/* The rule of the false position, by Illinois, in the logarithms. The value is NAN where
 * there is no such one as far as the pad is known. */
static sliding find_limit(const search *s, const sliding *present)
{
    enum { ROUNDS = 60 };
    const double CLOSE = 1e-12;
    sliding from = *present, to, next = *present;
    if (isinf(from.excess) || !bracket(s, &from, &to)) {
        next.value = isinf(from.excess) ? 0 : NAN;
        return next;
    }
    for (int i = 0; i < ROUNDS && fabs(to.excess) > CLOSE; i++) {
        const double ratio = log(to.value / from.value);
        const double value = to.value * exp(-ratio * to.excess / (to.excess - from.excess));
        if (value == to.value || slide(s, value, &next) != RWEDGE_OK)
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
    double P, x, y;
    const bool strong = !isnan(setup->k);
    const double k = strong ? setup->k : 1 / setup->A;
    const search present = {setup, INPUT_P, k, 1};
    int32_t status = slide(&present, setup->P, &now);
    if (status != RWEDGE_OK)
        return status;
    row[RESULT_TENSION_SLIDING] = cell_number(now.tension);
    row[RESULT_VON_MISES_SLIDING] = cell_number(SQRT_3 * k * exp(-now.excess));
    row[RESULT_P_OVER_BK] = cell_number(setup->P / now.b / k * exp(now.excess));
    if (!strong)
        return RWEDGE_OK;
    status = rwedge_contact_yield_load(setup->contact, setup->nu1, k, &P, &x, &y);
    if (status != RWEDGE_OK)
        return status == RWEDGE_EABSENT ? RWEDGE_OK : status;
    yield_place_settle(&x, &y);
    row[RESULT_P_YIELD] = cell_number(P);
    row[RESULT_SAFETY] = cell_number(P / setup->P);
    row[RESULT_YIELD_X] = cell_number(x);
    row[RESULT_YIELD_Y] = cell_number(y);
    row[RESULT_YIELD_BRANCH] = cell_text(y > 0 ? "subsurface" : "surface");
    return RWEDGE_OK;
}

double sliding_shakedown(const contact_case *setup)
{
    double P, y;
    const int32_t status =
        rwedge_contact_shakedown_load(setup->contact, setup->nu1, setup->k, &P, &y);
    return status == RWEDGE_OK ? P : NAN;
}

double sliding_find(const contact_case *setup, int input, double safety)
{
    const search values = {setup, input, setup->k, safety};
    sliding now;
    return slide(&values, 1, &now) == RWEDGE_OK ? find_limit(&values, &now).value : NAN;
}
