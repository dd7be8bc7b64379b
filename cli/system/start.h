/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What must be in order before anything is read or written. */
#ifndef CLI_START_H
#define CLI_START_H

#include <stdbool.h>

/* Gives the program its standard streams, and at least one argument. Both are what main() was
 * given, and may change. A file must not get the number of a standard stream that was closed:
 * messages would be written into it. So something is put in the place of each one that is closed.
 * The stand-in for standard output refuses to be written to, as the closed one would. Variables by
 * which popt would take no option after an operand, such as a table's name, are taken away. */
bool start(int *count, const char ***words);

#endif
