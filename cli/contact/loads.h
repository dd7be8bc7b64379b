/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A history of loads (P, Q), in straight steps, from the command line or a CSV file. */
#ifndef CLI_LOADS_H
#define CLI_LOADS_H

#include <rwedge.h>

/* Applies P, then Q under constant P; returns the library's status. */
int32_t loads_apply_monotonic(double P, double Q, rwedge_contact *contact);

/* Applies "P,Q" after "P,Q", one to a line, as --load gave them; returns the exit status. */
int loads_apply_list(const char *lines, double f, rwedge_contact *contact);

/* Applies the rows of a file with the columns P and Q, as --history names it; returns the exit
 * status. */
int loads_apply_file(const char *path, const char *encoding, char decimal_sign, double f,
                     rwedge_contact *contact);

#endif
