/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A contact with a load history: its life, its loads and what a load gives. */
#include "contact.h"

#include "batch.h"
#include "dissipation.h"
#include "pressure.h"
#include "stress.h"

#include <float.h>
#include <stdlib.h>

/* How far Q may exceed f P: Q, f and P are each rounded, and so is their product; where a caller
 * interpolates between two loads, they are rounded like the larger. */
static const double SLIDING_ROUNDING = 8 * DBL_EPSILON;

/* Of the load in one step: beyond, the rounding of the last load would be seen in what Q/(fP)
 * is, 2e-7 of it here. */
static const double STEEPEST_FALL = 1e-8;

/* Loads that an arithmetic of squares and ratios can hold, a width that a search of the
 * half-plane can multiply, and a stress of which tensors can be summed. */
static const double SMALLEST_LOAD = 1e-148, LARGEST_LOAD = 1e148, LARGEST_WIDTH = 1e300,
                    LARGEST_STRESS = 1e300;

/* Peak pressure of the sharp wedge in theta/A, as near to its apex as is_apex() allows: (2/pi)
 * arcosh(1/DBL_MIN). */
static const double SHARP_PEAK = 452;

static bool quotient_is_normal(double v, double divisor)
{
    return rw_scaled_is_normal(rw_scaled_over(rw_scaled_from(v), rw_scaled_from(divisor)));
}

/* ---- Life ---- */

int32_t rwedge_contact_create(double theta, double a, double A, double f, rwedge_contact **contact)
{
    const rw_geometry geometry = {theta, a, A};
    if (!rw_is_geometry(&geometry) || !rw_is_friction(f) || !quotient_is_normal(theta, A))
        return RWEDGE_EDOMAIN;
    if (!contact)
        return RWEDGE_ENULL;
    rwedge_contact *created = malloc(sizeof *created);
    if (!created)
        return RWEDGE_ENOMEM;
    *created = (rwedge_contact){.geometry = geometry, .f = f};
    if (!rw_path_create(&created->path)) {
        free(created);
        return RWEDGE_ENOMEM;
    }
    *contact = created;
    return RWEDGE_OK;
}

int32_t rwedge_contact_copy(const rwedge_contact *contact, rwedge_contact **copy)
{
    if (!contact || !copy)
        return RWEDGE_ENULL;
    rwedge_contact *copied = malloc(sizeof *copied);
    if (!copied)
        return RWEDGE_ENOMEM;
    *copied = *contact;
    copied->path = (rw_path){0};
    copied->entries = (rw_entries){0};
    if (!rw_path_copy(&contact->path, &copied->path) ||
        !rw_entries_copy(&contact->entries, &copied->entries)) {
        rwedge_contact_destroy(copied);
        return RWEDGE_ENOMEM;
    }
    *copy = copied;
    return RWEDGE_OK;
}

void rwedge_contact_destroy(rwedge_contact *contact)
{
    if (!contact)
        return;
    rw_path_destroy(&contact->path);
    rw_entries_destroy(&contact->entries);
    free(contact);
}

/* ---- Loads ---- */

/* Q/f, at friction's limit exactly. */
static int32_t shear_of(const rwedge_contact *contact, double P, double Q, double *shear)
{
    const double limit = contact->f * P, magnitude = fabs(Q);
    const double last = rw_path_end(&contact->path)->load;
    const double rounding = P > 0 ? SLIDING_ROUNDING * contact->f * fmax(P, last) : 0;
    if (magnitude > limit + rounding)
        return RWEDGE_ESLIDING;
    if (magnitude >= limit - rounding)
        *shear = Q > 0 ? P : Q < 0 ? -P : 0;
    else
        *shear = Q / limit * P;
    return RWEDGE_OK;
}

/* Whether the peak pressure is a normal number, and friction's traction under it not too large. */
static bool is_pressure_in_range(const rwedge_contact *contact, double b)
{
    const rw_geometry *g = &contact->geometry;
    const double peak = g->a > 0 ? rwedge_peak_pressure(g->a / b) : SHARP_PEAK;
    const rw_scaled pressure = rw_scaled_times(rw_unit_stress(g), rw_scaled_from(peak));
    const double traction =
        rw_scaled_value(rw_scaled_times(pressure, rw_scaled_from(fmax(1, contact->f))));
    /* it may be NaN */
    return rw_scaled_is_normal(pressure) && islessequal(traction, LARGEST_STRESS);
}

/* Whether lengths and stresses under the load stay far from the ends of the range of a double;
 * next to an a/b that underflows to 0 the apex of the sharp wedge would appear. */
static bool is_in_range(const rwedge_contact *contact, double P)
{
    const rw_geometry *g = &contact->geometry;
    const double b = rw_half_width(g, P);
    return P >= SMALLEST_LOAD && P <= LARGEST_LOAD && isnormal(b) && b <= LARGEST_WIDTH &&
           rw_patch_matters(b, g->a) && (g->a == 0 || quotient_is_normal(g->a, b)) &&
           is_pressure_in_range(contact, b);
}

