/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What the test of the Fortran module needs from C: how many handles are alive (linked with
 * --wrap), and the loop that an elemental function is timed against. */
#include "rwedge.h"

int32_t __real_rwedge_contact_create(double theta, double a, double A, double f,
                                     rwedge_contact **contact);
int32_t __real_rwedge_contact_copy(const rwedge_contact *contact, rwedge_contact **copy);
void __real_rwedge_contact_destroy(rwedge_contact *contact);
int32_t __real_rwedge_series_create(double alpha, int32_t terms, rwedge_series **series);
void __real_rwedge_series_destroy(rwedge_series *series);

static int32_t alive;

int32_t handles_alive(void)
{
    return alive;
}

int32_t __wrap_rwedge_contact_create(double theta, double a, double A, double f,
                                     rwedge_contact **contact)
{
    const int32_t status = __real_rwedge_contact_create(theta, a, A, f, contact);
    alive += status == RWEDGE_OK;
    return status;
}

int32_t __wrap_rwedge_contact_copy(const rwedge_contact *contact, rwedge_contact **copy)
{
    const int32_t status = __real_rwedge_contact_copy(contact, copy);
    alive += status == RWEDGE_OK;
    return status;
}

void __wrap_rwedge_contact_destroy(rwedge_contact *contact)
{
    alive -= contact != NULL;
    __real_rwedge_contact_destroy(contact);
}

int32_t __wrap_rwedge_series_create(double alpha, int32_t terms, rwedge_series **series)
{
    const int32_t status = __real_rwedge_series_create(alpha, terms, series);
    alive += status == RWEDGE_OK;
    return status;
}

void __wrap_rwedge_series_destroy(rwedge_series *series)
{
    alive -= series != NULL;
    __real_rwedge_series_destroy(series);
}

void loads_in_c(size_t n, const double alpha[], double load[])
{
    for (size_t i = 0; i < n; i++)
        load[i] = rwedge_load(alpha[i]);
}
