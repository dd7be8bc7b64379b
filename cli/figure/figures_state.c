/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A contact under its last loads: the pad as it touches, the tractions, the stress below. */
#include "figure.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

/* ---- The state ---- */

static void keep_last(void *of_copy, size_t loads, const rwedge_contact *contact)
{
    rwedge_contact **copy = of_copy;
    (void)loads;
    rwedge_contact_destroy(*copy);
    *copy = NULL;
    status_check(rwedge_contact_copy(contact, copy), "the contact");
}

/* What is drawn, with the edges of the contact; its contact stays to the end of the command. */
typedef struct {
    const contact_case *setup;
    const rwedge_contact *contact;
    double left, right, middle, half;
} drawn_state;

static drawn_state state_of(const figure_case *inputs)
{
    drawn_state state = {.setup = inputs->state};
    rwedge_contact *last = NULL;
    if (inputs->state == NULL) {
        contact_history_go(&inputs->history, keep_last, &last);
        state.setup = &inputs->history.setup;
        state.contact = last;
    } else
        state.contact = inputs->state->contact;
    if (rwedge_contact_edges(state.contact, &state.left, &state.right) != RWEDGE_OK ||
        !(state.right > state.left))
        failure("figure %s: nothing to draw: after the last load the bodies are apart",
                inputs->kind->name);
    state.middle = (state.left + state.right) / 2;
    state.half = (state.right - state.left) / 2;
    return state;
}

/* The edges, the outermost edges of what sticks, and the units. */
static void say_zones(const figure_case *inputs, const drawn_state *state, FILE *script)
{
    stick_zones zones = stick_zones_of(state->contact);
    const bool sticks = zones.count > 0 && state->setup->f > 0;
    script_number(script, "left", state->left);
    script_number(script, "right", state->right);
    script_number(script, "stick_left", sticks ? zones.left[0] : NAN);
    script_number(script, "stick_right", sticks ? zones.right[zones.count - 1] : NAN);
    script_number(script, "rubs", state->setup->f > 0);
    script_text(script, "length_unit", inputs->length_unit != NULL ? inputs->length_unit : "");
    script_text(script, "stress_unit", inputs->stress_unit != NULL ? inputs->stress_unit : "");
    stick_zones_free(&zones);
}

/* ---- The pad ---- */

enum { OUTLINE = 241 };
static const double REACH = 1.7; /* of the half-width, on either side */

/* Half of what is marked as a. */
static double marked(const pad *shape)
{
    return shape->kind == PAD_WEDGE ? shape->a : shape->kind == PAD_FLAT ? shape->flat : 0;
}

static double reach_of(const drawn_state *state)
{
    const double outer = fmax(-state->left, state->right);
    return REACH * fmax(outer, fmin(marked(&state->setup->shape), 2 * outer));
}

/* Its heights over the surface where it is pressed on, and as it was, which reaches below. */
static void compute_contact(const figure_case *inputs, dataset *rows)
{
    const drawn_state state = state_of(inputs);
    const pad *shape = &state.setup->shape;
    const double tilt = rwedge_contact_tilt(state.contact), reach = reach_of(&state),
                 lowest = fmax(pad_height(shape, state.left) - tilt * state.left,
                               pad_height(shape, state.right) - tilt * state.right);
    for (int i = 0; i < OUTLINE; i++) {
        const double x = reach * (2.0 * i / (OUTLINE - 1) - 1),
                     height = pad_height(shape, x) - tilt * x,
                     edge = x > state.right ? state.right : state.left;
        const bool touches = x >= state.left && x <= state.right;
        dataset_add(
            rows,
            (data_row){.number = {x, touches ? 0 : height - pad_height(shape, edge) + tilt * edge,
                                  touches ? height - lowest : NAN}});
    }
}

static void prepare_contact(const figure_case *inputs, const dataset *rows, FILE *script)
{
    static const char *const names[] = {[PAD_WEDGE] = "wedge with a rounded apex",
                                        [PAD_CYLINDER] = "cylinder",
                                        [PAD_FLAT] = "flat pad with rounded edges",
                                        [PAD_PROFILE] = "pad with a profile"};
    const drawn_state state = state_of(inputs);
    const load now = loads_of(state.contact);
    double lowest = 0;
    for (size_t i = 0; i < rows->count; i++)
        if (isfinite(rows->row[i].number[2]))
            lowest = fmin(lowest, rows->row[i].number[2]);
    say_zones(inputs, &state, script);
    script_text(script, "pad_name", names[state.setup->shape.kind]);
    script_number(script, "reach", reach_of(&state));
    script_number(script, "rise", fmax(dataset_largest(rows, 1), -2 * lowest));
    script_number(script, "marked", marked(&state.setup->shape));
    script_number(script, "theta",
                  state.setup->shape.kind == PAD_WEDGE ? state.setup->shape.theta : NAN);
    script_number(script, "P", now.P);
    script_number(script, "M", now.M);
    script_number(script, "Q", now.Q);
    script_number(script, "sigma", now.sigma);
}

