/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Files by their names, which are UTF-8 where the system has characters in names. */
#ifndef CLI_FILES_H
#define CLI_FILES_H

typedef enum {
    FILE_REGULAR,
    FILE_ABSENT,
    FILE_FOLDER,
    FILE_OTHER,  /* a pipe, a device */
    FILE_UNKNOWN /* errno says why */
} file_kind;

/* The kind of the file that path leads to, links followed. */
file_kind file_kind_of(const char *path);

/* Opens an existing file for reading, or a pipe or a device for writing. Returns the descriptor,
 * which other programs do not inherit; -1 with errno. */
int file_to_read(const char *path);
int file_to_write(const char *path);

/* What errno says of a file, for a message. */
const char *file_problem(int reason);

#endif
