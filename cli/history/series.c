/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "history.h"

#include "field/field.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* ---- One load ---- */

/* The stresses at the points, the contact being under the load. */
typedef struct {
    const point_rows *points;
    const rwedge_contact *contact;
    size_t step;
} points_after;

static void write_frame(void *of_points, records *rows)
{
    const points_after *under = of_points;
    const places *at = under->points->at;
    char title[80];
    snprintf(title, sizeof title, "rwedge history: load %zu; y is the depth below the surface",
             under->step + 1);
    point_columns_write(rows, title, at->columns);
    for (size_t i = 0; i < at->count; i++) {
        const tensor stress = point_rows_stress(under->points, under->contact, i);
        point_write(rows, at->x[i], at->y[i], &stress);
    }
    records_end(rows);
}

/* ---- Names ---- */

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

/* The files of a series and of the one that it replaces have other names: an interruption leaves
 * the old series whole. */
typedef struct {
    const char *path; /* of their list */
    const char *mark; /* "" or "b", in the names */
    size_t count;
} frames;

static char *frame_name(const frames *all, size_t step)
{
    const size_t size = strlen(all->path) + 40;
    char *name = memory_zeroed(size, 1);
    snprintf(name, size, "%.*s_%s%04zu.vtk", (int)stem_length(all->path), all->path, all->mark,
             step + 1);
    return name;
}

/* The files that the present series names; none where there is no series. */
static frames frames_of(const char *path)
{
    frames old = {path, "b", 0};
    char line[4096];
    FILE *list = fopen(path, "rb");
    while (list != NULL && fgets(line, sizeof line, list) != NULL)
        if (strncmp(line, "{\"name\": ", 9) == 0 && old.count++ == 0)
            old.mark = strstr(line, "_b0001.vtk\"") != NULL ? "b" : "";
    if (list != NULL)
        fclose(list);
    return old;
}

/* ---- The list ---- */

static void write_list(void *of_frames, records *rows)
{
    frames series = *(const frames *)of_frames;
    const char *slash = strrchr(series.path, '/');
    series.path = slash != NULL ? slash + 1 : series.path;
    output_text(rows->out, "{\"file-series-version\": \"1.0\", \"files\": [");
    for (size_t i = 0; i < series.count; i++) {
        char *name = frame_name(&series, i);
        char *json = memory_checked(json_quoted(name));
        output_print(rows->out, "%s\n{\"name\": %s, \"time\": %zu}", i == 0 ? "" : ",", json,
                     i + 1);
        free(json);
        free(name);
    }
    output_text(rows->out, "\n]}\n");
}

/* ---- All ---- */

void series_write(const point_rows *points, const arguments *line, const output_options *how)
{
    const frames old = frames_of(how->path);
    frames series = {how->path, old.mark[0] == 'b' ? "" : "b", points->history->steps};
    if (json_quoted(how->path) == NULL)
        usage_error("--output %s: must be UTF-8, as the list of the files is", how->path);
    output_options file = *how;
    file.format = &vtk_format;
    for (size_t step = 0; step < series.count; step++) {
        char *name = frame_name(&series, step);
        file.path = name;
        output_options_spare_files(line, &file);
        free(name);
    }
    rwedge_contact *contact = contact_history_begin(points->history);
    for (points_after under = {points, contact, 0}; under.step < series.count; under.step++) {
        char *name = frame_name(&series, under.step);
        contact_history_go_on(points->history, under.step, contact);
        file.path = name;
        output_options_write(&file, write_frame, &under);
        free(name);
    }
    output_options_write(how, write_list, &series);
    for (size_t step = 0; step < old.count; step++) {
        char *name = frame_name(&old, step);
        remove(name);
        free(name);
    }
}
