/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The tractions and stresses of a contact: sums over the patches of its memory. */
#include "formulas/pressure.h"
#include "history/contact.h"
#include "stress/stress.h"

#include <float.h>

/* ---- Tractions ---- */

/* Or so near to it that it is not to be told from it in units of the half-width. */
static bool is_apex(const rwedge_contact *contact, double x, double y)
{
    return contact->geometry.a == 0 && contact->memory.count > 1 &&
           fmax(fabs(x), y) <= DBL_MIN * rwedge_contact_half_width(contact);
}

static double patch_pressure(const rw_corner *corner, double a, double x)
{
    const double s = corner->half_width;
    return fabs(x) < s && rw_patch_matters(s, a) ? rw_patch_pressure(a, s, x) : 0;
}

int32_t rwedge_contact_tractions(const rwedge_contact *contact, size_t n, const double x[],
                                 double p[], double q[])
{
    if (!contact || (n > 0 && (!x || !p || !q)))
        return RWEDGE_ENULL;
    for (size_t i = 0; i < n; i++)
        if (!isfinite(x[i]) || is_apex(contact, x[i], 0))
            return RWEDGE_EDOMAIN;
    const rw_geometry *g = &contact->geometry;
    const rw_memory *memory = &contact->memory;
    for (size_t i = 0; i < n; i++) {
        const double at = x[i];
        double shear = 0, pressure = 0;
        for (size_t j = 1; j < memory->count; j++) {
            pressure = g->theta / g->A * patch_pressure(&memory->corners[j], g->a, at);
            shear += rw_patch_weight(memory, j) * pressure;
        }
        p[i] = pressure; /* the last patch is the contact */
        q[i] = contact->f * shear;
    }
    return RWEDGE_OK;
}

/* ---- Stresses ---- */

static void add(rw_field *sum, double weight, rw_field field)
{
    sum->G_re += weight * field.G_re;
    sum->G_im += weight * field.G_im;
    sum->H_re += weight * field.H_re;
    sum->H_im += weight * field.H_im;
}

/* The points at which a patch of half-width s is not remote beyond all bounds: which, and how
 * many. */
static int points_in_reach(double s, size_t n, const double x[], const double y[],
                           size_t which[RW_BLOCK], double near_x[RW_BLOCK], double near_y[RW_BLOCK])
{
    int count = 0;
    for (size_t i = 0; i < n; i++) {
        if (!rw_patch_matters(s, fmax(fabs(x[i]), y[i])))
            continue;
        near_x[count] = x[i];
        near_y[count] = y[i];
        which[count++] = i;
    }
    return count;
}

void rw_contact_fields_at(const rwedge_contact *contact, size_t n, const double x[],
                          const double y[], rw_contact_fields *fields)
{
    const rw_memory *memory = &contact->memory;
    for (size_t i = 0; i < n; i++)
        fields->normal[i] = fields->tangential[i] = (rw_field){0, 0, 0, 0};
    for (size_t j = 1; j < memory->count; j++) {
        const double s = memory->corners[j].half_width, weight = rw_patch_weight(memory, j);
        const bool whole = j + 1 == memory->count;
        if (!rw_patch_matters(s, contact->geometry.a) || (weight == 0 && !whole))
            continue;
        size_t which[RW_BLOCK];
        double near_x[RW_BLOCK], near_y[RW_BLOCK];
        const int count = points_in_reach(s, n, x, y, which, near_x, near_y);
        rw_potential patch;
        rw_fields of_patch;
        rw_potential_init_patch(&patch, contact->geometry.a, s);
        rw_potential_fields(&patch, count, near_x, near_y, &of_patch);
        for (int k = 0; k < count; k++) {
            const rw_field field = rw_field_in(&of_patch, k);
            add(&fields->tangential[which[k]], weight, field);
            if (whole)
                fields->normal[which[k]] = field;
        }
    }
}

/* Points in blocks, so that a patch is prepared once for many points, and an output may be an
 * input. */
int32_t rwedge_contact_stresses(const rwedge_contact *contact, size_t n, const double x[],
                                const double y[], double sxx[], double syy[], double txy[])
{
    if (!contact || (n > 0 && (!x || !y || !sxx || !syy || !txy)))
        return RWEDGE_ENULL;
    for (size_t i = 0; i < n; i++)
        if (!isfinite(x[i]) || !rw_is_nonnegative(y[i]) || is_apex(contact, x[i], y[i]))
            return RWEDGE_EDOMAIN;
    const double unit = contact->geometry.theta / contact->geometry.A;
    for (size_t start = 0; start < n; start += RW_BLOCK) {
        const size_t block = n - start < RW_BLOCK ? n - start : RW_BLOCK;
        rw_contact_fields fields;
        rw_contact_fields_at(contact, block, x + start, y + start, &fields);
        for (size_t i = 0; i < block; i++) {
            const rw_field shear = rw_field_multiple(contact->f, fields.tangential[i]);
            const rw_stress_state s = rw_superpose(fields.normal[i], shear);
            sxx[start + i] = unit * (s.mean - s.difference);
            syy[start + i] = unit * (s.mean + s.difference);
            txy[start + i] = unit * s.shear;
        }
    }
    return RWEDGE_OK;
}
