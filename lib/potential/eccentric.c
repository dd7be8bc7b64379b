/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "potential/eccentric.h"

#include "potential/eccentric_form.h"

/* ---- Preparation ---- */

/* A patch within the rounding is Hertz' contact. */
static rw_half_view plain_view(const rw_eccentric *p, double side)
{
    return (rw_half_view){.edge = side > 0 ? p->patch.right : -p->patch.left};
}

static rw_half_view view_of(const rw_eccentric *p, rw_arc arc, double side)
{
    const double left = side > 0 ? arc.left : -arc.right, right = side > 0 ? arc.right : -arc.left;
    const double centre = left / 2 + right / 2, part = centre - left / 2;
    const rw_arc_ends *k = &p->ends;
    const int first = side > 0 ? 0 : 1;
    const double sin_middle = side * k->sin_middle, up = fmax(sin_middle, 0);
    rw_half_view v = {
        .edge = side > 0 ? p->patch.right : -p->patch.left,
        .sine = {side * k->sine[first], side * k->sine[1 - first]},
        .cosine = {k->cosine[first], k->cosine[1 - first]},
        .sin_middle = sin_middle,
        .slant = sin_middle / k->cos_middle,
        .above = up,
        .beside = fmax(-sin_middle, 0),
        .clearance =
            sin_middle > 0 ? k->cosine[0] * k->cosine[1] / (k->cos_half + up) : k->cos_half,
    };
    v.end = left;
    v.other_end = right;
    v.centre = centre;
    v.centre_low = (left / 2 - (centre - part)) + (right / 2 - part);
    if (p->inside == 1) {
        const int in = v.cosine[1] > 0;
        v.end = in ? right : left;
        v.side = in ? -1 : 1;
        v.sine[0] = v.sine[in];
        v.cosine[0] = v.cosine[in];
        v.arc_over = rw_angle(v.side * v.sine[0], v.cosine[0]) * k->per_alpha;
    }
    return v;
}

/* <sin n psi> follows from the sines and cosines of multiples of half the angle between the ends,
 * and of psi midway: (1/2 alpha) [cos((n-1) psi) sin((n-1) half)/(n-1) - cos((n+1) psi) sin((n+1)
 * half)/(n+1)]. */
static void make_series(rw_eccentric *p)
{
    const rw_arc_ends *k = &p->ends;
    double part[RW_SERIES_TERMS + 2];                   /* cos(n psi) sin(n half)/(n alpha) */
    double cosine = 1, sine = 0, wave = 0, before = -1; /* wave: sin(n half)/sin(half) */
    part[0] = k->half_over;
    for (int n = 1; n < RW_SERIES_TERMS + 2; n++) {
        const double next = 2 * k->cos_half * wave - before;
        before = wave;
        wave = next;
        const double turned = cosine * k->sin_middle - sine * k->cos_middle;
        sine = sine * k->sin_middle + cosine * k->cos_middle;
        cosine = turned;
        part[n] = cosine * wave * k->sin_half_over / n;
    }
    for (int n = 1; n <= RW_SERIES_TERMS; n++)
        p->far[n - 1] = (part[n - 1] - part[n + 1]) / n;
}

void rw_eccentric_init_far(rw_eccentric *p, rw_patch patch)
{
    const double s = rw_patch_half_width(patch);
    *p = (rw_eccentric){
        .patch = patch, .middle = rw_patch_middle(patch), .half_width = s, .per_half_width = 1 / s};
    p->view[0] = plain_view(p, 1);
    p->view[1] = plain_view(p, -1);
}

void rw_eccentric_init_arc(rw_eccentric *p, rw_arc arc, rw_patch patch)
{
    const double s = rw_patch_half_width(patch), a = rw_arc_half_length(arc);
    p->is_centred = rw_patch_middle(patch) == 0 && arc.right == -arc.left;
    if (p->is_centred) { /* all it takes, and quick */
        rw_potential_init(&p->centred, a, s);
        return;
    }
    rw_eccentric_init_far(p, patch);
    p->a = a;
    if (rw_arc_covers(arc, patch)) {
        p->far[0] = RW_HALF_PI * (s / a);
        return;
    }
    p->ends = rw_arc_ends_of(arc, patch);
    p->inside = p->ends.is_inside[0] + p->ends.is_inside[1];
    p->view[0] = view_of(p, arc, 1);
    p->view[1] = view_of(p, arc, -1);
    make_series(p);
}

/* ---- Far away ---- */

static rw_field far_field(const rw_eccentric *p, double x, double y)
{
    const double sign = x < p->middle ? -1 : 1;
    const rw_side_place at = rw_side_place_of(p, &p->view[sign < 0], sign, x, y);
    rw_field field = rw_field_multiple(
        2 / RW_PI,
        rw_series_field(RW_SERIES_TERMS, p->far, rw_outer_place_of(at.x, at.y, at.beyond, sign)));
    if (y == 0)
        field.G_im = 0; /* no pressure, to the last bit */
    return field;
}

rw_field rw_eccentric_at(const rw_eccentric *p, double x, double y)
{
    if (p->is_centred)
        return rw_potential_at(&p->centred, x, y);
    if (rw_eccentric_is_far(p, x, y))
        return far_field(p, x, y);
    const rw_half_view *right = &p->view[0], *left = &p->view[1];
    if (p->inside == 0)
        return rw_eccentric_by(rw_side_hertz_field, p, right, left, x, y);
    if (p->inside == 1)
        return rw_eccentric_by(rw_side_half_rounded_field, p, right, left, x, y);
    if (p->ends.per_alpha == 0)
        return rw_eccentric_by(rw_side_sharp_field, p, right, left, x, y);
    return rw_eccentric_by(rw_side_rounded_field, p, right, left, x, y);
}
