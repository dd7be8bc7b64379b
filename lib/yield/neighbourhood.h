/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The fields of a contact around a place of its surface. A patch that ends far away has a potential
 * that is analytic there, across the surface too. So the shear traction of all such patches has an
 * analytic potential, which is interpolated: the time then does not depend on their number. */
#ifndef RW_NEIGHBOURHOOD_H
#define RW_NEIGHBOURHOOD_H

#include "contact/contact.h"

#include <complex.h>

enum { RW_NODES = 24 };

/* A half disc. The patches from first to last - 1 count one by one, and so does the contact; the
 * others by the Chebyshev series of their sum over the interval of twice the disc's width. */
typedef struct {
    double centre, radius; /* infinite where all patches count one by one */
    size_t first, last;
    double complex coefficient[RW_NODES];
} rw_neighbourhood;

/* The neighbourhood that is the whole half-plane. */
rw_neighbourhood rw_neighbourhood_whole(const rwedge_contact *contact);

/* A smaller one inside of another; the whole half-plane where it is not inside. */
rw_neighbourhood rw_neighbourhood_within(const rwedge_contact *contact,
                                         const rw_neighbourhood *outer, double centre,
                                         double radius);

/* The fields at n <= RW_BATCH points of the disc: to 1e-9 those of rw_contact_fields_at(). */
void rw_neighbourhood_fields(const rwedge_contact *contact, const rw_neighbourhood *n, int count,
                             const double x[], const double y[], rw_contact_fields *fields);

#endif
