/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The command line, for files that say how they were made. */
#ifndef CLI_INVOCATION_H
#define CLI_INVOCATION_H

/* Keeps it: "rwedge" and the words that follow, quoted where a shell needs it. Of an output file
 * only the name is kept, not its folder: the same command writes the same file wherever it is
 * called. It is UTF-8 that every format can hold, and ends with "..." where it is long. */
void invocation_keep(int argc, const char *const argv[]);

const char *invocation(void);

#endif
