/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The state of unlike bodies after a straight line from touching: shear over friction is that of
 * cells (growth.h), pressure and edges follow from the shear (coupled.h). */
#ifndef RW_GROWN_H
#define RW_GROWN_H

#include "numerical/computed_shear.h"

/* The computed shear under the loads `to`. RWEDGE_ENOMEM, RWEDGE_ENOCONV: then `grown` is NULL. */
int32_t rw_numerical_of_growth(const rw_frame *frame, rw_scaled_loads from, rw_scaled_loads to,
                               rw_numerical **grown);

#endif
