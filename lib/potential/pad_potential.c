/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Neighbouring arcs share a joint, where the curvature of the profile jumps by k_j. The potential
 * of all of them is a sum over the joints, G = C R - D + i sum K_j (z - t_j) l_j, K_j = k_j s/pi,
 * t_j = cos(psi_j), G' = i sum K_j l_j - (C R + D)/X, C = sum K_j psi_j, D = sum K_j sin(psi_j),
 * with one complex logarithm l_j (eccentric_form.h) for each joint; a sum over the arcs has two for
 * each arc. For arcs so curved that their terms would cancel, the arcs are added one by one
 * instead. An end on the left of the patch has psi = pi. Far away G = sum K_j sum_n (S_(n-1) -
 * S_(n+1)) R^n/n, S_n = sin(n psi_j)/n, S_0 = psi_j. */
#define RW_VECTORS
#include "potential/pad_potential.h"

#include "potential/eccentric_form.h"

/* An arc with both ends inside is added by itself if its curvature is this many times that which
 * would make all of the pressure by itself: as many times the rounding would be lost. */
static const double STEEPEST = 32;

enum { JOINTS = 64 };

typedef struct {
    double at, sine, cosine, jump; /* jump: K */
} joint;

typedef struct {
    rw_eccentric whole; /* for points that are far */
    double bend, lean;  /* C and D */
    bool is_last;
    int count;
    joint all[JOINTS]; /* whose logarithms are not added yet */
} joints;

typedef struct {
    int n, far;
    const double *x, *y;
    double near_x[RW_BATCH], near_y[RW_BATCH];
    rw_fields *sums; /* over the joints: of K (z - t) l as G, of K l as H; at last the fields */
    bool has_others;
    rw_fields others; /* of the arcs that are taken one by one */
} points;

/* ---- At many points ---- */

/* Points seen from their halves of the plane. */
typedef struct {
    double sign[RW_LANES], right[RW_LANES], beyond[RW_LANES], y[RW_LANES], sin_v[RW_LANES],
        cos_v[RW_LANES], sinh_w[RW_LANES], cosh_w[RW_LANES], cos2[RW_LANES], shrink[RW_LANES],
        cosh_less_1[RW_LANES], per_cosh[RW_LANES];
} seen;

RW_INLINE void see(const rw_eccentric *w, double x, double y, int i, seen *all)
{
    const double sign = rw_if_negative((x - w->middle) + 0.0, -1, 1), right = sign * x;
    const double edge = rw_if_negative(sign, -w->patch.left, w->patch.right);
    const double beyond = (right - edge) * w->per_half_width;
    const rw_elliptic_point at = rw_elliptic_point_of(rw_elliptic_at(
        (right - sign * w->middle) * w->per_half_width, y * w->per_half_width, beyond));
    all->sign[i] = sign;
    all->right[i] = right;
    all->beyond[i] = beyond;
    all->y[i] = at.e.y;
    all->sin_v[i] = at.e.sin_v;
    all->cos_v[i] = at.e.cos_v;
    all->sinh_w[i] = at.e.sinh_w;
    all->cosh_w[i] = at.e.cosh_w;
    all->cos2[i] = at.e.cos2;
    all->shrink[i] = at.shrink;
    all->cosh_less_1[i] = at.cosh_less_1;
    all->per_cosh[i] = at.per_cosh;
}

RW_INLINE rw_elliptic_point point_of(const seen *all, int i)
{
    return (rw_elliptic_point){{.y = all->y[i],
                                .sin_v = all->sin_v[i],
                                .cos_v = all->cos_v[i],
                                .sinh_w = all->sinh_w[i],
                                .cosh_w = all->cosh_w[i],
                                .cos2 = all->cos2[i]},
                               all->shrink[i],
                               all->cosh_less_1[i],
                               all->per_cosh[i]};
}

/* The field that the sums make. */
RW_INLINE rw_field field_of(const joints *p, const seen *all, int i, rw_field sums)
{
    const double sign = all->sign[i], lean = sign * p->lean, y = all->y[i];
    const rw_elliptic_point at = point_of(all, i);
    const double R_re = p->bend * (at.shrink * at.e.sin_v),
                 R_im = -p->bend * (at.shrink * at.e.cos_v);
    const rw_complex edge = rw_over_X(&at.e, y, R_re + lean, R_im);
    const rw_field right = {R_re - lean - sign * (sums.G_im + y * sums.H_re),
                            R_im + sign * (sums.G_re - y * sums.H_im),
                            -sign * (y * sums.H_im) - edge.re, sign * (y * sums.H_re) - edge.im};
    return rw_side_mirrored(sign, (rw_side_place){.y = y, .beyond = all->beyond[i]}, right);
}

