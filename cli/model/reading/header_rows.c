/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The rows below a header: their numbers, and those that nothing uses. */
#include "reading.h"

#include <stdio.h>
#include <string.h>
#include <strings.h>

/* ---- Cells ---- */

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
    const bool is_comma = decimal_sign == ',';
    const bool has_other =
        names->how->is_command && number_read_cell(text, is_comma ? '.' : ',', value);
    return complain(why, "%s %.60s: must be a number, with a decimal %s%s", column_name, text,
                    is_comma ? "comma" : "point",
                    !has_other ? ""
                    : is_comma ? "; allowed without --decimal-comma"
                               : "; --decimal-comma reads a comma");
}

/* ---- Numbers that are needed ---- */

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
    while (length > 0 && strchr(" \t", text[length - 1]) != NULL)
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

/* ---- Columns that nothing uses ---- */

/* The number may have either decimal sign, or be in percent: a column that is not read has not been
 * checked. */
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

/* ---- A row that is a load ---- */

const char displacement_column[] = "displacement";

/* Finds the column by which loads are driven. What a file has for Q besides was measured. */
static bool find_displacement(header *names, complaint *why)
{
    if (!header_column(names, displacement_column, &names->displacement, why))
        return false;
    const bool is_there = names->displacement < names->count,
               is_needed = names->how->is_driven || names->how->is_measured;
    if (is_there && is_needed)
        return header_need(names, names->displacement, displacement_column, "length", SHARE_NONE,
                           NEED_NUMBER, why);
    names->displacement = names->count;
    if (!is_needed && (!is_there || header_has_input(names, INPUT_Q)))
        return true;
    if (is_there)
        return complain(why,
                        "column Q: missing; a displacement in its place needs the compliance "
                        "of the rig%s",
                        names->how->is_command ? ", --compliance, 0 where it is stiff" : "");
    complain(why, names->how->is_measured
                      ? "column displacement: missing; a loop needs P, Q and displacement"
                      : "column displacement: missing; with a compliance loads have it in place "
                        "of Q");
    header_write_names(names, why);
    return false;
}

/* Whether the displacement stands in the place of the Q of a file, which was measured, if it is
 * there at all. */
static bool is_driven(const header *names)
{
    return names->how->is_driven && names->displacement < names->count;
}

bool load_header_find(header *names, complaint *why)
{
    if (!header_find(INPUT_TILT, INPUT_SIGMA + 1, NULL, names, why) ||
        !find_displacement(names, why))
        return false;
    if (header_has_input(names, INPUT_TILT) && header_has_input(names, INPUT_M))
        return complain(why, "column tilt: given together with column M; allowed: one of the two, "
                             "or another name");
    if (is_driven(names) && header_has_input(names, INPUT_Q))
        names->needed[names->column[INPUT_Q]] = NEED_NOTHING;
    if (header_has_input(names, INPUT_P) &&
        (header_has_input(names, INPUT_Q) ||
         (names->displacement < names->count && !names->how->is_measured)))
        return true;
    complain(why, "column %s: missing; a history needs P and Q%s",
             header_has_input(names, INPUT_P) ? "Q" : "P", header_hint(names->name, names->count));
    if (names->how->is_command)
        header_write_names(names, why);
    return false;
}

/* Moment and tension are 0 where they have no column. A tilt stands in place of a moment. */
bool load_row_read(const header *names, const char *const cells[], size_t count, char separator,
                   char decimal_sign, load *to, complaint *why)
{
    double value[INPUT_COUNT] = {0};
    if (!header_fits(names->count, count, separator, why))
        return false;
    for (int i = INPUT_TILT; i <= INPUT_SIGMA; i++)
        if (header_has_input(names, i) && !(i == INPUT_Q && is_driven(names)) &&
            !header_cell(names, cells, names->column[i], input_kinds[i].column, decimal_sign,
                         &value[i], why))
            return false;
    double displacement = 0;
    const bool has_one = names->displacement < names->count;
    if (has_one && !header_cell(names, cells, names->displacement, displacement_column,
                                decimal_sign, &displacement, why))
        return false;
    *to = (load){.P = value[INPUT_P],
                 .M = value[INPUT_M],
                 .Q = value[INPUT_Q],
                 .sigma = value[INPUT_SIGMA],
                 .is_guided = header_has_input(names, INPUT_TILT),
                 .tilt = value[INPUT_TILT],
                 .is_driven = is_driven(names),
                 .displacement = displacement};
    return true;
}
