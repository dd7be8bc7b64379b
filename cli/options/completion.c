/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Completion scripts for the shells, from the files in shells/: a list of what there is, and how
 * each shell reads it. The help text of an option says what may follow it: words between bars, a
 * FILE, or something to type. */
#include "options.h"

#include "text/text.h"

#include <errno.h>
#include <string.h>

/* Prints what the shell's quotes want: a backslash stands before the characters that are special
 * there. */
static void print_quoted(const char *text, const char *special)
{
    for (const char *c = text; *c != '\0'; c++) {
        if (strchr(special, *c) != NULL)
            putchar('\\');
        putchar(*c);
    }
}

/* A line for each option: command;option;letter;value;*;meaning, the * where it may be repeated. */
static void print_options(const struct poptOption *options, const command *owner,
                          const char *special)
{
    for (; options->longName != NULL || options->argInfo != 0; options++) {
        if ((options->argInfo & POPT_ARG_MASK) == POPT_ARG_INCLUDE_TABLE) {
            print_options(options->arg, owner, special);
            continue;
        }
        if ((options->argInfo & POPT_ARGFLAG_DOC_HIDDEN) != 0)
            continue;
        printf("%s;%s;%.1s;", owner != NULL ? owner->name : "", options->longName,
               &options->shortName);
        for (const char *c = options->argDescrip; c != NULL && *c != '\0'; c++)
            if (*c != ',') /* "svg|png, csv" is three words */
                putchar(*c == '|' ? ' ' : *c);
        fputs(owner != NULL && owner->grammar.repeated == options->val ? ";*;" : ";;", stdout);
        print_quoted(options->descrip, special);
        putchar('\n');
    }
}

/* A line for each command too, its value the words that may follow. */
static void print_command(const command *chosen, const char *special)
{
    printf("%s;;;", chosen->name);
    for (int k = 0; chosen->operand != NULL && chosen->operand(k) != NULL; k++)
        printf("%s%s", k > 0 ? " " : "", chosen->operand(k));
    fputs(";;", stdout);
    print_quoted(chosen->summary, special);
    putchar('\n');
    print_options(chosen->grammar.options, chosen, special);
}

void completion_print(const char *shell, const command *const commands[], int count,
                      const struct poptOption *own)
{
    const bool zsh = strcmp(shell, "zsh") == 0, fish = strcmp(shell, "fish") == 0;
    if (!zsh && !fish && strcmp(shell, "bash") != 0)
        usage_error("--completion %s: unknown shell; allowed: bash, zsh, fish", shell);
    const char *special = fish ? "'\\" : "";
    const char *const *line = zsh ? zsh_lines : fish ? fish_lines : bash_lines;
    for (; *line != NULL && strcmp(*line, "LIST") != 0; line++)
        puts(*line);
    print_options(own, NULL, special);
    for (int i = 0; i < count; i++)
        print_command(commands[i], special);
    while (*++line != NULL)
        puts(*line);
    if (fflush(stdout) != 0 || ferror(stdout))
        failure("standard output: %s", strerror(errno));
}
