/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "places.h"

#include "contact/table_header.h"
#include "text/message.h"
#include "text/number.h"

#include <inttypes.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

struct poptOption place_option_table[] = {
    {"at", '\0', POPT_ARG_STRING, NULL, OPTION_AT, "At these points, y the depth", "x,y;x,y"},
    {"points", '\0', POPT_ARG_STRING, NULL, OPTION_POINTS,
     "At the points of a CSV file with the columns x and y", "FILE"},
    {"x", '\0', POPT_ARG_STRING, NULL, OPTION_X, "Or on a grid, with these x", "RANGE"},
    {"depth", '\0', POPT_ARG_STRING, NULL, OPTION_DEPTH,
     "And these depths below the surface (default 0)", "RANGE"},
    OTHER_NAME("y", OPTION_DEPTH),
    POPT_TABLEEND,
};

enum { PLACES_MAX = 1000000 };

static bool add(places *to, double x, double y)
{
    if ((to->count & (to->count - 1)) == 0) { /* room for the next power of two */
        const size_t room = to->count == 0 ? 1 : 2 * to->count;
        double *longer = realloc(to->x, room * sizeof *longer);
        to->x = longer != NULL ? longer : to->x;
        double *deeper = realloc(to->y, room * sizeof *deeper);
        to->y = deeper != NULL ? deeper : to->y;
        if (longer == NULL || deeper == NULL) {
            failure("out of memory");
            return false;
        }
    }
    to->x[to->count] = x;
    to->y[to->count++] = y;
    return true;
}

void places_free(places *what)
{
    free(what->x);
    free(what->y);
    *what = (places){0};
}

/* NULL, or what is wrong with such a point. */
static const char *complaint_about(double x, double y)
{
    if (y < 0)
        return "y is a depth, and must not be below 0";
    if (fmax(fabs(x), y) > 1e60)
        return "must be at most 1e60 in magnitude";
    return NULL;
}

/* ---- --at ---- */

static bool read_pair(const char **text, double *x, double *y)
{
    size_t length = number_length(*text);
    if (!number_read_part(*text, length, x) || (*text)[length] != ',')
        return false;
    *text += length + 1;
    length = number_length(*text);
    if (!number_read_part(*text, length, y))
        return false;
    *text += length;
    return true;
}

static int read_at(const char *text, places *found)
{
    const char *rest = text;
    bool said = false;
    for (bool last = false; !last;) {
        double x, y;
        rest += strspn(rest, " ");
        const char *pair = rest;
        if (!read_pair(&rest, &x, &y) || (*rest != ';' && *rest != '\0'))
            return usage_error("--at %s: must be points x,y separated by semicolons", text);
        if (complaint_about(x, y) != NULL)
            return usage_error("--at %s: %s", text, complaint_about(x, y));
        if (!add(found, x, y))
            return STATUS_FAILED;
        if (y > 0 && !said)
            said = range_say_pair("at", text, pair, (size_t)(rest - pair));
        last = *rest++ == '\0';
    }
    return STATUS_DONE;
}

/* ---- --points ---- */

static const char *const names[] = {"x", "y"};

typedef struct {
    csv_row first;
    header names;
    bool unused[HEADER_COLUMNS];
    size_t column[2]; /* of x and y */
} columns;

static int find_column(const char *file, int n, columns *of)
{
    header *all = &of->names;
    of->column[n] = all->count;
    for (size_t c = 0; c < all->count; c++) {
        if (strcmp(all->name[c], names[n]) != 0)
            continue;
        if (of->column[n] < c)
            return failure("%s: column %s: there twice; allowed: once", file, names[n]);
        of->column[n] = c;
        all->is_used[c] = true;
    }
    if (of->column[n] == all->count)
        return failure("%s: column %s: missing; needed: x and y, the depth", file, names[n]);
    return STATUS_DONE;
}

static int find_columns(csv_input *in, columns *of)
{
    static const bool no_input[INPUT_COUNT] = {false};
    char complaint[COMPLAINT_SIZE];
    if (!table_header_read(in, &of->first))
        return STATUS_FAILED;
    header_find(of->first.cell, of->first.count, no_input, NULL, &of->names, complaint);
    int status = STATUS_DONE;
    for (int i = 0; i < 2 && status == STATUS_DONE; i++)
        status = find_column(csv_input_name(in), i, of);
    return status;
}

static int refuse_row(const csv_input *in, const char *complaint)
{
    return failure("%s: line %" PRId64 ": %s", csv_input_name(in), csv_input_line(in), complaint);
}

