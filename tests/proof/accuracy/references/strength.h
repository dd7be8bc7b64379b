/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The maxima of J2 of one contact in full sliding, natural units, alpha <= 1: enclosed by
 * Newton's method next to where the library says they are. That each is the global one is not
 * shown here. */
#ifndef STRENGTH_H
#define STRENGTH_H

#include "references/field.h"

/* The contact of half-width 1 in full sliding. */
void ball_contact(traction *t, const arb_t alpha, const arb_t f, double nu, slong prec);

/* The maximum over the surface next to x = guess. False where none is proved. flatness, if not
 * NULL, receives the curvature of J2 over J2, by the angle whose sine is x/alpha. */
bool ball_surface_maximum(arb_t x, arb_t J2, double *flatness, const traction *t, double guess,
                          slong prec);

/* A function of a parameter of the contact, friction or alpha, and its derivative, over a ball;
 * false where not proved. */
typedef bool (*ball_balance)(arb_t value, arb_t slope, const arb_t parameter, const void *context,
                             slong prec);

/* The zero of such a function next to the guess. False where none is proved. */
bool ball_parameter(arb_t parameter, double guess, ball_balance balance, const void *context,
                    slong prec);

/* P/(bk) of that maximum. */
void ball_limit(arb_t limit, const arb_t alpha, const arb_t J2, slong prec);

#endif
