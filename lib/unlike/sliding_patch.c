/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The integrals M_n = int u^n g/|X| du of the slope: M_0 = 0 is the tilt, M_1 and M_2 the load and
 * the moment, and all of them the potential far away. */
#include "unlike/moments.h"

#include "base/domain.h"

void rw_unlike_init(rw_unlike *unlike, double mu)
{
    unlike->mu = mu;
    const double lambda = atan(mu) / RW_PI;
    rw_power_rule_init(&unlike->rule[0], 0.5 - lambda);
    rw_power_rule_init(&unlike->rule[1], 0.5 + lambda);
}

typedef struct {
    double a;
    int count;
    double *sum;
} moments;

/* With J_n the integral of u^n/|X| from u on: (n + 1) J_(n+1) = n J_(n-1) + (1 - 2 a) J_n + u^n W.
 */
static void add(const moments *m, const rw_place *p, double jump, double step)
{
    const double u = (p->from_left - p->to_right) / 2;
    double before = 0, now = p->J, edge = p->W;
    for (int n = 0; n < m->count; n++) {
        const double next = (n * before + (1 - 2 * m->a) * now + edge) / (n + 1);
        m->sum[n] += jump * (next - u * now) + step * now;
        before = now;
        now = next;
        edge *= u;
    }
}

static void add_joint(const rw_joint *joint, void *context)
{
    add(context, &joint->place, joint->jump, joint->step);
}

static void add_arc(const rw_short_arc *arc, void *context)
{
    for (int i = 0; i < RW_ARC_NODES; i++)
        add(context, &arc->node[i], 0, arc->rise * arc->weight[i]);
}

rw_sliding_sums rw_sliding_sums_of(const rw_arcs *arcs, const rw_sliding_frame *f, int count)
{
    rw_sliding_sums s = {.moment = {0}};
    moments m = {f->rule->a, count, s.moment};
    const double left_slope = rw_visit_joints(arcs, f, &(rw_visitor){add_joint, add_arc, &m});
    s.offset = -s.moment[0] / f->whole;
    s.tilt = left_slope - s.offset;
    add(&m, &(rw_place){.from_left = 0, .to_right = 2, .J = f->whole}, 0, s.offset);
    return s;
}

rw_pressing rw_sliding_pressing(const rw_arcs *arcs, rw_sliding_way slides, rw_patch patch)
{
    if (!slides.unlike)
        return rw_arcs_pressing(arcs, patch);
    const rw_sliding_frame f = rw_sliding_frame_of(slides, patch);
    const rw_sliding_sums s = rw_sliding_sums_of(arcs, &f, 3);
    const double unit = f.half * (RW_PI / f.whole), load = unit * s.moment[1];
    const double off = s.moment[2] - (1 - 2 * f.rule->a) * s.moment[1];
    return (rw_pressing){load, f.middle * load + unit * f.half * off, s.tilt};
}

/* ---- The patch of a load ---- */

typedef struct {
    const rw_arcs *arcs;
    rw_sliding_way slides;
} carrier;

static rw_pressing carried(const void *context, rw_patch patch)
{
    const carrier *c = context;
    return rw_sliding_pressing(c->arcs, c->slides, patch);
}

rw_patch rw_sliding_patch_of_moment(const rw_arcs *arcs, rw_sliding_way slides, double P, double M)
{
    return rw_carried_patch(arcs, carried, &(carrier){arcs, slides}, P, M, true);
}

rw_patch rw_sliding_patch_of_tilt(const rw_arcs *arcs, rw_sliding_way slides, double P, double tilt)
{
    return rw_carried_patch(arcs, carried, &(carrier){arcs, slides}, P, tilt, false);
}
