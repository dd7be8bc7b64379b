/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef CLI_SYSTEM_H
#define CLI_SYSTEM_H

#include "text/text.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>

/* ---- program ---- What must be in order before anything is read or written. */

/* Gives the program its standard streams, and at least one argument. Both are what main() was
 * given, and may change. A file must not get the number of a standard stream that was closed:
 * messages would be written into it. So a stand-in is opened for each one that is closed. The
 * stand-in for standard output refuses to be written to, as the closed one would. Variables by
 * which popt would take no option after an operand, such as a table's name, are taken away. */
bool start(int *count, const char ***words);

/* How many threads the machine can run at a time, at least 1. */
long processors(void);

/* ---- files ---- Files by their names, which are UTF-8 where the system has characters in
 * names. */

typedef enum {
    FILE_REGULAR,
    FILE_ABSENT,
    FILE_FOLDER,
    FILE_OTHER,    /* a pipe, a device */
    FILE_NOT_KNOWN /* errno says why */
} file_kind;

/* The kind of the file that path leads to, links followed. */
file_kind file_kind_of(const char *path);

/* Opens an existing file for reading, or a pipe or a device for writing. Other programs do not
 * inherit it. NULL with errno. */
FILE *file_to_read(const char *path);
FILE *file_to_write(const char *path);

/* What errno says of a file, for a message. */
const char *file_problem(int reason);

/* ---- files ---- Temporary files as streams. */

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

/* ---- program ---- Another program, run to its end. */

typedef struct {
    bool by_signal;
    int number; /* of the signal, or the exit status */
} program_end;

/* What a program opens to read its standard input as a file; "-", the usual word for it, where it
 * has no name. */
extern const char program_input_name[];

/* Runs words[0], looked for on PATH, with the three files as its standard streams. These
 * variables, "NAME=value", become part of the environment. Lists end with NULL. 0; or errno where
 * it could not be run. */
int program_run(const char *const words[], const char *const variables[], FILE *const streams[3],
                program_end *end);

/* ---- target ---- The file that a result replaces, and the unfinished file beside it. */

/* Where path leads when symbolic links are followed: the link stays, what it points to is replaced.
 * Free it. NULL with errno. */
char *target_of_links(const char *path);

/* Whether an input and an output are one file, by whatever names; "-" is a standard stream. */
bool target_is_input(const char *to, const char *from);

/* Opens a new file in the folder of target, with the permissions that opening target would give, or
 * that target has; its name is in *unfinished. NULL with errno, and nothing left behind. */
FILE *target_open_beside(const char *target, char **unfinished);

/* Writes what the file, which is flushed, holds to the disk. 0, or errno. */
int target_sync(FILE *file);

/* The unfinished file, closed, takes the place of the target. 0, or errno; it is removed where it
 * cannot. */
int target_replace(const char *target, const char *unfinished);

/* ---- signals ---- A user who ends the program, by Ctrl-C, kill or a closed terminal: the
 * unfinished file is removed, a message says so, and the program ends by the signal itself, so that
 * the shell sees it. A closed pipe and a size limit are errors of write() instead. */

/* Once, at the start. A signal that is ignored already (nohup) stays so. */
void signals_install(void);

/* From now on a signal removes this file, NULL for none, and its message ends with the text.
 * Both are kept, not copied. */
void signals_on_end(const char *unfinished_file, const char *message);

/* Does so, for a handler: only calls that are safe there. */
void signals_end(const char *why);

/* Hold signals back while a file and what is known of it change together. Threads begun in between
 * leave signals to the one that begins them. */
void signals_hold(void);
void signals_release(void);

/* ---- output ---- Where results go. A file appears whole or not at all: it is written beside its
 * target under another name, flushed to the disk, and renamed. If anything goes wrong before that,
 * the old file stays as it was. Standard output, pipes and devices are written to directly; their
 * errors are noticed too. */

typedef struct {
    const char *name; /* as the user knows it */
    char *target;     /* the file to replace, links followed; NULL where written to directly */
    char *unfinished; /* the file beside it */
    FILE *stream;     /* `stdout` itself where that is written to */
    int error;        /* errno of the first failure; nothing is written after it */
} output;

/* Opens the output; NULL or "-" is standard output. One output is open at a time. If the command
 * ends by a mistake, a file is left as it was; rows for standard output, a pipe or a device are
 * written up to there. */
void output_open(output *out, const char *path);

/* Before long work: ends the command where the file cannot be written. Leaves all as it was. */
void output_try(const char *path);

/* Add bytes, a text, or a text as by printf. */
void output_write(output *out, const char *bytes, size_t count);
void output_text(output *out, const char *text);
void output_print(output *out, const char *format, ...) PRINTF_LIKE(2, 3);

/* Makes the result appear. */
void output_finish(output *out);

/* ---- progress ---- How far long work has come, on stderr: "rwedge table: 12345 of 650000 rows",
 * once it has taken half a second. */

/* total is the number of units, or this where it is not known. */
#define PROGRESS_NO_TOTAL INT64_C(-1)
void progress_start(bool wanted, int64_t total, const char *unit);

/* To be called for every row. It is cheap: it looks at the clock every few rows only. */
void progress_step(void);

/* Removes the line from the terminal. Safe in a signal handler. */
void progress_erase(void);

/* ---- threads ---- */

enum { THREADS_MAX = 256 };

/* Computes what belongs to an index. It is called by several threads at a time. */
typedef void threads_work(void *context, int64_t i);

/* Has the indices 0 to count - 1 computed, each once, and returns when all are done. Where the
 * system gives fewer threads, those do the work. */
void threads_run(int threads, int64_t count, threads_work *compute, void *context);

#endif
