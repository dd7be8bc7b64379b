/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What C's streams lack. */
#ifndef CLI_STREAMS_H
#define CLI_STREAMS_H

#include <stdbool.h>
#include <stdio.h>

/* A file must not get the number of a standard stream that was closed: messages would be written
 * into it. This puts something in the place of each one that is closed. The stand-in for standard
 * output refuses to be written to, as the closed one would. */
bool streams_fill_closed(void);

bool stream_is_terminal(FILE *stream);

/* A temporary file; closed, it is gone. Another program does not inherit it. NULL with errno. */
FILE *stream_temporary(void);

/* A temporary file that a library can open by this name too. Closed, it is gone. NULL with
 * errno. */
enum { STREAM_NAME_SIZE = 40 };
FILE *stream_with_name(char name[STREAM_NAME_SIZE]);

#endif
