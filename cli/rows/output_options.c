/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "output_options.h"

#include "delimited.h"
#include "json.h"
#include "spreadsheet.h"
#include "text/message.h"
#include "system/progress.h"
#include "system/streams.h"
#include "system/target.h"
#include "sheet/xlsx.h"

#include <string.h>

struct poptOption output_option_table[] = {
    {FORMAT_OPTION("csv|tsv|json|xlsx")},
    {NULL, '\0', POPT_ARG_INCLUDE_TABLE, other_output_option_table, 0, NULL, NULL},
    POPT_TABLEEND,
};

struct poptOption other_output_option_table[] = {
    {"digits", '\0', POPT_ARG_STRING, NULL, OPTION_DIGITS,
     "Significant digits, 1 to 17 (default 17: numbers read back to the same bits)", "N"},
    {"decimal-comma", '\0', POPT_ARG_NONE, NULL, OPTION_DECIMAL_COMMA,
     "In files 1,5 for 1.5, with ';' between the columns of csv", NULL},
    {"output", 'o', POPT_ARG_STRING, NULL, OPTION_OUTPUT,
     "Write to FILE, whole or not at all (default: standard output)", "FILE"},
    {"quiet", 'q', POPT_ARG_NONE, NULL, OPTION_QUIET, "No progress on the terminal", NULL},
    {HELP_OPTION},
    POPT_TABLEEND,
};

/* The formats of rows. */
static const struct {
    const char *name;
    const record_format *format;
    char separator;
} formats[] = {{"csv", &delimited_format, ','},
               {"tsv", &delimited_format, '\t'},
               {"json", &json_format, ','},
               {"xlsx", &xlsx_format, ','}};
enum { FORMAT_COUNT = sizeof formats / sizeof formats[0] };

static int check_spreadsheet(const output_options *how)
{
    if (xlsx_missing() != NULL)
        return usage_error("--format xlsx: %s", xlsx_missing());
    if ((how->path == NULL || strcmp(how->path, "-") == 0) && stream_is_terminal(stdout))
        return usage_error("--format xlsx: it is not for a terminal; allowed with: --output FILE");
    return STATUS_DONE;
}

static int read_format(const char *text, const char *other, output_options *how)
{
    for (int i = 0; i < FORMAT_COUNT; i++)
        if (strcmp(text, formats[i].name) == 0) {
            how->format = formats[i].format;
            how->separator = formats[i].separator;
            return formats[i].format == &xlsx_format ? check_spreadsheet(how) : STATUS_DONE;
        }
    how->format = NULL;
    how->separator = ',';
    if (other != NULL && strcmp(text, other) == 0)
        return STATUS_DONE;
    return usage_error("--format %s: unknown format; allowed: csv, tsv, json, xlsx%s%s", text,
                       other != NULL ? ", " : "", other != NULL ? other : "");
}

static int read_digits(const char *text, output_options *how)
{
    int64_t digits = NUMBER_DIGITS;
    if (text != NULL && !number_read_whole(text, 1, NUMBER_DIGITS, &digits))
        return usage_error("--digits %s: must be a whole number from 1 to %d", text, NUMBER_DIGITS);
    how->digits = (int)digits;
    return STATUS_DONE;
}

static int read_decimal_comma(bool given, output_options *how)
{
    how->decimal_sign = given ? ',' : '.';
    if (given && how->format != &delimited_format)
        return usage_error(
            "--decimal-comma: not in %s, whose numbers have a point; allowed with: csv, tsv",
            how->format == &json_format   ? "JSON"
            : how->format == &xlsx_format ? "XLSX"
                                          : "VTK");
    if (given && how->separator == ',')
        how->separator = ';';
    return STATUS_DONE;
}

int output_options_read_or(const arguments *given, const char *other_format, output_options *how)
{
    how->quiet = given->value[OPTION_QUIET] != NULL;
    how->path = given->value[OPTION_OUTPUT];
    if (how->path != NULL && how->path[0] == '\0')
        return usage_error("--output '': must be the name of a file, or - for standard output");
    const char *format = given->value[OPTION_FORMAT];
    int status = read_format(format != NULL ? format : "csv", other_format, how);
    if (status == STATUS_DONE)
        status = read_digits(given->value[OPTION_DIGITS], how);
    if (status == STATUS_DONE)
        status = read_decimal_comma(given->value[OPTION_DECIMAL_COMMA] != NULL, how);
    return status;
}

int output_options_read(const arguments *given, output_options *how)
{
    return output_options_read_or(given, NULL, how);
}

int output_options_spare(const output_options *how, const char *input)
{
    const char *path = how->path != NULL ? how->path : "-";
    if (input == NULL || !target_is_input(path, input))
        return STATUS_DONE;
    return usage_error("--output %s: it is the input; allowed: another file", path);
}

static records records_for(const output_options *how, output *out)
{
    return (records){.format = how->format,
                     .out = out,
                     .digits = how->digits,
                     .decimal_sign = how->decimal_sign,
                     .separator = how->separator};
}

int output_options_write(const output_options *how, rows_writer *write_rows, void *context)
{
    output out;
    if (!output_open(&out, how->path))
        return STATUS_FAILED;
    records rows = records_for(how, &out);
    const bool show_progress = !how->quiet && progress_wanted(output_is_stdout(&out));
    if (!write_rows(context, &rows, show_progress)) {
        if (rows.format != NULL)
            rows.format->discard(&rows);
        output_discard(&out);
        return STATUS_FAILED;
    }
    return output_finish(&out) ? STATUS_DONE : STATUS_FAILED;
}
