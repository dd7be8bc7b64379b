/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A case file gives values to options that the command line does not give. So a case is read as the
 * same words on a command line are, and refused with the same messages. */
#include "setup.h"

#include "model/words/words.h"

#include <stdlib.h>
#include <string.h>

/* ---- Options ---- */

/* Whether the command line gives it, or the other way to give it. */
static bool is_typed(const arguments *line, const case_word *word, int number)
{
    const int other = word->input < INPUT_COUNT ? input_alternative(word->input) : -1;
    return line->value[number] != NULL || (other >= 0 && line->value[OPTION_INPUT + other] != NULL);
}

/* A command that answers for body 1 alone would take the k of body 2 for its own. */
static void check_body(const char *path, const case_word *word, const node *value, int number)
{
    if (number != 0 || word->option == NULL || strcmp(word->option, "strength-of") != 0)
        return;
    char *body = node_words(value);
    if (strcmp(body, "1") != 0)
        failure("%s: strength_of %s: k is of that body; allowed: 'rwedge solve' and the page, "
                "which answer for it",
                path, body);
    free(body);
}

/* One value that replaces those of the case: the file has not both ways to give it. */
static void set_option(const char *path, arguments *line, const case_word *word, const node *value)
{
    const int number = word->option != NULL ? arguments_number(line, word->option) : 0;
    const node_kind needed = word->kind == WORD_FLAG ? NODE_FLAG : NODE_TEXT;
    if (value->kind != needed && !(word->kind == WORD_QUANTITY && value->kind == NODE_NUMBER))
        failure("%s: %s: must be %s", path, word->name,
                word->kind == WORD_FLAG   ? "true or false"
                : word->kind == WORD_TEXT ? "a text"
                                          : "a number, or a text with its unit");
    check_body(path, word, value, number);
    if (number == 0 || is_typed(line, word, number) || (needed == NODE_FLAG && value->number == 0))
        return;
    line->value[number] = needed == NODE_FLAG ? memory_zeroed(1, 1) : node_words(value);
}

/* ---- The pad's places ---- */

static double *numbers_of(const char *path, const node *list, size_t count)
{
    if (list->kind != NODE_LIST || list->count != count)
        failure("%s: %s: must be a list of numbers%s", path, list->name,
                list->kind == NODE_LIST ? ", as many as beside it" : "");
    double *number = memory_zeroed(count + 1, sizeof *number);
    for (size_t i = 0; i < count; i++) {
        if (list->part[i].kind != NODE_NUMBER)
            failure("%s: %s: number %zu of the list is none", path, list->name, i + 1);
        number[i] = list->part[i].number;
    }
    return number;
}

static void take_places(const char *path, const node *places, arguments *line)
{
    const node *x = node_part(places, "x"), *slope = node_part(places, "slope"),
               *height = node_part(places, "height");
    char **profile = &line->value[OPTION_INPUT + INPUT_PROFILE];
    if (x == NULL && slope == NULL && height == NULL)
        return;
    if (x == NULL || (slope == NULL) == (height == NULL))
        failure("%s: pad: needs x, and slope or height", path);
    if (*profile != NULL)
        return;
    const node *value = slope != NULL ? slope : height;
    *profile = memory_zeroed(strlen(path) + 1, 1);
    strcpy(*profile, path);
    profiles_offer(path, (pairs){.count = x->count,
                                 .first = numbers_of(path, x, x->count),
                                 .second = numbers_of(path, value, x->count),
                                 .column = value->name});
}

/* ---- Loads ---- */

/* Counts the loads that lists and numbers, which stay the same, make. */
static size_t count_loads(const char *path, const node *loads)
{
    size_t count = 0;
    for (size_t i = 0; i < loads->count; i++) {
        const node *column = &loads->part[i];
        if (column->kind == NODE_LIST && count != 0 && column->count != count)
            failure("%s: loads: %s has %zu numbers, and another one %zu", path, column->name,
                    column->count, count);
        if (column->kind == NODE_LIST && column->count == 0)
            failure("%s: loads: %s is empty", path, column->name);
        count = column->kind == NODE_LIST ? column->count : count;
    }
    return count;
}

