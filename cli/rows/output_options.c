/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "rows.h"

#include "sheet/sheet.h"

#include <string.h>
#include <strings.h>

#define FORMAT_OPTION(formats)                                                                     \
    "format", '\0', POPT_ARG_STRING, NULL, OPTION_FORMAT, "How results are written (default csv)", \
        formats

static struct poptOption other_output_option_table[] = {
    {VALUE("digits", OPTION_DIGITS),
     "Significant digits, 1 to 17 (default 17: numbers read back to the same bits)", "N"},
    {FLAG("decimal-comma", OPTION_DECIMAL_COMMA),
     "In files 1,5 for 1.5, with ';' between the columns of csv", NULL},
    {"output", 'o', POPT_ARG_STRING, NULL, OPTION_OUTPUT,
     "Write to FILE, whole or not at all; its ending is the format (default: standard output)",
     "FILE"},
    {"quiet", 'q', POPT_ARG_NONE, NULL, OPTION_QUIET, "No progress on the terminal", NULL},
    {HELP_OPTION},
    POPT_TABLEEND,
};

struct poptOption output_option_table[] = {
    {FORMAT_OPTION("csv|tsv|json|xlsx")},
    {INCLUDED(other_output_option_table), NULL, NULL},
    POPT_TABLEEND,
};

struct poptOption grid_output_option_table[] = {
    {FORMAT_OPTION("csv|tsv|json|xlsx|vtk")},
    {INCLUDED(other_output_option_table), NULL, NULL},
    POPT_TABLEEND,
};

const char *const grid_formats[] = {"csv", "tsv", "json", "xlsx", "vtk", NULL};

/* The formats of rows; of places they are the same and one more. */
static const char *const row_formats[] = {"csv", "tsv", "json", "xlsx", NULL};
static const record_format *const record_formats[] = {&delimited_format, &delimited_format,
                                                      &json_format, &xlsx_format, &vtk_format};

/* The formats of all commands. */
static const char *const all_formats[] = {"csv", "tsv", "json", "xlsx", "vtk",
                                          "svg", "png", "pdf",  NULL};

/* Its place in a list that ends with NULL; -1 where it is not there. */
static int place_of(const char *name, const char *const formats[])
{
    for (int i = 0; formats[i] != NULL; i++)
        if (strcasecmp(name, formats[i]) == 0)
            return i;
    return -1;
}

/* ---- The name of the output, and its format ---- */

/* What follows the last point of a file's name; "" where there is nothing. */
static const char *ending_of(const char *path)
{
    const char *slash = path != NULL ? strrchr(path, '/') : NULL;
    const char *name = slash != NULL ? slash + 1 : path;
    const char *point = name != NULL ? strrchr(name, '.') : NULL;
    return point != NULL && point != name ? point + 1 : "";
}

/* "csv, tsv", or ".csv, .tsv". */
static const char *list_of(const char *const formats[], const char *point)
{
    static char list[80];
    for (int i = 0; formats[i] != NULL; i++)
        list_add(list, sizeof list, ", ", "%s%s", point, formats[i]);
    return list;
}

const char *output_format_choose(const arguments *line, const char *const formats[],
                                 const char *hint)
{
    const char *text = line->value[OPTION_FORMAT], *path = line->value[line->output];
    const char *option = arguments_output(line);
    const char *ending = ending_of(path);
    const int asked = place_of(text != NULL ? text : formats[0], formats);
    const int named = place_of(ending, formats);
    if (asked < 0)
        usage_error("--format %s: unknown format; allowed: %s%s", text, list_of(formats, ""), hint);
    const char *format = formats[text == NULL && named >= 0 ? named : asked];
    if (ending[0] == '\0' || named == place_of(format, formats))
        return format;
    if (text == NULL)
        usage_error("--%s %s: the ending .%s belongs to no format here; allowed: %s%s", option,
                    path, ending, list_of(formats, "."), hint);
    if (place_of(ending, all_formats) >= 0)
        usage_error("--%s %s: its ending contradicts --format %s; allowed: .%s", option, path, text,
                    format);
    return format;
}

