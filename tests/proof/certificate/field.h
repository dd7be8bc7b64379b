/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The potential of one contact over squares of the half-plane, lengths in b, stresses in
 * theta/A. */
#ifndef FIELD_H
#define FIELD_H

#include "ball_potential.h"
#include "model.h"

enum { BITS = 128 };

typedef struct {
    ball_patch patch;
    arb_t load; /* AP/(theta b) */
} contact;

/* alpha = a/b > 0 */
void contact_init(contact *c, const arb_t alpha);
void contact_clear(contact *c);

typedef struct {
    double x, y, half; /* centre and half a side; y >= half */
} square;

/* G = u + iv and y G' = p + iq over a square. Rests are infinite where there is no enclosure:
 * split it. */
typedef struct {
    model u, v, p, q;
} field;

void field_enclose(field *over, const contact *c, square s);

/* J2 at a point, in balls, for the friction f and kappa = (1-2nu)^2/3. */
void ball_J2(arb_t J2, const contact *c, const acb_t z, const arb_t f, const arb_t kappa);

/* An upper bound of J2 wherever it is farther than the distance from the contact -1 <= x <= 1. */
void ball_far_J2(arb_t J2, const contact *c, ulong distance, const arb_t f, const arb_t kappa);

/* The largest double below all of the ball. */
double ball_lower(const arb_t ball);

#endif