RW_INLINE void add_all(const joints *restrict p, int count, const double *restrict x,
                       const double *restrict y, rw_fields *restrict sums)
{
    const double per_s = p->whole.per_half_width;
    for (int first = 0; first < count; first += RW_LANES) {
        seen all;
        double sum[4][RW_LANES] = {{0}};
        for (int i = 0; i < RW_LANES; i++)
            see(&p->whole, x[first + i], y[first + i], i, &all);
        for (int j = 0; j < p->count; j++) {
            const joint k = p->all[j];
            for (int i = 0; i < RW_LANES; i++) {
                const double past = (all.right[i] - all.sign[i] * k.at) * per_s;
                const rw_complex l =
                    rw_end_logarithm(all.sign[i] * k.sine, k.cosine, past, point_of(&all, i));
                const double l_re = k.jump * l.re, l_im = k.jump * l.im;
                sum[0][i] += past * l_re;
                sum[1][i] += past * l_im;
                sum[2][i] += l_re;
                sum[3][i] += l_im;
            }
        }
        for (int i = 0; i < RW_LANES; i++) {
            const rw_field before = rw_field_in(sums, first + i);
            const rw_field now = {before.G_re + sum[0][i], before.G_im + sum[1][i],
                                  before.H_re + sum[2][i], before.H_im + sum[3][i]};
            rw_put(sums, first + i, p->is_last ? field_of(p, &all, i, now) : now);
        }
    }
}

RW_BEST_PROCESSOR(add_best, add_all, joints)

/* ---- Joints ---- */

static void begin(joints *p, rw_patch patch)
{
    rw_eccentric_init_far(&p->whole, patch);
    p->bend = p->lean = 0;
    p->is_last = false;
    p->count = 0;
}

/* Adds the series without S_0, whose sum is C. */
static void add_series(rw_eccentric *whole, const joint *j)
{
    double before = 0, now = j->cosine, wave = j->cosine, last = 0; /* wave: sin(n psi) */
    for (int n = 1; n <= RW_SERIES_TERMS; n++) {
        const double next = 2 * j->sine * wave - last, after = next / (n + 1);
        whole->far[n - 1] += RW_HALF_PI * j->jump * (before - after) / n;
        last = wave;
        wave = next;
        before = now;
        now = after;
    }
}

static void flush(joints *p, points *at)
{
    for (int i = 0; at->far > 0 && i < p->count; i++)
        add_series(&p->whole, &p->all[i]);
    add_best(p, at->n, at->near_x, at->near_y, at->sums);
    p->count = 0;
}

/* An end of an arc, and by how much the curvature is larger beyond it; its cosine. */
static double put(joints *p, double place, double jump)
{
    const rw_patch patch = p->whole.patch;
    const double per_s = p->whole.per_half_width;
    if (place <= patch.left || place >= patch.right)
        return 0;
    const double cosine = sqrt((place - patch.left) * per_s * ((patch.right - place) * per_s));
    if (p->count > 0 && p->all[p->count - 1].at == place)
        p->all[p->count - 1].jump += jump;
    else
        p->all[p->count++] = (joint){place, (place - p->whole.middle) * per_s, cosine, jump};
    return cosine;
}

/* C and D of an arc: the angle between its ends is twice that of (the sum of their cosines, the
 * difference of their sines). */
static void put_arc(joints *p, rw_arc arc, double weight, points *at)
{
    const rw_patch patch = p->whole.patch;
    const double K = weight / rw_arc_half_length(arc) * p->whole.half_width / RW_PI;
    const double inside = fmin(arc.right, patch.right) - fmax(arc.left, patch.left);
    const double left = put(p, arc.left, K), right = put(p, arc.right, -K);
    p->bend += K * (2 * rw_angle(left + right, inside * p->whole.per_half_width));
    p->lean += K * (left - right);
    if (p->count > JOINTS - 2)
        flush(p, at);
}

