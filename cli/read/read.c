/* SPDX-License-Identifier: GPL-3.0-or-later */
/* rwedge read: files and options as a case in the working units, without computing. */
#include "rows/rows.h"
#include "setup/setup.h"
#include "system/system.h"

static const struct poptOption options[] = {
    {INCLUDED(input_option_table), "The contact:", NULL},
    {INCLUDED(strength_option_table), "Its strength:", NULL},
    {INCLUDED(load_option_table), "Its loads:", NULL},
    {FLAG("decimal-comma", OPTION_DECIMAL_COMMA), "Files have 1,5 for 1.5", NULL},
    {"output", 'o', POPT_ARG_STRING, NULL, OPTION_OUTPUT,
     "Write to FILE, whole or not at all (default: standard output)", "FILE"},
    {HELP_OPTION},
    POPT_TABLEEND,
};

static void describe(FILE *stream)
{
    fputs("\nWrites what it reads as a case, in the working units, forces per unit length: any\n"
          "part of one, nothing is needed. A profile is written as the slopes that are made\n"
          "of it, a material with all its constants. Programs take files so, with the\n"
          "messages of the tool.\n",
          stream);
}

static int read_case(const arguments *line)
{
    const char *path = line->value[OPTION_OUTPUT];
    history_check(line);
    input_options_check_hull(line);
    output_options_spare_files(line, &(output_options){.option = "output", .path = path});
    case_file_write(NULL, line, path);
    return STATUS_DONE;
}

const command read_command = {
    .name = "read",
    .summary = "files and options as a case, for other programs",
    .grammar = {options, "[LOADS.csv] [OPTION...]", describe, OPTION_LOAD},
    .run = read_case};
