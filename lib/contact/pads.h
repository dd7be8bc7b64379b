/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The arcs of a pad that is no wedge. */
#ifndef RW_PADS_H
#define RW_PADS_H

#include "formulas/pad.h"

/* A pad with room for `count` arcs. NULL where memory is short. */
rw_pad *rw_pad_create(size_t count);
rw_pad *rw_pad_copy(const rw_pad *pad, bool *is_whole); /* as other parts are: memory.h */
void rw_pad_destroy(rw_pad *pad);                       /* NULL is allowed */
void rw_pad_append(rw_pad *pad, rw_arc arc, double weight);

#endif
