/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The loop of the last cycle: of the whole contact where P is constant and there is no moment or
 * tension, else of one place. */
#ifndef PAGE_LOOP_H
#define PAGE_LOOP_H

#include "model/cycle/cycle.h"

/* Tangential load over displacement by slip, which encloses the energy of the cycle; or the shear
 * traction of a place over its slip, as long as it touches. */
typedef struct {
    bool is_whole;
    double place;  /* NAN where there is none */
    double *x, *y; /* freed by free(x) */
    size_t count;  /* 0 where no slip is known */
} loop;

/* At the place, NAN for none, where it is not of the whole. */
loop loop_of(const last_cycle *cycle, double place);

#endif
