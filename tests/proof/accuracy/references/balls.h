/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The formulas of one contact in ball arithmetic, from the paper, and roots enclosed by Newton's
 * method. */
#ifndef BALLS_H
#define BALLS_H

#include <stdbool.h>

#include "ball_potential.h"
#ifdef BALLS_IN_FLINT
#include <flint/acb_calc.h>
#include <flint/arb_mat.h>
#else
#include <acb_calc.h>
#include <arb_mat.h>
#endif

/* A P/theta of a contact of half-width b, Eq. (7), (11), (15): (b^2 phi0 + a sqrt(b^2-a^2))/a,
 * and its derivative by b. */
void ball_force(arb_t force, const arb_t a, const arb_t b, slong prec);
void ball_force_slope(arb_t slope, const arb_t a, const arb_t b, slong prec);

/* The half-width b > 0 of that force; guess is near it, and only a guess. Indeterminate where it
 * is too far off. */
void ball_half_width(arb_t b, const arb_t a, const arb_t force, double guess, slong prec);

/* A p/theta at |x| < c, pressed to the half-width c, Eq. (8), (12), (14); 0 beyond. */
void ball_pressure(arb_t p, const arb_t a, const arb_t c, const arb_t x, slong prec);

/* phi0 and c0 = cos(phi0), sin(phi0) = min(a/b, 1). */
void ball_angle(arb_t phi0, arb_t c0, const arb_t a, const arb_t b, slong prec);

/* A function and its derivative over a ball; either may be NULL. */
typedef void (*ball_function)(arb_ptr value, arb_ptr slope, const arb_t x, const void *context,
                              slong prec);

/* A zero near the guess: Newton's method, the last step with the derivative over a whole
 * neighbourhood, which proves that there is one and that it is where it says. False where none
 * is proved. The neighbourhoods tried are small beside the width. */
bool ball_zero(arb_t zero, const arb_t guess, double width, ball_function function,
               const void *context, slong prec);

#endif
