/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What is answered under a moment or a bulk tension, or after a history: from a contact in that
 * state. */
#ifndef CLI_PRESENT_STATE_H
#define CLI_PRESENT_STATE_H

#include "results.h"

/* Goes over the results of the geometry without moment; those that hold no longer become empty.
 * Returns the library's status, and rwedge_contact_error(). */
int32_t results_of_state(const contact_case *setup, cell row[], double *error);

#endif