/* From the sums to the fields. */
static void finish(joints *p, points *at)
{
    p->is_last = true;
    flush(p, at);
    p->whole.far[0] += RW_HALF_PI * p->bend;
    for (int i = 0; at->far > 0 && i < at->n; i++)
        if (rw_eccentric_is_far(&p->whole, at->x[i], at->y[i]))
            rw_put(at->sums, i, rw_eccentric_at(&p->whole, at->x[i], at->y[i]));
    if (at->has_others)
        rw_add_fields(&at->others, 1, at->n, at->sums);
}

/* ---- Arcs ---- */

/* About P/s: by how much the arcs turn the slope inside, times cos(phi). */
static double mean_pressure(const rw_arcs *arcs, rw_patch patch)
{
    const double per_s = 1 / rw_patch_half_width(patch);
    double sum = 0;
    for (size_t i = 0; i < arcs->count; i++) {
        const rw_arc arc = rw_arc_at(arcs, i);
        if (!rw_arc_is_inside(arc, patch))
            continue;
        const double left = fmax(arc.left, patch.left), right = fmin(arc.right, patch.right);
        const double middle = left / 2 + right / 2;
        const double part = arc.right > arc.left ? (right - left) / (arc.right - arc.left) : 1;
        sum += rw_arc_weight(arcs, i) * part *
               sqrt((middle - patch.left) * per_s * ((patch.right - middle) * per_s));
    }
    return sum;
}

static void arc_fields(rw_arc arc, rw_patch patch, int n, const double x[], const double y[],
                       rw_fields *fields)
{
    rw_eccentric potential;
    rw_eccentric_init_arc(&potential, arc, patch);
    rw_eccentric_fields(&potential, n, x, y, fields);
}

static void add_arc(rw_arc arc, rw_patch patch, double weight, points *at)
{
    rw_fields of_arc;
    if (!at->has_others)
        rw_clear_fields(at->n, &at->others);
    at->has_others = true;
    arc_fields(arc, patch, at->n, at->x, at->y, &of_arc);
    rw_add_fields(&of_arc, weight, at->n, &at->others);
}

static void add_arcs(const rw_arcs *arcs, rw_patch patch, points *at, joints *p)
{
    const double s = p->whole.half_width;
    const double most = STEEPEST * mean_pressure(arcs, patch);
    for (size_t i = 0; i < arcs->count; i++) {
        const rw_arc arc = rw_arc_at(arcs, i);
        const double weight = rw_arc_weight(arcs, i);
        if (!rw_arc_is_inside(arc, patch))
            continue;
        const bool is_whole = arc.left > patch.left && arc.right < patch.right;
        if (!is_whole || weight * s < most * rw_arc_half_length(arc))
            put_arc(p, arc, weight, at);
        else
            add_arc(arc, patch, weight, at);
    }
}

void rw_pad_fields(const rw_arcs *arcs, rw_patch patch, int n, const double x[], const double y[],
                   rw_fields *fields)
{
    if (!arcs->pad) {
        arc_fields(arcs->rounding, patch, n, x, y, fields);
        return;
    }
    points at; /* and joints: most of their room is never used */
    joints p;
    begin(&p, patch);
    at.n = n;
    at.x = x;
    at.y = y;
    at.sums = fields;
    at.has_others = false;
    at.far = rw_near_points(&p.whole, n, x, y, at.near_x, at.near_y);
    rw_clear_fields(RW_BATCH, fields);
    add_arcs(arcs, patch, &at, &p);
    finish(&p, &at);
}

/* ---- On the surface ---- */

void rw_pad_pressures(const rw_arcs *arcs, rw_patch patch, size_t n, const double x[], double p[])
{
    for (size_t k = 0; k < n; k++)
        p[k] = 0;
    for (size_t i = 0; i < arcs->count; i++) {
        rw_eccentric potential;
        if (!rw_arc_is_inside(rw_arc_at(arcs, i), patch))
            continue;
        rw_eccentric_init_arc(&potential, rw_arc_at(arcs, i), patch);
        for (size_t k = 0; k < n; k++)
            if (x[k] > patch.left && x[k] < patch.right)
                p[k] -= rw_arc_weight(arcs, i) * rw_eccentric_at(&potential, x[k], 0).G_im;
    }
}
