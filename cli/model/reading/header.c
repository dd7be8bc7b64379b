/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "reading.h"

#include <stdio.h>
#include <string.h>
#include <strings.h>

/* ---- Columns that are inputs ---- */

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
    *names = (header){.name = name, .count = count, .how = how != NULL ? how : &plain};
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

bool header_has_numbers(const header *names, const char *const cells[], size_t count,
                        char decimal_sign)
{
    bool any = false;
    double number;
    for (size_t i = 0; i < names->count; i++) {
        if (names->needed[i] == NEED_NOTHING)
            continue;
        if (i >= count || !number_read_cell(cells[i], decimal_sign, &number))
            return false;
        any = true;
    }
    return any;
}

static bool is_missing(const char *text, column_need need, char decimal_sign)
{
    static const char *const marks[] = {"", "nan", "na", "n/a", "#n/a"};
    char bare[8];
    double number;
    text += strspn(text, " \t");
    size_t length = strlen(text);
    while (length > 0 && is_blank_char(text[length - 1]))
        length--;
    snprintf(bare, sizeof bare, "%.*s", (int)length, text);
    for (size_t i = 0; i < sizeof marks / sizeof marks[0]; i++)
        if (length < sizeof bare && strcasecmp(bare, marks[i]) == 0)
            return true;
    return need == NEED_NUMBER && number_read_cell(text, decimal_sign, &number) && number == -9999;
}

size_t header_missing(const header *names, const char *const cells[], char decimal_sign)
{
    size_t i = 0;
    while (i < names->count && (names->needed[i] == NEED_NOTHING ||
                                !is_missing(cells[i], (column_need)names->needed[i], decimal_sign)))
        i++;
    return i;
}

void header_write_names(const header *names, complaint *why)
{
    char list[260] = "";
    double number;
    if (names->count > 0 && number_read_cell(names->name[0], '.', &number))
        return; /* no names */
    for (size_t i = 0; i < names->count && strlen(list) < 200; i++)
        list_add(list, sizeof list, ", ", "'%.40s'", names->name[i]);
    list_add(why->text, sizeof why->text, "", "; the names there: %s%s", list,
             names->how->is_command ? "; --column NAME='THEIR NAME' takes one" : "");
}

/* ---- Columns that are probably meant for an input ---- */

/* Other usual names of inputs. Where the input is given by its own name too, they are columns like
 * any other. */
static const struct {
    int input;
    const char *names; /* separated by blanks */
} synonyms[] = {
    /* the Greek letter, and the sign for micro, which keyboards have */
    {INPUT_F, "mu \xce\xbc \xc2\xb5 friction friction_coefficient coefficient_of_friction cof"},
    {INPUT_Q, "tangential_force tangential_load shear_force shear_load"},
    {INPUT_M, "moment"},
    {INPUT_SIGMA, "bulk_tension bulk_stress \xcf\x83"},
    {INPUT_P, "load force normal_force normal_load"},
    {INPUT_YIELD_STRESS, "sigma_y \xcf\x83y Sy Re ReH Rp0.2 yield yield_strength"},
    {INPUT_K, "tau_y \xcf\x84y"},
    {INPUT_E1, "E youngs_modulus"},
    {INPUT_NU1, "nu \xce\xbd \xce\xbd\x31 poissons_ratio poisson"},
    {INPUT_NU2, "\xce\xbd\x32"},
    {INPUT_THETA, "\xce\xb8 angle"},
    {INPUT_RADIUS, "R"},
};

/* Where inputs come from that may stand for a column. */
typedef struct {
    const header *names;
    int first, end; /* of the wanted inputs */
    const input_texts *options;
} sources;

/* Whether the input is given, or its alternative is, as the radius for a. */
static bool is_given_somehow(const sources *from, int input)
{
    const int ways[] = {input, input_alternative(input)};
    for (int i = 0; i < 2; i++)
        if (ways[i] >= 0 && (header_has_input(from->names, ways[i]) ||
                             (from->options != NULL && from->options->text[ways[i]] != NULL)))
            return true;
    return false;
}

/* The input whose name this nearly is: "Yield stress" and " f" are slips. But p beside P, or F
 * beside f, may be another thing; so is what stands beside the input's own column. */
