/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "series.h"

#include "field/vtk.h"
#include "text/message.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* ---- One load ---- */

typedef struct {
    const point_rows *what;
    const rwedge_contact *contact;
} moment;

static double point_x(const void *of_moment, int64_t column)
{
    return ((const moment *)of_moment)->what->at->x[column];
}

/* The first point of a row of the grid; any point of those that are no grid. */
static double point_y(const void *of_moment, int64_t row)
{
    const places *at = ((const moment *)of_moment)->what->at;
    return at->y[at->columns > 0 ? (size_t)row * at->columns : (size_t)row];
}

static bool stress_at(const void *of_moment, int64_t column, int64_t row, tensor *found)
{
    const moment *of = of_moment;
    return point_stress(of->what, of->contact, (size_t)row * of->what->at->columns + (size_t)column,
                        found);
}

static int write_moment(const moment *of, size_t step, const char *path, const output_options *how)
{
    char title[80];
    const places *at = of->what->at;
    snprintf(title, sizeof title, "rwedge history: load %zu; y is the depth below the surface",
             step + 1);
    vtk_points points = {.title = title,
                         .is_grid = at->columns > 0,
                         .columns = (int64_t)(at->columns > 0 ? at->columns : at->count),
                         .rows = (int64_t)(at->columns > 0 ? at->rows : 1),
                         .x = point_x,
                         .y = point_y,
                         .stress = stress_at,
                         .of = of};
    output_options one = *how;
    one.path = path;
    output_options_write(&one, vtk_write, &points);
    return STATUS_DONE;
}

/* ---- All ---- */

/* How much of the name stands before ".vtk.series" or ".series". */
static size_t stem_length(const char *path)
{
    const char *const endings[] = {".vtk.series", ".series"};
    const size_t length = strlen(path);
    for (int i = 0; i < 2; i++) {
        const size_t own = strlen(endings[i]);
        if (length > own && strcmp(path + length - own, endings[i]) == 0)
            return length - own;
    }
    return length;
}

static void name_moment(const char *path, size_t step, char *name, size_t size)
{
    snprintf(name, size, "%.*s_%04zu.vtk", (int)stem_length(path), path, step + 1);
}

typedef struct {
    const char *path;
    size_t steps;
} list;

static void put_string(output *out, const char *text)
{
    output_text(out, "\"");
    for (const char *c = text; *c != '\0'; c++) {
        if (*c == '"' || *c == '\\')
            output_text(out, "\\");
        output_write(out, c, 1);
    }
    output_text(out, "\"");
}

static bool write_list(void *of_list, records *rows, bool show_progress)
{
    (void)show_progress;
    const list *what = of_list;
    const char *slash = strrchr(what->path, '/');
    const char *file = slash != NULL ? slash + 1 : what->path;
    const size_t room = strlen(file) + 40;
    char *name = malloc(room), time[60];
    if (name == NULL) {
        failure("out of memory");
        return false;
    }
    output_text(rows->out, "{\"file-series-version\": \"1.0\", \"files\": [");
    for (size_t i = 0; i < what->steps; i++) {
        name_moment(file, i, name, room);
        output_text(rows->out, i == 0 ? "\n{\"name\": " : ",\n{\"name\": ");
        put_string(rows->out, name);
        snprintf(time, sizeof time, ", \"time\": %zu}", i + 1);
        output_text(rows->out, time);
    }
    output_text(rows->out, "\n]}\n");
    free(name);
    return true;
}

int series_write(const point_rows *what, const output_options *how)
{
    const size_t room = strlen(how->path) + 40;
    char *path = malloc(room);
    moment now = {what, NULL};
    rwedge_contact *contact = path != NULL ? course_begin(what->whole) : NULL;
    int status = contact != NULL ? STATUS_DONE : STATUS_FAILED;
    now.contact = contact;
    for (size_t step = 0; step < what->whole->steps && status == STATUS_DONE; step++) {
        name_moment(how->path, step, path, room);
        status = course_go_on(what->whole, step, contact) ? write_moment(&now, step, path, how)
                                                          : STATUS_FAILED;
    }
    list all = {how->path, what->whole->steps};
    output_options_write(how, write_list, &all);
    rwedge_contact_destroy(contact);
    free(path);
    return status;
}
