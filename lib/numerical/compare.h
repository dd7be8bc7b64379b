/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The error of a step by its halves. */
#ifndef RW_COMPARE_H
#define RW_COMPARE_H

#include "numerical/step.h"

/* Compares both halves of a step, the first of which ends at `half`, with the step as a whole. It
 * began in the contact `before`. The difference bounds the error of the halves, which is noted
 * there. Returns it, or that of the energies, over what is allowed. */
double rw_compare(const rw_frame *frame, rw_patch before, const rw_numerical_state *whole,
                  const rw_numerical_state *half, rw_numerical_state *both);

#endif
