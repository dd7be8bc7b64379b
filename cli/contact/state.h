/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A loaded contact to look into, dimensional or in natural units: what "profile" and "field"
 * have in common. */
#ifndef CLI_STATE_H
#define CLI_STATE_H

#include "load_table.h"

#include "pad/pad.h"

enum {
    OPTION_A_OVER_B = OPTION_AFTER_LOADS,
    OPTION_Q_OVER_FP,
    OPTION_C_OVER_B,
    OPTION_AFTER_STATE
};

/* For a command's own table, by POPT_ARG_INCLUDE_TABLE: the contact, its strength, its loads. */
extern struct poptOption state_option_table[];

typedef struct {
    rwedge_contact *contact;
    pad shape;
    double nu;
    /* half-width and edges of the contact, as they are written: 1, -1 and 1 in natural units; 0
     * when separated */
    double b, left, right;
    double length_unit; /* of what is written, in the contact's own unit; so is the next */
    double slip_unit;
} contact_state;

/* Reads the options and applies the loads; decimal_sign is that of a file of loads. Free
 * it. */
void state_read(const arguments *line, char decimal_sign, contact_state *state);
void state_free(contact_state *state);

/* The edges of the contact, or of its stick zone, in the contact's own unit; both are 0 where there
 * is none. */
typedef struct {
    double left, right;
} zone;
zone state_contact_zone(const contact_state *state);
zone state_stick_zone(const contact_state *state);

/* Whether the stresses at this point are infinite: at a sharp edge. */
bool state_is_kink(const contact_state *state, double x, double y);

/* Prints what the help of both commands says about them. */
void state_describe(FILE *stream);

#endif
