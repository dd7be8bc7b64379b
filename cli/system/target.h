/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The file that a result replaces, and the unfinished file beside it. */
#ifndef CLI_TARGET_H
#define CLI_TARGET_H

#include <stdbool.h>

/* Where path leads when symbolic links at its end are followed, also to a file that is not there
 * yet: the link stays, what it points to is replaced. Free it. NULL with errno. */
char *target_of_links(const char *path);

/* Whether an input and an output are one file, by whatever names; "-" is a standard stream. */
bool target_is_input(const char *output, const char *input);

/* Opens a new file in the folder of target, with the permissions that opening target would give, or
 * that target has; its name is in *unfinished. Returns the descriptor; -1 with errno, and nothing
 * left behind. */
int target_open_beside(const char *target, char **unfinished);

/* Writes what the file holds to the disk. 0, or errno. */
int target_sync(int descriptor);

/* Removes the unfinished file. */
void target_remove(const char *unfinished);

/* The unfinished file, closed, takes the place of the target, also on the disk. 0, or errno; it is
 * removed where it cannot. */
int target_replace(const char *target, const char *unfinished);

#endif
