/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Criteria of fatigue over all planes: which are asked for, and their constants. */
#ifndef CLI_CRITERIA_H
#define CLI_CRITERIA_H

#include "material.h"

#include "history/places.h"
#include "model/measures.h"

enum {
    OPTION_FS_K = OPTION_AFTER_PLACES,
    OPTION_FINDLEY_K,
    OPTION_KAPPA,
    OPTION_T_A,
    OPTION_SU,
    OPTION_CROSSLAND_ALPHA,
    OPTION_DANG_VAN_ALPHA,
    OPTION_CRITERIA,
    OPTION_PLANE_STRESS,
    OPTION_ARCHARD,
    OPTION_MATERIAL,
    OPTION_AFTER_CRITERIA
};

/* How a criterion is asked for, and what it is compared with. */
typedef struct {
    const char *name; /* in --criteria */
    int limit;        /* what it must not exceed, of the material; MATERIAL_COUNT: 1 */
    int option;       /* of its constant, and the name of that; 0 for none */
    const char *option_name;
    double least; /* of the constant */
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

/* For a command's own table, by POPT_ARG_INCLUDE_TABLE. */
extern struct poptOption criteria_option_table[];

/* Whether a column is written. */
bool column_is_wanted(const criteria *all, int column);

/* Smith, Watson and Topper's alone, in plane strain. */
criteria criteria_usual(const contact_case *setup);

/* Reads the options. In plane stress the contact is one of Poisson's ratio 0, and so are the inputs
 * from then on. */
void criteria_read(arguments *line, const material *constants, criteria *all);

/* When the contact is read: Fatemi and Socie's constant; then those of damage. */
void criteria_read_strength(const arguments *line, const contact_case *setup, criteria *all);

#endif
