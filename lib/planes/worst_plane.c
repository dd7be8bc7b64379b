/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Bound and refine over a quarter of the sphere of normals: planes that are mirrored by the plane
 * of x and y are equally bad. A cell is a rectangle of the longitude chi and the latitude beta.
 *
 * Between its corners the stresses of a plane, along the meridian, the parallel and the normal, are
 * mixtures of those at the corners but for a remainder, which is bounded by the second derivatives.
 * The radius of the smallest circle around points is a convex function of the points. So both the
 * amplitude and the peak are below mixtures of their values at the corners, but for the remainder,
 * whatever loads are the highest and on the circle. The bound exceeds the true values by the second
 * order of the cell's size.
 *
 * All cells that may have a worse plane are halved, again and again: few are left at each size. */
#include "planes/worst_plane.h"

#include "base/domain.h"
#include "planes/equator.h"
#include "planes/plane_cycle.h"

#include <float.h>

/* Where a curve of planes is nearly as bad, ever more cells are left. Where there is no room
 * for all, so many are kept, those with the highest bounds. */
enum { KEPT = RW_CELLS / 4 };

/* Bounds of an eighth of the second derivatives of a quantity by chi and beta. */
typedef struct {
    double chi, beta;
} bends;

typedef struct {
    const rw_severity *severity;
    rw_plane_cycle *cycle;
    double noise;
    rw_point pole, base, side; /* normals: of latitude pi/2; of longitude 0; across both */
    bends bend, peak_bend;     /* of what counts by its amplitude; of the normal stress */
    rw_worst_plane best;
    rw_point normal; /* of the best plane */
    size_t count;    /* of cells */
} search;

/* ---- A plane ---- */

/* What counts by its amplitude, of a load: the normal strain; the shear stress as a vector. */
static rw_point path_at(const rw_item *load, bool is_strain, double wave, const rw_point *normal)
{
    const double x = normal->x[0], y = normal->x[1], z = normal->x[2];
    if (is_strain)
        return (rw_point){{load->level - (x * x + y * y) * load->deviation_lift + wave}};
    const double in_x = load->deviation_t * y - load->deviation_d * x,
                 in_y = load->deviation_t * x + load->deviation_d * y,
                 in_z = load->deviation_lift * z;
    const double across = in_x * x + in_y * y + in_z * z;
    return (rw_point){{in_x - across * x, in_y - across * y, in_z - across * z}};
}

static rw_point normal_of(const search *w, rw_direction chi, rw_direction beta)
{
    rw_point n;
    for (int k = 0; k < 3; k++)
        n.x[k] = beta.sine * w->pole.x[k] +
                 beta.cosine * (chi.cosine * w->base.x[k] + chi.sine * w->side.x[k]);
    return n;
}

static rw_plane plane_at(search *w, rw_plane p)
{
    const rw_point normal = normal_of(w, p.chi, p.beta);
    const double x = normal.x[0], y = normal.x[1];
    const double level = x * x + y * y, cosine = (y - x) * (y + x), sine = 2 * x * y;
    const rw_plane_cycle *cycle = w->cycle;
    p.peak = -DBL_MAX;
    for (size_t i = 0; i < cycle->loads; i++) {
        const rw_item *load = &cycle->item[i];
        p.peak =
            rw_larger(p.peak, load->z - level * load->lift + (load->d * cosine + load->t * sine));
        cycle->point[i] = path_at(load, w->severity->is_strain,
                                  load->deviation_d * cosine + load->deviation_t * sine, &normal);
    }
    p.amplitude = rw_smallest_ball(cycle->loads, cycle->point).radius;
    const double value = rw_severity_of(w->severity, p.amplitude, p.peak);
    if (value > w->best.value) {
        w->best = (rw_worst_plane){.value = value, .amplitude = p.amplitude, .peak = p.peak};
        w->normal = normal;
    }
    return p;
}

static rw_direction direction_between(rw_direction a, rw_direction b)
{
    const double cosine = a.cosine + b.cosine, sine = a.sine + b.sine,
                 length = sqrt(cosine * cosine + sine * sine);
    return (rw_direction){cosine / length, sine / length};
}

static rw_plane plane_between(search *w, const rw_plane *a, const rw_plane *b)
{
    return plane_at(w, (rw_plane){.chi = direction_between(a->chi, b->chi),
                                  .beta = direction_between(a->beta, b->beta)});
}

/* ---- A cell ---- */

