/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "reading.h"

#include <stdio.h>
#include <string.h>

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
    complaint why;
    size_t column;
    return !header_column(names, name, &column, &why) || column < names->count;
}

bool header_column(const header *names, const char *name, size_t *column, complaint *why)
{
    *column = names->count;
    for (size_t i = 0; i < names->count; i++) {
        if (strcmp(names->name[i], name) != 0)
            continue;
        if (*column < i)
            return complain(why, "column %s: there twice; allowed: once", name);
        *column = i;
    }
    return true;
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
    return complain(why, "column '%.60s': allowed: %s%s%s", name, input_kinds[meant].column,
                    has_unit && meant == INPUT_THETA ? " in radians or theta_deg" : "",
                    slip ? "" : ", or another name if it is something else");
}

/* A column that says which row it is, not what is computed. A capital T may be a force. */
static bool is_label(const char *name)
{
    static const char labels[] =
        "case id key line load name no nr number row step time cycle point label node test zeit "
        "n_f";
    char plain[COLUMN_NAME_SIZE];
    column_name_make_plain(name, plain);
    const size_t stem = column_name_stem(plain);
    return is_among(labels, plain, stem) ||
           (is_among("t", plain, stem) && memchr(plain, 't', stem) != NULL);
}

bool header_find(const char *const name[], size_t count, int first, int end,
                 const input_texts *options, header *names, complaint *why)
{
    const sources from = {names, first, end, options};
    *names = (header){.name = name, .count = count};
    for (int i = 0; i < INPUT_COUNT; i++)
        names->column[i] = count;
    for (int i = first; i < end; i++)
        if (!header_column(names, input_kinds[i].column, &names->column[i], why))
            return false;
    for (size_t i = 0; i < count; i++) {
        const bool is_input = header_is_input(names, i);
        if (!is_input && !check_other(&from, name[i], why))
            return false;
        names->is_used[i] = is_input || is_label(name[i]);
    }
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

bool cell_read(const char *text, const char *column, char decimal_sign, double *value,
               complaint *why)
{
    if (number_read_cell(text, decimal_sign, value))
        return true;
    if (text[strspn(text, " \t")] == '\0')
        return complain(why, "%s: the cell is empty", column);
    return complain(why, "%s %.60s: must be a number, with a decimal %s", column, text,
                    decimal_sign == ',' ? "comma" : "point");
}

/* ---- A row that is a load ---- */

bool load_header_find(const char *const name[], size_t count, header *names, complaint *why)
{
    if (!header_find(name, count, INPUT_P, INPUT_SIGMA + 1, NULL, names, why))
        return false;
    if (header_has_input(names, INPUT_P) && header_has_input(names, INPUT_Q))
        return true;
    return complain(why, "column %s: missing; a history needs P and Q%s",
                    header_has_input(names, INPUT_P) ? "Q" : "P", header_hint(name, count));
}

/* Moment and tension are 0 where they have no column. */
bool load_row_read(const header *names, const char *const cells[], size_t count, char separator,
                   char decimal_sign, load *to, complaint *why)
{
    double value[INPUT_COUNT] = {0};
    if (!header_fits(names->count, count, separator, why))
        return false;
    for (int i = INPUT_P; i <= INPUT_SIGMA; i++)
        if (header_has_input(names, i) && !cell_read(cells[names->column[i]], input_kinds[i].column,
                                                     decimal_sign, &value[i], why))
            return false;
    *to = (load){value[INPUT_P], value[INPUT_M], value[INPUT_Q], value[INPUT_SIGMA]};
    return true;
}