static int read_row(csv_input *in, columns *of, char decimal_sign, places *found)
{
    double value[2];
    char complaint[COMPLAINT_SIZE];
    const char *const *cells = csv_input_cells(in);
    if (!header_fits(of->names.count, csv_input_count(in), csv_input_separator(in), complaint))
        return refuse_row(in, complaint);
    for (int i = 0; i < 2; i++) {
        const char *text = cells[of->column[i]];
        snprintf(complaint, COMPLAINT_SIZE, "%s %.60s: must be a number, with a decimal %s",
                 names[i], text, decimal_sign == ',' ? "comma" : "point");
        if (!number_read_cell(text, decimal_sign, &value[i]))
            return refuse_row(in, complaint);
    }
    if (complaint_about(value[0], value[1]) != NULL)
        return refuse_row(in, complaint_about(value[0], value[1]));
    if (found->count == PLACES_MAX)
        return failure("%s: more than %d points", csv_input_name(in), PLACES_MAX);
    header_note_unused(&of->names, cells, of->unused);
    return add(found, value[0], value[1]) ? STATUS_DONE : STATUS_FAILED;
}

static int read_rows(csv_input *in, char decimal_sign, columns *of, places *found)
{
    int status = find_columns(in, of);
    csv_event event;
    while (status == STATUS_DONE && (event = csv_input_next(in)) != CSV_END)
        status = event == CSV_ROW ? read_row(in, of, decimal_sign, found) : csv_input_fail(in);
    if (status == STATUS_DONE && found->count == 0)
        status = failure("%s: no points; needed: rows of x and y", csv_input_name(in));
    if (status == STATUS_DONE)
        table_header_say_unused(&of->names, of->unused, csv_input_name(in));
    return status;
}

static int read_file(const char *path, const char *encoding, char decimal_sign, places *found)
{
    csv_input *in = csv_input_open(path, decimal_sign == ',' ? ';' : ',', encoding);
    if (in == NULL)
        return STATUS_FAILED;
    columns of = {.column = {0}};
    const int status = read_rows(in, decimal_sign, &of, found);
    csv_row_free(&of.first);
    csv_input_close(in);
    return status;
}

/* ---- --x and --depth ---- */

int places_read_depth(const arguments *given, range *depth)
{
    const char *text = given->value[OPTION_DEPTH];
    double outside;
    const char *complaint = range_read(text != NULL ? text : "0", depth);
    if (complaint == NULL && !range_within(depth, 0, 1e60, &outside))
        complaint = "depths must not be below 0";
    if (complaint != NULL)
        return usage_error("--depth %s: %s", text, complaint);
    if (text != NULL)
        range_say_two_values("depth", text);
    return STATUS_DONE;
}

static int fill_grid(const char *text, const range *x, const range *y, places *found)
{
    if ((double)x->count * (double)y->count > PLACES_MAX)
        return usage_error("--x %s: must not give more than %d points in all", text, PLACES_MAX);
    for (int64_t j = 0; j < y->count; j++)
        for (int64_t i = 0; i < x->count; i++)
            if (!add(found, range_value(x, i), range_value(y, j)))
                return STATUS_FAILED;
    found->columns = (size_t)x->count;
    found->rows = (size_t)y->count;
    return STATUS_DONE;
}

static int read_grid(const arguments *given, places *found)
{
    const char *text = given->value[OPTION_X];
    range x = {0}, y = {0};
    const char *complaint = range_read(text, &x);
    int status = complaint == NULL ? places_read_depth(given, &y)
                                   : usage_error("--x %s: %s", text, complaint);
    if (status == STATUS_DONE) {
        range_say_two_values("x", text);
        status = fill_grid(text, &x, &y, found);
    }
    range_free(&x);
    range_free(&y);
    return status;
}

/* ---- All ---- */

int places_read(const arguments *given, char decimal_sign, places *found)
{
    const char *at = given->value[OPTION_AT], *points = given->value[OPTION_POINTS];
    const char *x = given->value[OPTION_X], *depth = given->value[OPTION_DEPTH];
    *found = (places){0};
    if ((at != NULL) + (points != NULL) + (x != NULL || depth != NULL) > 1)
        return usage_error("--%s %s: given together with --%s; allowed: one of the two",
                           at != NULL ? "at" : "points", at != NULL ? at : points,
                           at != NULL && points != NULL ? "points"
                           : x != NULL                  ? "x"
                                                        : "depth");
    if (at != NULL)
        return read_at(at, found);
    if (points != NULL)
        return read_file(points, given->value[OPTION_ENCODING], decimal_sign, found);
    return x != NULL ? read_grid(given, found) : STATUS_DONE;
}

int places_spare_files(const arguments *given, const output_options *how)
{
    const int status = output_options_spare(how, course_file(given));
    return status == STATUS_DONE ? output_options_spare(how, given->value[OPTION_POINTS]) : status;
}
