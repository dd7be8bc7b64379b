/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Where the header of a table is, and how its cells are separated, is found by trying: the rows at
 * the beginning of the file are read with each separator, until there is one row under whose names
 * numbers stand. */
#include "input.h"

#include <inttypes.h>
#include <stdio.h>
#include <string.h>

enum { BELOW = 4, LINES = 200 + BELOW };

/* The rows at the beginning, but comments. */
typedef struct {
    size_t count;
    csv_row row[LINES];
} beginning;

/* How names come: in a row; in a row that begins with #; in none, places or usual names stand for
 * them. */
typedef enum { NAMED, COMMENTED, PLACED, USUAL, MODES } naming_mode;

typedef struct {
    char separator;
    naming_mode mode;
    int64_t line, again, units; /* of the names, of others, of their units; 0 for none */
} finding;

/* ---- Rows at the beginning ---- */

static bool is_comment(const csv_row *row)
{
    return row->whole[strspn(row->whole, " \t")] == '#';
}

static bool begin_with(table_input *t, char separator, bool comments, beginning *to)
{
    to->count = 0;
    if (!csv_input_scan(t->in, separator))
        return false;
    while (to->count < LINES && csv_input_next(t->in) && t->in->row.line <= LINES)
        if (comments || !is_comment(&t->in->row))
            csv_row_keep(t->in, &to->row[to->count++]);
    return to->count > 0;
}

static void forget(beginning *all)
{
    while (all->count > 0)
        csv_row_free(&all->row[--all->count]);
}

/* ---- Names ---- */

/* "# P,Q" and "# P Q": the names behind the sign. */
static void take_sign_off(csv_row *row)
{
    if (row->count == 0) /* misplaced quotes */
        return;
    const char *name = row->cell[0] + strspn(row->cell[0], " \t");
    name += *name == '#' ? 1 : 0;
    row->cell[0] = name + strspn(name, " \t");
    if (row->cell[0][0] != '\0' || row->count < 2)
        return;
    row->count--;
    memmove(row->cell, row->cell + 1, row->count * sizeof *row->cell);
}

/* "1", "2" and so on, for columns that are given by their places. */
static const char *const *place_names(void)
{
    static char text[HEADER_COLUMNS][12]; /* of any int */
    static const char *names[HEADER_COLUMNS];
    for (int i = 0; i < HEADER_COLUMNS && names[HEADER_COLUMNS - 1] == NULL; i++) {
        snprintf(text[i], sizeof text[i], "%d", i + 1);
        names[i] = text[i];
    }
    return names;
}

static bool gives_places(const char *columns)
{
    for (const char *line = columns; line != NULL; line = strchr(line, '\n')) {
        line += *line == '\n' ? 1 : 0;
        const char *place = line + strcspn(line, "=");
        place += place[0] == '=' && place[1] == '-' ? 1 : 0; /* the sign is turned */
        const size_t length =
            *place != '\n' && *place != '\0' ? strspn(place + 1, "0123456789") : 0;
        if (length > 0 && (place[1 + length] == '\0' || place[1 + length] == '\n'))
            return true;
    }
    return false;
}

/* The names of a row in this mode; NULL where there are none. */
static const char *const *names_of(const table_input *t, const csv_row *row, naming_mode mode)
{
    if (mode == PLACED)
        return gives_places(t->how.columns) ? place_names() : NULL;
    if (mode == USUAL)
        return t->wanted.usual != NULL ? t->wanted.usual(row->count) : NULL;
    return row->cell;
}

static bool find(table_input *t, const char *const *names, size_t count, naming *how,
                 complaint *why)
{
    header_begin(names, count, how, &t->names);
    return t->wanted.find(t->wanted.context, &t->names, why);
}

/* ---- Is it the header? ---- */

/* Whether a row has units where numbers are needed. */
static bool is_unit_row(const header *names, const csv_row *row)
{
    measuring_unit known;
    size_t needed = 0;
    if (row->count != names->count)
        return false;
    for (size_t i = 0; i < names->count; i++) {
        const char *text = row->cell[i] + strspn(row->cell[i], " \t[(");
        char bare[COLUMN_NAME_SIZE];
        snprintf(bare, sizeof bare, "%.*s", (int)strcspn(text, "])"), text);
        if (names->needed[i] == NEED_NOTHING)
            continue;
        needed++;
        if (!unit_read(bare, &known) && strcmp(bare, "-") != 0)
            return false;
    }
    return needed > 0;
}

static bool has_numbers(const table_input *t, const csv_row *row)
{
    return header_has_numbers(&t->names, row->cell, row->count, t->decimal_sign);
}

static size_t numbers_in(const csv_row *row, char decimal_sign)
{
    size_t numbers = 0;
    double number;
    for (size_t i = 0; i < row->count; i++)
        numbers += number_read_cell(row->cell[i], decimal_sign, &number) ? 1 : 0;
    return numbers;
}

/* Whether the rows without names begin with row i. A row of as many cells above it has names, which
 * are not the usual ones. A mistake in the first row leaves it the first one, if the next is of
 * numbers. */
