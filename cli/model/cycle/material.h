/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A material's constants, by name. */
#ifndef CLI_MATERIAL_H
#define CLI_MATERIAL_H

#include <stdbool.h>

enum {
    MATERIAL_SWT_LIMIT,
    MATERIAL_FS_LIMIT,
    MATERIAL_FINDLEY_LIMIT,
    MATERIAL_LAMBDA,
    MATERIAL_CROSSLAND_LIMIT,
    MATERIAL_DANG_VAN_LIMIT,
    MATERIAL_SF,
    MATERIAL_B,
    MATERIAL_EF,
    MATERIAL_C,
    MATERIAL_G,
    MATERIAL_TF,
    MATERIAL_B0,
    MATERIAL_GF,
    MATERIAL_C0,
    MATERIAL_DK_TH,
    MATERIAL_DS0,
    /* From here on an input or an option has the same. */
    MATERIAL_E,
    MATERIAL_NU,
    MATERIAL_YIELD_STRESS,
    MATERIAL_FS_K,
    MATERIAL_FINDLEY_K,
    MATERIAL_KAPPA,
    MATERIAL_T_A,
    MATERIAL_SU,
    MATERIAL_CROSSLAND_ALPHA,
    MATERIAL_DANG_VAN_ALPHA,
    MATERIAL_COUNT
};
extern const char *const material_names[MATERIAL_COUNT];

typedef struct {
    double value[MATERIAL_COUNT]; /* NAN where not given */
} material;

/* Without any constant. */
material material_unknown(void);

/* The constant of a name; -1 where none is known. */
int material_constant(const char *name);

/* Whether a name is a remark on the constants, such as their source. */
bool material_is_remark(const char *name);

/* The allowable value of a criterion; NAN where it is not known. */
double material_allowable(const material *all, int criterion);

/* Whether the curve of life of a criterion is known. */
bool material_has_life(const material *all, int criterion);

/* (dK_th/ds0)^2/pi; NAN where they are not known. */
double material_length(const material *all);

#endif
