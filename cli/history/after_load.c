/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "history.h"

#include <math.h>

const after_load_kind after_load_kinds[AFTER_COUNT] = {
    [AFTER_LOAD] = {"load", "its number, from 1"},
    [AFTER_P] = {"P", "normal force"},
    [AFTER_M] = {"M", "moment"},
    [AFTER_Q] = {"Q", "tangential force"},
    [AFTER_SIGMA] = {"sigma", "bulk tension"},
    [AFTER_LEFT] = {"left", "left edge of the contact; empty when separated"},
    [AFTER_RIGHT] = {"right", "right edge of the contact"},
    [AFTER_STICK_LEFT] = {"stick_left", "left edge of the stick zone; empty in full sliding"},
    [AFTER_STICK_RIGHT] = {"stick_right", "right edge of the stick zone"},
    [AFTER_TILT] = {"tilt", "angle by which the moment tilts body 2, in radians"},
    [AFTER_PEAK_PRESSURE] = {"peak_pressure", "largest pressure; empty where it is infinite"},
    [AFTER_TENSION_LEFT] = {"tension_left", "sxx at the left edge of the contact"},
    [AFTER_TENSION_RIGHT] = {"tension_right", "sxx at its right edge"},
    [AFTER_LARGEST_SLIP] = {"largest_slip", "largest magnitude of slip since the bodies touched"},
    [AFTER_ENERGY] = {"energy", "dissipated by friction so far, per unit thickness"},
    [AFTER_YIELD_FACTOR] = {"yield_factor", "k over the largest sqrt(J2); needs a yield stress"},
    [AFTER_YIELD_X] = {"yield_x", "where that is"},
    [AFTER_YIELD_Y] = {"yield_y", "and how deep"},
    [AFTER_WARNINGS] = {"warnings", "what makes these numbers doubtful"},
    [AFTER_ERROR] = {"error", "estimated, of q over f p0, where it is computed; 0 is exact"},
};

/* A contact and its edges. */
typedef struct {
    const rwedge_contact *contact;
    double left, right;
} touching;

static double slip_size_at(const void *contact, double x)
{
    double slip;
    return rwedge_contact_slip(contact, 1, &x, &slip) == RWEDGE_OK ? fabs(slip) : NAN;
}

static int32_t edges(const contact_case *setup, const touching *at, cell row[])
{
    const double edge[2] = {at->left, at->right}, surface[2] = {0, 0};
    double sxx[2], syy[2], txy[2], left, right;
    row[AFTER_LEFT] = cell_number(at->left);
    row[AFTER_RIGHT] = cell_number(at->right);
    row[AFTER_TILT] = cell_number(rwedge_contact_tilt(at->contact));
    row[AFTER_PEAK_PRESSURE] = cell_number(peak_pressure(setup, at->contact));
    row[AFTER_LARGEST_SLIP] =
        cell_number(peak_over(at->left, at->right, slip_size_at, at->contact));
    if (rwedge_contact_stick_zone(at->contact, &left, &right) == RWEDGE_OK) {
        row[AFTER_STICK_LEFT] = cell_number(left);
        row[AFTER_STICK_RIGHT] = cell_number(right);
    }
    const int32_t status = rwedge_contact_stresses(at->contact, 2, edge, surface, sxx, syy, txy);
    if (status == RWEDGE_OK) {
        row[AFTER_TENSION_LEFT] = cell_number(sxx[0]);
        row[AFTER_TENSION_RIGHT] = cell_number(sxx[1]);
    }
    return status;
}

static int32_t strength(const contact_case *setup, const rwedge_contact *contact, double *factor,
                        cell row[])
{
    double x, y;
    if (isnan(setup->k))
        return RWEDGE_OK;
    const int32_t status =
        rwedge_contact_yield_factor(contact, setup->nu1, setup->k, factor, &x, &y);
    if (status == RWEDGE_OK) {
        row[AFTER_YIELD_FACTOR] = cell_number(*factor);
        row[AFTER_YIELD_X] = cell_number(x);
        row[AFTER_YIELD_Y] = cell_number(y);
    }
    return status == RWEDGE_EABSENT ? RWEDGE_OK : status;
}

static void loads(const rwedge_contact *contact, size_t number, cell row[])
{
    load now;
    rwedge_contact_loads(contact, &now.P, &now.M, &now.Q, &now.sigma);
    row[AFTER_LOAD] = cell_number((double)number);
    row[AFTER_P] = cell_number(now.P);
    row[AFTER_M] = cell_number(now.M);
    row[AFTER_Q] = cell_number(now.Q);
    row[AFTER_SIGMA] = cell_number(now.sigma);
    row[AFTER_ENERGY] = cell_number(rwedge_contact_dissipated_energy(contact));
}

void after_load_compute(const contact_case *setup, const rwedge_contact *contact, size_t number,
                        after_load *row)
{
    double factor = NAN;
    touching at = {.contact = contact};
    int32_t status = RWEDGE_OK;
    for (int i = 0; i < AFTER_COUNT; i++)
        row->value[i] = cell_empty();
    loads(contact, number, row->value);
    if (rwedge_contact_edges(contact, &at.left, &at.right) == RWEDGE_OK) {
        status = edges(setup, &at, row->value);
        if (status == RWEDGE_OK)
            status = strength(setup, contact, &factor, row->value);
    }
    if (status != RWEDGE_OK)
        failure("load %zu: %s", number, rwedge_strerror(status));
    row->doubts = doubts_of_factor(setup, contact, factor);
    row->warnings[0] = '\0';
    doubts_write(row->doubts, row->warnings, sizeof row->warnings);
    row->value[AFTER_WARNINGS] = cell_text(row->warnings);
    row->value[AFTER_ERROR] = cell_number(row->doubts.error);
}
