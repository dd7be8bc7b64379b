/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "table.h"

#include "model/results/results.h"

#include <math.h>

const table_variable flat_over_b = {
    "a-over-b",
    "a_over_b",
    "a/b of a flat pad",
    0,
    0.999,
    "a number from 0 to 0.999",
    "0,0.2,0.4,0.5,0.6,0.7,0.8,0.9,0.95,0.99",
};

/* With b and A of 1, the edges being known farther than that: Hertz' load less a rounded wedge's.
 */
static const double RADIUS = 2;

static double load_of(double alpha)
{
    return (PI / 2 - (alpha > 0 ? alpha * rwedge_load(alpha) : 0)) / RADIUS;
}

/* Destroy the contact in either case. */
static int32_t slide(double alpha, double f, rwedge_contact **contact)
{
    *contact = NULL;
    const int32_t status = rwedge_contact_create_flat(alpha, RADIUS, 1, f, contact);
    const double P = load_of(alpha);
    return status == RWEDGE_OK ? rwedge_contact_load(*contact, P, f * P) : status;
}

/* The stress hardly changes around its top. */
static double rounded(double place)
{
    return round(1e5 * place) / 1e5;
}

/* Without friction there is a top below each edge. */
int32_t flat_elastic_limit(const double value[], cell row[])
{
    const double alpha = value[A_OVER_B], f = value[FRICTION], nu = value[NU];
    double factor, x, y;
    rwedge_contact *contact;
    int32_t status = slide(alpha, f, &contact);
    if (status == RWEDGE_OK)
        status = rwedge_contact_yield_factor(contact, nu, 1, &factor, &x, &y);
    rwedge_contact_destroy(contact);
    if (status != RWEDGE_OK)
        return status;
    row[0] = cell_number(alpha);
    row[1] = cell_number(f);
    row[2] = cell_number(nu);
    row[3] = cell_number(load_of(alpha) * factor);
    row[4] = cell_number(rounded(f == 0 ? fabs(x) : x));
    row[5] = cell_number(rounded(y));
    row[6] = cell_text(y > 0 ? "subsurface" : "surface");
    return RWEDGE_OK;
}

int32_t flat_contact_law(const double value[], cell row[])
{
    const contact_case setup = {.shape = value[A_OVER_B] > 0 ? pad_flat(value[A_OVER_B], RADIUS)
                                                             : pad_cylinder(RADIUS),
                                .A = 1};
    const double alpha = value[A_OVER_B], total = RADIUS * load_of(alpha), middle = 0;
    double p, q;
    rwedge_contact *contact;
    int32_t status = slide(alpha, 0, &contact);
    if (status == RWEDGE_OK)
        status = rwedge_contact_tractions(contact, 1, &middle, &p, &q);
    row[0] = cell_number(alpha);
    row[1] = cell_number(total);
    row[2] = cell_number(total / (alpha * alpha));
    if (status == RWEDGE_OK) {
        row[3] = cell_number(RADIUS * peak_pressure(&setup, contact));
        row[4] = cell_number(-RADIUS * p);
    }
    rwedge_contact_destroy(contact);
    return status;
}
