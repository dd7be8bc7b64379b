/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The normal load of a largest pressure. No pressure falls where a convex profile is pressed
 * further: the largest one grows with the load. */
#include "base/root.h"
#include "contact/contact.h"

typedef struct {
    const rwedge_contact *apart;
    double pressure;
    int32_t *status; /* of the first load that is refused */
} question;

static int32_t press(rwedge_contact *contact, double P)
{
    return contact->is_held ? rwedge_contact_guide(contact, P, rwedge_contact_tilt(contact), 0, 0)
                            : rwedge_contact_apply(contact, P, 0, 0, 0);
}

static int32_t peak_under(const rwedge_contact *apart, double P, double *pressure)
{
    rwedge_contact *contact = NULL;
    double x;
    int32_t status = rwedge_contact_copy(apart, &contact);
    if (status == RWEDGE_OK)
        status = press(contact, P);
    if (status == RWEDGE_OK)
        status = rwedge_contact_peak_pressure(contact, pressure, &x);
    rwedge_contact_destroy(contact);
    return status;
}

/* The logarithm of the pressure over the wanted one. An infinite pressure, where a kink touches,
 * is so much more; one that is lost in rounding so much less. NaN where the load is refused. */
static double excess(double log_P, const void *of)
{
    static const double INFINITE = 600;
    const question *asked = of;
    double pressure;
    const int32_t status = fabs(log_P) > log(RW_LARGEST)
                               ? RWEDGE_EDOMAIN
                               : peak_under(asked->apart, exp(log_P), &pressure);
    if (status == RWEDGE_EABSENT)
        return INFINITE;
    if (status != RWEDGE_OK && *asked->status == RWEDGE_OK)
        *asked->status = status;
    if (status != RWEDGE_OK)
        return NAN;
    return pressure > 0 ? log(pressure / asked->pressure) : -INFINITE;
}

/* The logarithm of the load; NaN where none is found. The steps go from a load of the pad's own
 * size as far as loads go. */
static double search(const question *asked, double from)
{
    static const double STEP = 2, SURE = 1e-3;
    const double first = excess(from, asked);
    if (isnan(first))
        return NAN;
    const double step = first > 0 ? -STEP : STEP;
    double there = first;
    while (!isnan(there) && there * first > 0) {
        from += step;
        there = excess(from, asked);
    }
    if (isnan(there) || there == 0)
        return isnan(there) ? NAN : from;
    const double root = rw_root(excess, asked, fmin(from, from - step), fmax(from, from - step), 0);
    return fabs(excess(root, asked)) < SURE ? root : NAN; /* else it jumps there */
}

static int32_t find(const rwedge_contact *apart, double pressure, double *P)
{
    int32_t status = RWEDGE_OK;
    const question asked = {apart, pressure, &status};
    const double size = apart->geometry.a > 0 ? apart->geometry.a : 1;
    const double from = log(pressure) + log(size), far = log(RW_LARGEST);
    const double found = search(&asked, fmin(fmax(from, -far), far));
    if (status != RWEDGE_OK && status != RWEDGE_EDOMAIN && status != RWEDGE_ERANGE)
        return status; /* these two: no pad reaches so far */
    if (isnan(found))
        return RWEDGE_EABSENT;
    *P = exp(found);
    return RWEDGE_OK;
}

int32_t rwedge_contact_peak_load(const rwedge_contact *contact, double pressure, double *P)
{
    if (!contact || !P)
        return RWEDGE_ENULL;
    if (!rw_is_positive(pressure))
        return RWEDGE_EDOMAIN;
    rwedge_contact *apart = NULL;
    int32_t status = rwedge_contact_copy(contact, &apart);
    if (status == RWEDGE_OK)
        status = press(apart, 0);
    if (status == RWEDGE_OK)
        status = find(apart, pressure, P);
    rwedge_contact_destroy(apart);
    return status;
}