static bool is_first_unnamed(const table_input *t, const beginning *all, size_t i)
{
    const csv_row *row = &all->row[i];
    if (i > 0 && all->row[i - 1].count == row->count)
        return false;
    return has_numbers(t, row) ||
           (numbers_in(row, t->decimal_sign) > 0 && i + 1 < all->count &&
            all->row[i + 1].count == row->count && has_numbers(t, &all->row[i + 1]));
}

/* Whether row i has the names, and numbers stand below it, or in it where it has no names. */
static bool is_header(table_input *t, const beginning *all, size_t i, naming_mode mode,
                      int64_t *units)
{
    naming how = t->how;
    complaint why;
    const csv_row *row = &all->row[i];
    const bool is_of_names = mode == NAMED || mode == COMMENTED;
    const char *const *names = names_of(t, row, mode);
    how.takes_any_unit = true; /* what is wrong with a unit is said when the header is known */
    *units = 0;
    if (names == NULL || row->malformed ||
        (is_of_names ? numbers_in(row, t->decimal_sign) == row->count : row->count == 0) ||
        (mode == COMMENTED) != is_comment(row) || !find(t, names, row->count, &how, &why))
        return false;
    if (mode == USUAL)
        return is_first_unnamed(t, all, i);
    if (mode == PLACED)
        return has_numbers(t, row);
    for (size_t j = i + 1; j < all->count && j <= i + BELOW; j++) {
        if (has_numbers(t, &all->row[j]))
            return true;
        if (j == i + 1 && is_unit_row(&t->names, &all->row[j]))
            *units = all->row[j].line;
    }
    return false;
}

static bool look(table_input *t, char separator, naming_mode mode, finding *to)
{
    static beginning all;
    int64_t units;
    *to = (finding){.separator = separator, .mode = mode};
    begin_with(t, separator, mode == COMMENTED, &all);
    for (size_t i = 0; i < all.count; i++) {
        if (mode == COMMENTED && is_comment(&all.row[i]))
            take_sign_off(&all.row[i]);
        if (!is_header(t, &all, i, mode, &units))
            continue;
        if (to->line != 0) {
            to->again = all.row[i].line;
            break;
        }
        to->line = all.row[i].line;
        to->units = units;
        if (mode != NAMED)
            break;
    }
    forget(&all);
    return to->line != 0;
}

/* ---- Where there is none ---- */

/* The numbers in a row, whichever decimal sign they have. */
static size_t numbers_of_either(const csv_row *row)
{
    const size_t points = numbers_in(row, '.'), commas = numbers_in(row, ',');
    return points > commas ? points : commas;
}

static bool has_most_numbers(const csv_row *row)
{
    return row->count > 1 && numbers_of_either(row) * 2 > row->count;
}

/* Whether row i is one of numbers, and the next one too: a preamble has lines such as "Samples 60
 * 60". */
static bool is_of_numbers(const beginning *all, size_t i)
{
    const csv_row *row = &all->row[i];
    return has_most_numbers(row) &&
           (i + 1 == all->count || (row[1].count == row->count && has_most_numbers(&row[1])));
}

/* The separator that makes most rows of numbers: a comma in 12,000 separates nothing where another
 * does. The first of equals. */
static char probable_separator(table_input *t, const char *separators, int count)
{
    static beginning all;
    size_t most = 0;
    char best = separators[0];
    for (int i = 0; i < count; i++) {
        size_t rows = 0;
        begin_with(t, separators[i], false, &all);
        for (size_t j = 0; j < all.count; j++)
            rows += is_of_numbers(&all, j) ? 1 : 0;
        forget(&all);
        best = rows > most ? separators[i] : best;
        most = rows > most ? rows : most;
    }
    return best;
}

/* Whether most cells of a row are units, known or in brackets. */
static bool is_of_units(const csv_row *row)
{
    measuring_unit known;
    size_t units = 0;
    for (size_t i = 0; i < row->count; i++) {
        const char *text = row->cell[i] + strspn(row->cell[i], " \t");
        units += text[0] != '\0' && (strchr("[(", text[0]) != NULL || unit_read(text, &known));
    }
    return units * 2 > row->count;
}

/* The line that probably has the names: the next one above the first row of numbers that has
 * neither a number nor units. */
static void guess(table_input *t, char separator, finding *to)
{
    static beginning all;
    size_t i = 0;
    *to = (finding){.separator = separator};
    begin_with(t, separator, false, &all);
    while (i < all.count && !is_of_numbers(&all, i))
        i++;
    if (all.count > 0 && i == 0 && gives_places(t->how.columns))
        to->mode = PLACED;
    i = i < all.count ? i : 0; /* there are no numbers */
    while (i > 0 && (numbers_of_either(&all.row[i]) > 0 || is_of_units(&all.row[i])))
        i--;
    if (all.count > 0)
        to->line = all.row[i].line;
    forget(&all);
}

