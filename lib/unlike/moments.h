/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef RW_MOMENTS_H
#define RW_MOMENTS_H

#include "unlike/joints.h"

enum { RW_MOMENTS = 34 };

/* M_n for n < count; the slope at the left edge less the tilt; the tilt. */
typedef struct {
    double moment[RW_MOMENTS];
    double offset, tilt;
} rw_sliding_sums;

rw_sliding_sums rw_sliding_sums_of(const rw_arcs *arcs, const rw_sliding_frame *frame, int count);

#endif
