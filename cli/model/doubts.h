/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What makes results doubtful: the library's bits of a contact, how exact it is; their texts. */
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

/* The bits of a contact with these edges, both 0 where it is separated; safety is P_yield/P, NAN
 * where it is not known. */
int32_t doubts_of(const contact_case *setup, double left, double right, double safety);

/* Of the state of a contact. It may yield by P, or by a tension or moment at a P that would not. */
doubts doubts_of_state(const contact_case *setup, const rwedge_contact *contact);

/* The same where rwedge_contact_yield_factor() is known; NAN is not known. */
doubts doubts_of_factor(const contact_case *setup, const rwedge_contact *contact, double factor);

/* Of several states: the largest error. */
void doubts_add(doubts *all, doubts more);

/* Takes the first of them off, and writes its text. False where there is none left. */
enum { DOUBT_SIZE = 200 };
bool doubts_next(doubts *left, char text[DOUBT_SIZE]);

/* Adds their texts to one that has some or none, "; " between them. */
void doubts_write(doubts all, char *text, size_t size);

#endif
