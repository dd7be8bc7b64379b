/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The tractions and stresses of a contact: sums over the patches of its memory. */
#include "formulas/pressure.h"
#include "contact/contact.h"
#include "traction/transform.h"
#include "stress/stress.h"

bool rw_has_stress(const rw_geometry *geometry, double b, double x, double y)
{
    if (!rw_is_signed(x) || !rw_is_magnitude(y))
        return false;
    if (b == 0)
        return true;
    return rw_is_signed(x / b) && rw_is_magnitude(y / b) && !(y == 0 && rw_is_kink(geometry, x));
}

bool rw_contact_has_stress(const rwedge_contact *contact, double x, double y)
{
    return rw_has_stress(&contact->geometry, rwedge_contact_half_width(contact), x, y);
}

/* The shear that is no sum of patches but computed. */
static const rw_traction *shear_of(const rwedge_contact *contact)
{
    return &contact->computed.now->now.shear.traction;
}

/* f times the pressure where it is no patch's; else NULL. */
static const rw_traction *pressed_of(const rwedge_contact *contact)
{
    return contact->unlike && contact->phase == RW_COMPUTED ? &contact->computed.now->now.pressed
                                                            : NULL;
}

/* ---- Tractions ---- */

double rw_pressure_of(const rw_geometry *g, rw_patch patch, double x)
{
    if (!g->pad && rw_patch_middle(patch) == 0)
        return rw_patch_pressure(g->a, patch.right, x);
    const rw_arcs arcs = rw_arcs_of(g);
    double pressure;
    rw_pad_pressures(&arcs, patch, 1, &x, &pressure);
    return 0 - pressure;
}

double rw_contact_pressure(const rwedge_contact *c, double x)
{
    const rw_patch patch = rw_memory_end(&c->memory)->patch;
    const rw_traction *pressed = pressed_of(c);
    if (pressed)
        return 0 - fmax(0, rw_traction_at(pressed, x)) / c->f;
    if (!c->unlike)
        return rw_pressure_of(&c->geometry, patch, x);
    const rw_arcs arcs = rw_arcs_of(&c->geometry);
    return rw_sliding_pressure(&arcs, rw_contact_way(c), patch, x);
}

/* Many places of unlike bodies are computed at once. */
static void sliding_tractions(const rwedge_contact *c, size_t n, const double x[], double p[],
                              double q[])
{
    static const double surface[RW_BATCH] = {0};
    const rw_arcs arcs = rw_arcs_of(&c->geometry);
    const rw_corner *end = rw_memory_end(&c->memory);
    for (size_t start = 0; start < n; start += RW_BATCH) {
        const size_t block = n - start < RW_BATCH ? n - start : RW_BATCH;
        double pressure[RW_BATCH];
        rw_fields fields;
        rw_sliding_fields(&arcs, rw_contact_way(c), end->patch, (int)block, x + start, surface,
                          &fields);
        for (size_t i = 0; i < block; i++) {
            const double at = x[start + i];
            const bool is_inside = at > end->patch.left && at < end->patch.right;
            pressure[i] = is_inside ? rw_unit_stress(&c->geometry) * fields.G_im[i] : 0;
        }
        for (size_t i = 0; i < block; i++) {
            p[start + i] = pressure[i];
            q[start + i] = c->f * end->ratio * pressure[i];
        }
    }
}

