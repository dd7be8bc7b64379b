/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef CLI_OPTIONS_H
#define CLI_OPTIONS_H

#include "number/number.h"

#include <stdbool.h>
#include <stdio.h>

#include <popt.h>

/* ---- arguments ---- A command's options and operands, by popt, with one line for every
 * mistake. */

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
    OPTION_COLUMN, /* may be repeated, wherever it is */
    OPTION_OWN,
    OPTION_LIMIT = 160
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
    const syntax *grammar;
    int output; /* the number of the option that names the file to write */
} arguments;

/* Reads a command line whose argv[0] is the whole command, "rwedge table". False after --help, with
 * which the command is done. */
bool arguments_read(arguments *line, const syntax *grammar, int argc, const char **argv);

/* The number of the option of that name, 0 for none; the name of one of that number, as the help
 * has it; the option whose name is nearest to one that is none, NULL where none is near. */
int arguments_number(const arguments *line, const char *name);
const char *arguments_name(const arguments *line, int number);
const char *arguments_nearest(const syntax *grammar, const char *name);

/* The name of the option that names the file to write; of one that names another file, as the help
 * has it, NULL where it names none. */
const char *arguments_output(const arguments *line);
const char *arguments_other_file(const arguments *line, int number);

/* Refuses a word that is no option. */
void arguments_no_operand(const arguments *line);

/* Entries of a table begin so: an option with a value, one without, the options of another table.
 * What they mean, and NULL or the value's name, follow. */
#define VALUE(name, number) name, '\0', POPT_ARG_STRING, NULL, number
#define FLAG(name, number) name, '\0', POPT_ARG_NONE, NULL, number
#define INCLUDED(table) NULL, '\0', POPT_ARG_INCLUDE_TABLE, table, 0

/* Another name of an option, which the help and the shells do not list. */
#define OTHER_NAME(name, number)                                                                   \
    {                                                                                              \
        name, '\0', POPT_ARG_STRING | POPT_ARGFLAG_DOC_HIDDEN, NULL, number, NULL, NULL            \
    }

#define HELP_OPTION "help", 'h', POPT_ARG_NONE, NULL, OPTION_HELP, "Show this help, and end", NULL

/* ---- command ---- What main() and the shells' completion know of a command. */

typedef struct {
    const char *name, *summary;
    syntax grammar;
    /* the words that may follow, NULL after the last; NULL where none may */
    const char *(*operand)(int i);
    int (*run)(const arguments *line); /* returns the exit status */
    bool is_of_any_case;               /* as case_file_take() has it */
} command;

/* Each is defined in the file of its name. */
extern const command solve_command, table_command, profile_command, field_command, history_command,
    fretting_command, crack_command, loop_command, figure_command, workbook_command,
    materials_command, read_command, report_command;

/* ---- completion ---- Completion for bash, zsh and fish, written from the tables of options that
 * drive the parsing. */

/* Prints the completion of a shell; `own` has the options that may stand in front of a command. */
void completion_print(const char *shell, const command *const commands[], int count,
                      const struct poptOption *own);

/* The lines of the files in shells/, which the build makes of them; NULL after the last. */
extern const char *const bash_lines[], *const zsh_lines[], *const fish_lines[];

/* ---- variable ---- The variables that tables depend on, and two more of figures: for each its
 * option, its column, its domain and its range by default. */

enum { A_OVER_B, FRICTION, NU, Q_OVER_FP, BETA_F, VARIABLE_COUNT };
enum { C_OVER_B = VARIABLE_COUNT, SIGMA_OVER_MAX, FIGURE_VARIABLES };

typedef struct {
    const char *option; /* without its dashes */
    const char *column;
    const char *name; /* as the subject of a sentence */
    double lo, hi;    /* the domain; hi is HUGE_VAL where there is no upper end */
    const char *domain;
    const char *usual; /* the range by default */
} table_variable;

extern const table_variable variables[FIGURE_VARIABLES];

/* Reads the values of an option. */
void range_option(const char *option, const char *text, range *values);

/* Reads an option's text, or the usual range where it is NULL. */
void variable_read(const table_variable *variable, const char *text, range *values);

/* The same for one number. */
double variable_read_one(const table_variable *variable, const char *text);

#define THREADS_OPTION                                                                             \
    "threads", '\0', POPT_ARG_STRING, NULL, OPTION_THREADS,                                        \
        "Threads that compute; the rows are the same for any N (default: one for each processor)", \
        "N"

/* Reads it; where it is not given there is one thread for each processor. */
int threads_read(const arguments *line);

#endif
