/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The recurrence of Legendre's functions of both kinds,
 *     P_(k+1) = RISE[k] v P_k - FALL[k-1] P_(k-1). */
#ifndef RW_LEGENDRE_H
#define RW_LEGENDRE_H

#include "traction/traction.h"

/* (2k + 1)/(k + 1) and (k + 1)/(k + 2). */
#define RW_FOUR(F, K) F(K), F(K + 1), F(K + 2), F(K + 3)
#define RW_SIXTEEN(F) RW_FOUR(F, 0), RW_FOUR(F, 4), RW_FOUR(F, 8), RW_FOUR(F, 12)
#define RW_RISE_OF(K) ((2.0 * (K) + 1) / ((K) + 1))
#define RW_FALL_OF(K) (((K) + 1.0) / ((K) + 2))

static const double RW_LEGENDRE_RISE[] = {RW_SIXTEEN(RW_RISE_OF), RW_RISE_OF(RW_TERMS),
                                          RW_RISE_OF(RW_TERMS + 1)};
static const double RW_LEGENDRE_FALL[] = {RW_SIXTEEN(RW_FALL_OF), RW_FALL_OF(RW_TERMS)};

#endif