static int slip_for(const sources *from, const char *name, size_t length)
{
    for (int i = from->first; i < from->end; i++) {
        const char *column = input_kinds[i].column;
        if (header_has_input(from->names, i) || !column_name_is_like(name, length, column))
            continue;
        if (column[1] != '\0' || memchr(name, column[0], length) != NULL ||
            !is_given_somehow(from, i))
            return i;
    }
    return INPUT_COUNT;
}

/* Whether one of the names, separated by blanks, is like this one. */
static bool is_among(const char *names, const char *name, size_t length)
{
    for (size_t own; *names != '\0'; names += own + (names[own] == ' ')) {
        char one_name[COLUMN_NAME_SIZE];
        own = strcspn(names, " ");
        snprintf(one_name, sizeof one_name, "%.*s", (int)own, names);
        if (column_name_is_like(name, length, one_name))
            return true;
    }
    return false;
}

static int synonym_for(const sources *from, const char *name, size_t length)
{
    for (size_t i = 0; i < sizeof synonyms / sizeof synonyms[0]; i++) {
        const int input = synonyms[i].input;
        if (input >= from->first && input < from->end && !is_given_somehow(from, input) &&
            is_among(synonyms[i].names, name, length))
            return input;
    }
    return INPUT_COUNT;
}

/* Whether it is the name that stands for another one. */
static bool is_given_name(const header *names, const char *name)
{
    for (int i = 0; i < INPUT_COUNT; i++) {
        size_t length;
        const char *given = name_for(names->how, input_kinds[i].column, &length);
        const size_t minus = given != NULL && given[0] == '-' ? 1 : 0;
        if (given != NULL && (is_exactly(name, strlen(name), given, length) ||
                              is_exactly(name, strlen(name), given + minus, length - minus)))
            return true;
    }
    return false;
}

/* If a column that is meant for an input passed through, nobody would notice: friction, for one, is
 * 0 by default. */
static bool check_other(const sources *from, const char *name, complaint *why)
{
    char plain[COLUMN_NAME_SIZE];
    const size_t length = column_name_make_plain(name, plain), stem = column_name_stem(plain);
    int meant = slip_for(from, plain, length); /* "theta (deg)" is theta_deg */
    const bool has_unit = meant == INPUT_COUNT && stem < length;
    if (has_unit)
        meant = slip_for(from, plain, stem);
    const bool slip = meant < INPUT_COUNT;
    if (!slip)
        meant = synonym_for(from, plain, stem);
    if (meant == INPUT_COUNT)
        return true;
    complain(why, "column '%.60s': allowed: %s%s%s", name, input_kinds[meant].column,
             has_unit && meant == INPUT_THETA ? " in radians or theta_deg" : "",
             slip ? "" : ", or another name if it is something else");
    if (!from->names->how->is_command)
        return false;
    list_add(why->text, sizeof why->text, "; ", "--column %s='%.60s' takes it",
             input_kinds[meant].column, name);
    return false;
}

static const char label_names[] = LABEL_NAMES;

/* A column that says which row it is, not what is computed. A capital T may be a force. */
static bool is_label(const char *name)
{
    char plain[COLUMN_NAME_SIZE];
    column_name_make_plain(name, plain);
    const size_t stem = column_name_stem(plain);
    return is_among(label_names, plain, stem) ||
           (is_among("t", plain, stem) && memchr(plain, 't', stem) != NULL);
}

void header_note_labels(header *names)
{
    for (size_t i = 0; i < names->count; i++)
        names->is_used[i] = names->is_used[i] || is_label(names->name[i]);
}

bool header_find(int first, int end, const input_texts *options, header *names, complaint *why)
{
    const sources from = {names, first, end, options};
    for (int i = first; i < end; i++) {
        const input_kind *kind = &input_kinds[i];
        if (i == INPUT_TILT) /* the column of this name is a result */
            continue;
        if (!header_column(names, kind->column, &names->column[i], why))
            return false;
        if (names->column[i] == names->count)
            continue;
        names->is_used[names->column[i]] = true;
        if (i != INPUT_PROFILE && !header_need(names, names->column[i], kind->column, kind->unit,
                                               kind->of, NEED_NUMBER, why))
            return false;
    }
    for (size_t i = 0; i < names->count; i++) {
        const bool is_input = header_is_input(names, i);
        if (!is_input && !is_given_name(names, names->name[i]) &&
            !check_other(&from, names->name[i], why))
            return false;
    }
    header_note_labels(names);
    return true;
}

