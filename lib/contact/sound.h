/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Whether numbers that were read can be a contact: what it has computed from each other agrees. */
#ifndef RW_SOUND_H
#define RW_SOUND_H

#include "contact/contact.h"

/* The next arc of a pad; all of its arcs. */
bool rw_is_arc_sound(const rw_pad *pad, rw_arc arc, double weight);
bool rw_is_pad_sound(const rw_pad *pad);

/* The first corner of a path has none before it. */
bool rw_is_corner_sound(const rw_geometry *g, const rw_corner *c, const rw_corner *before);

/* Whether slip is measured from the end of its path, at points that the one before does not have.
 */
bool rw_is_origin_sound(const rw_slip_origins *origins, size_t i);

/* All that its parts, each of them sound, have to do with each other. */
bool rw_is_contact_sound(const rwedge_contact *c);

#endif
