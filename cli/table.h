/* SPDX-License-Identifier: GPL-3.0-or-later */
/* rwedge table: lookup tables. */
#ifndef CLI_TABLE_H
#define CLI_TABLE_H

/* argv[0] is "rwedge table"; returns the exit status. */
int table_command(int argc, const char **argv);

#endif
