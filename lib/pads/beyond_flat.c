/* SPDX-License-Identifier: GPL-3.0-or-later */
/* How far the contact reaches beyond the corners of a flat. */
#include "pads/pads.h"

#include "base/logarithm.h"
#include "base/root.h"

/* The load of a flat pad in theta/A that is in contact up to d beyond its corners: s^2 (psi - sin
 * psi cos psi)/R, cos psi = a/s. */
typedef struct {
    double a, R, P;
} flat_pad;

static double beyond_excess(double d, const void *context)
{
    const flat_pad *p = context;
    const double a = p->a, s = a + d, sine = sqrt(d / s) * sqrt((2 * a + d) / s);
    return s / p->R * s * rw_arc_less_product(rw_angle(a / s, sine), sine, a / s) - p->P;
}

static double beyond_flat(const flat_pad *p)
{
    double hi = p->a + p->R;
    while (beyond_excess(hi / 4, p) > 0)
        hi /= 4;
    return rw_root(beyond_excess, p, hi / 4, hi, 0);
}

int32_t rwedge_contact_beyond_flat(const rwedge_contact *contact, double *left, double *right)
{
    if (!contact || !left || !right)
        return RWEDGE_ENULL;
    const rw_geometry *g = &contact->geometry;
    if (contact->phase == RW_APART)
        return RWEDGE_EABSENT;
    const rw_patch patch = rw_memory_end(&contact->memory)->patch;
    const double a = rw_pad_flat(g);
    const flat_pad p = {a, g->a, rw_as_length(g, contact->loads.P)};
    const bool is_level = a > 0 && patch.right == -patch.left;
    *left = is_level ? beyond_flat(&p) : -a - patch.left;
    *right = is_level ? *left : patch.right - a;
    return RWEDGE_OK;
}
