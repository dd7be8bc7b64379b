/* SPDX-License-Identifier: GPL-3.0-or-later */
/* rwedge field: stresses on a grid below the surface. */
#include "field.h"

#include <math.h>

/* ---- Points ---- */

tensor point_stress(const rwedge_contact *contact, const pad *shape, double nu, double x, double y)
{
    double sxx, syy, txy;
    if (y == 0 && pad_is_kink(shape, x) && rwedge_contact_half_width(contact) > 0)
        return tensor_unknown();
    const int32_t status = rwedge_contact_stresses(contact, 1, &x, &y, &sxx, &syy, &txy);
    if (status != RWEDGE_OK)
        failure("x = %.17g, y = %.17g: %s", x, y, rwedge_strerror(status));
    return tensor_of(sxx, syy, txy, nu);
}

void point_columns_write(records *rows, const char *title, size_t across)
{
    rows->title = title;
    rows->across = across;
    records_name(rows, "x");
    records_name(rows, "y");
    records_columns(rows, tensor_kinds, TENSOR_COUNT);
}

void point_write(records *rows, double x, double y, const tensor *at)
{
    records_value(rows, cell_number(x));
    records_value(rows, cell_number(y));
    for (int i = 0; i < TENSOR_COUNT; i++)
        records_value(rows, cell_number(at->value[i]));
    records_end_row(rows);
}

/* ---- The grid ---- */

enum { X, Y, AXES };
static const char *const axis_names[AXES] = {"x", "y"};

typedef struct {
    loaded_contact loaded;
    range axis[AXES];
} grid;

/* A row for every point, x fastest. */
static void write_rows(void *of_grid, records *rows)
{
    const grid *points = of_grid;
    const contact_case *setup = &points->loaded.setup;
    const double unit = points->loaded.length_unit;
    const range *across = &points->axis[X], *down = &points->axis[Y];
    progress_start(rows->show_progress, range_product(AXES, points->axis), "points");
    point_columns_write(rows, "rwedge field: y is the depth below the surface",
                        (size_t)across->count);
    for (int64_t j = 0; j < down->count; j++)
        for (int64_t i = 0; i < across->count && records_go_on(rows); i++) {
            const double x = range_value(across, i), y = range_value(down, j);
            const tensor at =
                point_stress(setup->contact, &setup->shape, setup->nu1, x * unit, y * unit);
            point_write(rows, x, y, &at);
            progress_step();
        }
}

/* ---- The command ---- */

enum { OPTION_AXIS = OPTION_AFTER_LOADED };

static const struct poptOption options[] = {
    {INCLUDED(loaded_contact_option_table), NULL, NULL},
    {VALUE("x", OPTION_AXIS + X),
     "Columns of the grid (default: 81 within 2 b of the contact's middle)", "RANGE"},
    {VALUE("y", OPTION_AXIS + Y), "Its rows, depths below the surface (default: 41 from 0 to 2 b)",
     "RANGE"},
    OTHER_NAME("depth", OPTION_AXIS + Y),
    {INCLUDED(grid_output_option_table), "Common options:", NULL},
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
    columns_describe(tensor_kinds + TENSOR_TXY + 1, TENSOR_COUNT - TENSOR_TXY - 1, 14, stream);
    loaded_contact_describe(stream);
}

/* The text of an axis, or its default between two multiples of b. */
static range read_axis(int axis, const char *text, double from, double to, int64_t count)
{
    range values;
    if (text == NULL && from == to)
        usage_error("--%s: missing; after the last load there is no contact to lay a grid around",
                    axis_names[axis]);
    if (text == NULL)
        return range_between(from, to, count);
    range_option(axis_names[axis], text, &values);
    return values;
}

static void check_grid(char *const text[], const range axis[], bool vtk)
{
    const int wider = axis[X].count > axis[Y].count ? X : Y;
    double outside;
    if (!range_within(&axis[Y], 0, HUGE_VAL, &outside))
        usage_error("--y %s: depths must not be below 0", text[Y]);
    if (range_product(AXES, axis) > RANGE_VALUES_MAX)
        usage_error("--%s %s: must not give the grid more than 1000000000 points in all",
                    axis_names[wider], text[wider]);
    for (int k = 0; k < AXES && vtk; k++)
        for (int64_t i = 1; i < axis[k].count;
             i += axis[k].items != NULL ? 1 : axis[k].count) /* steps are all alike */
            if (!(range_value(&axis[k], i) > range_value(&axis[k], i - 1)))
                usage_error("--%s %s: must ascend; so the format vtk wants it", axis_names[k],
                            text[k]);
}

static int field(const arguments *line)
{
    grid points = {0};
    output_options how;
    arguments_no_operand(line);
    output_options_read_of(line, grid_formats, "", &how);
    loaded_contact_read(line, how.decimal_sign, &points.loaded);
    const double b = points.loaded.b, middle = (points.loaded.left + points.loaded.right) / 2;
    char *const *text = &line->value[OPTION_AXIS];
    points.axis[X] = read_axis(X, text[X], middle - 2 * b, middle + 2 * b, 81);
    points.axis[Y] = read_axis(Y, text[Y], 0, 2 * b, 41);
    check_grid(text, points.axis, how.format == &vtk_format);
    output_options_write(&how, write_rows, &points);
    return STATUS_DONE;
}

const command field_command = {.name = "field",
                               .summary = "stresses on a grid below the surface",
                               .grammar = {options, "[OPTION...]", describe, OPTION_LOAD},
                               .run = field};
