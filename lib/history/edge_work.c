/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The energy of a step under constant load and moment. The front N_0 of slip has passed the layers
 * of the path up to the contact N_n. The shear traction has changed by f c_i times the pressures
 * between N_i and N_(i+1), c_i = 1 - S D_i >= 0.
 *
 * The work is a sum over pairs of a flat punch t of that change and a flat punch u of the pressure
 * that is larger: the work of u on the displacement of t outside of t. With L = (P, M) of a punch
 * and its compliance C, a symmetric matrix, that is L_t . (C_u - C_t) L_u. As a punch grows from t
 * to u, its compliance changes by the stress intensities k at its moving edges (Irwin):
 *
 *     L_t . dC L_u = (k_t k_u dr)_right - (k_t k_u dl)_left,   k = P +- 2 (M - m P)/s,
 *
 * over 2 pi s. So with the sums of all punches inside and outside of a patch v the work is one
 * integral over nested patches from the front to the contact,
 *
 *     (1/2 pi) int k_in k_out dr/s,   L_in = sum c_i dL_i up to v,   L_out = L_n - L_v.
 *
 * The pressures between two patches do not depend on the way from one to the other: here the edges
 * move evenly. */
#include "history/dissipation.h"

#include "base/domain.h"

/* One layer: the change of the traction has the load and the moment `inner` inside `from`. */
typedef struct {
    const rw_geometry *geometry;
    double weight;
    rw_patch from, to;
    rw_pressing inner, start, contact;
} layer;

static rw_patch patch_at(const layer *l, double t)
{
    return (rw_patch){l->from.left + t * (l->to.left - l->from.left),
                      l->from.right + t * (l->to.right - l->from.right)};
}

static rw_pressing sum(rw_pressing inner, double weight, rw_pressing more, rw_pressing less)
{
    return (rw_pressing){.load = inner.load + weight * (more.load - less.load),
                         .moment = inner.moment + weight * (more.moment - less.moment)};
}

/* The stress intensity k = P +- 2 (M - m P)/s at an edge, the right one for side = 1. */
static double intensity(rw_pressing carried, rw_patch patch, int side)
{
    const double about_middle = carried.moment - rw_patch_middle(patch) * carried.load;
    return carried.load + side * 2 * about_middle / rw_patch_half_width(patch);
}

static double rate(const layer *l, double t)
{
    const rw_patch v = patch_at(l, t);
    const rw_pressing here = rw_pressing_of(l->geometry, v), none = {0, 0, 0};
    const rw_pressing in = sum(l->inner, l->weight, here, l->start),
                      out = sum(none, 1, l->contact, here);
    const double right = intensity(in, v, 1) * intensity(out, v, 1) * (l->to.right - l->from.right);
    const double left = intensity(in, v, -1) * intensity(out, v, -1) * (l->from.left - l->to.left);
    return (right + left) / rw_patch_half_width(v);
}

enum { STEPS = 20 };

/* The integrand is smooth but for roots at the ends, which the substitution of tanh and sinh
 * removes. */
static double panel_integral(const layer *l, double from, double to)
{
    const double half = (to - from) / 2, middle = from + half, step = 0.16;
    double sum = 0;
    for (int i = -STEPS; i <= STEPS; i++) {
        const double t = i * step, u = tanh(RW_HALF_PI * sinh(t));
        sum += RW_HALF_PI * cosh(t) * (1 - u * u) * rate(l, middle + half * u);
    }
    return half * step * sum;
}

/* The part of the way, 0 to 1, at which an edge that moves evenly passes a place; 1 where it does
 * not. */
static double passing(double from, double to, double place)
{
    return (from < place) != (to < place) ? (place - from) / (to - from) : 1;
}

/* Panels end where an edge passes the end of an arc, and where the patch has four times the width,
 * however narrow the front is: there is a pole where it has none. */
static double next_end(const layer *l, double t)
{
    const double from = rw_patch_half_width(l->from), to = rw_patch_half_width(l->to);
    const rw_arcs arcs = rw_arcs_of(l->geometry);
    double next = rw_earlier(passing(from, to, 4 * (from + t * (to - from))), t, 1);
    for (size_t i = 0; i < arcs.count; i++) {
        const rw_arc arc = rw_arc_at(&arcs, i);
        next = rw_earlier(passing(l->from.left, l->to.left, arc.left), t, next);
        next = rw_earlier(passing(l->from.right, l->to.right, arc.right), t, next);
        next = rw_earlier(passing(l->from.left, l->to.left, arc.right), t, next);
        next = rw_earlier(passing(l->from.right, l->to.right, arc.left), t, next);
    }
    return next;
}

static double layer_integral(const layer *l)
{
    double sum = 0;
    for (double t = 0, next; t < 1; t = next) {
        next = next_end(l, t);
        sum += panel_integral(l, t, next);
    }
    return sum;
}

double rw_edge_work(const rw_memory *path, const rw_departure *departure, const rw_geometry *g)
{
    const rw_corner *front = &departure->corner;
    const rw_patch contact = rw_memory_end(path)->patch;
    layer l = {.geometry = g, .to = front->patch, .contact = rw_pressing_of(g, contact)};
    rw_pressing reached = rw_pressing_of(g, front->patch);
    double sum_of_all = 0;
    for (size_t i = departure->kept; i < path->count; i++) {
        const rw_corner *corner = &path->corners[i];
        l.from = l.to;
        l.to = corner->patch;
        l.start = reached;
        l.weight = 1 - departure->slip * corner->ratio;
        sum_of_all += layer_integral(&l);
        reached = rw_pressing_of(g, l.to);
        l.inner = sum(l.inner, l.weight, reached, l.start);
    }
    return fmax(0, sum_of_all / (2 * RW_PI));
}
