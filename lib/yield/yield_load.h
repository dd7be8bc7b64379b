/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The load at which a pad that slides fully is at a limit. */
#ifndef RW_YIELD_LOAD_H
#define RW_YIELD_LOAD_H

#include "contact/contact.h"

/* Finds by what a contact may be multiplied until it is at the limit, and where that is, as
 * rwedge_contact_yield_factor() does. */
typedef int32_t rw_factor(const rwedge_contact *contact, double nu, double k, double *factor,
                          double *x, double *y);

/* The load of the pad of a contact at which the factor is 1, in full sliding to the side of the
 * contact's Q. RWEDGE_EABSENT where there is none that can be applied. */
int32_t rw_limit_of_pad(const rwedge_contact *contact, rw_factor *factor, double nu, double k,
                        double *P, double *x, double *y);

#endif
