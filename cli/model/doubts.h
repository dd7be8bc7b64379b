/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What makes results doubtful: the library's bits of a contact, and their texts. */
#ifndef CLI_DOUBTS_H
#define CLI_DOUBTS_H

#include "contact_case.h"

#include <stddef.h>
#include <stdint.h>

#include <rwedge.h>

/* Of a contact with these edges, both 0 where it is separated; safety is P_yield/P, NAN where it is
 * not known. */
int32_t doubts_of(const contact_case *setup, double left, double right, double safety);

/* Of the state of a contact. It may yield by P, or by a tension or moment at a P that would not. */
int32_t doubts_of_state(const contact_case *setup, const rwedge_contact *contact);

/* The same where rwedge_contact_yield_factor() is known; NAN is not known. */
int32_t doubts_of_factor(const contact_case *setup, const rwedge_contact *contact, double factor);

/* The text of one bit; "" for any other number. */
const char *doubt_text(int32_t bit);

/* Adds their texts to one that has some or none, "; " between them. */
void doubts_write(int32_t doubts, char *text, size_t size);

#endif
