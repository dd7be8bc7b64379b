/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef RW_LOAD_H
#define RW_LOAD_H

#include "contact/contact.h"

/* The next load of a contact alone, with nothing beside it. */
int32_t rw_contact_apply_alone(rwedge_contact *contact, rw_goal to);

#endif
