/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "model.h"

#include <math.h>
#include <stdarg.h>
#include <stdio.h>

load loads_of(const rwedge_contact *contact)
{
    load now = {.P = 0};
    rwedge_contact_loads(contact, &now.P, &now.M, &now.Q, &now.sigma);
    return now;
}

bool loads_are_guided(const load to[], size_t count)
{
    return count > 0 && to[0].is_guided;
}

bool loads_are_driven(const load to[], size_t count)
{
    return count > 0 && to[0].is_driven;
}

bool loads_turn(const load to[], size_t count)
{
    for (size_t i = 1; i < count; i++)
        if (to[i].is_guided && to[i].tilt != to[0].tilt)
            return true;
    return false;
}

bool loads_read_compliance(const char *text, char decimal_sign, const unit_system *units,
                           double *value, complaint *why)
{
    const double width = isnan(units->width) ? 1 : units->width;
    const char *own = NULL;
    double number, factor = width;
    if (!quantity_read(text, decimal_sign, &number, &own))
        return complain(why, "must be a number, with a decimal %s",
                        decimal_sign == ',' ? "comma" : "point");
    if (own != NULL && units_factor(units, own, "length/force", SHARE_NONE, &factor, why)) {
        if (isnan(units->width))
            return complain(why, "is of the whole contact; needed: its width too");
        factor *= width;
    } else if (own != NULL && !units_factor(units, own, "area/force", SHARE_NONE, &factor, why))
        return false;
    *value = number * factor;
    return (*value >= 0 && number_is_size(*value)) || complain(why, "must be a number not below 0");
}

static double between(double from, double to, int i, int n)
{
    return from + (to - from) * i / n;
}

load loads_between(load from, load to, int i, int n)
{
    return (load){.P = between(from.P, to.P, i, n),
                  .M = between(from.M, to.M, i, n),
                  .Q = between(from.Q, to.Q, i, n),
                  .sigma = between(from.sigma, to.sigma, i, n),
                  .is_driven = to.is_driven,
                  .displacement = between(from.displacement, to.displacement, i, n),
                  .compliance = to.compliance};
}

int32_t loads_apply(load to, rwedge_contact *contact)
{
    double Q;
    if (to.is_driven) /* a pad that is held keeps its tilt */
        return rwedge_contact_drive(contact, to.P, to.is_guided ? 0 : to.M, to.sigma,
                                    to.displacement, to.compliance, &Q);
    return to.is_guided ? rwedge_contact_guide(contact, to.P, to.tilt, to.Q, to.sigma)
                        : rwedge_contact_apply(contact, to.P, to.M, to.Q, to.sigma);
}

int32_t loads_hold(double tilt, rwedge_contact *contact)
{
    const int32_t status = rwedge_contact_set_rotation(contact, 1);
    return status == RWEDGE_OK ? rwedge_contact_guide(contact, 0, tilt, 0, 0) : status;
}

int32_t loads_apply_monotonic(load to, rwedge_contact *contact)
{
    const int32_t status = loads_apply((load){.P = to.P, .M = to.M}, contact);
    return status == RWEDGE_OK ? loads_apply(to, contact) : status;
}

/* ---- What is wrong with a load ---- */

/* The library's status where an error is allowed; 0: nothing is computed, which takes seconds near
 * the largest moment. */
static int32_t try_load(load to, const rwedge_contact *contact, double allowed)
{
    rwedge_contact *trial = NULL;
    int32_t status = rwedge_contact_copy(contact, &trial);
    if (status == RWEDGE_OK)
        status = rwedge_contact_allow_error(trial, allowed);
    if (status == RWEDGE_OK)
        status = loads_apply(to, trial);
    rwedge_contact_destroy(trial);
    return status;
}

/* Whatever has a size is 0 or at least this: the library's header. */
static const double SIZE_LEAST = 1e-60;

/* The magnitude below which a moment lays no flank on the surface, to the digits that are shown. */
static double largest_moment(load to, const rwedge_contact *contact)
{
    double allowed = 0, refused = to.M;
    while (fabs(refused) >= SIZE_LEAST && fabs(refused - allowed) > 1e-7 * fabs(refused)) {
        to.M = allowed + (refused - allowed) / 2;
        if (try_load(to, contact, 0) != RWEDGE_EDOMAIN)
            allowed = to.M;
        else
            refused = to.M;
    }
    return fabs(allowed);
}

PRINTF_LIKE(2, 3)
static load_fault fault_at(int input, const char *format, ...)
{
    load_fault fault = {.input = input};
    va_list values;
    va_start(values, format);
    vsnprintf(fault.why.text, sizeof fault.why.text, format, values);
    va_end(values);
    return fault;
}

/* The first of the four loads that is neither 0 nor a size: INPUT_COUNT where all are. */
static int not_a_size(load to)
{
    const double part[] = {to.P, to.M, to.Q, to.sigma};
    const int input[] = {INPUT_P, INPUT_M, INPUT_Q, INPUT_SIGMA};
    for (int i = 0; i < 4; i++)
        if (!number_is_size(part[i]))
            return input[i];
    return INPUT_COUNT;
}

