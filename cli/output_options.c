/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "output_options.h"

#include "message.h"
#include "progress.h"

#include <string.h>

struct poptOption output_option_table[] = {
    {"format", '\0', POPT_ARG_STRING, NULL, OPTION_FORMAT, "How rows are written (default csv)", "csv|tsv|json"},
    {"digits", '\0', POPT_ARG_STRING, NULL, OPTION_DIGITS,
     "Significant digits, 1 to 17 (default 17: numbers read back to the same bits)", "N"},
    {"decimal-comma", '\0', POPT_ARG_NONE, NULL, OPTION_DECIMAL_COMMA,
     "Write 1,5 for 1.5, with ';' between the columns of csv", NULL},
    {"output", 'o', POPT_ARG_STRING, NULL, OPTION_OUTPUT,
     "Write to FILE, whole or not at all (default: standard output)", "FILE"},
    {"quiet", 'q', POPT_ARG_NONE, NULL, OPTION_QUIET, "No progress on the terminal", NULL},
    OPTION_HELP_ENTRY,
    POPT_TABLEEND,
};

static int read_format(const char *text, output_options *how)
{
    how->format = &delimited_format;
    how->separator = ',';
    if (text == NULL || strcmp(text, "csv") == 0)
        return STATUS_DONE;
    if (strcmp(text, "tsv") == 0) {
        how->separator = '\t';
        return STATUS_DONE;
    }
    if (strcmp(text, "json") == 0) {
        how->format = &json_format;
        return STATUS_DONE;
    }
    if (strcmp(text, "xlsx") == 0)
        return usage_error("--format xlsx: this build cannot write it; allowed: csv, tsv, json");
    return usage_error("--format %s: unknown format; allowed: csv, tsv, json", text);
}

static int read_digits(const char *text, output_options *how)
{
    how->digits = NUMBER_DIGITS;
    if (text == NULL)
        return STATUS_DONE;
    int digits = 0;
    const size_t length = strspn(text, "0123456789");
    for (size_t i = 0; i < length && digits <= NUMBER_DIGITS; i++)
        digits = 10 * digits + (text[i] - '0');
    if (text[length] != '\0' || digits < 1 || digits > NUMBER_DIGITS)
        return usage_error("--digits %s: must be a whole number from 1 to %d", text, NUMBER_DIGITS);
    how->digits = digits;
    return STATUS_DONE;
}

static int read_decimal_comma(bool given, output_options *how)
{
    how->decimal_sign = given ? ',' : '.';
    if (given && how->format == &json_format)
        return usage_error("--decimal-comma: not in JSON, whose numbers have a point; allowed with: csv, tsv");
    if (given && how->separator == ',')
        how->separator = ';';
    return STATUS_DONE;
}

int output_options_read(const arguments *given, output_options *how)
{
    how->quiet = given->value[OPTION_QUIET] != NULL;
    how->path = given->value[OPTION_OUTPUT];
    if (how->path != NULL && how->path[0] == '\0')
        return usage_error("--output '': must be the name of a file, or - for standard output");
    int status = read_format(given->value[OPTION_FORMAT], how);
    if (status == STATUS_DONE)
        status = read_digits(given->value[OPTION_DIGITS], how);
    if (status == STATUS_DONE)
        status = read_decimal_comma(given->value[OPTION_DECIMAL_COMMA] != NULL, how);
    return status;
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
        output_discard(&out);
        return STATUS_FAILED;
    }
    return output_finish(&out) ? STATUS_DONE : STATUS_FAILED;
}
