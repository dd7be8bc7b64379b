/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The largest value of a function over a contact. */
#ifndef CLI_PEAK_H
#define CLI_PEAK_H

#include "model/contact_case.h"

/* NAN where it has no value, which no peak is. */
typedef double peak_function(const void *context, double x);

/* Finds the largest value at places that are dense at the edges, and then around the best place, to
 * 1e-10 of the distance of its neighbours. */
double peak_over(double left, double right, peak_function *f, const void *context);

/* The largest pressure of a contact in its present state, a magnitude; NAN where it is infinite, or
 * not known. */
double peak_pressure(const contact_case *setup, const rwedge_contact *contact);

#endif
