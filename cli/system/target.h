/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The file that a result replaces, and the unfinished file beside it. */
#ifndef CLI_TARGET_H
#define CLI_TARGET_H

/* Where path leads when symbolic links at its end are followed, also to a file that is not there
 * yet: the link stays, what it points to is replaced. Free it. NULL with errno. */
char *target_of_links(const char *path);

/* Opens a new file in the folder of target, with the permissions that opening target would give,
 * and its name in *unfinished. Returns the descriptor; -1 with errno, and nothing left behind. */
int target_open_beside(const char *target, char **unfinished);

/* Writes the name's change to the disk. 0, or errno. */
int target_sync_folder(const char *target);

#endif
