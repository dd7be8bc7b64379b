/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Criteria of fatigue over all planes: which are asked for, their constants, and their columns. */
#ifndef CLI_CRITERIA_H
#define CLI_CRITERIA_H

#include "material.h"

#include "model/contact_case.h"
#include "model/results/measures.h"

enum {
    CRITERION_SWT,
    CRITERION_FATEMI_SOCIE,
    CRITERION_FINDLEY,
    CRITERION_MODIFIED_WOHLER,
    CRITERION_MCDIARMID,
    CRITERION_CROSSLAND,
    CRITERION_DANG_VAN,
    CRITERION_SWT_DAMAGE,
    CRITERION_FS_DAMAGE,
    CRITERION_COUNT
};

/* Columns that follow those of the measures where they are asked for. */
enum {
    COLUMN_SWT_OUT = MEASURE_COUNT,
    COLUMN_FS_OUT,
    COLUMN_FINDLEY,
    COLUMN_FINDLEY_ANGLE,
    COLUMN_FINDLEY_OUT,
    COLUMN_MODIFIED_WOHLER,
    COLUMN_MODIFIED_WOHLER_ANGLE,
    COLUMN_MODIFIED_WOHLER_OUT,
    COLUMN_MCDIARMID,
    COLUMN_MCDIARMID_ANGLE,
    COLUMN_MCDIARMID_OUT,
    COLUMN_CROSSLAND,
    COLUMN_DANG_VAN,
    COLUMN_SWT_DAMAGE,
    COLUMN_SWT_DAMAGE_ANGLE,
    COLUMN_SWT_DAMAGE_OUT,
    COLUMN_SWT_CYCLES,
    COLUMN_FS_DAMAGE,
    COLUMN_FS_DAMAGE_ANGLE,
    COLUMN_FS_DAMAGE_OUT,
    COLUMN_FS_CYCLES,
    COLUMN_WEAR,
    COLUMN_COUNT
};

typedef struct {
    const char *name;
    int32_t measure;                /* as the library calls it; -1 for damage */
    int value, angle, out_of_plane; /* its columns; 0: it has no plane */
    int cycles;                     /* of damage: the column of their number; else 0 */
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

const measure_kind *column_kind_of(int column);

/* The criterion that a column has the value of; -1 for other columns. */
int column_criterion(int column);

/* Whether a column is written. */
bool column_is_wanted(const criteria *all, int column);

/* Smith, Watson and Topper's alone, in plane strain. */
criteria criteria_usual(const contact_case *setup);

/* Fatemi and Socie's constant, of their k; NAN without a yield stress. */
double criteria_fatemi_socie(const contact_case *setup, double k);

#endif
