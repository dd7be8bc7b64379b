/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A command's options and operands, by popt, with one line for every mistake. */
#ifndef CLI_ARGUMENTS_H
#define CLI_ARGUMENTS_H

#include <stdbool.h>
#include <stdio.h>

#include <popt.h>

/* Each option of a command's table has a number, its val, from 1 to OPTION_LIMIT - 1. Its arg is
 * NULL, so that popt hands every value over. The first few are common to all commands. */
enum {
    OPTION_HELP = 1,
    OPTION_FORMAT,
    OPTION_DIGITS,
    OPTION_DECIMAL_COMMA,
    OPTION_OUTPUT,
    OPTION_QUIET,
    OPTION_ENCODING,
    OPTION_THREADS,
    OPTION_NO_FORMULAS,
    OPTION_OWN,
    OPTION_LIMIT = 80
};

typedef struct {
    const struct poptOption *options;
    const char *operands;            /* as the usage line shows them */
    void (*more_help)(FILE *stream); /* what follows the options */
    /* the option that may be given again, its values one to a line; 0 for none */
    int repeated;
} syntax;

typedef struct {
    /* by the option's number: NULL where not given, "" for one that takes no value */
    char *value[OPTION_LIMIT];
    const char **operand; /* ends with NULL; NULL where there is none */
} arguments;

/* Reads a command line whose argv[0] is the whole command, "rwedge table". False after --help, with
 * which the command is done. */
bool arguments_read(arguments *line, const syntax *grammar, int argc, const char **argv);

/* Refuses a word that is no option. */
void arguments_no_operand(const arguments *line);

/* Another name of an option, which the help and the shells do not list. */
#define OTHER_NAME(name, number)                                                                   \
    {                                                                                              \
        name, '\0', POPT_ARG_STRING | POPT_ARGFLAG_DOC_HIDDEN, NULL, number, NULL, NULL            \
    }

/* An entry of a table. */
#define HELP_OPTION "help", 'h', POPT_ARG_NONE, NULL, OPTION_HELP, "Show this help, and end", NULL

#endif