/* ---- The options ---- */

static void use_format(output_options *how)
{
    const int i = place_of(how->format_name, grid_formats);
    how->format = i >= 0 ? record_formats[i] : NULL;
    how->separator = strcmp(how->format_name, "tsv") == 0 ? '\t' : ',';
    if (how->format == &xlsx_format && xlsx_missing() != NULL)
        usage_error("--format xlsx: %s", xlsx_missing());
    if (how->format == &xlsx_format && (how->path == NULL || strcmp(how->path, "-") == 0) &&
        stream_is_terminal(stdout))
        usage_error("--format xlsx: it is not for a terminal; allowed with: --output FILE");
}

void output_options_read_of(const arguments *line, const char *const formats[], const char *hint,
                            output_options *how)
{
    *how = (output_options){.quiet = line->value[OPTION_QUIET] != NULL,
                            .no_formulas = line->value[OPTION_NO_FORMULAS] != NULL,
                            .option = arguments_output(line),
                            .path = line->value[line->output]};
    const char *text = line->value[OPTION_DIGITS];
    const bool comma = line->value[OPTION_DECIMAL_COMMA] != NULL;
    int64_t digits = NUMBER_DIGITS;
    if (how->path != NULL && how->path[0] == '\0')
        usage_error("--%s '': must be the name of a file, or - for standard output", how->option);
    how->format_name = output_format_choose(line, formats, hint);
    use_format(how);
    if (text != NULL && !number_read_whole(text, 1, NUMBER_DIGITS, &digits))
        usage_error("--digits %s: must be a whole number from 1 to %d", text, NUMBER_DIGITS);
    how->digits = (int)digits;
    how->decimal_sign = comma ? ',' : '.';
    if (comma && how->format != &delimited_format)
        usage_error(
            "--decimal-comma: not in %s, whose numbers have a point; allowed with: csv, tsv",
            how->format == &json_format   ? "JSON"
            : how->format == &xlsx_format ? "XLSX"
                                          : "VTK");
    if (comma && how->separator == ',')
        how->separator = ';';
    output_options_spare_files(line, how);
    output_try(how->path);
}

void output_options_read(const arguments *line, output_options *how)
{
    output_options_read_of(line, row_formats, "", how);
}

void output_options_spare(const output_options *how, const char *file, const char *kind,
                          const char *name)
{
    const char *path = how->path != NULL ? how->path : "-";
    const bool is_new = file != NULL && strcmp(path, "-") != 0 && strcmp(path, file) == 0;
    if (is_new || (file != NULL && target_is_input(path, file)))
        usage_error("--%s %s: it is the %s%s; allowed: another file", how->option, path, kind,
                    name);
}

/* Words are files where the usage says so, as "LOADS.csv". */
void output_options_spare_files(const arguments *line, const output_options *how)
{
    const bool has_words = line->operand != NULL && strstr(line->grammar->operands, ".csv") != NULL;
    for (int i = 1; i < OPTION_LIMIT; i++) {
        const char *option = arguments_other_file(line, i);
        if (option != NULL && line->value[i] != NULL && line->value[i][0] == '\0')
            usage_error("--%s '': must be the name of a file", option);
        if (option != NULL)
            output_options_spare(how, line->value[i], "file of --", option);
    }
    for (const char **word = line->operand; has_words && *word != NULL; word++)
        output_options_spare(how, *word, "input", "");
}

void output_options_write(const output_options *how, rows_writer *write_rows, void *context)
{
    output out;
    output_open(&out, how->path);
    /* progress shows only where stderr is a terminal, and stdout, when it takes the rows, is not */
    records rows = {.how = how,
                    .out = &out,
                    .show_progress = !how->quiet && stream_is_terminal(stderr) &&
                                     !(out.stream == stdout && stream_is_terminal(stdout))};
    write_rows(context, &rows);
    records_end(&rows);
    progress_erase();
    output_finish(&out);
}
