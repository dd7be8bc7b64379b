/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What makes the results of a contact doubtful, though they can be computed. */
#ifndef CLI_WARNINGS_H
#define CLI_WARNINGS_H

#include "contact/contact_case.h"

/* Writes the warnings, "; " between them; empty where there is none. safety is P_yield/P where k
 * is given. */
void warnings_write(const contact_case *what, double safety, char *text, size_t size);

#endif
