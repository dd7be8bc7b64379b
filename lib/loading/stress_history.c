/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Stresses at many points through many loads. First the contact goes through the loads, and a
 * record notes its states; then the points are computed. */
#include "contact/record.h"

static bool have_stress(const rwedge_contact *contact, const rw_stress_points *p)
{
    for (size_t i = 0; i < p->n; i++)
        if (!rw_contact_has_stress(contact, p->x[i], p->y[i]))
            return false;
    return true;
}

/* Points have to be in the domain in units of the half-width too, the least and the largest. */
static int32_t load_all(rwedge_contact *contact, const rw_load_history *loads,
                        const rw_stress_points *p, rw_record *r)
{
    double least = HUGE_VAL, most = 0;
    for (size_t i = 0; i < loads->count; i++) {
        const rw_loads to = rw_loads_at(loads, i);
        const int32_t status = rwedge_contact_apply(contact, to.P, to.M, to.Q, to.sigma);
        if (status != RWEDGE_OK)
            return status;
        const double b = rwedge_contact_half_width(contact);
        if ((b == 0 || b < least || b > most) && !have_stress(contact, p))
            return RWEDGE_EDOMAIN;
        least = b > 0 ? fmin(b, least) : least;
        most = fmax(b, most);
        if (!rw_record_add(r, contact, NULL))
            return RWEDGE_ENOMEM;
    }
    return RWEDGE_OK;
}

static int32_t follow(rwedge_contact *contact, const rw_load_history *loads,
                      const rw_stress_points *p)
{
    rw_record r = {.count = 0};
    int32_t status = load_all(contact, loads, p, &r);
    if (status == RWEDGE_OK && !rw_record_stresses(&r, contact, p))
        status = RWEDGE_ENOMEM;
    rw_record_destroy(&r);
    return status;
}

int32_t rwedge_contact_stress_history(rwedge_contact *contact, size_t loads, const double P[],
                                      const double M[], const double Q[], const double sigma[],
                                      size_t n, const double x[], const double y[], double sxx[],
                                      double syy[], double txy[])
{
    const rw_load_history history = {loads, P, M, Q, sigma};
    const rw_stress_points p = {n, x, y, sxx, syy, txy};
    if (!contact || !rw_is_load_history(&history) || (n > 0 && (!x || !y)) ||
        (n > 0 && loads > 0 && (!sxx || !syy || !txy)))
        return RWEDGE_ENULL;
    rwedge_contact *ahead;
    int32_t status = rwedge_contact_copy(contact, &ahead);
    if (status != RWEDGE_OK)
        return status;
    status = follow(ahead, &history, &p);
    if (status == RWEDGE_OK)
        rw_contact_exchange(contact, ahead);
    rwedge_contact_destroy(ahead);
    return status;
}
