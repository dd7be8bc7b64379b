/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "figure.h"

#include "fretting/fretting.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* ---- Along the loads ---- */

enum { STEPS = 24 }; /* from load to load, for smooth curves */

/* Adds what is to be seen of a state; the number of the load counts on in between. */
typedef void visitor(const figure_case *inputs, double number, const rwedge_contact *contact,
                     dataset *rows);

typedef struct {
    const figure_case *inputs;
    size_t first; /* loads that are seen: after it */
    visitor *visit;
    dataset *rows;
    rwedge_contact *before; /* the contact before the present load */
    load last;              /* that load, as the rig had it where it is driven */
} way;

/* Where a state on the way to a load has no closed form, the curve is straight from there. */
static void visit_between(const way *w, size_t loads, load to)
{
    const load from = to.is_driven ? w->last : loads_of(w->before);
    for (int i = 1; i < STEPS && from.P > 0; i++) {
        if (loads_apply(loads_between(from, to, i, STEPS), w->before) != RWEDGE_OK)
            break;
        w->visit(w->inputs, (double)(loads - 1) + (double)i / STEPS, w->before, w->rows);
    }
}

static void visit_load(void *of_way, size_t loads, const rwedge_contact *contact)
{
    way *w = of_way;
    w->rows->error = fmax(w->rows->error, rwedge_contact_error(contact));
    const contact_history *history = &w->inputs->history;
    const load at =
        loads > 0 ? history->loads.load[contact_history_row(history, loads - 1)] : (load){.P = 0};
    if (loads > w->first + 1)
        visit_between(w, loads, at.is_driven ? at : loads_of(contact));
    if (loads > w->first)
        w->visit(w->inputs, (double)loads, contact, w->rows);
    rwedge_contact_destroy(w->before);
    w->last = at;
    case_check(w->inputs, rwedge_contact_copy(contact, &w->before));
}

/* Visits the loads after the first so many, and the states between two. Loads before the first
 * cycle have no number and no place. */
static void visit_all(const figure_case *inputs, size_t first, visitor *visit, dataset *rows)
{
    way w = {inputs, first, visit, rows, NULL, {.P = 0}};
    contact_history_go(&inputs->history, visit_load, &w);
    rwedge_contact_destroy(w.before);
}

/* ---- The stress at a point ---- */

static void add_stress(const figure_case *inputs, double number, const rwedge_contact *contact,
                       dataset *rows)
{
    const double x = inputs->at.x[0], y = inputs->at.y[0];
    double sxx, syy, txy;
    case_check(inputs, rwedge_contact_stresses(contact, 1, &x, &y, &sxx, &syy, &txy));
    const tensor at = tensor_of(sxx, syy, txy, inputs->history.setup.nu1);
    dataset_add(rows, (data_row){.number = {number, x, y, sxx, syy, at.value[TENSOR_SZZ], txy}});
}

/* The last cycle, from the load before it; where the loads may end before, all. */
static void compute_history(const figure_case *inputs, dataset *rows)
{
    const contact_history *history = &inputs->history;
    const size_t loads = history->loads.count, steps = history->steps;
    visit_all(inputs, steps > loads && !history->is_until ? steps - loads - 1 : 0, add_stress,
              rows);
}

const figure figure_history = {
    .name = "history",
    .summary = "stresses at a point, --at, in the last cycle of loads",
    .has_history = true,
    .cycles = 1,
    .column = (const char *const[]){"load", "x", "y", "sxx", "syy", "szz", "txy", NULL},
    .compute = compute_history,
    .drawn = 1 << 3 | 1 << 4 | 1 << 6, /* sxx, syy, txy */
    .nothing = "there is no stress",
    .script = history_lines};

/* ---- The loop of Q over the displacement ---- */

static void add_displacement(const figure_case *inputs, double number,
                             const rwedge_contact *contact, dataset *rows)
{
    const load now = loads_of(contact);
    dataset_add(rows,
                (data_row){.number = {number, now.P, now.M, now.Q, now.sigma,
                                      rwedge_contact_displacement(contact, inputs->half_width),
                                      rwedge_contact_dissipated_energy(contact)}});
}

static void compute_any_loop(const figure_case *inputs, dataset *rows)
{
    visit_all(inputs, 0, add_displacement, rows);
}

const figure figure_any_loop = {
    .name = "loop",
    .summary = "Q over the displacement by slip",
    .has_history = true,
    .cycles = 1,
    .column = (const char *const[]){"load", "P", "M", "Q", "sigma", "displacement", "energy", NULL},
    .compute = compute_any_loop,
    .drawn = 1 << 5,
    .nothing = "nothing slips, or the slip has no closed form",
    .script = any_loop_lines};

/* ---- Smith, Watson and Topper's parameter along the surface ---- */

/* Measures the cycle at the places by default. */
static measured measure_usual(const figure_case *inputs, const last_cycle *last)
{
    const measured result = stops_usual(last);
    case_check(inputs, result.count > 0 ? last_cycle_measure(last, result.count, result.place)
                                        : RWEDGE_EABSENT);
    return result;
}