static finding find_header(table_input *t)
{
    const char usual = t->decimal_sign == ',' ? ';' : ',';
    finding found = {.separator = usual};
    if (!csv_input_scan(t->in, usual))
        return found;
    const char first = csv_input_guess(t->in, usual);
    const char separators[] = {first, usual, '\t', ';', CSV_BLANKS};
    const int count = csv_input_names_separator(t->in) ? 1 : (int)sizeof separators;
    for (int mode = NAMED; mode < MODES; mode++)
        for (int i = 0; i < count; i++)
            if (look(t, separators[i], (naming_mode)mode, &found))
                return found;
    guess(t, probable_separator(t, separators, count), &found);
    return found;
}

/* ---- Opening ---- */

/* Reads up to the row of that line, which is kept. */
static bool keep_line(table_input *t, int64_t line, csv_row *row)
{
    bool there = csv_input_next(t->in);
    if (t->first_line == 0)
        t->first_line = t->in->row.line;
    while (there && t->in->row.line < line)
        there = csv_input_next(t->in);
    if (t->in->problem.text[0] != '\0')
        return false;
    if (!there || t->in->row.malformed)
        return csv_input_stop(t->in, "%s; needed: a header row with the names of the columns",
                              there ? "misplaced quotes in the first row" : "empty");
    csv_row_keep(t->in, row);
    return true;
}

static void say_what_was_passed(table_input *t, const finding *found)
{
    if (found->mode == PLACED || found->mode == USUAL) {
        if (found->line > 1)
            complain(&t->remark, "numbers from line %" PRId64 " on", found->line);
    } else if (t->first_line != found->line) {
        complain(&t->remark, "header in line %" PRId64, found->line);
    }
    if (found->units != 0)
        list_add(t->remark.text, sizeof t->remark.text, ", ", "units in line %" PRId64,
                 found->units);
}

static bool take_header(table_input *t, const finding *found)
{
    complaint why;
    if (found->again != 0)
        return csv_input_stop(t->in,
                              "the header is in line %" PRId64 " and again in line %" PRId64
                              "; needed: one table",
                              found->line, found->again);
    if (!keep_line(t, found->line, &t->first))
        return false;
    if (found->mode == COMMENTED)
        take_sign_off(&t->first);
    t->is_pending = found->mode == PLACED || found->mode == USUAL;
    if (found->units != 0) {
        if (!keep_line(t, found->units, &t->units))
            return false;
        t->how.unit_row = t->units.cell;
    }
    const char *const *names = names_of(t, &t->first, found->mode);
    if (find(t, names, t->first.count, &t->how, &why))
        return true;
    if (t->first_line == found->line)
        return csv_input_stop(t->in, "%s", why.text);
    return csv_input_stop(t->in, "line %" PRId64 ": %s", found->line, why.text);
}

bool table_open(const char *path, const reading *how, const table_wanted *wanted, table_input *t)
{
    *t = (table_input){.wanted = *wanted, .decimal_sign = how->decimal_sign, .drops = how->drops};
    t->how = (naming){.columns = how->columns,
                      .units = how->units,
                      .is_command = how->is_command,
                      .is_driven = how->is_driven,
                      .is_measured = how->is_measured};
    t->in = csv_input_open(path, how->decimal_sign == ',' ? ';' : ',', how->encoding);
    const finding found = find_header(t);
    csv_input_begin(t->in, found.separator);
    t->in->takes_malformed = true; /* above the header */
    const bool taken = t->in->problem.text[0] == '\0' && take_header(t, &found);
    t->in->takes_malformed = wanted->takes_malformed;
    if (taken)
        say_what_was_passed(t, &found);
    return taken;
}

/* ---- Rows ---- */

/* Whether a row lacks a number; it is counted. */
static bool lacks_number(table_input *t)
{
    const csv_row *row = &t->in->row;
    if (!t->wanted.counts_missing || row->malformed || row->count != t->names.count)
        return false;
    const size_t column = header_missing(&t->names, row->cell, t->decimal_sign);
    if (column == t->names.count)
        return false;
    if (t->missing++ == 0)
        complain(&t->first_missing, "line %" PRId64 ", column %.60s: '%.20s'", row->line,
                 t->names.name[column], row->cell[column]);
    return true;
}

static bool end(table_input *t)
{
    if (t->in->problem.text[0] != '\0' || t->missing == 0)
        return false;
    if (!t->drops)
        return csv_input_stop(t->in, "%zu row%s without a number, the first in %s%s", t->missing,
                              t->missing > 1 ? "s" : "", t->first_missing.text,
                              t->how.is_command ? "; --drop leaves such rows out" : "");
    list_add(t->remark.text, sizeof t->remark.text, ", ",
             "%zu row%s without a number left out, the first in %s", t->missing,
             t->missing > 1 ? "s" : "", t->first_missing.text);
    return false;
}

bool table_next(table_input *t)
{
    for (;;) {
        if (!t->is_pending && !csv_input_next(t->in))
            return end(t);
        t->is_pending = false;
        const csv_row *row = &t->in->row;
        if (is_comment(row) && !(row->count == t->names.count && has_numbers(t, row)))
            continue;
        if (!lacks_number(t))
            return true;
    }
}

void table_close(table_input *t)
{
    csv_row_free(&t->first);
    csv_row_free(&t->units);
    csv_input_close(t->in);
}