/* The load (pi/2) a theta/A under which the rounding is just filled, over 2^doublings. */
static double corner_load_of(const rw_geometry *g, int doublings)
{
    if (g->a == 0)
        return 0;
    const rw_scaled width = rw_scaled_times(rw_scaled_from(RW_HALF_PI), rw_scaled_from(g->a));
    rw_scaled load = rw_scaled_times(width, rw_unit_stress(g));
    load.exponent -= doublings;
    /* where all is Hertz, whatever it is */
    return load.exponent > 1000 ? 1e300 : rw_scaled_value(load);
}

/* NaN where it is too large for a double. */
static double energy_of(const rwedge_contact *contact, double P, double shear)
{
    const double largest = fmax(P, rw_path_end(&contact->path)->load);
    if (contact->f == 0 || largest == 0)
        return 0;
    const int doublings = ilogb(largest);
    const double in_units = rw_dissipation(&contact->path, P, shear, rw_power_of_two(doublings),
                                           corner_load_of(&contact->geometry, doublings));
    if (!(in_units > 0))
        return 0;
    const rw_scaled f = rw_scaled_from(contact->f),
                    f_over_pi = rw_scaled_over(f, rw_scaled_from(RW_PI));
    const rw_scaled factor = rw_scaled_times(f, rw_scaled_from(contact->geometry.A));
    rw_scaled energy =
        rw_scaled_times(factor, rw_scaled_times(f_over_pi, rw_scaled_from(in_units)));
    energy.exponent += 2 * doublings;
    return rw_scaled_value(energy);
}

static void measure_new_corners(rwedge_contact *contact)
{
    rw_path *path = &contact->path;
    for (size_t i = path->count; i-- > 1 && isnan(path->corners[i].half_width);)
        path->corners[i].half_width = rw_half_width(&contact->geometry, path->corners[i].load);
}

int32_t rwedge_contact_load(rwedge_contact *contact, double P, double Q)
{
    if (!contact)
        return RWEDGE_ENULL;
    if (!rw_is_nonnegative(P) || !isfinite(Q))
        return RWEDGE_EDOMAIN;
    if (P > 0 &&
        (!is_in_range(contact, P) || P < STEEPEST_FALL * rw_path_end(&contact->path)->load))
        return RWEDGE_ERANGE;
    double shear;
    const int32_t status = shear_of(contact, P, Q, &shear);
    if (status != RWEDGE_OK)
        return status;
    const double share = energy_of(contact, P, shear) + contact->energy_carry;
    if (!isfinite(share) || contact->energy / 2 + share / 2 > DBL_MAX / 2)
        return RWEDGE_ERANGE;
    /* the carry may be negative */
    const double energy = fmax(contact->energy, contact->energy + share);
    if (!rw_path_reserve(&contact->path, 2) ||
        !rw_entries_advance(&contact->entries, &contact->path, P, shear))
        return RWEDGE_ENOMEM;
    rw_path_advance(&contact->path, P, shear);
    measure_new_corners(contact);
    contact->energy_carry = share - (energy - contact->energy);
    contact->energy = energy;
    return RWEDGE_OK;
}

/* ---- Results ---- */

double rwedge_contact_half_width(const rwedge_contact *contact)
{
    return contact ? rw_path_end(&contact->path)->half_width : NAN;
}

double rwedge_contact_stick_half_width(const rwedge_contact *contact)
{
    if (!contact)
        return NAN;
    const rw_corner *end = rw_path_end(&contact->path);
    return fabs(end->ratio) == 1 ? (end - 1)->half_width : end->half_width;
}

size_t rwedge_contact_memory(const rwedge_contact *contact)
{
    return contact ? contact->path.count - 1 : 0;
}

double rwedge_contact_dissipated_energy(const rwedge_contact *contact)
{
    return contact ? contact->energy : NAN;
}

/* Or so near to it that it is not to be told from it in units of the half-width. */
static bool is_apex(const rwedge_contact *contact, double x, double y)
{
    return contact->geometry.a == 0 && contact->path.count > 1 &&
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
    const rw_path *path = &contact->path;
    for (size_t i = 0; i < n; i++) {
        const double at = x[i];
        double shear = 0, pressure = 0;
        for (size_t j = 1; j < path->count; j++) {
            pressure = g->theta / g->A * patch_pressure(&path->corners[j], g->a, at);
            shear += rw_patch_weight(path, j) * pressure;
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
    const rw_path *path = &contact->path;
    for (size_t i = 0; i < n; i++)
        fields->normal[i] = fields->tangential[i] = (rw_field){0, 0, 0, 0};
    for (size_t j = 1; j < path->count; j++) {
        const double s = path->corners[j].half_width, weight = rw_patch_weight(path, j);
        const bool whole = j + 1 == path->count;
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
