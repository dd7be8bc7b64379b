/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The potential of a contact of unlike bodies that slides, as a sum over its joints (joints.h).
 * With X I the potential of a kink at t, times pi/cos(pi lambda),
 *     G  = offset + (1/whole) sum { jump [(z - t) X I - X J] + step X I },
 *     G' = (1/whole) sum { jump [X I - Y (W + (z - 2 a + 1) J)] - step Y W/(z - t) },
 * Y = X/(z^2 - 1). With w = -rho (z + 1)/(z - 1), rho = (1 - t)/(1 + t), V = ((z + 1)/(z - 1))^a,
 *     X I = rho^a V Phi(w; a) = whole - rho^(a-1) V (z - 1)/(z + 1) Phi(1/w; 1 - a),
 * so that a point has one power for all joints, and G' has no transcendental function of its own.
 * The logarithm of Phi near w = 1 is -e^(-i pi a) ln(1 - w) in X I, and -e^(-i pi a) ln(1 - 1/w).
 */
#include "unlike/sliding_points.h"

#include "potential/pad_potential.h"

static void add_joint(const rw_joint *joint, void *context)
{
    rw_sliding_points *p = context;
    if (joint->step != 0)
        rw_sliding_points_add(p, &joint->place, joint->step, true, p->all);
    if (joint->jump != 0) {
        rw_sliding_points_add(p, &joint->place, joint->jump, false, p->all);
        rw_sliding_points_add_edges(p, joint->place.J, joint->place.W, joint->jump, p->all);
    }
}

static void add_near_arc(rw_sliding_points *p, const rw_short_arc *arc, const double share[])
{
    const double jump = arc->rise / (2 * arc->half);
    double J = 0; /* of the arc alone */
    for (int i = 0; i < RW_ARC_NODES; i++)
        J += 2 * arc->half * arc->weight[i] * arc->node[i].power / arc->node[i].to_right;
    rw_sliding_points_add(p, &arc->end[0], jump, false, share);
    rw_sliding_points_add(p, &arc->end[1], -jump, false, share);
    rw_sliding_points_add_edges(p, J, arc->end[0].W - arc->end[1].W, jump, share);
}

/* A point is near an arc within so many halves of it. */
static const double NEAR = 32;

static void add_arc(const rw_short_arc *arc, void *context)
{
    rw_sliding_points *p = context;
    rw_lanes near, far;
    bool is_any_near = false, is_any_far = false;
    for (int i = 0; i < p->count; i++) {
        const double d = (p->x[i] - arc->middle) / p->frame->half, h = p->height[i];
        const bool is_near = d * d + h * h < NEAR * NEAR * arc->half * arc->half;
        near[i] = is_near;
        far[i] = !is_near;
        is_any_near = is_any_near || is_near;
        is_any_far = is_any_far || !is_near;
    }
    if (is_any_near)
        add_near_arc(p, arc, near);
    for (int k = 0; is_any_far && k < RW_ARC_NODES; k++)
        rw_sliding_points_add(p, &arc->node[k], arc->rise * arc->weight[k], true, far);
}

void rw_sliding_fields(const rw_arcs *arcs, rw_sliding_way slides, rw_patch patch, int n,
                       const double x[], const double y[], rw_fields *fields)
{
    if (!slides.unlike) {
        rw_pad_fields(arcs, patch, n, x, y, fields);
        return;
    }
    const rw_sliding_frame f = rw_sliding_frame_of(slides, patch);
    rw_sliding_points p;
    rw_sliding_points_begin(&p, &f, n, x, y);
    const rw_sliding_sums sums = rw_sliding_sums_of(arcs, &f, p.has_far ? RW_MOMENTS : 1);
    if (p.has_near)
        rw_visit_joints(arcs, &f, &(rw_visitor){add_joint, add_arc, &p});
    rw_sliding_points_finish(&p, &sums);
    for (int i = 0; i < n; i++)
        rw_put(fields, i, (rw_field){p.G_re[i], p.G_im[i], p.D_re[i], p.D_im[i]});
}

double rw_sliding_pressure(const rw_arcs *arcs, rw_sliding_way slides, rw_patch patch, double x)
{
    const double surface = 0;
    rw_fields fields;
    if (!(x > patch.left && x < patch.right))
        return 0;
    rw_sliding_fields(arcs, slides, patch, 1, &x, &surface, &fields);
    return fields.G_im[0];
}