static double *load_numbers(const char *path, const node *loads, const char *name, size_t count)
{
    const node *column = node_part(loads, name);
    if (column != NULL && column->kind == NODE_LIST)
        return numbers_of(path, column, count);
    double *number = memory_zeroed(count, sizeof *number);
    if (column != NULL && column->kind != NODE_NUMBER)
        failure("%s: loads: %s: must be a number or a list of numbers", path, name);
    for (size_t i = 0; i < count && column != NULL; i++)
        number[i] = column->number;
    return number;
}

static const case_word *compliance_word(void)
{
    complaint why;
    return case_word_find("loads", "compliance", &why);
}

/* Where one of them is a list, all of them are one load after the other. */
static bool take_list(const char *path, const node *loads, arguments *line)
{
    const size_t count = count_loads(path, loads);
    if (count == 0)
        return false;
    const bool is_driven = node_part(loads, displacement_column) != NULL;
    if (is_driven && node_part(loads, "Q") != NULL)
        failure("%s: loads: Q and displacement: allowed: one of the two", path);
    if (is_driven != (node_part(loads, "compliance") != NULL))
        failure("%s: loads: needs displacement and compliance, or neither", path);
    if (node_part(loads, "P") == NULL || (!is_driven && node_part(loads, "Q") == NULL))
        failure("%s: loads: needs P and Q", path);
    const bool is_guided = node_part(loads, "tilt") != NULL;
    if (is_guided && node_part(loads, "M") != NULL)
        failure("%s: loads: M and tilt: allowed: one of the two", path);
    double *P = load_numbers(path, loads, "P", count), *M = load_numbers(path, loads, "M", count),
           *Q = load_numbers(path, loads, "Q", count),
           *sigma = load_numbers(path, loads, "sigma", count),
           *tilt = load_numbers(path, loads, "tilt", count),
           *displacement = load_numbers(path, loads, displacement_column, count);
    load *to = memory_zeroed(count, sizeof *to);
    for (size_t i = 0; i < count; i++)
        to[i] = (load){.P = P[i],
                       .M = M[i],
                       .Q = Q[i],
                       .sigma = sigma[i],
                       .is_guided = is_guided,
                       .tilt = tilt[i],
                       .is_driven = is_driven,
                       .displacement = displacement[i]};
    free(P);
    free(M);
    free(Q);
    free(sigma);
    free(tilt);
    free(displacement);
    if (is_driven && !history_is_given(line))
        set_option(path, line, compliance_word(), node_part(loads, "compliance"));
    if (!history_is_given(line))
        load_history_offer(path, units_of(line), to, count);
    free(to);
    return true;
}

/* ---- What is asked ---- */

/* A list is a range as an option has it. */
static char *words_of(const char *path, const node *value)
{
    if (value->kind != NODE_LIST) {
        char *words = node_words(value);
        if (words == NULL)
            failure("%s: asked: %s: must be a number, a text, true, or a list", path, value->name);
        return words;
    }
    char *all = memory_zeroed(value->count * (NUMBER_SIZE + 1) + 1, 1);
    const size_t size = value->count * (NUMBER_SIZE + 1) + 1;
    for (size_t i = 0, used = 0; i < value->count; i++) {
        char *words = node_words(&value->part[i]);
        if (words == NULL || strlen(words) > NUMBER_SIZE)
            failure("%s: asked: %s: must be a list of numbers", path, value->name);
        used += (size_t)snprintf(all + used, size - used, "%s%s", i > 0 ? "," : "", words);
        free(words);
    }
    return all;
}

static void take_asked(const char *path, const node *asked, const char *command_name,
                       arguments *line)
{
    const node *its = node_part(asked, "command"), *options = node_part(asked, "options");
    for (size_t i = 0; i < asked->count; i++)
        if (&asked->part[i] != its && &asked->part[i] != options)
            failure("%s: asked: %.60s: unknown; allowed: command, options", path,
                    asked->part[i].name);
    if (its == NULL || its->kind != NODE_TEXT || options == NULL || options->kind != NODE_OBJECT)
        failure("%s: asked: must have command, a text, and options, an object", path);
    const bool is_of_any = command_name == NULL;
    for (size_t i = 0; i < options->count && (is_of_any || strcmp(its->text, command_name) == 0);
         i++) {
        const node *value = &options->part[i];
        const int number = case_option_asked(line, value->name);
        const char *nearest = arguments_nearest(line->grammar, value->name);
        if (number == 0 && is_of_any)
            continue;
        if (number == 0)
            failure("%s: asked: %.60s: no option of %s that a case may have%s%s", path, value->name,
                    command_name, nearest != NULL ? "; the nearest is " : "",
                    nearest != NULL ? nearest : "");
        if (line->value[number] == NULL && !(value->kind == NODE_FLAG && value->number == 0))
            line->value[number] =
                value->kind == NODE_FLAG ? memory_zeroed(1, 1) : words_of(path, value);
    }
}