/* ---- Columns that nothing uses ---- */

/* With either decimal sign, or in percent: a column that is not read has not been checked. */
static bool looks_like_number(const char *text)
{
    char bare[40];
    double number;
    const size_t length = strcspn(text, "%");
    if (length >= sizeof bare || (text[length] != '\0' && text[length + 1] != '\0'))
        return false;
    snprintf(bare, sizeof bare, "%.*s", (int)length, text);
    return number_read_cell(bare, '.', &number) || number_read_cell(bare, ',', &number);
}

void header_note_unused(header *names, const char *const cells[])
{
    for (size_t i = 0; i < names->count; i++)
        if (!names->is_used[i] && !names->has_number[i])
            names->has_number[i] = looks_like_number(cells[i]);
}

void header_write_unused(const header *names, char *text, size_t size)
{
    char list[400] = "";
    for (size_t i = 0; i < names->count; i++)
        if (names->has_number[i])
            list_add(list, sizeof list, ", ", "'%.60s'", names->name[i]);
    if (list[0] != '\0')
        list_add(text, size, "; ", "columns with numbers that are not used: %s", list);
}

/* ---- Rows ---- */

bool header_fits(size_t columns, size_t cells, char separator, complaint *why)
{
    if (cells == columns)
        return true;
    return complain(
        why, "%zu cells in this row, %zu in the header%s", cells, columns,
        cells > columns && separator == ','
            ? "; with decimal commas, separate the cells by ';' and give --decimal-comma"
            : "");
}

const char *header_hint(const char *const name[], size_t count)
{
    double number;
    if (count != 1)
        return count > 1 && number_read_cell(name[0], '.', &number)
                   ? "; the first row has numbers, where the names of the columns must be"
                   : "";
    if (strchr(name[0], ';') != NULL)
        return "; the columns seem to be separated by ';': --decimal-comma reads that, or, where "
               "numbers have a point, a first line \"sep=;\"";
    if (strchr(name[0], ',') != NULL)
        return "; the columns seem to be separated by ',': leave --decimal-comma out";
    return strchr(name[0], '\t') != NULL
               ? "; the columns seem to be separated by tabs; allowed: commas"
               : "";
}

bool header_cell(const header *names, const char *const cells[], size_t column,
                 const char *column_name, char decimal_sign, double *value, complaint *why)
{
    const char *text = cells[column];
    if (number_read_cell(text, decimal_sign, value)) {
        *value *= names->factor[column];
        return true;
    }
    if (text[strspn(text, " \t")] == '\0')
        return complain(why, "%s: the cell is empty", column_name);
    return complain(why, "%s %.60s: must be a number, with a decimal %s", column_name, text,
                    decimal_sign == ',' ? "comma" : "point");
}

/* ---- A row that is a load ---- */

bool load_header_find(header *names, complaint *why)
{
    if (!header_find(INPUT_P, INPUT_SIGMA + 1, NULL, names, why))
        return false;
    if (header_has_input(names, INPUT_P) && header_has_input(names, INPUT_Q))
        return true;
    complain(why, "column %s: missing; a history needs P and Q%s",
             header_has_input(names, INPUT_P) ? "Q" : "P", header_hint(names->name, names->count));
    if (names->how->is_command)
        header_write_names(names, why);
    return false;
}

/* Moment and tension are 0 where they have no column. */
bool load_row_read(const header *names, const char *const cells[], size_t count, char separator,
                   char decimal_sign, load *to, complaint *why)
{
    double value[INPUT_COUNT] = {0};
    if (!header_fits(names->count, count, separator, why))
        return false;
    for (int i = INPUT_P; i <= INPUT_SIGMA; i++)
        if (header_has_input(names, i) &&
            !header_cell(names, cells, names->column[i], input_kinds[i].column, decimal_sign,
                         &value[i], why))
            return false;
    *to = (load){value[INPUT_P], value[INPUT_M], value[INPUT_Q], value[INPUT_SIGMA]};
    return true;
}
