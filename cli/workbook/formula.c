/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "workbook.h"

#include <ctype.h>
#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>

/* ---- Templates ---- */

enum { ARGUMENTS = 4, FORMULA_SIZE = 5000 };

/* What a name, function or number becomes: writes it, and returns its end. */
typedef char *word_writer(char *end, const char *word, size_t length, const void *about);

typedef struct {
    const char *text;
    size_t length;
} argument;

/* The length of the name, function or number that a text begins with; 0 for another character. */
static size_t word_length(const char *text)
{
    size_t length = 0;
    while (isalnum((unsigned char)text[length]) || text[length] == '_')
        length++;
    return length;
}

/* The comma or parenthesis that ends an argument, outside of inner ones and of quotes. */
static const char *end_of(const char *from)
{
    bool quoted = false;
    for (int depth = 0; quoted || depth > 0 || (*from != ',' && *from != ')'); from++) {
        quoted = quoted != (*from == '"');
        if (!quoted)
            depth += (*from == '(') - (*from == ')');
    }
    return from;
}

/* Returns the end of the call. */
static const char *read_arguments(const char *from, argument values[ARGUMENTS])
{
    for (int i = 0; i < ARGUMENTS; i++) {
        const char *end = end_of(from);
        values[i] = (argument){from, (size_t)(end - from)};
        from = end + 1;
        if (*end == ')')
            break;
    }
    return from;
}

/* The argument, with another text in place of each #, unless that is NULL. */
static char *put_argument(char *end, argument from, const char *instead, size_t length)
{
    for (size_t i = 0; i < from.length; i++)
        if (from.text[i] == '#' && instead != NULL)
            end = (char *)memcpy(end, instead, length) + length;
        else
            *end++ = from.text[i];
    return end;
}

static void fill(const char *from, const argument values[ARGUMENTS], char *end)
{
    while (*from != '\0') {
        if (*from != '$') {
            *end++ = *from++;
            continue;
        }
        const argument next = values[from[1] - '1'];
        from += 2;
        const char *instead = *from == '{' ? from + 1 : NULL;
        const size_t length = instead != NULL ? strcspn(instead, "}") : 0;
        end = put_argument(end, next, instead, length);
        from += instead != NULL ? length + 2 : 0;
    }
    *end = '\0';
}

/* The formula of the texts about wrong inputs, as parts of a list. */
static void fill_checks(char *end)
{
    for (int i = 0; i < INPUT_CELLS; i++) {
        const char *name = case_cells[i].column;
        end += sprintf(end, "&IF(rw_%s=\"\",\"", name);
        if (case_cells[i].needed[0] != '\0')
            end += sprintf(end, "; %s is missing", name);
        end += sprintf(end, "\",IF(%s,\"; %s must be %s\",\"\"))", case_cells[i].wrong, name,
                       case_cells[i].must);
    }
}

/* NULL for a name that is not called, or that is none of a template. */
static const formula_template *find_template(const char *name, size_t length)
{
    const formula_template *each = formula_templates;
    if (name[length] != '(')
        return NULL;
    while (each->name != NULL &&
           (strlen(each->name) != length || strncmp(each->name, name, length) != 0))
        each++;
    return each->name != NULL ? each : NULL;
}

/* How words outside of quotes are written. */
typedef struct {
    word_writer *write;
    const void *about;
} writer;

/* Returns the end. */
static char *expand(const char *from, const writer *words, char *end)
{
    bool quoted = false;
    while (*from != '\0') {
        const size_t length = quoted ? 0 : word_length(from);
        const formula_template *called = length > 0 ? find_template(from, length) : NULL;
        if (called != NULL) {
            argument values[ARGUMENTS] = {{NULL, 0}};
            char text[FORMULA_SIZE];
            from = read_arguments(from + length + 1, values);
            if (called->text[0] != '\0')
                fill(called->text, values, text);
            else
                fill_checks(text);
            end = expand(text, words, end);
        } else if (length > 0) {
            end = words->write(end, from, length, words->about);
            from += length;
        } else {
            quoted = quoted != (*from == '"');
            *end++ = *from++;
        }
    }
    *end = '\0';
    return end;
}

/* As it is. */
static char *word_copy(char *end, const char *word, size_t length, const void *about)
{
    (void)about;
    return (char *)memcpy(end, word, length) + length;
}

char *text_copy(const char *text)
{
    const size_t size = strlen(text) + 1;
    return memcpy(memory_zeroed(size, 1), text, size);
}

/* The formula with "=" in front, and what each call stands for. */
static const char *template_expand(const char *formula, word_writer *write, const void *about)
{
    static char room[FORMULA_SIZE] = "=";
    expand(formula, &(writer){write, about}, room + 1);
    return text_copy(room);
}

/* ---- Formulas ---- */

