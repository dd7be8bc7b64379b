/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "last_cycle.h"

#include "model/tensor.h"
#include "text/message.h"

#include <math.h>
#include <stdlib.h>

const measure_kind measure_kinds[MEASURE_COUNT] = {
    [MEASURE_STRESS_RANGE] = {"stress_range", "largest less smallest sxx", false},
    [MEASURE_SWT] = {"swt", "Smith, Watson and Topper's parameter, on the critical plane", false},
    [MEASURE_SWT_ANGLE] = {"swt_angle", "from the surface's normal to that of the plane, deg",
                           true},
    [MEASURE_FATEMI_SOCIE] = {"fatemi_socie", "Fatemi and Socie's; needs a yield stress", false},
    [MEASURE_FS_ANGLE] = {"fs_angle", "that of its plane", true},
    [MEASURE_SLIP_RANGE] = {"slip_range", "largest less smallest slip", false},
    [MEASURE_RUIZ_F1] = {"ruiz_f1", "largest |q| * slip range", false},
    [MEASURE_RUIZ_F2] = {"ruiz_f2", "F1 * largest sxx; 0 in compression", false},
    [MEASURE_ENERGY_PER_AREA] = {"energy_per_area", "dissipated by friction, integral of q d(slip)",
                                 false},
};

/* ---- The states ---- */

static bool add_state(last_cycle *of, const rwedge_contact *contact)
{
    cycle_state *next = &of->state[of->states];
    *next = (cycle_state){.left = NAN, .right = NAN};
    if (rwedge_contact_copy(contact, &next->contact) != RWEDGE_OK) {
        failure("out of memory");
        return false;
    }
    of->states++;
    rwedge_contact_edges(contact, &next->left, &next->right);
    const double edges[2] = {next->left, next->right};
    double slip[2];
    if (!isnan(next->left) && rwedge_contact_slip(contact, 2, edges, slip) != RWEDGE_OK)
        of->slip_known = false;
    return true;
}

static double part_of(double from, double to, int i, int parts)
{
    return i == parts ? to : from + (to - from) * i / parts;
}

/* The states on the way to a load, but the last. Where one of them has no closed form, there are
 * none: the whole step has. */
static bool add_parts(last_cycle *of, load to, int parts, const rwedge_contact *contact)
{
    load from;
    rwedge_contact *on_the_way = NULL;
    const size_t states = of->states;
    rwedge_contact_loads(contact, &from.P, &from.M, &from.Q, &from.sigma);
    if (from.P == to.P && from.M == to.M)
        return true;
    int32_t status = rwedge_contact_copy(contact, &on_the_way);
    for (int i = 1; i < parts && status == RWEDGE_OK; i++) {
        status = rwedge_contact_apply(
            on_the_way, part_of(from.P, to.P, i, parts), part_of(from.M, to.M, i, parts),
            part_of(from.Q, to.Q, i, parts), part_of(from.sigma, to.sigma, i, parts));
        if (status == RWEDGE_OK && !add_state(of, on_the_way))
            status = RWEDGE_ENOMEM;
    }
    rwedge_contact_destroy(on_the_way);
    while (status != RWEDGE_OK && of->states > states)
        rwedge_contact_destroy(of->state[--of->states].contact);
    return status != RWEDGE_ENOMEM;
}

static bool make_room(last_cycle *of, int parts)
{
    of->state = calloc(of->loads * (size_t)parts + 1, sizeof *of->state);
    if (of->state == NULL)
        failure("out of memory");
    return of->state != NULL;
}

static bool go_through(const course *whole, size_t first, int parts, rwedge_contact *contact,
                       last_cycle *of)
{
    for (size_t step = 0; step < whole->steps; step++) {
        if (step == first && !add_state(of, contact))
            return false;
        if (step >= first && !add_parts(of, course_load(whole, step), parts, contact))
            return false;
        if (!course_go_on(whole, step, contact) || (step >= first && !add_state(of, contact)))
            return false;
        of->state[of->states > 0 ? of->states - 1 : 0].is_load = step >= first;
    }
    return true;
}

bool last_cycle_begin(const course *whole, double k_over_sy, int parts, last_cycle *of)
{
    *of = (last_cycle){.what = &whole->what, .k_over_sy = k_over_sy, .slip_known = true};
    of->loads = whole->steps < whole->loads.count ? whole->steps : whole->loads.count;
    rwedge_contact *contact = make_room(of, parts) ? course_begin(whole) : NULL;
    const bool done =
        contact != NULL && go_through(whole, whole->steps - of->loads, parts, contact, of);
    rwedge_contact_destroy(contact);
    return done;
}

