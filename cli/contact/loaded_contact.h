/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A loaded contact to look into, dimensional or in natural units: what "profile" and "field"
 * have in common. */
#ifndef CLI_LOADED_CONTACT_H
#define CLI_LOADED_CONTACT_H

#include "load_history.h"

#include "pad/pad.h"

enum {
    OPTION_A_OVER_B = OPTION_AFTER_LOADS,
    OPTION_Q_OVER_FP,
    OPTION_C_OVER_B,
    OPTION_AFTER_LOADED
};

/* For a command's own table, by POPT_ARG_INCLUDE_TABLE: the contact, its strength, its loads. */
extern struct poptOption loaded_contact_option_table[];

typedef struct {
    rwedge_contact *contact;
    pad shape;
    double nu;
    /* half-width and edges of the contact, as they are written: 1, -1 and 1 in natural units; 0
     * when separated */
    double b, left, right;
    double length_unit; /* of what is written, in the contact's own unit; so is the next */
    double slip_unit;
} loaded_contact;

/* Reads the options and applies the loads; decimal_sign is that of a file of loads. */
void loaded_contact_read(const arguments *line, char decimal_sign, loaded_contact *loaded);

/* The edges of the contact, or of its stick zone, in the contact's own unit; both are 0 where there
 * is none. */
typedef struct {
    double left, right;
} zone;
zone loaded_contact_zone(const loaded_contact *loaded);
zone loaded_contact_stick_zone(const loaded_contact *loaded);

/* Whether the stresses at this point are infinite: at a sharp edge. */
bool loaded_contact_is_kink(const loaded_contact *loaded, double x, double y);

/* Prints what the help of both commands says about them. */
void loaded_contact_describe(FILE *stream);

#endif