static void compute_fretting(const figure_case *inputs, dataset *rows)
{
    last_cycle last;
    const criteria usual = criteria_usual(&inputs->history.setup);
    history_cycle(&inputs->history, &usual, &last, NULL);
    rows->error = last.error;
    const measured result = measure_usual(inputs, &last);
    for (size_t i = 0; i < result.count; i++) {
        data_row row = {.number = {result.place[i].x}};
        for (int k = 1; figure_fretting.column[k] != NULL; k++)
            row.number[k] = result.place[i].value[measure_column_named(figure_fretting.column[k])];
        dataset_add(rows, row);
    }
}

const figure figure_fretting = {.name = "fretting",
                                .summary = "Smith-Watson-Topper along the surface, last cycle",
                                .has_history = true,
                                .cycles = 3,
                                .column = (const char *const[]){"x", "swt", "swt_angle",
                                                                "slip_range", "ruiz_f1", "ruiz_f2",
                                                                "energy_per_area", NULL},
                                .compute = compute_fretting,
                                .drawn = 1 << 1,
                                .nothing = "there is no tension in the cycle",
                                .script = fretting_lines};

/* ---- Any measure: along the surface, below its worst place, as contours ---- */

enum { DEPTHS = 121, COLUMNS = 81, ROWS = 41 };

static void add_places(const figure_case *inputs, const measured *result, dataset *rows)
{
    for (size_t i = 0; i < result->count; i++)
        dataset_add(rows, (data_row){.number = {result->place[i].x, result->place[i].y,
                                                result->place[i].value[inputs->measure]}});
}

/* Notes the worst of the places, and between them on the line of the best. */
static void note_worst(const figure_case *inputs, const last_cycle *last, const measured *result,
                       dataset *rows)
{
    worst_table found = {.last = last};
    worst_find(result, &found);
    const worst_row *row = &found.row[inputs->measure];
    if (row->value > rows->worst[2]) {
        rows->worst[0] = row->x;
        rows->worst[1] = row->y;
        rows->worst[2] = row->value;
    }
}

static void measure_surface(const figure_case *inputs, const last_cycle *last, dataset *rows)
{
    const measured result = measure_usual(inputs, last);
    add_places(inputs, &result, rows);
    note_worst(inputs, last, &result, rows);
}

/* Down to the half-width, dense at the surface. */
static void measure_depth(const figure_case *inputs, const last_cycle *last, dataset *rows)
{
    const measured along = measure_usual(inputs, last);
    measured_place place[DEPTHS];
    const measured below = {place, DEPTHS, 0};
    for (int i = 0; i < DEPTHS; i++) {
        const double part = (double)i / (DEPTHS - 1);
        place[i] = (measured_place){.x = along.place[measured_best(&along, inputs->measure)].x,
                                    .y = inputs->half_width * part * part};
    }
    case_check(inputs, last_cycle_measure(last, DEPTHS, place));
    add_places(inputs, &below, rows);
    note_worst(inputs, last, &below, rows);
}

/* ---- As contours ---- */

/* Damage, and Smith, Watson and Topper's parameter, an energy, fall by decades: they have lines at
 * powers of ten, or at 1, 2 and 5 times these, over so many decades. Others have equal steps. */
typedef struct {
    int decades, lines_a_decade; /* 0 for equal steps */
} scale;

static scale scale_of(const figure_case *inputs)
{
    const measure_kind *kind = measure_kind_of(inputs->measure);
    const bool is_energy =
        kind->number == RWEDGE_MEASURE_SWT || kind->number == RWEDGE_MEASURE_SWT_IN_PLANE;
    if (inputs->over != OVER_FIELD || !(kind->is_damage || is_energy))
        return (scale){0, 0};
    return kind->is_damage ? (scale){5, 1} : (scale){2, 3};
}

/* The power of ten below the lowest line. */
static double decade_below(const figure_case *inputs, double worst)
{
    return floor(log10(worst)) - scale_of(inputs).decades;
}

static double lowest_line(const figure_case *inputs, double worst)
{
    const int lines = scale_of(inputs).lines_a_decade;
    return lines == 0 ? step_of_levels(worst)
                      : pow(10, decade_below(inputs, worst)) * (lines == 1 ? 10 : 2);
}

typedef struct {
    double left, right, depth;
} frame;

/* Row by row, closer near the surface. To be freed. */
static measured measure_grid(const figure_case *inputs, const last_cycle *last, frame in)
{
    const measured grid = {memory_zeroed(ROWS * COLUMNS, sizeof *grid.place), ROWS * COLUMNS,
                           COLUMNS};
    for (int j = 0; j < ROWS; j++)
        for (int i = 0; i < COLUMNS; i++)
            grid.place[j * COLUMNS + i] =
                (measured_place){.x = in.left + (in.right - in.left) * i / (COLUMNS - 1),
                                 .y = in.depth * pow((double)j / (ROWS - 1), 1.5)};
    case_check(inputs, last_cycle_measure(last, grid.count, grid.place));
    return grid;
}

