/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef RW_APPLY_H
#define RW_APPLY_H

#include "contact/contact.h"

/* The next load: rwedge_contact_apply(), with the tilt of a held pad. */
int32_t rw_contact_apply(rwedge_contact *contact, rw_goal to);

#endif
