/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Whether numbers that were read can be a contact: those that follow from each other agree. */
#ifndef RW_SOUND_H
#define RW_SOUND_H

#include "contact/contact.h"

bool rw_is_pad_sound(const rw_pad *pad);

/* The first corner of a path has none before it. */
bool rw_is_corner_sound(const rwedge_contact *contact, const rw_corner *c, const rw_corner *before);

/* Whether an origin starts at the end of its path, and its points begin where those of the origin
 * before it end. */
bool rw_is_origin_sound(const rw_slip_origins *origins, size_t i);

/* Whether the parts of a contact, each of them sound, agree with each other. */
bool rw_is_contact_sound(const rwedge_contact *c);

#endif
