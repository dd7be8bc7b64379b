/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The kind of a pad, of what a contact keeps of it; profiles. */
#ifndef RW_PADS_H
#define RW_PADS_H

#include "contact/handle.h"

int32_t rw_pad_kind(const rw_geometry *geometry); /* RWEDGE_PAD_... */
double rw_pad_flat(const rw_geometry *geometry);  /* half of the flat; 0 of a cylinder */

/* The geometry of a profile, with a pad that the caller owns. RWEDGE_EDOMAIN, RWEDGE_ENOMEM as
 * rwedge_contact_create_profile() has them. */
int32_t rw_profile_geometry(size_t n, const double x[], const double slope[], double A,
                            rw_geometry *geometry);

#endif
