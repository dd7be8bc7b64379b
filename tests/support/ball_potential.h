/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The potential G(z) = (1/pi) int p(t)/(t-z) dt of a rounded wedge, pressed to the half-width c,
 * in ball arithmetic: each result contains the value at every point of the given ball, in as
 * many bits as are asked for. Written from the paper's Eq. (8) in elliptic coordinates; it
 * shares nothing with the library.
 *
 * Natural units: stresses in theta/A, lengths in any one unit. On y = 0 the values are those of
 * the limit from y > 0, and a ball that reaches below the surface encloses the continuation from
 * above. z = ±a and z = ±c are ordinary points of G and of y G'; a result that has no finite
 * enclosure (G' there, the apex of the sharp wedge) is a ball of infinite radius or not a
 * number. Many bits cancel for small a/c (about twice its magnitude) and far away: look at the
 * radius, and ask for more. */
#ifndef BALL_POTENTIAL_H
#define BALL_POTENTIAL_H

#ifdef BALLS_IN_FLINT /* FLINT 3 contains Arb */
#include <flint/acb.h>
#else
#include <acb.h>
#endif

/* One patch; the members are those of a contact of half-width 1. */
typedef struct {
    arb_t half_width;
    arb_t alpha; /* a/c; 0 is the sharp wedge, 1 and above is Hertz */
    arb_t c0, phi0;
} ball_patch;

/* a >= 0 and c > 0: half-widths of the rounding and of the contact, or of the stick zone. */
void ball_patch_init(ball_patch *patch, const arb_t a, const arb_t c, slong prec);
void ball_patch_clear(ball_patch *patch);

/* G(z), G'(z), and y G'(z), which is finite where G' is not. */
void ball_potential(acb_t G, const ball_patch *patch, const acb_t z, slong prec);
void ball_potential_slope(acb_t dG, const ball_patch *patch, const acb_t z, slong prec);
void ball_potential_slope_by_depth(acb_t H, const ball_patch *patch, const acb_t z, slong prec);

/* Blocks of such formulas: square root and logarithm continuous over the closed upper half-plane
 * but for 0, cut downwards. */
void ball_root(acb_t root, const acb_t z, slong prec);
void ball_logarithm(acb_t logarithm, const acb_t z, slong prec);
void ball_times_i_over_pi(acb_t z, slong prec);

#endif