const char *compose(const char *format, ...)
{
    static char room[FORMULA_SIZE];
    va_list values;
    va_start(values, format);
    vsnprintf(room, sizeof room, format, values);
    va_end(values);
    return text_copy(room);
}

const char *column_letters(int column)
{
    if (column >= 26 * 27) /* below column 1378, as all are */
        return compose("%c%c%c", 'A' + column / 676 - 1, 'A' + column / 26 % 26, 'A' + column % 26);
    return column >= 26 ? compose("%c%c", 'A' + column / 26 - 1, 'A' + column % 26)
                        : compose("%c", 'A' + column);
}

/* ---- Formulas of a row ----------------------------------------------------------------------- */

/* Names of three cells side by side: rwt_wn of rwt_wn1 to rwt_wn3. */
static const char *const triples[] = {"rwt_wn", "rwt_wf", "rwt_wt", "rwt_wp", "rwt_s_k", "rwt_b_k"};
enum { TRIPLES = sizeof triples / sizeof triples[0] };

static bool is_named(const char *name, size_t length, const char *cell)
{
    return strncmp(name, cell, length) == 0 && cell[length] == '\0';
}

static int find_cell(const char *name, size_t length)
{
    int cell = 0;
    while (cell < case_cell_count && !is_named(name, length, case_cells[cell].name))
        cell++;
    return cell;
}

static int first_of(const char *triple)
{
    char name[16];
    return find_cell(name, (size_t)snprintf(name, sizeof name, "%s1", triple));
}

/* The cells that a name stands for: the first, and how many; 0 for a name that is none of a
 * case. */
static int find(const char *name, size_t length, int *first)
{
    if (length < 4 || name[0] != 'r' || name[1] != 'w')
        return 0; /* most words of a formula are functions and numbers */
    *first = find_cell(name, length);
    if (*first < case_cell_count)
        return 1;
    for (int i = 0; i < TRIPLES; i++)
        if (is_named(name, length, triples[i])) {
            *first = first_of(triples[i]);
            return 3;
        }
    return 0;
}

/* Where the cells of a row are. */
typedef struct {
    int row;
    column_finder *column_of;
} row_cells;

static char *write_in_row(char *end, const char *name, size_t length, const void *about)
{
    const row_cells *cells = about;
    int first = 0;
    const int count = find(name, length, &first);
    if (count == 0)
        return word_copy(end, name, length, NULL);
    const int column = cells->column_of(first), row = cells->row + 1;
    end += sprintf(end, "$%s%d", column_letters(column), row);
    return count == 1 ? end : end + sprintf(end, ":$%s%d", column_letters(column + count - 1), row);
}

const char *formula_in_row(const char *formula, int row, column_finder *column_of)
{
    return template_expand(formula, write_in_row, &(row_cells){row, column_of});
}

static char *write_number(char *end, const char *name, size_t length, const void *number)
{
    return is_named(name, length, "rwt_i") ? end + sprintf(end, "%d", *(const int *)number)
                                           : word_copy(end, name, length, NULL);
}

const char *formula_at(const char *formula, int number)
{
    return template_expand(formula, write_number, &number);
}

const char *formula_named(const char *formula)
{
    return template_expand(formula, word_copy, NULL);
}

/* ---- Cells ----------------------------------------------------------------------------------- */

void formula_cell(xlsx *book, int row, int column, const char *formula, double value,
                  xlsx_style style)
{
    if (isfinite(value))
        xlsx_formula(book, row, column, formula, workbook_rounded(value), style);
    else
        xlsx_text_formula(book, row, column, formula, "", style);
}

const char *input_check(int cell)
{
    return compose("NOT(%s)", case_cells[cell].wrong);
}

const char *input_message(int cell)
{
    return compose("%s must be %s.", case_cells[cell].column, case_cells[cell].must);
}

static void write_cell(xlsx *book, int row, int column, int cell, const char *formula,
                       const case_values *values, xlsx_style style)
{
    if (strcmp(case_cells[cell].column, "yield_branch") == 0)
        xlsx_text_formula(book, row, column, formula, values->branch, style);
    else
        formula_cell(book, row, column, formula, cell < SHOWN_CELLS ? values->number[cell] : NAN,
                     style);
}

void named_cell(xlsx *book, int row, int column, int cell, const case_values *values,
                xlsx_style style)
{
    write_cell(book, row, column, cell, formula_named(case_cells[cell].formula), values, style);
    xlsx_name(book, case_cells[cell].name, row, column);
}

void cell_in_row(xlsx *book, int row, int cell, column_finder *column_of, const case_values *values)
{
    write_cell(book, row, column_of(cell), cell,
               formula_in_row(case_cells[cell].formula, row, column_of), values, XLSX_PLAIN);
}

void name_triples(xlsx *book, int row, column_finder *column_of)
{
    for (int i = 0; i < TRIPLES; i++)
        xlsx_name_range(book, triples[i], row, column_of(first_of(triples[i])), 1, 3);
}
