/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The results under a moment or a bulk tension, or after a history, from a contact in that
 * state. */
#ifndef CLI_PRESENT_STATE_H
#define CLI_PRESENT_STATE_H

#include "results.h"

/* Corrects the results that were computed without moment and tension; those that do not hold become
 * empty. Returns the library's status, and rwedge_contact_error() in *error. */
int32_t results_of_state(const contact_case *setup, cell row[], double *error);

#endif
