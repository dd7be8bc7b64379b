/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Options of criteria of fatigue: which are asked for, and their constants. */
#ifndef CLI_CRITERIA_OPTIONS_H
#define CLI_CRITERIA_OPTIONS_H

#include "history/places.h"
#include "model/cycle/criteria.h"

/* OPTION_OF() a constant: those of a material that an option has too are in the same order. */
enum {
    OPTION_CONSTANTS = OPTION_AFTER_PLACES,
    OPTION_CRITERIA = OPTION_CONSTANTS + MATERIAL_COUNT - MATERIAL_FS_K,
    OPTION_PLANE_STRESS,
    OPTION_ARCHARD,
    OPTION_MATERIAL,
    OPTION_AFTER_CRITERIA
};
#define OPTION_OF(constant) (OPTION_CONSTANTS + (constant)-MATERIAL_FS_K)

/* For a command's own table, by POPT_ARG_INCLUDE_TABLE. */
extern struct poptOption criteria_option_table[];

/* Reads the options. In plane stress the contact is one of Poisson's ratio 0, and so are the inputs
 * from then on. */
void criteria_read(arguments *line, const material *constants, criteria *all);

/* When the contact is read: Fatemi and Socie's constant; then those of damage. */
void criteria_read_strength(const arguments *line, const contact_case *setup, criteria *all);

#endif