int32_t rwedge_contact_tractions(const rwedge_contact *contact, size_t n, const double x[],
                                 double p[], double q[])
{
    if (!contact || (n > 0 && (!x || !p || !q)))
        return RWEDGE_ENULL;
    for (size_t i = 0; i < n; i++)
        if (!rw_contact_has_stress(contact, x[i], 0))
            return RWEDGE_EDOMAIN;
    const rw_geometry *g = &contact->geometry;
    const rw_memory *memory = &contact->memory;
    if (contact->unlike && contact->phase == RW_SLIDING) {
        sliding_tractions(contact, n, x, p, q);
        return RWEDGE_OK;
    }
    for (size_t i = 0; i < n; i++) {
        const double at = x[i];
        double shear = 0, pressure = 0;
        for (size_t j = 1; j < memory->count; j++) {
            pressure = rw_unit_stress(g) * rw_pressure_of(g, memory->corners[j].patch, at);
            shear += rw_patch_weight(memory, j) * pressure;
        }
        if (contact->unlike)
            pressure = rw_unit_stress(g) * rw_contact_pressure(contact, at);
        p[i] = pressure; /* the last patch is the contact */
        q[i] = contact->phase == RW_COMPUTED
                   ? -rw_unit_stress(g) * rw_traction_at(shear_of(contact), at)
                   : contact->f * shear;
    }
    return RWEDGE_OK;
}

/* ---- Stresses ---- */

void rw_add_traction(const rw_traction *traction, double f, int n, const double x[],
                     const double y[], rw_fields *sum)
{
    rw_fields own;
    rw_traction_fields(traction, n, x, y, &own);
    rw_add_fields(&own, -1 / f, n, sum);
}

static void add_corner(const rwedge_contact *contact, size_t corner, int n, const double x[],
                       const double y[], rw_fields *of_patch, rw_fields *sum)
{
    const rw_memory *memory = &contact->memory;
    const rw_arcs arcs = rw_arcs_of(&contact->geometry);
    rw_sliding_fields(&arcs, rw_contact_way(contact), memory->corners[corner].patch, n, x, y,
                      of_patch);
    rw_add_fields(of_patch, rw_patch_weight(memory, corner), n, sum);
}

void rw_contact_fields_at(const rwedge_contact *contact, size_t first, size_t last, int n,
                          const double x[], const double y[], rw_contact_fields *fields)
{
    const size_t end = contact->memory.count - 1; /* its patch is the contact */
    rw_clear_fields(n, &fields->tangential);
    if (end == 0)
        rw_clear_fields(n, &fields->normal);
    for (size_t j = first; j < last && j < end; j++) {
        rw_fields of_patch;
        if (rw_patch_weight(&contact->memory, j) != 0)
            add_corner(contact, j, n, x, y, &of_patch, &fields->tangential);
    }
    if (end > 0)
        add_corner(contact, end, n, x, y, &fields->normal, &fields->tangential);
    if (contact->phase == RW_COMPUTED)
        rw_add_traction(shear_of(contact), contact->f, n, x, y, &fields->tangential);
    if (pressed_of(contact)) {
        rw_clear_fields(n, &fields->normal);
        rw_add_traction(pressed_of(contact), contact->f, n, x, y, &fields->normal);
    }
}

void rw_contact_stresses_from(const rwedge_contact *contact, double sigma, const rw_fields *normal,
                              const rw_fields *tangential, int n, double sxx[], double syy[],
                              double txy[])
{
    const double unit = rw_unit_stress(&contact->geometry);
    for (int i = 0; i < n; i++) {
        const rw_field shear = rw_field_multiple(contact->f, rw_field_in(tangential, i));
        const rw_stress_state s = rw_superpose(rw_field_in(normal, i), shear);
        sxx[i] = unit * (s.mean - s.difference) + sigma;
        syy[i] = unit * (s.mean + s.difference);
        txy[i] = unit * s.shear;
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
        if (!rw_contact_has_stress(contact, x[i], y[i]))
            return RWEDGE_EDOMAIN;
    for (size_t start = 0; start < n; start += RW_BATCH) {
        const int block = n - start < RW_BATCH ? (int)(n - start) : RW_BATCH;
        rw_contact_fields fields;
        rw_contact_fields_at(contact, 1, contact->memory.count, block, x + start, y + start,
                             &fields);
        rw_contact_stresses_from(contact, contact->loads.sigma, &fields.normal, &fields.tangential,
                                 block, sxx + start, syy + start, txy + start);
    }
    return RWEDGE_OK;
}
