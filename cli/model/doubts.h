/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What makes results doubtful: the library's bits of a contact, and their texts. */
#ifndef CLI_DOUBTS_H
#define CLI_DOUBTS_H

#include "contact_case.h"

#include <stddef.h>
#include <stdint.h>

/* Of a contact of the half-width b, 0 where it is separated; safety is P_yield/P, NAN where it is
 * not known. */
int32_t doubts_of(const contact_case *setup, double b, double safety);

/* Adds their texts to one that has some or none, "; " between them. */
void doubts_write(int32_t doubts, char *text, size_t size);

#endif