/* Adds what is above the lowest line. */
static void frame_add(const measured *around, int column, double lowest, frame *box)
{
    for (size_t i = 0; i < around->count; i++) {
        const measured_place *place = &around->place[i];
        if (!(place->value[column] >= lowest))
            continue;
        box->left = fmin(box->left, place->x);
        box->right = fmax(box->right, place->x);
        box->depth = fmax(box->depth, place->y);
    }
}

/* What a bulk tension alone does: the largest value at the sides and the bottom. */
static double background(const measured *grid, int column)
{
    double most = 0;
    for (int j = 0; j < ROWS; j++)
        for (int i = 0; i < COLUMNS; i += j < ROWS - 1 ? COLUMNS - 1 : 1) {
            const double value = grid->place[j * COLUMNS + i].value[column];
            most = fmax(most, isnan(value) ? 0 : value);
        }
    return most;
}

/* Around what its lines enclose, with a margin; neither flat nor narrow. */
static frame frame_of(const figure_case *inputs, const last_cycle *last, const measured *along,
                      dataset *rows)
{
    const double FLATTEST = 0.25, DEEPEST = 0.8, MARGIN = 0.12;
    const double middle = (last->left + last->right) / 2, half = (last->right - last->left) / 2;
    const measured wide =
        measure_grid(inputs, last, (frame){middle - 2.5 * half, middle + 2.5 * half, 2.5 * half});
    note_worst(inputs, last, along, rows);
    note_worst(inputs, last, &wide, rows);
    const double worst = rows->worst[2],
                 lowest = fmin(worst / 2, fmax(lowest_line(inputs, worst),
                                               1.05 * background(&wide, inputs->measure)));
    frame box = {rows->worst[0], rows->worst[0], rows->worst[1]};
    frame_add(along, inputs->measure, lowest, &box);
    frame_add(&wide, inputs->measure, lowest, &box);
    free(wide.place);
    const double width = fmax(fmax((box.right - box.left) * (1 + 2 * MARGIN), 0.05 * half),
                              box.depth * (1 + MARGIN) / DEEPEST),
                 x = (box.left + box.right) / 2;
    return (frame){x - width / 2, x + width / 2, fmax(box.depth * (1 + MARGIN), FLATTEST * width)};
}

/* The peaks of the surface are too narrow for its grid. */
static void measure_field(const figure_case *inputs, const last_cycle *last, dataset *rows)
{
    const measured along = measure_usual(inputs, last);
    const measured grid = measure_grid(inputs, last, frame_of(inputs, last, &along, rows));
    rows->across = COLUMNS;
    add_places(inputs, &grid, rows);
    note_worst(inputs, last, &grid, rows);
    free(grid.place);
}

static void compute_measure(const figure_case *inputs, dataset *rows)
{
    static void (*const ways[OVER_COUNT])(const figure_case *, const last_cycle *, dataset *) = {
        measure_surface, measure_depth, measure_field};
    last_cycle last;
    history_cycle(&inputs->history, &inputs->asked, &last, NULL);
    rows->error = last.error;
    case_check(inputs, isnan(last.left) ? RWEDGE_EABSENT : RWEDGE_OK);
    ways[inputs->over](inputs, &last, rows);
    rows->touched[0] = last.left;
    rows->touched[1] = last.right;
    rwedge_cycle_permanent_stick(last.cycle, &rows->stuck[0], &rows->stuck[1]);
}

static void prepare_measure(const figure_case *inputs, const dataset *rows, FILE *script)
{
    const double worst = rows->worst[2];
    const char *unit = measure_kind_of(inputs->measure)->unit;
    const bool has_unit = strcmp(unit, "none") != 0;
    char text[80];
    if (worst == 0)
        failure("figure measure: nothing to draw: the measure is nowhere above 0");
    snprintf(text, sizeof text, "%s%s", has_unit ? "in units of " : "pure number",
             has_unit ? unit : "");
    char *star = strchr(text, '*'); /* would begin italics */
    if (star != NULL)
        *star = ' ';
    script_text(script, "title", measure_kind_of(inputs->measure)->title);
    script_text(script, "unit", text);
    script_number(script, "worst_x", rows->worst[0]);
    script_number(script, "worst_y", rows->worst[1]);
    script_number(script, "worst", worst);
    const int lines = scale_of(inputs).lines_a_decade;
    script_number(script, "lines_a_decade", lines);
    script_number(script, "base", decade_below(inputs, worst));
    script_number(script, "step", lines > 0 ? 1 : step_of_levels(worst));
    script_number(script, "touched_left", rows->touched[0]);
    script_number(script, "touched_right", rows->touched[1]);
    script_number(script, "stuck_left", rows->stuck[0]);
    script_number(script, "stuck_right", rows->stuck[1]);
    fprintf(script, "along = %d\n",
            inputs->over == OVER_FIELD   ? 0
            : inputs->over == OVER_DEPTH ? 2
                                         : 1);
}

const figure figure_measure = {.name = "measure",
                               .summary = "any column of fretting, by --measure and --over",
                               .has_history = true,
                               .cycles = 3,
                               .column = (const char *const[]){"x", "y", "value", NULL},
                               .compute = compute_measure,
                               .prepare = prepare_measure,
                               .script = measure_lines};
