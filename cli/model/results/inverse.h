/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The input with which a contact has a safety. */
#ifndef CLI_INVERSE_H
#define CLI_INVERSE_H

#include "model/contact_case.h"

/* The input of a name, "radius"; INPUT_COUNT where it is none that can be looked for. */
int inverse_input(const char *name);

/* The names that inverse_input() accepts, for a message. */
extern const char inverse_names[];

/* Finds the radius, a, P or f with which P_yield/P, in full sliding, is `safety`, and reads the
 * case with it. The texts give the other inputs; their text of this input and of its alternative is
 * ignored. False, with the complaint, where there is no such value. */
bool inverse_find(const input_texts *texts, int input, double safety, contact_case *setup,
                  double *value, char complaint[COMPLAINT_SIZE]);

#endif
