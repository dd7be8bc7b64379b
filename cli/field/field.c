/* SPDX-License-Identifier: GPL-3.0-or-later */
/* rwedge field: stresses on a grid below the surface. */
#include "field.h"

#include <math.h>

enum { OPTION_X = OPTION_AFTER_LOADED, OPTION_Y };

static const struct poptOption options[] = {
    {NULL, '\0', POPT_ARG_INCLUDE_TABLE, loaded_contact_option_table, 0, NULL, NULL},
    {"x", '\0', POPT_ARG_STRING, NULL, OPTION_X,
     "Columns of the grid (default: 81 within 2 b of the contact's middle)", "RANGE"},
    {"y", '\0', POPT_ARG_STRING, NULL, OPTION_Y,
     "Its rows, depths below the surface (default: 41 from 0 to 2 b)", "RANGE"},
    {NULL, '\0', POPT_ARG_INCLUDE_TABLE, grid_output_option_table, 0, "Common options:", NULL},
    POPT_TABLEEND,
};

static void describe(FILE *stream)
{
    fputs(
        "\nA RANGE is START:STOP:STEP, a comma list, or one number.\n\nColumns, of vtk all but the "
        "first two\nas scalars, and the stress as a tensor:\n"
        "  x, y           the point, y the depth; in ParaView the half-plane is above\n"
        "  sxx, syy, txy  stresses in body 1, tension positive\n",
        stream);
    for (int i = TENSOR_TXY + 1; i < TENSOR_COUNT; i++)
        fprintf(stream, "  %-14s %s\n", tensor_kinds[i].column, tensor_kinds[i].meaning);
    loaded_contact_describe(stream);
}

/* The text of an axis, or its default between two multiples of b. */
static void read_axis(const char *name, const char *text, double from, double to, int64_t count,
                      range *values)
{
    if (text == NULL && from == to)
        usage_error("--%s: missing; after the last load there is no contact to lay a grid around",
                    name);
    *values = text == NULL ? range_between(from, to, count) : (range){0};
    const char *complaint = text != NULL ? range_read(text, values) : NULL;
    if (complaint != NULL)
        usage_error("--%s %s: %s", name, text, complaint);
    if (text != NULL)
        range_say_two_values(name, text);
}

static bool ascends(const range *values)
{
    for (int64_t i = 1; i < values->count;
         i += values->items != NULL ? 1 : values->count) /* steps are all alike */
        if (!(range_value(values, i) > range_value(values, i - 1)))
            return false;
    return true;
}

static void check_grid(const arguments *line, const grid *points, bool vtk)
{
    const char *const text[] = {line->value[OPTION_X], line->value[OPTION_Y]};
    double outside;
    if (!range_within(&points->y, 0, HUGE_VAL, &outside))
        usage_error("--y %s: depths must not be below 0", text[1]);
    if (grid_size(points) > RANGE_VALUES_MAX)
        usage_error("--%s %s: must not give the grid more than 1000000000 points in all",
                    points->x.count > points->y.count ? "x" : "y",
                    text[points->x.count > points->y.count ? 0 : 1]);
    for (int i = 0; i < 2 && vtk; i++)
        if (!ascends(i == 0 ? &points->x : &points->y))
            usage_error("--%s %s: must ascend; so the format vtk wants it", i == 0 ? "x" : "y",
                        text[i]);
}

static int field(const arguments *line)
{
    grid points = {0};
    output_options how;
    arguments_no_operand(line);
    output_options_read_of(line, grid_formats, "", &how);
    output_options_spare(&how, line->value[OPTION_HISTORY]);
    output_options_spare(&how, line->value[OPTION_INPUT + INPUT_PROFILE]);
    loaded_contact_read(line, how.decimal_sign, &points.loaded);
    const bool vtk = how.format == NULL;
    const double b = points.loaded.b, middle = (points.loaded.left + points.loaded.right) / 2;
    read_axis("x", line->value[OPTION_X], middle - 2 * b, middle + 2 * b, 81, &points.x);
    read_axis("y", line->value[OPTION_Y], 0, 2 * b, 41, &points.y);
    check_grid(line, &points, vtk);
    output_options_write(&how, vtk ? grid_write_vtk : grid_write_rows, &points);
    return STATUS_DONE;
}

static const syntax grammar = {options, "[OPTION...]", describe, OPTION_LOAD};

const command field_command = {"field",  "rwedge field", "stresses on a grid below the surface",
                               &grammar, NULL,           field};
