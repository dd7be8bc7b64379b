/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "results.h"

#include <math.h>

/* The pressure's top and its values at x = -a and a have no closed form under a moment. */
static void tilted(const contact_case *setup, double b, cell row[])
{
    row[RESULT_B] = cell_number(b);
    if (setup->shape.kind == PAD_WEDGE) {
        row[RESULT_A_OVER_B] = cell_number(setup->shape.a / b);
        row[RESULT_AP_OVER_THETA_B] = cell_number(setup->A * setup->P / (setup->shape.theta * b));
    }
    row[RESULT_P0] = row[RESULT_P_TRANSITION] = cell_empty();
}

static void of_pad(const contact_case *setup, const rwedge_contact *contact, double b, cell row[])
{
    row[RESULT_A] = cell_number(setup->A);
    row[RESULT_BETA] = cell_number(setup->beta);
    row[RESULT_RADIUS] = cell_number(setup->shape.radius);
    row[RESULT_B] = cell_number(b);
    row[RESULT_P0] = cell_number(peak_pressure(setup, contact));
}

/* Without friction there is neither stick nor slip to speak of. */
static void friction(const contact_case *setup, const rwedge_contact *contact, double b, cell row[])
{
    if (setup->f == 0)
        return;
    const double c = rwedge_contact_stick_half_width(contact);
    double left, right;
    row[RESULT_Q_OVER_FP] = cell_number(case_shear_ratio(setup));
    row[RESULT_C] = cell_number(c);
    row[RESULT_C_OVER_B] = cell_number(c / b);
    if (rwedge_contact_stick_zone(contact, &left, &right) != RWEDGE_OK)
        return;
    row[RESULT_STICK_LEFT] = cell_number(left);
    row[RESULT_STICK_RIGHT] = cell_number(right);
}

/* The larger of the two edges' is that of the trailing edge. */
static int32_t tension(const rwedge_contact *contact, const double edge[2], cell row[])
{
    const double surface[2] = {0, 0};
    double sxx[2], syy[2], txy[2];
    const int32_t status = rwedge_contact_stresses(contact, 2, edge, surface, sxx, syy, txy);
    if (status == RWEDGE_OK)
        row[RESULT_TENSION] = cell_number(fmax(sxx[0], sxx[1]));
    return status;
}

int32_t results_of_state(const contact_case *setup, cell row[], double *error)
{
    rwedge_contact *contact = NULL;
    double edge[2];
    int32_t status = case_loaded(setup, &contact);
    if (status == RWEDGE_OK)
        status = rwedge_contact_edges(contact, &edge[0], &edge[1]);
    if (status == RWEDGE_OK) {
        const double b = rwedge_contact_half_width(contact);
        if (!pad_has_formulas(&setup->shape))
            of_pad(setup, contact, b, row);
        else if (setup->M != 0)
            tilted(setup, b, row);
        row[RESULT_LEFT] = cell_number(edge[0]);
        row[RESULT_RIGHT] = cell_number(edge[1]);
        row[RESULT_TILT] = cell_number(rwedge_contact_tilt(contact));
        friction(setup, contact, b, row);
        if (!isnan(setup->k))
            row[RESULT_LOAD_OVER_BK] = cell_number(setup->P / b / setup->k);
        *error = rwedge_contact_error(contact);
        status = tension(contact, edge, row);
    }
    rwedge_contact_destroy(contact);
    return status;
}
