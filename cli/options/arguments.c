/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "options.h"

#include "system/system.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>

/* The option with this number, in a table or those it includes. */
static const struct poptOption *find(const struct poptOption *options, int number)
{
    for (; options->longName != NULL || options->argInfo != 0; options++) {
        const struct poptOption *match = NULL;
        if ((options->argInfo & POPT_ARG_MASK) == POPT_ARG_INCLUDE_TABLE)
            match = find(options->arg, number);
        else if (options->val == number)
            match = options;
        if (match != NULL)
            return match;
    }
    return NULL;
}

/* Other usual names, and the options that they mean; a command has one of them or none. */
static const struct {
    const char *usual, *option;
} synonyms[] = {
    {"mu", "friction"}, {"mu", "f"},       {"cof", "friction"},    {"cof", "f"},
    {"R", "radius"},    {"E", "E1"},       {"sy", "yield-stress"}, {"sigma-y", "yield-stress"},
    {"file", "output"}, {"out", "output"}, {"csv", "format"},
};

static void try_options(const struct poptOption *options, nearest_name *to)
{
    for (; options->longName != NULL || options->argInfo != 0; options++) {
        if ((options->argInfo & POPT_ARG_MASK) == POPT_ARG_INCLUDE_TABLE) {
            try_options(options->arg, to);
            continue;
        }
        if ((options->argInfo & POPT_ARGFLAG_DOC_HIDDEN) != 0)
            continue;
        for (size_t i = 0; i < sizeof synonyms / sizeof synonyms[0]; i++)
            if (strcmp(to->typed, synonyms[i].usual) == 0 &&
                strcmp(options->longName, synonyms[i].option) == 0)
                *to = (nearest_name){to->typed, options->longName, 0};
        nearest_try(to, options->longName);
    }
}

const char *arguments_nearest(const syntax *grammar, const char *name)
{
    nearest_name to = nearest_to(name);
    try_options(grammar->options, &to);
    return to.name;
}

static void refuse_unknown(const syntax *grammar, const char *option)
{
    char allowed[512] = "", name[40];
    const char *typed = option + strspn(option, "-");
    snprintf(name, sizeof name, "%.*s", (int)strcspn(typed, "="), typed);
    const char *nearest = arguments_nearest(grammar, name);
    if (nearest != NULL)
        usage_error("%s: unknown option; the nearest is --%s; \"%s --help\" lists all", option,
                    nearest, message_speaker());
    for (int i = 0; i < OPTION_LIMIT; i++) { /* the command's own first, then the common ones */
        const struct poptOption *own = find(grammar->options, (OPTION_OWN + i) % OPTION_LIMIT);
        if (own != NULL)
            list_add(allowed, sizeof allowed, ", ", "--%s", own->longName);
    }
    usage_error("%s: unknown option; allowed: %s", option, allowed);
}

/* popt goes on without an option that it has no memory for; nobody would notice. */
static void check_memory(void)
{
    if (errno == ENOMEM)
        failure("out of memory");
}

static void refuse_option(const syntax *grammar, poptContext context, int error)
{
    const char *option = poptBadOption(context, POPT_BADOPTION_NOALIAS);
    if (error == POPT_ERROR_BADOPT)
        refuse_unknown(grammar, option);
    if (error == POPT_ERROR_NOARG)
        usage_error("%s: a value must follow", option);
    if (error == POPT_ERROR_UNWANTEDARG)
        usage_error("%s: takes no value", option);
    usage_error("%s: %s", option, poptStrerror(error));
}

/* Whether a word is an option of these, with its dashes. */
static bool is_option(const struct poptOption *options, const char *word)
{
    for (int i = 1; i < OPTION_LIMIT && strncmp(word, "--", 2) == 0; i++) {
        const struct poptOption *option = find(options, i);
        if (option != NULL && strcmp(option->longName, word + 2) == 0)
            return true;
    }
    return false;
}

/* Another value of an option that may be repeated is on a line of its own. */
static void keep(arguments *line, const syntax *grammar, int number, char *value)
{
    char **kept = &line->value[number];
    if (value != NULL && is_option(grammar->options, value)) /* popt takes any word for a value */
        usage_error("--%s: a value must follow, not the option %s",
                    find(grammar->options, number)->longName, value);
    if (*kept == NULL)
        *kept = value != NULL ? value : memory_zeroed(1, 1);
    else if (value != NULL && (number == grammar->repeated || number == OPTION_COLUMN)) {
        *kept = memory_resized(*kept, strlen(*kept) + strlen(value) + 2);
        strcat(strcat(*kept, "\n"), value);
        free(value);
    } else if (value != NULL)
        usage_error("--%s %s: given twice; allowed: once", find(grammar->options, number)->longName,
                    value);
}

bool arguments_read(arguments *line, const syntax *grammar, int argc, const char **argv)
{
    int number;
    *line = (arguments){.grammar = grammar, .output = OPTION_OUTPUT};
    errno = 0;
    const poptContext context =
        memory_checked(poptGetContext(NULL, argc, argv, grammar->options, 0));
    while ((number = poptGetNextOpt(context)) > 0) {
        char *value = poptGetOptArg(context);
        check_memory();
        keep(line, grammar, number, value);
    }
    check_memory();
    if (number < -1)
        refuse_option(grammar, context, number);
    if (line->value[OPTION_HELP] != NULL) {
        poptSetOtherOptionHelp(context, grammar->operands);
        poptPrintHelp(context, stdout, 0);
        grammar->more_help(stdout);
        if (fflush(stdout) != 0 || ferror(stdout))
            failure("standard output: %s", strerror(errno));
        return false;
    }
    line->operand = poptGetArgs(context);
    check_memory();
    return true;
}

static int number_of(const struct poptOption *options, const char *name)
{
    for (; options->longName != NULL || options->argInfo != 0; options++) {
        int number = 0;
        if ((options->argInfo & POPT_ARG_MASK) == POPT_ARG_INCLUDE_TABLE)
            number = number_of(options->arg, name);
        else if (strcmp(options->longName, name) == 0)
            number = options->val;
        if (number != 0)
            return number;
    }
    return 0;
}

int arguments_number(const arguments *line, const char *name)
{
    return number_of(line->grammar->options, name);
}

const char *arguments_name(const arguments *line, int number)
{
    const struct poptOption *option = find(line->grammar->options, number);
    return option != NULL ? option->longName : NULL;
}

const char *arguments_output(const arguments *line)
{
    return find(line->grammar->options, line->output)->longName;
}

const char *arguments_other_file(const arguments *line, int number)
{
    const struct poptOption *option = find(line->grammar->options, number);
    const char *kind = option != NULL ? option->argDescrip : NULL;
    const bool is_file = kind != NULL && strcmp(kind, "FILE") == 0 && number != line->output;
    return is_file ? option->longName : NULL;
}

void arguments_no_operand(const arguments *line)
{
    if (line->operand != NULL && line->operand[0] != NULL)
        usage_error("%s: unexpected; allowed: options only", line->operand[0]);
}

/* ---- --threads ---- */

int threads_read(const arguments *line)
{
    const char *text = line->value[OPTION_THREADS];
    int64_t number = processors() < THREADS_MAX ? processors() : THREADS_MAX;
    if (text != NULL && !number_read_whole(text, 1, THREADS_MAX, &number))
        usage_error("--threads %s: must be a whole number from 1 to %d", text, THREADS_MAX);
    return (int)number;
}
