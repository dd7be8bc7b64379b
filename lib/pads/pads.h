/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The kind of a pad, of what a contact keeps of it. */
#ifndef RW_PADS_H
#define RW_PADS_H

#include "contact/handle.h"

int32_t rw_pad_kind(const rw_geometry *geometry); /* RWEDGE_PAD_... */
double rw_pad_flat(const rw_geometry *geometry);  /* half of the flat; 0 of a cylinder */

#endif
