/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The potential of a contact of unlike bodies that slides, as a sum over its joints (joints.h).
 * With X I the potential of a kink at t, times pi/cos(pi lambda),
 *     G  = offset + (1/whole) sum { jump [(z - t) X I - X J] + step X I },
 *     G' = (1/whole) sum { jump [X I - Y (W + (z - 2 a + 1) J)] - step Y W/(z - t) },
 * Y = X/(z^2 - 1). With w = -rho (z + 1)/(z - 1), rho = (1 - t)/(1 + t), V = ((z + 1)/(z - 1))^a,
 *     X I = rho^a V Phi(w; a) = whole - rho^(a-1) V (z - 1)/(z + 1) Phi(1/w; 1 - a),
 * so that a point has one power for all joints, and G' has no transcendental function of its own.
 */
#include "unlike/moments.h"

#include "base/domain.h"
#include "potential/pad_potential.h"

/* Beyond so many half-widths from the middle the terms would cancel: it is a series in 1/z there.
 */
static const double FAR = 3;

/* The square of a distance from an edge that is none. */
static const double AT_EDGE = 1e-290;

/* A point, in half-widths from the middle; the powers V and V (z - 1)/(z + 1). */
typedef struct {
    rw_complex from_left, from_right, V, other_V, X, Y, beside; /* beside: z - 2 a + 1 */
    double angle_left, angle_right, x, y;
    rw_complex G, D; /* so far */
} point;

static double square(rw_complex z)
{
    return z.re * z.re + z.im * z.im;
}

/* e^(a z). */
static rw_complex power(double a, rw_complex logarithm)
{
    const double size = exp(a * logarithm.re), angle = a * logarithm.im;
    return (rw_complex){size * cos(angle), size * sin(angle)};
}

static point point_at(const rw_sliding_frame *f, double x, double y)
{
    const double a = f->rule->a, height = y / f->half;
    point p = {.x = x,
               .y = y,
               .from_left = {(x - f->patch.left) / f->half, height},
               .from_right = {(x - f->patch.right) / f->half, height}};
    p.angle_left = rw_angle(p.from_left.re, height);
    p.angle_right = rw_angle(p.from_right.re, height);
    const rw_complex logarithm = {
        rw_log_of_quotient(square(p.from_left) + AT_EDGE, square(p.from_right) + AT_EDGE) / 2,
        p.angle_left - p.angle_right};
    p.V = power(a, logarithm);
    p.other_V = power(a - 1, logarithm);
    const bool is_left = logarithm.re < 0;
    p.X = is_left ? rw_product(p.V, p.from_right) : rw_product(p.other_V, p.from_left);
    if (height > 0)
        p.Y = is_left ? rw_quotient(p.V, p.from_left) : rw_quotient(p.other_V, p.from_right);
    p.beside = (rw_complex){(x - f->middle) / f->half - 2 * a + 1, height};
    return p;
}

/* z less a place. */
static rw_complex distance(const rw_sliding_frame *f, const point *p, double at)
{
    return (rw_complex){(p->x - at) / f->half, p->y / f->half};
}

/* X I. */
static rw_complex kink(const rw_sliding_frame *f, const point *p, const rw_place *t, rw_complex d)
{
    if (!(t->from_left > 0))
        return (rw_complex){f->whole, 0};
    const double rho = t->to_right / t->from_left, angle = rw_angle(d.re, d.im);
    const rw_complex twice = rw_multiple(2, d);
    if (rho * rho * square(p->from_left) <= square(p->from_right)) {
        const rw_complex w = rw_multiple(-rho, rw_quotient(p->from_left, p->from_right));
        const rw_complex rest = rw_quotient(twice, rw_multiple(t->from_left, p->from_right));
        const rw_complex phi = rw_power_integral(f->rule, w, rest, angle - p->angle_right);
        return rw_multiple(t->power, rw_product(p->V, phi));
    }
    const rw_complex w = rw_multiple(-1 / rho, rw_quotient(p->from_right, p->from_left));
    const rw_complex rest = rw_quotient(twice, rw_multiple(t->to_right, p->from_left));
    const rw_complex phi = rw_power_integral(f->other, w, rest, angle - p->angle_left);
    const rw_complex less = rw_multiple(-t->power / rho, rw_product(p->other_V, phi));
    return (rw_complex){f->whole + less.re, less.im};
}

typedef struct {
    const rw_sliding_frame *frame;
    int count;
    point *points;
} cloud;

/* X J and Y (W + (z - 2 a + 1) J), off. */
static void add_edges(point *p, double J, double W, double jump)
{
    const rw_complex beside = {W + p->beside.re * J, p->beside.im * J};
    p->G = rw_sum(p->G, rw_multiple(-jump * J, p->X));
    p->D = rw_sum(p->D, rw_multiple(-jump, rw_product(p->Y, beside)));
}

static void add_kink(const rw_sliding_frame *f, point *p, const rw_place *t, double step)
{
    const rw_complex d = distance(f, p, t->at);
    p->G = rw_sum(p->G, rw_multiple(step, kink(f, p, t, d)));
    p->D = rw_sum(p->D, rw_multiple(-step * t->W, rw_quotient(p->Y, d)));
}

