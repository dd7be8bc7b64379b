/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What other rooms ask a contact, beside the functions of rwedge.h. */
#ifndef RW_CONTACT_H
#define RW_CONTACT_H

#include "contact/handle.h"
#include "history/path.h"
#include "potential/pad_potential.h"

/* The loads of a history, or of a cycle. */
typedef struct {
    size_t count;
    const double *P, *M, *Q, *sigma;
} rw_load_history;

static inline bool rw_is_load_history(const rw_load_history *loads)
{
    return loads->count == 0 || (loads->P && loads->M && loads->Q && loads->sigma);
}

static inline rw_loads rw_loads_at(const rw_load_history *loads, size_t i)
{
    return (rw_loads){loads->P[i], loads->M[i], loads->Q[i], loads->sigma[i]};
}

/* The loads at a part of the way from one to the other, 0 to 1. */
static inline rw_loads rw_loads_between(rw_loads from, rw_loads to, double part)
{
    return part == 1 ? to
                     : (rw_loads){from.P + part * (to.P - from.P), from.M + part * (to.M - from.M),
                                  from.Q + part * (to.Q - from.Q),
                                  from.sigma + part * (to.sigma - from.sigma)};
}

/* The traction of a history is a sum of patches, one for each corner of its path: the pressure
 * of the contact under the corner's load, times f and the step that D makes there. The last
 * patch is the contact itself. */
static inline double rw_patch_weight(const rw_memory *memory, size_t corner)
{
    const double beyond = corner + 1 < memory->count ? memory->corners[corner + 1].ratio : 0;
    return memory->corners[corner].ratio - beyond;
}

/* The pressure at a place of a contact, not the apex of the sharp wedge, in theta/A. */
double rw_pressure_of(const rw_geometry *geometry, rw_patch patch, double x);

/* The pressure of the contact itself. */
double rw_contact_pressure(const rwedge_contact *contact, double x);

/* The zones of a contact, none where the bodies are apart. */
rw_zones rw_contact_zones(const rwedge_contact *contact);

/* The fields of the pressure and of the shear traction over f at n <= RW_BATCH points; not the
 * apex of the sharp wedge. Of the patches inside the contact, those from first to last - 1. */
typedef struct {
    rw_fields normal, tangential;
} rw_contact_fields;

void rw_contact_fields_at(const rwedge_contact *contact, size_t first, size_t last, int n,
                          const double x[], const double y[], rw_contact_fields *fields);

/* A patch's own fields at n <= RW_BATCH points. */
static inline void rw_patch_fields(const rw_geometry *geometry, rw_patch patch, int n,
                                   const double x[], const double y[], rw_fields *fields)
{
    const rw_arcs arcs = rw_arcs_of(geometry);
    rw_pad_fields(&arcs, patch, n, x, y, fields);
}

/* Adds the fields of a computed shear traction t = -q, over f. */
void rw_add_traction(const rw_traction *traction, double f, int n, const double x[],
                     const double y[], rw_fields *sum);

/* The slip of a place when the contact last slid off its centre under a rig; 0 if it never did. */
double rw_slip_of_slide(const rwedge_contact *contact, double x);

/* How much further than a bonded contact over |x| < b the tractions and the tension move the
 * half-plane's surface at a place in contact, against remote points and the wedge. */
double rw_contact_moved(const rwedge_contact *contact, double b, double x);

/* Whether the point is in the domain, in units of the half-width too, and has a finite stress: the
 * apex of a loaded sharp wedge has none. */
bool rw_contact_has_stress(const rwedge_contact *contact, double x, double y);
bool rw_has_stress(const rw_geometry *geometry, double half_width, double x, double y);

/* The stresses of the fields and a bulk tension. */
void rw_contact_stresses_from(const rwedge_contact *contact, double sigma, const rw_fields *normal,
                              const rw_fields *tangential, int n, double sxx[], double syy[],
                              double txy[]);

#endif
