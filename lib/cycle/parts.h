/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The way to a load of a cycle, in parts. */
#ifndef RW_PARTS_H
#define RW_PARTS_H

#include "cycle/states.h"

/* Goes on, and notes the state. */
int32_t rw_go_part(rwedge_cycle *cycle, rwedge_contact *going, rw_goal to);

/* Goes along the way to a load, but not to the load itself, and notes the states. It ends where one
 * of them has no closed form: the step as a whole has one. On the way to separation the slip is
 * then not known, RWEDGE_EPATH. */
int32_t rw_go_parts(rwedge_cycle *cycle, rwedge_contact *going, rw_goal to);

#endif
