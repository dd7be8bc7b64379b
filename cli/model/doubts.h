/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What makes results doubtful: the bits of rwedge_validity(), the error of a computed contact, and
 * their texts. */
#ifndef CLI_DOUBTS_H
#define CLI_DOUBTS_H

#include "contact_case.h"

#include <stddef.h>
#include <stdint.h>

#include <rwedge.h>

typedef struct {
    int32_t bits;
    double error; /* rwedge_contact_error(), 0 where there is a closed form */
} doubts;

/* The doubts about a contact with these edges, both 0 where it is separated; safety is P_yield/P,
 * NAN where it is not known. */
int32_t doubts_of(const contact_case *setup, double left, double right, double safety);

/* The doubts about the present state of a contact. It may yield by P, or by a tension or moment
 * under a P that alone would not make it yield. */
doubts doubts_of_state(const contact_case *setup, const rwedge_contact *contact);

/* The same where rwedge_contact_yield_factor() is known; NAN is not known. */
doubts doubts_of_factor(const contact_case *setup, const rwedge_contact *contact, double factor);

/* Adds the doubts about another state; the error is the larger one. */
void doubts_add(doubts *all, doubts more);

/* Removes the first doubt and writes its text. False where none is left. */
enum { DOUBT_SIZE = 200 };
bool doubts_next(doubts *left, char text[DOUBT_SIZE]);

/* Adds the texts of the doubts to a list that is separated by "; ". */
void doubts_write(doubts all, char *text, size_t size);

#endif
