/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The origin of slip by place: slip less displacement, constant while the place is in contact. A
 * place that comes into contact has the origin of that moment. */
#ifndef RW_ORIGIN_H
#define RW_ORIGIN_H

#include "numerical/computed_shear.h"

/* After a step in two halves from the present state. false where memory is short. */
bool rw_origin_renew(rw_numerical *numerical, const rw_frame *frame, const rw_numerical_state *half,
                     const rw_numerical_state *now);

#endif
