/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A patch off the centre in balls, and contacts that have one. */
#ifndef ECCENTRIC_HPP
#define ECCENTRIC_HPP

#include <vector>

#include "rows/rows.hpp"
#include "rwedge.h"

struct ball_edges {
    ball left, right;
};

/* An arc of a profile, and its part of the angle between the outermost slopes. */
struct arc {
    ball middle, half, weight;
};
typedef std::vector<arc> profile;

/* The wedge with the rounding a; 0 is a corner. */
inline profile wedge(const ball &a)
{
    return {{0, a, 1}};
}

/* What a patch carries, and how fast it changes with the edges: dP = u dr - v dl, pi s d delta =
 * u dr + v dl. */
struct carried {
    ball P, M, tilt, u, v, middle, half;
};

carried carried_by(const profile &arcs, const ball_edges &e);

/* The patch near a guess that carries P and so much of M or of the tilt, in theta/A; indeterminate
 * where none is proved. */
ball_edges patch_carrying(const profile &arcs, const ball &P, ball carried::*other,
                          const ball &much, const double guess[2]);

/* 1 - |delta| */
ball flatness(const ball &tilt);

/* The width of a patch, or |x| at its edges where that is larger. */
ball reach_of(const ball_edges &e);

/* The larger error of two edges over a scale. */
ball edges_error(const double answer[2], const ball_edges &e, const ball &scale);

/* The contact under its first load; none where it could not be created, or M tilts too far. */
shared_contact pressed(int32_t status, rwedge_contact *created, double P, double M);

/* Arguments of a contact that slips in one step of Q and sigma, the latter up to its limit.
 * result: the edges of the stick zone and of the contact, as the library finds them. None where the
 * arguments leave the domain. */
enum { THETA, ROUNDING, COMPLIANCE, LOAD, MOMENT, FRICTION, SHEAR, TENSION };
shared_contact draw_slipping(probe *call);

#endif
