/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The names of the columns of a table, and their units. */
#include "reading.h"

#include <stdio.h>
#include <string.h>

bool header_has_input(const header *names, int input)
{
    return names->column[input] < names->count;
}

bool header_is_input(const header *names, size_t column)
{
    for (int i = 0; i < INPUT_COUNT; i++)
        if (names->column[i] == column)
            return true;
    return false;
}

cell header_cell_written(const header *names, size_t column, const char *text, char decimal_sign)
{
    const bool is_read = header_is_input(names, column) || names->needed[column] != NEED_NOTHING;
    double number;
    return (is_read ? number_read_cell : number_survives)(text, decimal_sign, &number)
               ? (cell){text, number}
               : cell_text(text);
}

bool header_has(const header *names, const char *name)
{
    for (size_t i = 0; i < names->count; i++)
        if (strcmp(names->name[i], name) == 0)
            return true;
    return false;
}

void header_begin(const char *const name[], size_t count, const naming *how, header *names)
{
    static const naming plain = {.columns = NULL};
    *names = (header){
        .name = name, .count = count, .how = how != NULL ? how : &plain, .displacement = count};
    for (int i = 0; i < INPUT_COUNT; i++)
        names->column[i] = count;
    for (size_t i = 0; i < count && i < HEADER_COLUMNS; i++)
        names->factor[i] = 1;
}

/* ---- The column of a name ---- */

/* The name that stands for this one: how long it is, NULL where none was given. */
static const char *name_for(const naming *how, const char *name, size_t *length)
{
    for (const char *line = how->columns; line != NULL && *line != '\0';) {
        const size_t whole = strcspn(line, "\n"), own = strcspn(line, "=");
        if (own < whole && own == strlen(name) && strncmp(line, name, own) == 0) {
            *length = whole - own - 1;
            return line + own + 1;
        }
        line += whole + (line[whole] == '\n');
    }
    return NULL;
}

static bool is_blank_char(char c)
{
    return c == ' ' || c == '\t';
}

/* Whether a name, without the blanks around it, has these letters. */
static bool is_exactly(const char *name, size_t size, const char *wanted, size_t length)
{
    while (size > 0 && is_blank_char(name[0]))
        name++, size--;
    while (size > 0 && is_blank_char(name[size - 1]))
        size--;
    return size == length && strncmp(name, wanted, length) == 0;
}

/* Whether it stands before a unit that is known. */
static bool is_before_unit(const char *name, const char *wanted, size_t length)
{
    char plain[COLUMN_NAME_SIZE], own[COLUMN_NAME_SIZE];
    measuring_unit known;
    column_name_make_plain(name, plain);
    if (strncmp(plain + strspn(plain, " \t"), wanted, length) != 0)
        return false; /* most are no such column: units are not looked at */
    for (int i = 0; i < INPUT_COUNT; i++)
        if (strcmp(plain, input_kinds[i].column) == 0)
            return false; /* theta_deg */
    const size_t stem = column_name_unit(plain, own);
    return stem < strlen(plain) && (own[0] == '\0' || unit_read(own, &known)) &&
           is_exactly(plain, stem, wanted, length);
}

/* The columns of that name; where there is none, those of that name and a unit. */
static bool find_named(const header *names, const char *wanted, size_t length, size_t *column)
{
    bool once = true;
    *column = names->count;
    for (int with_unit = 0; with_unit < 2 && *column == names->count; with_unit++)
        for (size_t i = 0; i < names->count; i++) {
            if (with_unit ? !is_before_unit(names->name[i], wanted, length)
                          : !is_exactly(names->name[i], strlen(names->name[i]), wanted, length))
                continue;
            once = once && *column == names->count;
            *column = i;
        }
    return once;
}

/* How much of a name that was given stands before a unit. */
static size_t stem_of_given(const char *given, size_t length)
{
    char plain[COLUMN_NAME_SIZE], own[COLUMN_NAME_SIZE];
    snprintf(plain, sizeof plain, "%.*s", (int)length, given);
    return column_name_unit(plain, own);
}

/* The columns of a name that was given: "height (um)" has its unit too. */
static bool find_given(const header *names, const char *given, size_t length, size_t *column)
{
    const bool once = find_named(names, given, length, column);
    return *column < names->count ? once
                                  : find_named(names, given, stem_of_given(given, length), column);
}

/* Whether a name was given with a minus before it, which turns the sign of the numbers. */
static bool is_turned(const header *names, const char *name)
{
    size_t length, column;
    const char *given = name_for(names->how, name, &length);
    if (given == NULL || given[0] != '-')
        return false;
    find_given(names, given, length, &column);
    return column == names->count;
}

/* Whether the columns have no names but their places. */
static bool are_places(const header *names)
{
    double number;
    return names->count > 0 && number_read_cell(names->name[0], '.', &number);
}

