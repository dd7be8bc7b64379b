/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Criteria of fatigue over all planes: which are asked for, and their constants. */
#ifndef CLI_CRITERIA_H
#define CLI_CRITERIA_H

#include "material.h"
#include "measures.h"

#include "model/contact_case.h"

typedef struct {
    const char *name;
    int constant; /* of the material; MATERIAL_COUNT: it needs none of its own */
    int limit;    /* what it must not exceed, of the material; MATERIAL_COUNT: 1 */
} criterion_kind;
extern const criterion_kind criterion_kinds[CRITERION_COUNT];

typedef struct {
    bool is_listed;                  /* by --criteria; otherwise what has its constants is wanted */
    bool is_wanted[CRITERION_COUNT]; /* with columns of its own */
    bool is_plane_stress;
    double nu;                 /* of body 1 */
    double archard;            /* depth worn per energy and area; NAN for none */
    const material *constants; /* NULL for none */
    /* Of the library's criteria; NAN: not known. Fatemi and Socie's is k over the yield stress. Of
     * damage it is that of its criterion. */
    double constant[CRITERION_COUNT], su;
} criteria;

/* Whether a column is written. */
bool column_is_wanted(const criteria *all, int column);

/* The criteria by default: Smith, Watson and Topper's alone, in plane strain. */
criteria criteria_usual(const contact_case *setup);

/* Fatemi and Socie's constant, their k over the yield stress; NAN without a yield stress. */
double criteria_fatemi_socie(const contact_case *setup, double k);

#endif
