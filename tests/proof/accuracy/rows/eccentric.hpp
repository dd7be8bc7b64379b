/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A patch off the centre in balls, and contacts that have one. */
#ifndef ECCENTRIC_HPP
#define ECCENTRIC_HPP

#include <functional>

#include "rows/rows.hpp"
#include "rwedge.h"

struct ball_edges {
    ball left, right;
};

/* What a patch carries, and how fast it changes with the edges: dP = u dr - v dl, pi s d delta =
 * u dr + v dl. */
struct carried {
    ball P, M, tilt, u, v, middle, half;
};

carried carried_by(const ball &a, const ball_edges &e);

/* The patch near a guess that carries P and M, in theta/A; indeterminate where none is proved. */
ball_edges patch_carrying(const std::function<carried(const ball_edges &)> &carry, const ball &P,
                          const ball &M, const double guess[2]);

/* Arguments of a contact that slips in one step of Q and sigma, the latter up to its limit.
 * result: the edges of the stick zone and of the contact, as the library finds them. None where the
 * arguments leave the domain. */
enum { THETA, ROUNDING, COMPLIANCE, LOAD, MOMENT, FRICTION, SHEAR, TENSION };
shared_contact draw_slipping(probe *call);

#endif
