/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Completion scripts for the shells. The help text of an option says what may follow it: words
 * between bars, a FILE, or something to type. */
#include "options.h"

#include "text/text.h"

#include <errno.h>
#include <string.h>

typedef void option_printer(const struct poptOption *option, const command *owner);

static void each_option(const struct poptOption *options, const command *owner,
                        option_printer *print)
{
    for (; options->longName != NULL || options->argInfo != 0; options++)
        if ((options->argInfo & POPT_ARG_MASK) == POPT_ARG_INCLUDE_TABLE)
            each_option(options->arg, owner, print);
        else if ((options->argInfo & POPT_ARGFLAG_DOC_HIDDEN) == 0)
            print(options, owner);
}

static bool takes_file(const struct poptOption *option)
{
    return option->argDescrip != NULL && strcmp(option->argDescrip, "FILE") == 0;
}

static bool takes_words(const struct poptOption *option)
{
    return option->argDescrip != NULL && strchr(option->argDescrip, '|') != NULL;
}

/* "svg|png, csv" is three words. */
static void print_words(const struct poptOption *option)
{
    for (const char *c = option->argDescrip; *c != '\0'; c++)
        if (*c != ',')
            putchar(*c == '|' ? ' ' : *c);
}

/* Within single quotes of any of the shells, with a backslash before the characters that are
 * special there. */
static void print_quoted(const char *text, const char *special)
{
    for (const char *c = text; *c != '\0'; c++) {
        if (*c == '\'')
            fputs("'\\'", stdout);
        else if (strchr(special, *c) != NULL)
            putchar('\\');
        putchar(*c);
    }
}

static void print_operands(const command *owner)
{
    for (int i = 0; owner->operand != NULL && owner->operand(i) != NULL; i++)
        printf("%s ", owner->operand(i));
}

/* ---- bash ---- */

static void bash_value(const struct poptOption *option, const command *owner)
{
    if (option->argDescrip == NULL)
        return;
    printf("    %s,--%s", owner != NULL ? owner->name : "", option->longName);
    if (option->shortName != '\0')
        printf(" | %s,-%c", owner != NULL ? owner->name : "", option->shortName);
    fputs(") ", stdout);
    if (takes_words(option)) {
        fputs("words='", stdout);
        print_words(option);
        fputs("' ;;\n", stdout);
    } else
        puts(takes_file(option) ? "files=yes ;;" : "return ;;");
}

static void bash_name(const struct poptOption *option, const command *owner)
{
    (void)owner;
    printf("--%s ", option->longName);
}

static const char bash_begin[] = "_rwedge()\n{\n"
                                 "    local cur=${COMP_WORDS[COMP_CWORD]} "
                                 "prev=${COMP_WORDS[COMP_CWORD - 1]} command= words= files=\n"
                                 "    COMPREPLY=()\n"
                                 "    [[ $prev == = ]] && prev=${COMP_WORDS[COMP_CWORD - 2]}\n"
                                 "    [[ $cur == = ]] && cur=\n"
                                 "    ((COMP_CWORD > 1)) && command=${COMP_WORDS[1]}\n"
                                 "    [[ $command == -* ]] && command=\n"
                                 "    case $command,$prev in\n";

static const char bash_end[] = "        esac ;;\n    esac\n"
                               "    local IFS=$' \\n'\n"
                               "    if [[ $files ]]; then\n"
                               "        compopt -o filenames 2>/dev/null\n"
                               "        IFS=$'\\n'\n"
                               "        COMPREPLY=($(compgen -f -- \"$cur\"))\n"
                               "    else\n"
                               "        COMPREPLY=($(compgen -W \"$words\" -- \"$cur\"))\n"
                               "    fi\n}\n"
                               "complete -F _rwedge rwedge\n";

static void print_bash(const command *const commands[], int count, const struct poptOption *own)
{
    fputs(bash_begin, stdout);
    each_option(own, NULL, bash_value);
    for (int i = 0; i < count; i++)
        each_option(commands[i]->grammar.options, commands[i], bash_value);
    fputs("    *) case $command in\n        '') words='", stdout);
    for (int i = 0; i < count; i++)
        printf("%s ", commands[i]->name);
    each_option(own, NULL, bash_name);
    fputs("' ;;\n", stdout);
    for (int i = 0; i < count; i++) {
        printf("        %s) words='", commands[i]->name);
        print_operands(commands[i]);
        each_option(commands[i]->grammar.options, commands[i], bash_name);
        fputs("' ;;\n", stdout);
    }
    fputs(bash_end, stdout);
}