void last_cycle_free(last_cycle *of)
{
    for (size_t i = 0; i < of->states; i++)
        rwedge_contact_destroy(of->state[i].contact);
    free(of->state);
    *of = (last_cycle){0};
}

/* ---- Stresses ---- */

/* Of the loads at the places: the three components one after the other. */
static int32_t stresses(const last_cycle *of, size_t n, const double x[], const double y[],
                        double *stress)
{
    const size_t all = of->loads * n;
    int32_t status = RWEDGE_OK;
    for (size_t i = 0; i < of->states && status == RWEDGE_OK; i++) {
        if (!of->state[i].is_load)
            continue;
        status = rwedge_contact_stresses(of->state[i].contact, n, x, y, stress, stress + all,
                                         stress + 2 * all);
        stress += n;
    }
    return status;
}

static double largest_sxx(const last_cycle *of, size_t n, const double *stress, size_t place,
                          double sign)
{
    double most = -HUGE_VAL;
    for (size_t i = 0; i < of->loads; i++)
        most = fmax(most, sign * stress[i * n + place]);
    return sign * most;
}

/* room holds 4 n numbers. */
static int32_t critical_planes(const last_cycle *of, size_t n, const double *stress, double *room,
                               measures found[])
{
    const double *sxx = stress, *syy = stress + of->loads * n, *txy = stress + 2 * of->loads * n;
    const double E = of->what->E1, nu = of->what->nu1;
    const bool strength = !isnan(of->k_over_sy);
    int32_t status =
        rwedge_smith_watson_topper_field(of->loads, n, sxx, syy, txy, E, nu, room, room + n);
    if (status == RWEDGE_OK && strength)
        status = rwedge_fatemi_socie_field(of->loads, n, sxx, syy, txy, E, nu, of->k_over_sy,
                                           room + 2 * n, room + 3 * n);
    for (size_t i = 0; i < n && status == RWEDGE_OK; i++) {
        found[i].value[MEASURE_SWT] = room[i];
        found[i].value[MEASURE_SWT_ANGLE] = degrees(room[n + i]);
        found[i].value[MEASURE_FATEMI_SOCIE] = strength ? room[2 * n + i] : NAN;
        found[i].value[MEASURE_FS_ANGLE] = strength ? degrees(room[3 * n + i]) : NAN;
        found[i].value[MEASURE_STRESS_RANGE] =
            largest_sxx(of, n, stress, i, 1) - largest_sxx(of, n, stress, i, -1);
    }
    return status;
}

/* ---- Slip ---- */

static const double ROUNDING = 1e-12; /* of an edge, in widths of the contact */

/* An edge of one load may lie outside the contact of another by a rounding. */
static bool is_inside(const cycle_state *state, double *x)
{
    const double rounding = ROUNDING * (state->right - state->left);
    if (!(*x >= state->left - rounding && *x <= state->right + rounding))
        return false;
    *x = fmin(fmax(*x, state->left), state->right);
    return true;
}

/* Slip may jump at an edge. A place within a rounding of an edge is moved inwards, so that all
 * states see it on the same side. */
static double off_the_edges(const last_cycle *of, double x)
{
    double inside = x;
    for (size_t i = 0; i < of->states; i++) {
        const cycle_state *state = &of->state[i];
        const double margin = 4 * ROUNDING * (state->right - state->left);
        if (fabs(x - state->left) <= margin)
            inside = fmax(inside, state->left + margin);
        if (fabs(x - state->right) <= margin)
            inside = fmin(inside, state->right - margin);
    }
    return inside;
}

double last_cycle_slip(const last_cycle *of, size_t state, double x)
{
    double slip;
    return is_inside(&of->state[state], &x) &&
                   rwedge_contact_slip(of->state[state].contact, 1, &x, &slip) == RWEDGE_OK
               ? slip
               : NAN;
}

/* What friction does at one place, from state to state. */
typedef struct {
    bool touches;
    double slip, limit; /* of the last state: slip; f |p| */
    double most, least, shear, energy;
} rubbing;

/* Where a place slips, its shear is f |p| all the way from one state to the next; p is taken to
 * change in proportion to the slip. */
static void slip_to(rubbing *at, double slip, double limit)
{
    at->energy += (at->limit + limit) / 2 * fabs(slip - at->slip);
    at->most = fmax(at->most, slip);
    at->least = fmin(at->least, slip);
    at->slip = slip;
    at->limit = limit;
}

