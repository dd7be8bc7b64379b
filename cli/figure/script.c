/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The script that draws the rows of a figure, in gnuplot's language. */
#include "figure.h"

#include <math.h>
#include <string.h>

/* The lines of a file; a line "frame" stands for the lines of `frame`. */
static void write_lines(FILE *script, const char *const lines[], const char *const frame[])
{
    for (size_t i = 0; lines[i] != NULL; i++)
        if (strcmp(lines[i], "frame") == 0)
            write_lines(script, frame, NULL);
        else
            fprintf(script, "%s\n", lines[i]);
}

void script_number(FILE *script, const char *name, double value)
{
    if (isfinite(value))
        fprintf(script, "%s = %#.15g\n", name, value); /* a point makes it no integer */
    else
        fprintf(script, "%s = NaN\n", name);
}

/* *a* -> {/:Italic a}; an underscore means the same in both. */
void script_text(FILE *script, const char *name, const char *text)
{
    bool italic = false;
    fprintf(script, "%s = \"", name);
    for (const char *c = text; *c != '\0'; c++)
        if (*c == '*') {
            fputs(italic ? "}" : "{/:Italic ", script);
            italic = !italic;
        } else
            fprintf(script, "%s%c", *c == '"' || *c == '\\' ? "\\" : "", *c);
    fputs("\"\n", script);
}

/* Seven digits: far more than can be seen, and a last bit that differs between math libraries
 * does not show. */
void script_rows(FILE *script, const char *name, const dataset *rows)
{
    fprintf(script, "%s << EOD\n", name);
    for (size_t i = 0; i < rows->count; i++) {
        const double *number = rows->row[i].number;
        for (int k = 0; rows->column[k] != NULL; k++)
            if (isfinite(number[k]))
                fprintf(script, "%.7g ", number[k] + 0);
            else
                fputs("NaN ", script);
        if (rows->text_column != NULL)
            fprintf(script, "\"%s\"", rows->row[i].text);
        fputs("\n", script);
        if (i + 1 < rows->count && rows->row[i + 1].curve != rows->row[i].curve)
            fputs("\n\n", script);
        else if (rows->across > 0 && (i + 1) % rows->across == 0)
            fputs("\n", script);
    }
    fputs("EOD\n", script);
}

void script_write(const figure_case *inputs, const dataset *rows, FILE *script)
{
    const figure *kind = inputs->kind;
    char names[FIGURE_NAMES_SIZE];
    bool is_drawn = kind->nothing == NULL; /* or a number of its columns is not 0 */
    for (size_t i = 0; i < rows->count && !is_drawn; i++)
        for (int k = 0; k < DATA_COLUMNS_MAX; k++)
            is_drawn = is_drawn || ((kind->drawn >> k & 1) != 0 && rows->row[i].number[k] != 0 &&
                                    isfinite(rows->row[i].number[k]));
    if (!is_drawn)
        failure("figure %s: nothing to draw: %s", kind->name, kind->nothing);
    write_lines(script, head_lines, NULL);
    for (int i = 0; i < FIGURE_VARIABLES; i++)
        if (inputs->value[i].count > 0) {
            case_names(inputs, i, names);
            script_text(script, variables[i].column, names);
        }
    script_number(script, "titled", !inputs->no_title);
    script_rows(script, "$rows", rows);
    if (kind->prepare != NULL)
        kind->prepare(inputs, rows, script);
    write_lines(script, kind->script, frame_lines);
}
