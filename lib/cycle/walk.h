/* SPDX-License-Identifier: GPL-3.0-or-later */
/* How a cycle comes to be: a contact goes through its loads, in parts where P or M changes, and its
 * states are noted. */
#ifndef RW_WALK_H
#define RW_WALK_H

#include "cycle/states.h"

/* Goes through all loads of a cycle that has nothing but them and the contact before. */
int32_t rw_go_through(rwedge_cycle *cycle);

#endif