bool header_column(const header *names, const char *name, size_t *column, complaint *why)
{
    size_t length;
    const char *given = name_for(names->how, name, &length);
    const size_t turned = is_turned(names, name) ? 1 : 0;
    const char *wanted = given != NULL ? given + turned : name;
    length = given != NULL ? length - turned : strlen(name);
    const bool once = given != NULL ? find_given(names, wanted, length, column)
                                    : find_named(names, wanted, length, column);
    if (!once)
        return complain(why, "column %.*s: there twice; allowed: once", (int)length, wanted);
    if (given != NULL && *column == names->count) {
        complain(why, "column %.*s, for %s: missing", (int)length, wanted, name);
        if (are_places(names))
            list_add(why->text, sizeof why->text, "; ", "there are %zu", names->count);
        header_write_names(names, why);
        return false;
    }
    return true;
}

/* ---- Columns that are needed ---- */

/* The unit of a column, from its name or from below it; "" for none. */
static void find_unit(const header *names, size_t column, const char *name,
                      char own[COLUMN_NAME_SIZE])
{
    char plain[COLUMN_NAME_SIZE];
    const char *given;
    size_t length;
    column_name_make_plain(names->name[column], plain);
    own[0] = '\0';
    if (!is_exactly(plain, strlen(plain), name, strlen(name))) /* theta_deg is a name */
        column_name_unit(plain, own);
    if (own[0] == '\0' && (given = name_for(names->how, name, &length)) != NULL) {
        snprintf(plain, sizeof plain, "%.*s", (int)length, given);
        column_name_unit(plain, own);
    }
    if (own[0] != '\0' || names->how->unit_row == NULL)
        return;
    const char *text = names->how->unit_row[column];
    text += strspn(text, " \t[(-");
    snprintf(own, COLUMN_NAME_SIZE, "%.*s", (int)strcspn(text, "])"), text);
}

bool header_need(header *names, size_t column, const char *name, const char *dimension,
                 unit_share of, column_need need, complaint *why)
{
    char own[COLUMN_NAME_SIZE];
    const naming *how = names->how;
    const unit_system *units = how->units != NULL ? how->units : &units_unknown;
    complaint reason;
    names->needed[column] = (unsigned char)need;
    names->is_used[column] = true;
    if (how->takes_any_unit)
        return true;
    find_unit(names, column, name, own);
    if (units_factor(units, own[0] != '\0' ? own : NULL, dimension, of, &names->factor[column],
                     &reason)) {
        names->factor[column] *= is_turned(names, name) ? -1 : 1;
        return true;
    }
    return complain(why, "column '%.60s': %s%s", names->name[column], reason.text,
                    !units->is_known && how->is_command
                        ? ": --units, such as --units mm,N,MPa, converts it"
                        : "");
}

void header_write_names(const header *names, complaint *why)
{
    char list[260] = "";
    if (are_places(names))
        return;
    for (size_t i = 0; i < names->count && strlen(list) < 200; i++)
        list_add(list, sizeof list, ", ", "'%.40s'", names->name[i]);
    list_add(why->text, sizeof why->text, "", "; the names there: %s%s", list,
             names->how->is_command ? "; --column NAME='THEIR NAME' takes one" : "");
}

static bool is_given_for(const header *names, const char *wanted, const char *name)
{
    size_t length;
    const char *given = name_for(names->how, wanted, &length);
    const size_t minus = given != NULL && given[0] == '-' ? 1 : 0;
    return given != NULL && (is_exactly(name, strlen(name), given, length) ||
                             is_exactly(name, strlen(name), given + minus, length - minus));
}

bool header_is_given_name(const header *names, const char *name)
{
    for (int i = 0; i < INPUT_COUNT; i++)
        if (is_given_for(names, input_kinds[i].column, name))
            return true;
    return is_given_for(names, displacement_column, name);
}

const char *header_hint(const char *const name[], size_t count)
{
    double number;
    if (count != 1)
        return count > 1 && number_read_cell(name[0], '.', &number)
                   ? "; the first row has numbers, where the names of the columns must be"
                   : "";
    if (strchr(name[0], '|') != NULL)
        return "; the columns seem to be separated by '|': a first line \"sep=|\" says so";
    if (strchr(name[0], ';') != NULL)
        return "; the columns seem to be separated by ';': --decimal-comma reads that, or, where "
               "numbers have a point, a first line \"sep=;\"";
    if (strchr(name[0], ',') != NULL)
        return "; the columns seem to be separated by ',': leave out --decimal-comma, "
               "and blanks within numbers";
    return strchr(name[0], '\t') != NULL
               ? "; the columns seem to be separated by tabs; allowed: commas"
               : "";
}
