/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A file of a material's constants, by name. */
#ifndef CLI_MATERIAL_H
#define CLI_MATERIAL_H

#include "options/arguments.h"

#include <stdbool.h>

/* Constants without an option of their own. */
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
    MATERIAL_COUNT
};

typedef struct {
    double value[MATERIAL_COUNT]; /* NAN where not given */
} material;

/* Reads a file, JSON by its ending or CSV; nothing where the path is NULL. Its other constants
 * stand for options that are not given. What is wrong ends the command. */
void material_read(const char *path, arguments *line, material *all);

/* What a criterion must not exceed; NAN where it is not known. */
double material_allowable(const material *all, int criterion);

/* Whether the curve of life of a criterion is known. */
bool material_has_life(const material *all, int criterion);

/* (dK_th/ds0)^2/pi; NAN where they are not known. */
double material_length(const material *all);

#endif