const figure figure_contact = {.name = "contact",
                               .summary = "the pad as it touches, its loads, what sticks",
                               .has_history = true,
                               .cycles = 1,
                               .column = (const char *const[]){"x", "height", "height_free", NULL},
                               .compute = compute_contact,
                               .prepare = prepare_contact,
                               .script = contact_lines};

/* ---- Tractions ---- */

enum { PLACES = 401 };

/* Closer at the edges, where the tractions go to 0 with the root of the distance. */
static void compute_tractions(const figure_case *inputs, dataset *rows)
{
    const drawn_state state = state_of(inputs);
    double x[PLACES], p[PLACES], q[PLACES];
    for (int i = 0; i < PLACES; i++)
        x[i] = state.middle - state.half * cos(PI * i / (PLACES - 1));
    x[0] = state.left;
    x[PLACES - 1] = state.right;
    case_check(inputs, rwedge_contact_tractions(state.contact, PLACES, x, p, q));
    for (int i = 0; i < PLACES; i++)
        dataset_add(rows, (data_row){.number = {x[i], 0 - p[i], q[i], 0 - state.setup->f * p[i]}});
    rows->error = rwedge_contact_error(state.contact);
}

static void prepare_state(const figure_case *inputs, const dataset *rows, FILE *script)
{
    const drawn_state state = state_of(inputs);
    (void)rows;
    say_zones(inputs, &state, script);
}

const figure figure_tractions = {.name = "tractions",
                                 .summary = "pressure and shear of the last load",
                                 .has_history = true,
                                 .cycles = 1,
                                 .column =
                                     (const char *const[]){"x", "pressure", "shear", "limit", NULL},
                                 .compute = compute_tractions,
                                 .prepare = prepare_state,
                                 .script = tractions_lines};

/* ---- The stress below ---- */

enum { STATE_COLUMNS = 161, STATE_ROWS = 65, STATE_POINTS = STATE_COLUMNS * STATE_ROWS };
static const double SIDE = 1.6, DEPTH = 1.5;

/* Rows are closer near the surface. At a kink that touches the stress is infinite: just below. */
static void compute_stress(const figure_case *inputs, dataset *rows)
{
    const drawn_state state = state_of(inputs);
    double *x = memory_zeroed(5 * STATE_POINTS, sizeof *x), *y = x + STATE_POINTS,
           *sxx = y + STATE_POINTS, *syy = sxx + STATE_POINTS, *txy = syy + STATE_POINTS;
    for (int i = 0; i < STATE_POINTS; i++) {
        x[i] = state.middle +
               SIDE * state.half * (2.0 * (i % STATE_COLUMNS) / (STATE_COLUMNS - 1) - 1);
        y[i] = DEPTH * state.half * pow((double)(i / STATE_COLUMNS) / (STATE_ROWS - 1), 1.5);
        if (y[i] == 0 && pad_is_kink(&state.setup->shape, x[i]))
            y[i] = 1e-6 * state.half;
    }
    case_check(inputs, rwedge_contact_stresses(state.contact, STATE_POINTS, x, y, sxx, syy, txy));
    rows->across = STATE_COLUMNS;
    rows->error = rwedge_contact_error(state.contact);
    for (int i = 0; i < STATE_POINTS; i++)
        dataset_add(rows, (data_row){.number = {x[i], y[i], sxx[i], syy[i], txy[i],
                                                rwedge_von_mises(sxx[i], syy[i], txy[i],
                                                                 state.setup->nu1)}});
    free(x);
}

static void prepare_stress(const figure_case *inputs, const dataset *rows, FILE *script)
{
    const drawn_state state = state_of(inputs);
    double factor = 0, x = NAN, y = NAN;
    const int32_t status =
        rwedge_contact_yield_factor(state.contact, state.setup->nu1, 1, &factor, &x, &y);
    const bool is_found = status == RWEDGE_OK && factor > 0;
    const double top = is_found ? SQRT_3 / factor : dataset_largest(rows, 5);
    say_zones(inputs, &state, script);
    script_number(script, "top", top);
    script_number(script, "step", step_of_levels(top));
    script_number(script, "hardest_x", is_found ? x : NAN);
    script_number(script, "hardest_y", is_found ? y : NAN);
    script_number(script, "half", state.half);
}

const figure figure_stress = {
    .name = "stress",
    .summary = "contours of von Mises stress below the last load",
    .has_history = true,
    .cycles = 1,
    .column = (const char *const[]){"x", "y", "sxx", "syy", "txy", "von_mises", NULL},
    .compute = compute_stress,
    .prepare = prepare_stress,
    .script = stress_lines};
