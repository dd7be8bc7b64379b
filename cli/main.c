/* SPDX-License-Identifier: GPL-3.0-or-later */
/* rwedge: which command, and what holds for all of them. */
#include "options/arguments.h"
#include "options/completion.h"
#include "field/field.h"
#include "figure/figure.h"
#include "text/invocation.h"
#include "text/message.h"
#include "field/profile.h"
#include "system/signals.h"
#include "solve/solve.h"
#include "table/table.h"
#include "workbook/workbook.h"

#include <errno.h>
#include <fcntl.h>
#include <string.h>
#include <unistd.h>

#include <rwedge.h>

static const command *const commands[] = {&solve_command, &table_command,  &profile_command,
                                          &field_command, &figure_command, &workbook_command};
enum { COMMAND_COUNT = sizeof commands / sizeof commands[0] };

enum { OPTION_VERSION = OPTION_OWN, OPTION_COMPLETION };
static const struct poptOption options[] = {
    OPTION_HELP_ENTRY,
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
    for (int i = 0; i < COMMAND_COUNT; i++) {
        const size_t used = strlen(allowed);
        snprintf(allowed + used, sizeof allowed - used, "%s%s", used > 0 ? ", " : "",
                 commands[i]->name);
    }
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

/* A file must not get the number of a standard stream that was closed: messages would be written
 * into it. The stand-in for standard output refuses to be written to, as the closed one would. */
static bool fill_standard_streams(void)
{
    for (int stream = STDIN_FILENO; stream <= STDERR_FILENO; stream++)
        if (fcntl(stream, F_GETFD) < 0 &&
            open("/dev/null", stream == STDERR_FILENO ? O_WRONLY : O_RDONLY) != stream)
            return false;
    return true;
}

int main(int argc, char **argv)
{
    const char *no_arguments[] = {"rwedge", NULL};
    const char **words = argc > 0 ? (const char **)argv : no_arguments;
    if (!fill_standard_streams())
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
