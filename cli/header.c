/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "header.h"

#include "message.h"

#include <ctype.h>
#include <stdlib.h>
#include <string.h>

static bool copy_names(const csv_input *in, header *names)
{
    names->name = calloc(csv_input_count(in), sizeof *names->name);
    for (size_t i = 0; names->name != NULL && i < csv_input_count(in); i++, names->count++) {
        names->name[i] = strdup(csv_input_cell(in, i));
        if (names->name[i] == NULL)
            break;
    }
    if (names->count == csv_input_count(in))
        return true;
    failure("out of memory");
    return false;
}

/* The letters and digits of two names, whatever stands between them. */
static bool is_like(const char *a, const char *b)
{
    for (;; a++, b++) {
        while (*a != '\0' && !isalnum((unsigned char)*a))
            a++;
        while (*b != '\0' && !isalnum((unsigned char)*b))
            b++;
        if (tolower((unsigned char)*a) != tolower((unsigned char)*b))
            return false;
        if (*a == '\0')
            return true;
    }
}

/* "yield stress" is a slip; but P and p, or A and a, may be two things. */
static bool is_slip(const char *name, const char *column)
{
    return strlen(column) > 1 && strcmp(name, column) != 0 && is_like(name, column);
}

static bool find(const csv_input *in, int input, header *names)
{
    char column[INPUT_NAME_SIZE];
    input_column(input, column);
    names->column[input] = names->count;
    for (size_t i = 0; i < names->count; i++) {
        if (is_slip(names->name[i], column)) {
            failure("%s: column %.60s: allowed: %s", csv_input_name(in), names->name[i], column);
            return false;
        }
        if (strcmp(names->name[i], column) != 0)
            continue;
        if (names->column[input] < names->count) {
            failure("%s: column %s: there twice; allowed: once", csv_input_name(in), column);
            return false;
        }
        names->column[input] = i;
    }
    return true;
}

bool header_read(csv_input *in, const bool wanted[INPUT_COUNT], header *names)
{
    *names = (header){0};
    const csv_event event = csv_input_next(in);
    if (event == CSV_FAILED)
        return false;
    if (event != CSV_ROW) {
        failure("%s: %s; needed: a header row with the names of the columns", csv_input_name(in),
                event == CSV_END ? "empty" : "misplaced quotes in the first row");
        return false;
    }
    if (!copy_names(in, names))
        return false;
    for (int i = 0; i < INPUT_COUNT; i++) {
        names->column[i] = names->count;
        if (wanted[i] && !find(in, i, names))
            return false;
    }
    return true;
}

void header_free(header *names)
{
    for (size_t i = 0; i < names->count; i++)
        free(names->name[i]);
    free(names->name);
    *names = (header){0};
}

bool header_has(const header *names, const char *name)
{
    for (size_t i = 0; i < names->count; i++)
        if (strcmp(names->name[i], name) == 0)
            return true;
    return false;
}

bool header_fits(const header *names, const csv_input *row, char complaint[COMPLAINT_SIZE])
{
    if (csv_input_count(row) == names->count)
        return true;
    snprintf(complaint, COMPLAINT_SIZE, "%zu cells in this row, %zu in the header", csv_input_count(row), names->count);
    return false;
}

const char *header_separator_hint(const header *names)
{
    if (names->count != 1)
        return "";
    if (strchr(names->name[0], ';') != NULL)
        return "; the columns seem to be separated by ';': --decimal-comma reads that";
    if (strchr(names->name[0], ',') != NULL)
        return "; the columns seem to be separated by ',': leave --decimal-comma out";
    return strchr(names->name[0], '\t') != NULL ? "; the columns seem to be separated by tabs; allowed: commas" : "";
}
