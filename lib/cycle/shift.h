/* SPDX-License-Identifier: GPL-3.0-or-later */
/* How far the surfaces have moved tangentially against each other, from state to state. */
#ifndef RW_SHIFT_H
#define RW_SHIFT_H

#include "contact/contact.h"

/* The patch of a contact; NaN where the bodies are apart. */
static inline rw_patch rw_patch_of(const rwedge_contact *c)
{
    return c->memory.count > 1 ? rw_memory_end(&c->memory)->patch : (rw_patch){NAN, NAN};
}

/* How far the surfaces have moved tangentially against each other, at a place x of a state, is
 *     unit sum + slope x + shift
 * with the sum of friction.c. It counts from the same for all states of a cycle; while the place is
 * in contact it changes by slip alone. */
typedef struct {
    double slope, shift;
} rw_displacement;

/* The slip of a place in contact. */
double rw_slip_at(const rwedge_contact *contact, double x);

/* The displacement in the first state, and after a step. */
rw_displacement rw_first_displacement(const rwedge_contact *contact);
rw_displacement rw_next_displacement(rw_displacement last, const rwedge_contact *before,
                                     const rwedge_contact *after);

#endif
