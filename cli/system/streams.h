/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Temporary files as streams. */
#ifndef CLI_STREAMS_H
#define CLI_STREAMS_H

#include <stdbool.h>
#include <stdio.h>

bool stream_is_terminal(FILE *stream);

/* A temporary file; closed, it is gone. Another program does not inherit it. NULL with errno. */
FILE *stream_temporary(void);

/* A temporary file that a library writes to by its name. */
typedef struct {
    char name[1024];
    FILE *stream;
} spool;

/* False with errno. Should the command end before spool_end(), the file goes too. */
bool spool_begin(spool *file);

/* What the library has written and closed; NULL with errno. The stream is the spool's. */
FILE *spool_read(spool *file);

/* The file is gone. */
void spool_end(spool *file);

#endif
