/* SPDX-License-Identifier: GPL-3.0-or-later */
/* rwedge: finds the command, and does what all commands need. */
#include "system/system.h"
#include "fretting/fretting.h"
#include "setup/setup.h"

#include <errno.h>
#include <string.h>

static const command help_command;
static const command *const commands[] = {
    &solve_command,     &table_command, &profile_command, &field_command,  &history_command,
    &fretting_command,  &crack_command, &loop_command,    &figure_command, &workbook_command,
    &materials_command, &read_command,  &report_command,  &help_command};
enum { COMMAND_COUNT = sizeof commands / sizeof commands[0] };

enum { OPTION_VERSION = OPTION_OWN, OPTION_COMPLETION };
static const struct poptOption options[] = {
    {HELP_OPTION},
    {VALUE("completion", OPTION_COMPLETION), "Print the completion of a shell, and end",
     "bash|zsh|fish"},
    {"version", 'V', POPT_ARG_NONE, NULL, OPTION_VERSION, "Show the version, and end", NULL},
    POPT_TABLEEND,
};

static void list_commands(FILE *stream)
{
    fputs("\nThe contact of a wedge with a rounded apex and a half-plane;\n"
          "or of a cylinder, a flat pad with rounded edges, any convex profile.\n\nCommands:\n",
          stream);
    for (int i = 0; i < COMMAND_COUNT; i++)
        fprintf(stream, "  %-10s %s\n", commands[i]->name, commands[i]->summary);
    fputs("\n\"rwedge COMMAND --help\" describes a command.\n"
          "Exit status: 0 done, 1 it could not be done, 2 a mistake on the command line.\n",
          stream);
}

NO_RETURN static void refuse_command(const char *name)
{
    char allowed[200] = "";
    for (int i = 0; i < COMMAND_COUNT; i++)
        list_add(allowed, sizeof allowed, ", ", "%s", commands[i]->name);
    if (name == NULL)
        usage_error("a command must follow; allowed: %s, --help, --version", allowed);
    nearest_name to = nearest_to(name);
    for (int i = 0; i < COMMAND_COUNT; i++)
        nearest_try(&to, commands[i]->name);
    usage_error("%s: unknown command; %s%s%sallowed: %s", name,
                to.name != NULL ? "the nearest is " : "", to.name != NULL ? to.name : "",
                to.name != NULL ? "; " : "", allowed);
}

/* NULL where there is none of that name. */
static const command *command_named(const char *name)
{
    for (int i = 0; i < COMMAND_COUNT; i++)
        if (strcmp(name, commands[i]->name) == 0)
            return commands[i];
    return NULL;
}

static int run_command(const command *chosen, int count, const char **words)
{
    static char whole_name[30];
    snprintf(whole_name, sizeof whole_name, "rwedge %s", chosen->name);
    words[0] = whole_name;
    message_speaker_is(whole_name);
    arguments line;
    if (!arguments_read(&line, &chosen->grammar, count, words))
        return STATUS_DONE;
    case_file_take(chosen->is_of_any_case ? NULL : chosen->name, &line);
    case_file_check(&line);
    const int status = chosen->run(&line);
    if (status == STATUS_DONE)
        case_file_save(chosen->name, &line);
    return status;
}

/* Options in front of a command are rwedge's own. */
static int without_command(int argc, const char **argv)
{
    const syntax grammar = {options, "COMMAND ...", list_commands, 0};
    arguments line;
    if (arguments_read(&line, &grammar, argc, argv)) {
        if (line.value[OPTION_VERSION] != NULL) {
            if (printf("rwedge %s\n", rwedge_version()) < 0 || fflush(stdout) != 0)
                failure("standard output: %s", strerror(errno));
        } else if (line.value[OPTION_COMPLETION] != NULL)
            completion_print(line.value[OPTION_COMPLETION], commands, COMMAND_COUNT, options);
        else
            refuse_command(line.operand != NULL ? line.operand[0] : NULL);
    }
    return STATUS_DONE;
}

/* ---- rwedge help [COMMAND] ---- */

static int help(const arguments *line)
{
    const char *words[] = {"rwedge", "--help", NULL};
    const char *name = line->operand != NULL ? line->operand[0] : NULL;
    const command *chosen = name != NULL ? command_named(name) : NULL;
    if (name != NULL && line->operand[1] != NULL)
        usage_error("%s: unexpected; allowed: one command", line->operand[1]);
    if (name != NULL && chosen == NULL)
        refuse_command(name);
    return chosen != NULL ? run_command(chosen, 2, words) : without_command(2, words);
}

static void describe_help(FILE *stream)
{
    fputs("\nThe help of a command, or of rwedge itself, as --help prints it.\n", stream);
}

static const char *command_name(int i)
{
    return i < COMMAND_COUNT ? commands[i]->name : NULL;
}

static const struct poptOption help_options[] = {{HELP_OPTION}, POPT_TABLEEND};
static const command help_command = {.name = "help",
                                     .summary = "the help of a command",
                                     .grammar = {help_options, "[COMMAND]", describe_help},
                                     .operand = command_name,
                                     .run = help};

int main(int argc, char **argv)
{
    const char **words = (const char **)argv;
    if (!start(&argc, &words))
        return STATUS_FAILED;
    signals_install();
    invocation_keep(argc, words);
    input_options_prepare();
    criteria_options_prepare();
    const command *chosen = argc > 1 ? command_named(words[1]) : NULL;
    if (chosen != NULL)
        return run_command(chosen, argc - 1, words + 1);
    if (argc > 1 && words[1][0] != '-')
        refuse_command(words[1]);
    words[0] = "rwedge";
    return without_command(argc, words);
}