static load_fault domain_fault(load to, const rwedge_contact *contact)
{
    load level = to;
    level.M = level.tilt = 0;
    if (not_a_size(to) != INPUT_COUNT)
        return fault_at(not_a_size(to), "must be 0, or 1e-60 to 1e60 in magnitude");
    if (to.P < 0)
        return fault_at(INPUT_P, "must not be below 0, and Q must be 0 where P is");
    if (to.is_guided && try_load(level, contact, 0) != RWEDGE_EDOMAIN)
        return fault_at(INPUT_TILT, "so large a tilt lays a flank on the surface");
    if (to.P == 0 && to.M != 0)
        return fault_at(INPUT_M, "must be 0 where P is");
    if (try_load(level, contact, 0) == RWEDGE_EDOMAIN)
        return fault_at(INPUT_COUNT, "%s", rwedge_strerror(RWEDGE_EDOMAIN));
    const double most = largest_moment(to, contact);
    return fault_at(INPUT_M,
                    most > 0 ? "must be below %.6g in magnitude: more lays a flank on the surface"
                             : "must be %.6g: any other lays a flank on the surface",
                    most);
}

static load_fault range_fault(load to, const rwedge_contact *contact)
{
    const double last = loads_of(contact).P;
    if (to.P > 0 && to.P < 1e-8 * last)
        return fault_at(INPUT_COUNT,
                        "P %.6g is below 1e-8 of the last P, %.6g; allowed: a load between them",
                        to.P, last);
    return fault_at(INPUT_COUNT, "the contact would reach farther than the radius, or results "
                                 "leave 1e-60 to 1e60; allowed: smaller loads, or larger ones");
}

/* What is wrong with a displacement. */
static load_fault drive_fault(load to, const rwedge_contact *contact)
{
    if (rwedge_contact_beta(contact) != 0)
        return fault_at(INPUT_COUNT, "the displacement is not known: unlike bodies slide fully");
    const bool is_refused = try_load(to, contact, usual_tolerance) == RWEDGE_OK;
    return fault_at(INPUT_COUNT, "the displacement is not known: %s",
                    is_refused ? "no closed form; without --exact it is computed"
                               : "the bodies slid before there was a displacement");
}

static load_fault path_fault(load to, const rwedge_contact *contact)
{
    if (to.is_driven)
        return drive_fault(to, contact);
    const load last = loads_of(contact);
    load_fault fault = to.is_guided
                           ? fault_at(INPUT_SIGMA, "no closed form")
                           : fault_at(INPUT_SIGMA, "no closed form: %s",
                                      rwedge_contact_obstacle(contact, to.P, to.M, to.Q, to.sigma));
    const double most = rwedge_contact_largest_tension_step(contact, to.Q);
    if (to.P == last.P && to.M == last.M && fabs(to.sigma - last.sigma) > most)
        list_add(fault.why.text, sizeof fault.why.text, "; ",
                 "sigma may change by %.6g with this Q", most);
    if (rwedge_contact_beta(contact) != 0 || try_load(to, contact, usual_tolerance) == RWEDGE_OK)
        list_add(fault.why.text, sizeof fault.why.text, "; ", "without --exact it is computed");
    return fault;
}

load_fault loads_fault(int32_t status, load to, double f, const rwedge_contact *contact)
{
    if (status == RWEDGE_EDOMAIN)
        return domain_fault(to, contact);
    if (status == RWEDGE_ERANGE)
        return range_fault(to, contact);
    if (status == RWEDGE_EPATH)
        return path_fault(to, contact);
    if (status == RWEDGE_ESLIDING)
        return fault_at(INPUT_Q, "must not exceed f P = %.6g: there is no equilibrium", f * to.P);
    const bool is_first = rwedge_contact_beta(contact) != 0 && loads_of(contact).P == 0;
    return fault_at(INPUT_COUNT, "%s%s", rwedge_strerror(status),
                    status != RWEDGE_ENOCONV ? ""
                    : is_first ? ": the first load of unlike bodies has too large an M or sigma; "
                                 "allowed: P alone first, then the rest"
                               : ": smaller loads may go");
}

bool loads_spare_flanks(const pad *shape, const rwedge_contact *contact, complaint *why)
{
    const pad_profile *places = shape->places;
    double left = 0, right = 0;
    if (places == NULL || !places->is_cut)
        return true;
    rwedge_contact_edges(contact, &left, &right);
    return (left >= places->left && right <= places->right) ||
           complain(why,
                    "the contact, from %.6g to %.6g, reaches flanks that were left out as too "
                    "steep for the theory, below %.6g and above %.6g; allowed: a smaller load",
                    left, right, places->left, places->right);
}

bool loads_apply_next(load to, const pad *shape, double f, rwedge_contact *contact, complaint *why)
{
    const int32_t status = loads_apply(to, contact);
    if (status == RWEDGE_OK)
        return loads_spare_flanks(shape, contact, why);
    const load_fault fault = loads_fault(status, to, f, contact);
    char value[NUMBER_SIZE];
    const double part[INPUT_COUNT] = {[INPUT_TILT] = to.tilt,
                                      [INPUT_P] = to.P,
                                      [INPUT_M] = to.M,
                                      [INPUT_Q] = to.Q,
                                      [INPUT_SIGMA] = to.sigma};
    if (fault.input == INPUT_COUNT || status == RWEDGE_EPATH) /* the path has no one to blame */
        return complain(why, "%s", fault.why.text);
    number_write(part[fault.input], NUMBER_DIGITS, '.', value);
    return complain(why, "%s %s: %s", input_kinds[fault.input].column, value, fault.why.text);
}