/* The place slips until the edge passes it. How much it slips is interpolated: at the edge's new
 * position the change of slip is known, at its old position it is 0. The change is taken, not the
 * slip: slip jumps at the border of what the contact has never left. */
static void leave(const last_cycle *of, rubbing *at, double x, size_t to)
{
    const cycle_state *before = &of->state[to - 1], *after = &of->state[to];
    const bool to_the_left = x < after->left;
    const double start = to_the_left ? before->left : before->right;
    const double end = to_the_left ? after->left : after->right;
    const double near = off_the_edges(of, end);
    const double change = last_cycle_slip(of, to, near) - last_cycle_slip(of, to - 1, near);
    if (!isnan(change)) /* part of the contact is where some of it was */
        slip_to(at, at->slip + change * (x - start) / (end - start), 0);
    at->touches = false;
}

/* It begins without slip and pressure where it comes into contact. */
static void touch(rubbing *at)
{
    at->touches = true;
    at->slip = at->limit = 0;
}

static int32_t rub_through(const last_cycle *of, double x, rubbing *at)
{
    *at = (rubbing){.most = -HUGE_VAL, .least = HUGE_VAL};
    const double inside = off_the_edges(of, x);
    for (size_t i = 0; i < of->states; i++) {
        const cycle_state *now = &of->state[i];
        double place = inside, p, q, slip;
        if (!is_inside(now, &place)) {
            if (at->touches)
                leave(of, at, inside, i);
            continue;
        }
        int32_t status = rwedge_contact_slip(now->contact, 1, &place, &slip);
        place = fmin(fmax(x, now->left), now->right);
        if (status == RWEDGE_OK)
            status = rwedge_contact_tractions(now->contact, 1, &place, &p, &q);
        if (status != RWEDGE_OK)
            return status;
        if (!at->touches)
            touch(at);
        slip_to(at, slip, of->what->f * fabs(p));
        at->shear = fmax(at->shear, fabs(q));
        if (i == 0) /* what came before the cycle is none of its energy */
            *at = (rubbing){true, slip, at->limit, slip, slip, at->shear, 0};
    }
    return RWEDGE_OK;
}

static int32_t friction(const last_cycle *of, double x, double tension, measures *found)
{
    rubbing at;
    const int32_t status = rub_through(of, x, &at);
    if (status != RWEDGE_OK || at.most < at.least)
        return status;
    const double range = at.most - at.least;
    found->value[MEASURE_SLIP_RANGE] = range;
    found->value[MEASURE_RUIZ_F1] = at.shear * range;
    found->value[MEASURE_RUIZ_F2] = fmax(tension, 0) * at.shear * range;
    found->value[MEASURE_ENERGY_PER_AREA] = at.energy;
    return RWEDGE_OK;
}

/* ---- All ---- */

static int32_t measure(const last_cycle *of, size_t n, const double x[], const double y[],
                       double *stress, double *room, measures found[])
{
    int32_t status = stresses(of, n, x, y, stress);
    if (status == RWEDGE_OK)
        status = critical_planes(of, n, stress, room, found);
    for (size_t i = 0; i < n && status == RWEDGE_OK; i++)
        if (y[i] == 0 && of->slip_known)
            status = friction(of, x[i], largest_sxx(of, n, stress, i, 1), &found[i]);
    return status;
}

static void forget(measures *found)
{
    for (int m = 0; m < MEASURE_COUNT; m++)
        found->value[m] = NAN;
}

/* Infinite at the apex of the sharp wedge: another point stands for it. */
int32_t last_cycle_measure(const last_cycle *of, size_t n, const double x[], const double y[],
                           measures found[])
{
    double *room = malloc((3 * of->loads + 6) * n * sizeof *room);
    if (room == NULL)
        return RWEDGE_ENOMEM;
    double *at_x = room + (3 * of->loads + 4) * n, *at_y = at_x + n;
    const bool sharp = of->what->a == 0;
    for (size_t i = 0; i < n; i++) {
        at_x[i] = x[i];
        at_y[i] = sharp && x[i] == 0 && y[i] == 0 ? 1 : y[i];
        forget(&found[i]);
    }
    const int32_t status = measure(of, n, at_x, at_y, room, room + 3 * of->loads * n, found);
    for (size_t i = 0; i < n; i++)
        if (at_y[i] != y[i])
            forget(&found[i]);
    free(room);
    return status;
}
