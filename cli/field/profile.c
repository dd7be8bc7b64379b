/* SPDX-License-Identifier: GPL-3.0-or-later */
/* rwedge profile: tractions, stress and slip along the surface. */
#include "field.h"

#include <math.h>

enum { OPTION_X = OPTION_AFTER_LOADED, OPTION_POINTS };

static const struct poptOption options[] = {
    {INCLUDED(loaded_contact_option_table), NULL, NULL},
    {VALUE("x", OPTION_X), "Where on the surface", "RANGE"},
    {VALUE("points", OPTION_POINTS),
     "Or how many points from edge to edge, dense at the edges (default 201)", "N"},
    {INCLUDED(output_option_table), "Common options:", NULL},
    POPT_TABLEEND,
};

enum { X, P, Q, ZONE, SXX, SLIP, PROFILE_COLUMNS };
static const column_kind columns[PROFILE_COLUMNS] = {
    [X] = {"x", "along the surface"},
    [P] = {"p", "pressure, negative in compression"},
    [Q] = {"q", "shear traction, txy at the surface; q = f p where it slips under Q > 0"},
    [ZONE] = {"zone", "stick; slip, where friction is exhausted; or free, outside the contact"},
    [SXX] = {"sxx", "stress along the surface, tension positive"},
    [SLIP] = {"slip", "of body 1 relative to body 2, the wedge, since they came into contact"},
};

static void describe(FILE *stream)
{
    fputs("\nA RANGE is START:STOP:STEP, a comma list, or one number.\n\nColumns:\n", stream);
    columns_describe(columns, PROFILE_COLUMNS, 5, stream);
    loaded_contact_describe(stream);
}

typedef struct {
    loaded_contact loaded;
    stick_zones sticks;
    range x;        /* the places, if points is 0 */
    int64_t points; /* so many places from edge to edge */
} plan;

/* Over b, the distance from the middle is the sine of an angle that grows in equal steps. The ends
 * and the middle are exact. */
static double x_of(const plan *job, int64_t i)
{
    if (job->points == 0)
        return range_value(&job->x, i);
    if (i == 0 || i == job->points - 1)
        return i == 0 ? job->loaded.left : job->loaded.right;
    return (job->loaded.left + job->loaded.right) / 2 +
           job->loaded.b *
               sin(PI / 2 * (double)(2 * i - (job->points - 1)) / (double)(job->points - 1));
}

static const char *zone_of(const loaded_contact *loaded, const stick_zones *sticks, double x)
{
    if (!(x > loaded->touches.left && x < loaded->touches.right))
        return "free";
    return stick_zones_have(sticks, x) ? "stick" : "slip";
}

/* NAN, an empty cell, for stresses at a sharp edge, which are infinite, and for slip outside the
 * contact. Where a history off the centre has no closed form of it, the slip alone is not known. */
static int32_t look(const loaded_contact *loaded, double at, double value[])
{
    const rwedge_contact *contact = loaded->setup.contact;
    const bool touches = loaded->b > 0, is_kink = touches && pad_is_kink(&loaded->setup.shape, at);
    const double surface = 0;
    double syy, txy;
    int32_t status = RWEDGE_OK;
    value[P] = value[Q] = value[SXX] = value[SLIP] = NAN;
    if (!is_kink)
        status = rwedge_contact_tractions(contact, 1, &at, &value[P], &value[Q]);
    if (status == RWEDGE_OK && !is_kink)
        status = rwedge_contact_stresses(contact, 1, &at, &surface, &value[SXX], &syy, &txy);
    if (status == RWEDGE_OK && touches && at >= loaded->touches.left && at <= loaded->touches.right)
        status = rwedge_contact_slip(contact, 1, &at, &value[SLIP]);
    return status == RWEDGE_EPATH ? RWEDGE_OK : status;
}

static void write_row(const plan *job, records *rows, double x)
{
    const loaded_contact *loaded = &job->loaded;
    const double at = x * loaded->length_unit;
    double value[PROFILE_COLUMNS];
    const int32_t status = look(loaded, at, value);
    if (status != RWEDGE_OK)
        failure("x = %.17g: %s", x, rwedge_strerror(status));
    value[X] = x;
    value[SLIP] /= loaded->slip_unit;
    for (int i = 0; i < PROFILE_COLUMNS; i++)
        records_value(rows, i == ZONE ? cell_text(zone_of(loaded, &job->sticks, at))
                                      : cell_number(value[i]));
    records_end_row(rows);
    progress_step();
}

static void write_profile(void *of_plan, records *rows)
{
    const plan *job = of_plan;
    const int64_t count = job->points > 0 ? job->points : job->x.count;
    progress_start(rows->show_progress, count, "rows");
    records_columns(rows, columns, PROFILE_COLUMNS);
    for (int64_t i = 0; i < count && records_go_on(rows); i++)
        write_row(job, rows, x_of(job, i));
}

static int profile(const arguments *line)
{
    const char *x = line->value[OPTION_X], *points = line->value[OPTION_POINTS];
    plan job = {0};
    output_options how;
    double slip;
    arguments_no_operand(line);
    output_options_read(line, &how);
    if (x != NULL && points != NULL)
        usage_error("--points %s: given together with --x; allowed: one of the two", points);
    if (x != NULL)
        range_option("x", x, &job.x);
    job.points = x != NULL ? 0 : 201;
    if (points != NULL && !number_read_whole(points, 2, 1000000000, &job.points))
        usage_error("--points %s: must be a whole number from 2 to 1000000000", points);
    loaded_contact_read(line, how.decimal_sign, &job.loaded);
    if (job.points > 0 && job.loaded.b == 0)
        usage_error("--x: missing; after the last load there is no contact to take points from");
    job.sticks = stick_zones_of(job.loaded.setup.contact);
    output_options_write(&how, write_profile, &job);
    stick_zones_free(&job.sticks);
    if (rwedge_contact_slip(job.loaded.setup.contact, 1, &job.loaded.touches.left, &slip) ==
        RWEDGE_EPATH)
        notice("the slip has no closed form after these loads: the column slip is empty");
    return STATUS_DONE;
}

const command profile_command = {.name = "profile",
                                 .summary = "pressure, shear, stress and slip along the surface",
                                 .grammar = {options, "[OPTION...]", describe, OPTION_LOAD},
                                 .run = profile};
