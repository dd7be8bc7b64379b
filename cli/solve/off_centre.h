/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What is answered under a moment or a bulk tension: from a contact that carries them. */
#ifndef CLI_OFF_CENTRE_H
#define CLI_OFF_CENTRE_H

#include "results.h"

/* Goes over the results of the geometry without moment; those that hold no longer become empty.
 * Returns the library's status. */
int32_t off_centre_results(const contact_case *what, cell row[]);

#endif
