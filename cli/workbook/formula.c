/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "workbook.h"

#include <ctype.h>
#include <stdio.h>
#include <string.h>

/* ---- Templates ---- */

enum { ARGUMENTS = 4, FORMULA_SIZE = 5000 };

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

/* Arguments may have another text in place of each #. */
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
        for (size_t i = 0; i < next.length; i++)
            if (next.text[i] == '#' && instead != NULL)
                end = (char *)memcpy(end, instead, length) + length;
            else
                *end++ = next.text[i];
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

static bool is_named(const char *word, size_t length, const char *name)
{
    return strncmp(word, name, length) == 0 && name[length] == '\0';
}

/* The cells of the row for the name of a cell, or of three side by side; other words as they
 * are. */
static char *write_word(char *end, const char *word, size_t length, int row)
{
    char column[XLSX_COLUMN_SIZE];
    const bool may_be_cell = row > 0 && strncmp(word, "rw", 2) == 0;
    for (int i = 0; may_be_cell && i < case_cell_count; i++) {
        const bool are_three = is_named(word, length, case_cells[i].column);
        if (!are_three && !is_named(word, length, case_cells[i].name))
            continue;
        xlsx_column_name(batch_column(i), column);
        end += sprintf(end, "%s%d", column, row);
        xlsx_column_name(batch_column(i + 2), column);
        return are_three ? end + sprintf(end, ":%s%d", column, row) : end;
    }
    return (char *)memcpy(end, word, length) + length;
}

/* Returns the end. */
static char *expand(const char *from, int number, int row, char *end)
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
            end = expand(text, number, row, end);
        } else if (length > 0) {
            end = write_word(end, from, length, row);
            from += length;
        } else if (*from == '~') {
            end += sprintf(end, "%d", number);
            from++;
        } else {
            quoted = quoted != (*from == '"');
            *end++ = *from++;
        }
    }
    *end = '\0';
    return end;
}

const char *formula_of(const char *formula, int number, int row)
{
    static char room[FORMULA_SIZE] = "=";
    expand(formula, number, row, room + 1);
    return room;
}

void check_typing(xlsx *book, xlsx_area area, int number, int row)
{
    const case_cell *input = &case_cells[number];
    char condition[FORMULA_SIZE], message[FORMULA_SIZE];
    snprintf(condition, sizeof condition, "NOT(%s)", input->wrong);
    snprintf(message, sizeof message, "%s must be %s.", input->column, input->must);
    const char *const texts[] = {"", formula_of(condition, 0, row),
                                 row > 0 ? input->column : input->label,
                                 row > 0 ? input->label : input->hint, message};
    xlsx_property(book, "rule", area, texts);
}