/* ---- All ---- */

static void take_group(const char *path, const char *group, const node *all, arguments *line)
{
    complaint why;
    if (all->kind != NODE_OBJECT)
        failure("%s: %s: must be an object", path, group);
    for (size_t i = 0; i < all->count; i++)
        if (case_word_find(group, all->part[i].name, &why) == NULL)
            failure("%s: %s", path, why.text);
    if (strcmp(group, "loads") == 0 && take_list(path, all, line))
        return;
    if (strcmp(group, "loads") == 0 && node_part(all, "tilt") != NULL)
        failure("%s: loads: tilt: is of lists; of one load it stands in the pad", path);
    if (strcmp(group, "loads") == 0 && node_part(all, displacement_column) != NULL)
        failure("%s: loads: displacement: is of lists", path);
    for (size_t i = 0; i < all->count; i++) {
        const case_word *word = case_word_find(group, all->part[i].name, &why);
        const bool is_replaced = strcmp(group, "loads") == 0 && history_is_given(line);
        if (word->kind != WORD_NUMBERS && !is_replaced)
            set_option(path, line, word, &all->part[i]);
    }
    if (strcmp(group, "pad") == 0)
        take_places(path, all, line);
}

static void take_material(const char *path, const node *value, arguments *line)
{
    const int number = arguments_number(line, "material");
    if (value->kind != NODE_TEXT && value->kind != NODE_OBJECT)
        failure("%s: material: must be a name, or an object of constants", path);
    if (number == 0 || line->value[number] != NULL)
        return;
    line->value[number] = value->kind == NODE_TEXT ? node_words(value) : node_written(value);
}

static void take_part(const char *path, const node *part, const char *command_name, arguments *line)
{
    complaint why;
    const char *name = part->name;
    if (strcmp(name, case_version_name) == 0 || strcmp(name, "name") == 0)
        return;
    if (case_group_exists(name))
        take_group(path, name, part, line);
    else if (strcmp(name, "material") == 0)
        take_material(path, part, line);
    else if (strcmp(name, "asked") == 0 && part->kind == NODE_OBJECT)
        take_asked(path, part, command_name, line);
    else {
        const case_word *word = case_word_find("", name, &why);
        if (word == NULL)
            failure("%s: %s", path, why.text);
        set_option(path, line, word, part);
    }
}

/* The word of a command of any case is its file. */
static void take_operand(arguments *line, int option)
{
    if (line->operand == NULL || line->operand[0] == NULL)
        return;
    if (line->value[option] != NULL)
        usage_error("%s: given together with --case; allowed: one of the two", line->operand[0]);
    if (line->operand[1] != NULL)
        usage_error("%s: unexpected; allowed: one case file", line->operand[1]);
    line->value[option] = memory_zeroed(strlen(line->operand[0]) + 1, 1);
    strcpy(line->value[option], line->operand[0]);
    line->operand = NULL;
}

void case_file_take(const char *command_name, arguments *line)
{
    const int option = arguments_number(line, "case");
    complaint why;
    if (command_name == NULL)
        take_operand(line, option);
    const char *path = option != 0 ? line->value[option] : NULL;
    if (path == NULL)
        return;
    const node *top = document_read(path), *version = node_part(top, case_version_name);
    const bool has_version = version != NULL && version->kind == NODE_NUMBER;
    if (!case_version_check(has_version ? version->number : NAN, &why))
        failure("%s: %s", path, why.text);
    for (int loads = 0; loads < 2; loads++) /* these come last: a width divides them */
        for (size_t i = 0; i < top->count; i++)
            if ((strcmp(top->part[i].name, "loads") == 0) == (loads == 1))
                take_part(path, &top->part[i], command_name, line);
}