/* ---- zsh ---- */

static void zsh_option(const struct poptOption *option, const command *owner)
{
    const char *repeated = owner != NULL && owner->grammar.repeated == option->val ? "*" : "";
    const char *value = option->argDescrip != NULL ? "=" : "";
    if (option->shortName != '\0')
        printf(" \\\n            '(-%c --%s)'{-%c%s,--%s%s}'[", option->shortName, option->longName,
               option->shortName, option->argDescrip != NULL ? "+" : "", option->longName, value);
    else
        printf(" \\\n            '%s--%s%s[", repeated, option->longName, value);
    print_quoted(option->descrip, "[]");
    putchar(']');
    if (option->argDescrip != NULL) {
        printf(":%s:", takes_words(option) ? "word" : option->argDescrip);
        if (takes_words(option)) {
            putchar('(');
            print_words(option);
            putchar(')');
        } else if (takes_file(option))
            fputs("_files", stdout);
    }
    putchar('\'');
}

static void print_zsh(const command *const commands[], int count, const struct poptOption *own)
{
    fputs("_rwedge()\n{\n    local curcontext=$curcontext state line\n    typeset -A opt_args\n"
          "    _arguments -C",
          stdout);
    each_option(own, NULL, zsh_option);
    fputs(" \\\n            '1:command:((", stdout);
    for (int i = 0; i < count; i++) {
        printf("%s\\:\"", commands[i]->name);
        print_quoted(commands[i]->summary, ":\"()");
        fputs(i < count - 1 ? "\" " : "\"", stdout);
    }
    fputs("))' '*::argument:->argument' && return\n    case $line[1] in\n", stdout);
    for (int i = 0; i < count; i++) {
        printf("    %s)\n        _arguments", commands[i]->name);
        each_option(commands[i]->grammar.options, commands[i], zsh_option);
        if (commands[i]->operand != NULL) {
            fputs(" \\\n            '1:operand:(", stdout);
            print_operands(commands[i]);
            fputs(")'", stdout);
        }
        fputs("\n        ;;\n", stdout);
    }
    fputs("    esac\n}\n"
          "if [[ $funcstack[1] == _rwedge ]]; then\n    _rwedge \"$@\"\nelse\n    compdef _rwedge "
          "rwedge\nfi\n",
          stdout);
}

/* ---- fish ---- */

static void fish_option(const struct poptOption *option, const command *owner)
{
    fputs("complete -c rwedge -n ", stdout);
    if (owner != NULL)
        printf("'__fish_seen_subcommand_from %s'", owner->name);
    else
        fputs("__fish_use_subcommand", stdout);
    if (option->shortName != '\0')
        printf(" -s %c", option->shortName);
    printf(" -l %s", option->longName);
    if (takes_words(option)) {
        fputs(" -x -a '", stdout);
        print_words(option);
        putchar('\'');
    } else if (option->argDescrip != NULL)
        fputs(takes_file(option) ? " -r -F" : " -x", stdout);
    fputs(" -d '", stdout);
    print_quoted(option->descrip, "");
    fputs("'\n", stdout);
}

static void print_fish(const command *const commands[], int count, const struct poptOption *own)
{
    puts("complete -c rwedge -f");
    each_option(own, NULL, fish_option);
    for (int i = 0; i < count; i++) {
        printf("complete -c rwedge -n __fish_use_subcommand -a %s -d '", commands[i]->name);
        print_quoted(commands[i]->summary, "");
        fputs("'\n", stdout);
        each_option(commands[i]->grammar.options, commands[i], fish_option);
        if (commands[i]->operand == NULL)
            continue;
        printf("complete -c rwedge -n '__fish_seen_subcommand_from %s' -a '", commands[i]->name);
        print_operands(commands[i]);
        fputs("'\n", stdout);
    }
}

void completion_print(const char *shell, const command *const commands[], int count,
                      const struct poptOption *own)
{
    const bool zsh = strcmp(shell, "zsh") == 0, fish = strcmp(shell, "fish") == 0;
    if (!zsh && !fish && strcmp(shell, "bash") != 0)
        usage_error("--completion %s: unknown shell; allowed: bash, zsh, fish", shell);
    printf("%s# Completion of %s for rwedge, written by \"rwedge --completion %s\".\n",
           zsh ? "#compdef rwedge\n" : "", shell, shell);
    (zsh ? print_zsh : fish ? print_fish : print_bash)(commands, count, own);
    if (fflush(stdout) != 0 || ferror(stdout))
        failure("standard output: %s", strerror(errno));
}
