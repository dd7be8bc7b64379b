/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The shear that pressing alone leaves between unlike bodies. Pressed bodies stick but for a rim of
 * about 8 exp(-pi f/|B|) b, and each growth of the load leaves the tractions of a bonded flat
 * punch:
 *     N + i t = (cosh(pi e)/pi) int_|x|^b ((s + x)/(s - x))^(i e) dP(s)/sqrt(s^2 - x^2),
 *     e = ln((1 + B)/(1 - B))/(2 pi).
 * dP is taken from similar bodies, times one factor so that all of it is the load at the edge of
 * the coupled contact. */
#ifndef RW_BONDED_H
#define RW_BONDED_H

#include "numerical/coupled.h"

/* Sets traction, contact and pressure of a state under a load of a symmetric pad. false where
 * memory is short or there is no contact. */
bool rw_press_bonded(const rw_frame *frame, rw_numerical_state *state);

/* The error of that factor, and of friction as the bound of what has slipped meanwhile, over f
 * times the peak pressure. */
double rw_bonded_error(const rw_frame *frame);

#endif