static double rest_of(const rw_cell *c, bends by)
{
    return by.chi * c->chi * c->chi + by.beta * c->beta * c->beta;
}

/* Above the severity everywhere in the cell. Both factors of a product are below mixtures of their
 * values at the corners, with the same weights. The product of two mixtures exceeds that of the
 * products by their covariance at most. */
static double bound_of(const search *w, const rw_cell *c)
{
    const rw_severity *v = w->severity;
    const double rest = rest_of(c, w->bend), peak_rest = rest_of(c, w->peak_bend);
    double most = -DBL_MAX, top = -DBL_MAX, bottom = DBL_MAX, high = -DBL_MAX, low = DBL_MAX;
    for (int k = 0; k < RW_CORNERS; k++) {
        const double amplitude = c->corner[k].amplitude + rest,
                     peak = c->corner[k].peak + peak_rest;
        const double factor = v->is_sum ? 0 : rw_larger(0, v->offset + v->gain * peak);
        most = rw_larger(most, rw_severity_of(v, amplitude, peak));
        top = rw_larger(top, amplitude), bottom = rw_smaller(bottom, amplitude);
        high = rw_larger(high, factor), low = rw_smaller(low, factor);
    }
    return most + (top - bottom) * (high - low) / 4;
}

/* ---- All cells ---- */

/* Corners 0 and 1 have the least chi, 0 and 2 the least beta. */
static void halve(search *w, rw_cell *c, rw_cell *other)
{
    const bends both = {w->bend.chi + w->severity->gain * w->peak_bend.chi,
                        w->bend.beta + w->severity->gain * w->peak_bend.beta};
    const bool along_chi = both.chi * c->chi * c->chi > both.beta * c->beta * c->beta;
    *(along_chi ? &c->chi : &c->beta) /= 2;
    *other = *c;
    for (int k = 0; k < 2; k++) {
        const int from = along_chi ? k : 2 * k, to = along_chi ? k + 2 : 2 * k + 1;
        c->corner[to] = other->corner[from] = plane_between(w, &c->corner[from], &c->corner[to]);
    }
}

static void halve_all(search *w)
{
    for (size_t i = 0, count = w->count; i < count; i++)
        halve(w, &w->cycle->cell[i], &w->cycle->cell[w->count++]);
}

/* A bound that more than KEPT cells exceed, and hardly more. (A large qsort() asks for memory.) */
static double bound_of_kept(const search *w)
{
    enum { HALVINGS = 64 };
    const rw_cell *cells = w->cycle->cell;
    double low = w->best.value, high = low;
    for (size_t i = 0; i < w->count; i++)
        high = rw_larger(high, cells[i].bound);
    for (int turn = 0; turn < HALVINGS; turn++) {
        const double middle = low + (high - low) / 2;
        size_t above = 0;
        for (size_t i = 0; i < w->count; i++)
            above += cells[i].bound > middle;
        *(above > KEPT ? &low : &high) = middle;
    }
    return low;
}

/* Keeps the cells whose bounds exceed this, but not more of them than `most`. */
static void keep(search *w, double least, size_t most)
{
    rw_cell *cells = w->cycle->cell;
    size_t kept = 0;
    for (size_t i = 0; i < w->count && kept < most; i++)
        if (cells[i].bound > least)
            cells[kept++] = cells[i];
    w->count = kept;
}

/* Keeps the cells that may have a worse plane than the worst so far. */
static void settle(search *w)
{
    for (size_t i = 0; i < w->count; i++)
        w->cycle->cell[i].bound = bound_of(w, &w->cycle->cell[i]);
    keep(w, w->best.value + w->noise, w->count);
    if (w->count > RW_CELLS)
        keep(w, bound_of_kept(w), KEPT);
}

/* ---- Poles and bends ---- */

/* psi: of the pole, or where z is the pole, of the base. */
typedef struct {
    rw_direction psi;
    bool is_z;
} pole_choice;

/* Where the stresses change along one direction alone, as near a free surface in plane stress, all
 * planes of one latitude around it are nearly equally bad, and cells may be long. So the pole is
 * the principal direction that differs most from the two others, where these are so close; of the
 * load farthest from the middle. Otherwise it is z: on its equator the worst plane is mostly. */