static void add_bend(const rw_sliding_frame *f, point *p, const rw_place *t, double jump)
{
    const rw_complex d = distance(f, p, t->at), by = kink(f, p, t, d);
    p->G = rw_sum(p->G, rw_multiple(jump, rw_product(d, by)));
    p->D = rw_sum(p->D, rw_multiple(jump, by));
}

static void add_joint(const rw_joint *joint, void *context)
{
    const cloud *all = context;
    for (int i = 0; i < all->count; i++) {
        point *p = &all->points[i];
        if (joint->step != 0)
            add_kink(all->frame, p, &joint->place, joint->step);
        if (joint->jump != 0) {
            add_bend(all->frame, p, &joint->place, joint->jump);
            add_edges(p, joint->place.J, joint->place.W, joint->jump);
        }
    }
}

/* A point is near an arc within so many halves of it. */
static const double NEAR = 16;

static void add_near_arc(const rw_sliding_frame *f, point *p, const rw_short_arc *arc)
{
    const double jump = arc->rise / (2 * arc->half);
    double J = 0; /* of the arc alone */
    for (int i = 0; i < RW_ARC_NODES; i++)
        J += 2 * arc->half * arc->weight[i] * arc->node[i].power / arc->node[i].to_right;
    add_bend(f, p, &arc->end[0], jump);
    add_bend(f, p, &arc->end[1], -jump);
    add_edges(p, J, arc->end[0].W - arc->end[1].W, jump);
}

static void add_arc(const rw_short_arc *arc, void *context)
{
    const cloud *all = context;
    for (int i = 0; i < all->count; i++) {
        point *p = &all->points[i];
        const rw_complex d = distance(all->frame, p, arc->middle);
        if (square(d) < NEAR * NEAR * arc->half * arc->half)
            add_near_arc(all->frame, p, arc);
        else
            for (int k = 0; k < RW_ARC_NODES; k++)
                add_kink(all->frame, p, &arc->node[k], arc->rise * arc->weight[k]);
    }
}

/* X Q and its derivative, Q = sum M_n/z^(n+1). */
static void set_far(const rw_sliding_frame *f, const rw_sliding_sums *sums, point *p)
{
    const rw_complex one = {1, 0}, zero = {0, 0};
    const rw_complex z = {(p->x - f->middle) / f->half, p->y / f->half}, u = rw_quotient(one, z);
    rw_complex Q = zero, slope = zero; /* of Q over u, by u */
    for (int n = RW_MOMENTS; n-- > 1;) {
        slope = rw_sum(rw_product(slope, u), Q);
        Q = rw_product(Q, u);
        Q.re += sums->moment[n];
    }
    /* Q u^2: its derivative by z is -u^2 (2 u Q + u^2 slope) */
    const rw_complex u2 = rw_product(u, u);
    const rw_complex all = rw_product(u2, Q);
    const rw_complex fall =
        rw_product(u2, rw_sum(rw_multiple(2, rw_product(u, Q)), rw_product(u2, slope)));
    const double a = f->rule->a;
    const rw_complex bend = rw_sum(rw_multiple(a, rw_quotient(one, p->from_left)),
                                   rw_multiple(1 - a, rw_quotient(one, p->from_right)));
    p->G = rw_product(p->X, all);
    p->D = rw_product(p->X, rw_sum(rw_product(bend, all), rw_multiple(-1, fall)));
}

static bool is_far(const rw_sliding_frame *f, double x, double y)
{
    const double away = (x - f->middle) / f->half, deep = y / f->half;
    return away * away + deep * deep > FAR * FAR;
}

void rw_sliding_fields(const rw_arcs *arcs, rw_sliding_way slides, rw_patch patch, int n,
                       const double x[], const double y[], rw_fields *fields)
{
    if (!slides.unlike) {
        rw_pad_fields(arcs, patch, n, x, y, fields);
        return;
    }
    const rw_sliding_frame f = rw_sliding_frame_of(slides, patch);
    const rw_sliding_sums sums = rw_sliding_sums_of(arcs, &f, RW_MOMENTS);
    point near[RW_BATCH], far;
    int place[RW_BATCH];
    cloud all = {&f, 0, near};
    for (int i = 0; i < n; i++) {
        if (is_far(&f, x[i], y[i])) {
            far = point_at(&f, x[i], y[i]);
            set_far(&f, &sums, &far);
            rw_put(fields, i,
                   (rw_field){far.G.re / f.whole, far.G.im / f.whole,
                              (y[i] / f.half) * far.D.re / f.whole,
                              (y[i] / f.half) * far.D.im / f.whole});
        } else {
            place[all.count] = i;
            near[all.count++] = point_at(&f, x[i], y[i]);
        }
    }
    if (all.count > 0)
        rw_visit_joints(arcs, &f, &(rw_visitor){add_joint, add_arc, &all});
    for (int k = 0; k < all.count; k++) {
        const point *p = &near[k];
        const double depth = p->y / f.half / f.whole;
        rw_put(fields, place[k],
               (rw_field){p->G.re / f.whole + sums.offset, p->G.im / f.whole,
                          depth > 0 ? depth * p->D.re : 0, depth > 0 ? depth * p->D.im : 0});
    }
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
