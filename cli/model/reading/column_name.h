/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The name of a column as people write it: with spaces, a unit, and letters that look alike. */
#ifndef CLI_COLUMN_NAME_H
#define CLI_COLUMN_NAME_H

#include <stdbool.h>
#include <stddef.h>

enum { COLUMN_NAME_SIZE = 200 };

/* Copies a name with plain letters, digits and spaces for those that look the same: full-width
 * ones, subscripts, spaces that do not break or have no width. A longer name is cut. Returns the
 * length. */
size_t column_name_make_plain(const char *name, char plain[COLUMN_NAME_SIZE]);

/* How much of a plain name stands before its unit: "Q" of "Q [N/mm]", "Q / N", "Q in N", "Q_N". The
 * whole name where it has none. */
size_t column_name_stem(const char *plain);

/* Whether two names have the same letters and digits, whatever stands between them. The first has
 * `length` bytes. */
bool column_name_is_like(const char *a, size_t length, const char *b);

#endif
