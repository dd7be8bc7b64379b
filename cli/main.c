/* SPDX-License-Identifier: GPL-3.0-or-later */
/* rwedge: finds the command, and does what all commands need. */
#include "options/arguments.h"
#include "options/completion.h"
#include "field/field.h"
#include "figure/figure.h"
#include "text/invocation.h"
#include "text/list.h"
#include "text/message.h"
#include "field/profile.h"
#include "system/signals.h"
#include "system/streams.h"
#include "solve/solve.h"
#include "table/table.h"
#include "workbook/workbook.h"

#include <errno.h>
#include <string.h>

#include <rwedge.h>

static const command *const commands[] = {&solve_command, &table_command,  &profile_command,
                                          &field_command, &figure_command, &workbook_command};
enum { COMMAND_COUNT = sizeof commands / sizeof commands[0] };

enum { OPTION_VERSION = OPTION_OWN, OPTION_COMPLETION };
static const struct poptOption options[] = {
    {HELP_OPTION},
    {"completion", '\0', POPT_ARG_STRING, NULL, OPTION_COMPLETION,
     "Print the completion of a shell, and end", "bash|zsh|fish"},
    {"version", 'V', POPT_ARG_NONE, NULL, OPTION_VERSION, "Show the version, and end", NULL},
    POPT_TABLEEND,
};

static void list_commands(FILE *stream)
{
    fputs("\nThe contact of a wedge with a rounded apex and an elastically similar "
          "half-plane.\n\nCommands:\n",
          stream);
    for (int i = 0; i < COMMAND_COUNT; i++)
        fprintf(stream, "  %-10s %s\n", commands[i]->name, commands[i]->summary);
    fputs("\n\"rwedge COMMAND --help\" describes a command.\n"
          "Exit status: 0 done, 1 it could not be done, 2 a mistake on the command line.\n",
          stream);
}

static int unknown_command(const char *name)
{
    char allowed[200] = "";
    for (int i = 0; i < COMMAND_COUNT; i++)
        list_add(allowed, sizeof allowed, ", ", "%s", commands[i]->name);
    if (name == NULL)
        return usage_error("a command must follow; allowed: %s, --help, --version", allowed);
    return usage_error("%s: unknown command; allowed: %s", name, allowed);
}

static int show_version(void)
{
    if (printf("rwedge %s\n", rwedge_version()) < 0 || fflush(stdout) != 0)
        return failure("standard output: %s", strerror(errno));
    return STATUS_DONE;
}

/* Options in front of a command are rwedge's own. */
static int without_command(int argc, const char **argv)
{
    const syntax grammar = {options, "COMMAND ...", list_commands, 0};
    arguments given;
    int status;
    if (arguments_read(&given, &grammar, argc, argv, &status)) {
        if (given.value[OPTION_VERSION] != NULL)
            status = show_version();
        else if (given.value[OPTION_COMPLETION] != NULL)
            status =
                completion_print(given.value[OPTION_COMPLETION], commands, COMMAND_COUNT, options);
        else
            status = unknown_command(given.operand != NULL ? given.operand[0] : NULL);
    }
    arguments_free(&given);
    return status;
}

int main(int argc, char **argv)
{
    const char *no_arguments[] = {"rwedge", NULL};
    const char **words = argc > 0 ? (const char **)argv : no_arguments;
    if (!streams_fill_closed())
        return STATUS_FAILED;
    signals_install();
    invocation_keep(argc, words);
    for (int i = 0; argc > 1 && i < COMMAND_COUNT; i++)
        if (strcmp(words[1], commands[i]->name) == 0) {
            words[1] = commands[i]->whole_name;
            message_speaker_is(words[1]);
            return arguments_run(commands[i]->grammar, argc - 1, words + 1, commands[i]->run);
        }
    words[0] = "rwedge";
    return without_command(argc > 0 ? argc : 1, words);
}
