/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The maxima of J2 of one contact in full sliding, natural units, alpha <= 1: enclosed by
 * Newton's method next to where the library says they are. That each is the global one is not
 * shown here. */
#ifndef STRENGTH_HPP
#define STRENGTH_HPP

#include "references/field.hpp"

/* The maximum over the surface next to x = guess. False where none is proved. flatness is the
 * curvature of J2 over J2, by the angle whose sine is x/alpha. */
bool find_surface_maximum(extremum *at, const sliding_contact &t, double guess);

/* P/(bk) of that maximum. */
ball limit_of(const ball &alpha, const ball &J2);

#endif
