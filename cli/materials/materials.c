/* SPDX-License-Identifier: GPL-3.0-or-later */
/* rwedge materials: a row for each constant of a material that is shipped. */
#include "document/document.h"
#include "rows/rows.h"
#include "setup/setup.h"

#include <stdlib.h>
#include <string.h>

static const struct poptOption options[] = {
    {INCLUDED(output_option_table), "Common options:", NULL},
    POPT_TABLEEND,
};

static const char *const columns[] = {"material", "constant", "value", "unit", "meaning", "source"};
enum { COLUMNS = sizeof columns / sizeof columns[0] };

static void describe(FILE *stream)
{
    fputs("\nThe names that --material takes, with their constants. Another material is a\n"
          "file: a JSON object of constants by name, or CSV.\n",
          stream);
}

/* A stress is in the unit of the file; a K says its own. */
static const char *unit_of(int constant, const char *units, const char *own)
{
    const char *stress = strrchr(units, ',');
    if (own != NULL)
        return own;
    return strcmp(material_unit(constant), "stress") == 0 && stress != NULL ? stress + 1 : "";
}

/* A number and its own unit, NULL for none. That of a growth is no unit of a quantity: it stands
 * behind the number as it is written. */
static bool read_constant(char *text, double *value, const char **own)
{
    char *blank = strchr(text, ' ');
    if (quantity_read(text, '.', value, own))
        return true;
    if (blank == NULL)
        return false;
    *blank = '\0';
    *own = blank + 1;
    return number_read(text, value);
}

static void write_constant(const shipped_material *shipped, const node *top, const node *constant,
                           records *rows)
{
    const int i = material_constant(constant->name);
    char *text = node_words(constant);
    const char *own;
    double value;
    if (read_constant(text, &value, &own))
        records_row(
            rows, COLUMNS,
            (cell[]){cell_text(shipped->name), cell_text(constant->name), cell_number(value),
                     cell_text(unit_of(i, node_part(top, "units")->text, own)),
                     cell_text(material_meaning(i)), cell_text(node_part(top, "source")->text)});
    free(text);
}

static void write_rows(void *nothing, records *rows)
{
    (void)nothing;
    records_header(rows, COLUMNS, columns);
    for (const shipped_material *one = shipped_materials; one->name != NULL; one++) {
        const node *top = document_read_text(one->text, one->name);
        for (size_t i = 0; i < top->count; i++)
            if (!material_is_remark(top->part[i].name))
                write_constant(one, top, &top->part[i], rows);
    }
}

static int materials(const arguments *line)
{
    output_options how;
    arguments_no_operand(line);
    output_options_read(line, &how);
    output_options_write(&how, write_rows, NULL);
    return STATUS_DONE;
}

const command materials_command = {.name = "materials",
                                   .summary = "the materials that --material takes by name",
                                   .grammar = {options, "[OPTION...]", describe},
                                   .run = materials};