static pole_choice pole_of(const rw_plane_cycle *cycle)
{
    static const double CLOSE = 0.2;
    pole_choice chosen = {{1, 0}, true};
    double most = 0;
    for (size_t i = 0; i < cycle->loads; i++) {
        const rw_item *load = &cycle->item[i];
        const double lift = fabs(load->deviation_lift), size = load->deviation_size;
        if (size == 0 || size + lift <= most)
            continue;
        const double length = load->deviation_lift > 0 ? -size : size;
        most = size + lift;
        chosen = (pole_choice){{load->deviation_d / length, load->deviation_t / length},
                               fabs(size - lift) > CLOSE * 2 * size};
    }
    return chosen;
}

/* Raises the bends to those of a stress, given by its differences between pole and base and side
 * and base, and its shear stresses between pole and side and side and base. */
static void raise_bends(bends *b, double pole, double side, double shear, double twist)
{
    const double ring = sqrt(side * side + 4 * twist * twist);
    b->chi = rw_larger(b->chi, (ring + fabs(shear) / 2) / 4);
    b->beta = rw_larger(b->beta, (fabs(pole) + ring + 2 * fabs(shear)) / 4);
}

static void raise_by(bends *b, const pole_choice *p, double d, double t, double lift)
{
    const rw_direction back = {p->psi.cosine, -p->psi.sine},
                       u = rw_turned_with((rw_direction){d, t}, back);
    if (p->is_z)
        raise_bends(b, lift - u.cosine, -2 * u.cosine, 0, u.sine);
    else
        raise_bends(b, u.cosine - lift, -u.cosine - lift, u.sine, 0);
}

static void set_axes(search *w, const pole_choice *p)
{
    const double cosine = p->psi.cosine, large = sqrt((1 + fabs(cosine)) / 2),
                 small = p->psi.sine / (2 * large);
    const double x = cosine < 0 ? large : small, y = cosine < 0 ? small : large;
    const rw_point across_z = {{0, 0, 1}}, in_plane = {{x, y, 0}};
    w->pole = p->is_z ? across_z : in_plane;
    w->base = p->is_z ? in_plane : across_z;
    w->side = (rw_point){{y, -x, 0}};
}

static void set_sphere(search *w)
{
    const pole_choice p = pole_of(w->cycle);
    set_axes(w, &p);
    for (size_t i = 0; i < w->cycle->loads; i++) {
        const rw_item *l = &w->cycle->item[i];
        raise_by(&w->peak_bend, &p, l->d, l->t, l->lift);
        raise_by(&w->bend, &p, l->deviation_d, l->deviation_t, l->deviation_lift);
    }
}

/* ---- All ---- */

/* Two cells, as directions that are opposite have no middle. */
static void begin(search *w)
{
    static const rw_direction CHI[3] = {{0, -1}, {1, 0}, {0, 1}}, BETA[2] = {{1, 0}, {0, 1}};
    set_sphere(w);
    w->count = 2;
    for (int i = 0; i < 2; i++) {
        rw_cell *c = &w->cycle->cell[i];
        *c = (rw_cell){.chi = RW_HALF_PI, .beta = RW_HALF_PI};
        for (int k = 0; k < RW_CORNERS; k++)
            c->corner[k] = plane_at(w, (rw_plane){.chi = CHI[i + k / 2], .beta = BETA[k % 2]});
    }
}

static void name_plane(search *w)
{
    const double x = w->normal.x[0], y = w->normal.x[1];
    w->best.angle = rw_plane_angle((y - x) * (y + x), 2 * x * y);
    w->best.out_of_plane = rw_angle(sqrt(x * x + y * y), fabs(w->normal.x[2]));
}

/* Planes that may be worse than the worst of the equator. */
static void search_sphere(search *w)
{
    const rw_worst_plane equator = w->best;
    begin(w);
    for (settle(w); w->count > 0; settle(w))
        halve_all(w);
    if (w->best.value > equator.value + w->noise)
        name_plane(w);
    else
        w->best = equator;
}

rw_worst_plane rw_worst_plane_of(rw_plane_cycle *cycle, const rw_severity *severity)
{
    rw_plane_cycle_centre(cycle);
    search w = {
        .severity = severity, .cycle = cycle, .noise = rw_plane_cycle_noise(cycle, severity)};
    rw_direction psi;
    rw_equator_search(cycle, severity, &w.best, &psi);
    w.best.angle = rw_plane_angle(psi.cosine, psi.sine);
    if (!rw_equator_has_worst(cycle, severity, w.best.value, w.noise))
        search_sphere(&w);
    return w.best;
}
