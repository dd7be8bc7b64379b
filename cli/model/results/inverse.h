/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The input with which a contact has a safety. */
#ifndef CLI_INVERSE_H
#define CLI_INVERSE_H

#include "model/contact_case.h"

/* The input of a name, "radius"; INPUT_COUNT where it is none that can be looked for. */
int inverse_input(const char *name);

/* What inverse_input() takes, for a message. */
extern const char inverse_names[];

/* Finds the radius, a, P or f with which P_yield/P, in full sliding, is `safety`. All else is given
 * by the texts; what they say of that input and its alternative does not count. Reads the case with
 * it. False, with the complaint, where there is none. */
bool inverse_find(const input_texts *texts, int input, double safety, contact_case *setup,
                  double *value, char complaint[COMPLAINT_SIZE]);

#endif
