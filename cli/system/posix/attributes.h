/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What a file has beside its content: owner, permissions, access list, extended attributes. */
#ifndef CLI_ATTRIBUTES_H
#define CLI_ATTRIBUTES_H

#include <sys/stat.h>

/* Gives an open file, which is ours, what the old one has, whose state this is. Nobody gets more
 * access than before: where the group cannot be kept, it gets none. 0, or errno. */
int attributes_keep(int descriptor, const char *old, const struct stat *existing);

/* What a replacement cannot keep; "" where it keeps all. The text ends a message. */
const char *attributes_lost(int descriptor, const struct stat *existing);

#endif
