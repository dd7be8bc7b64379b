/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The cells and the templates, from their tables in data/. */
#include "workbook.h"

#include <string.h>

bool workbook_line(const char *const **next, const char *field[FIELDS])
{
    while (**next != NULL && ((**next)[0] == '#' || (**next)[0] == '\0'))
        ++*next;
    if (**next == NULL)
        return false;
    const char *line = *(*next)++;
    char *text = memcpy(memory_zeroed(strlen(line) + 1, 1), line, strlen(line));
    for (int i = 0; i < FIELDS; i++) {
        field[i] = text;
        text += strcspn(text, "\t");
        if (*text != '\0')
            *text++ = '\0';
    }
    return true;
}

case_cell *case_cells;
int case_cell_count;
formula_template *formula_templates;

void cells_read(void)
{
    const char *const *next = cells_lines, *f[FIELDS];
    size_t templates = 0;
    for (case_cell_count = 0; workbook_line(&next, f); case_cell_count++) {
        case_cells = memory_for_one_more(case_cells, (size_t)case_cell_count, sizeof *case_cells);
        case_cells[case_cell_count] =
            (case_cell){f[0], f[1], f[2], f[3], f[4], f[5], f[6], f[7], f[8], f[9]};
    }
    next = templates_lines;
    for (bool more = true; more; templates++) { /* the last has no name */
        more = workbook_line(&next, f);
        formula_templates =
            memory_for_one_more(formula_templates, templates, sizeof *formula_templates);
        formula_templates[templates] =
            more ? (formula_template){f[0], f[1]} : (formula_template){0};
    }
}

int cell_of_column(const char *column)
{
    int i = SHOWN_CELLS - 1;
    while (i >= 0 && strcmp(case_cells[i].column, column) != 0)
        i--;
    return i;
}
