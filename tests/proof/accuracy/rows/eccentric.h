/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A patch off the centre in balls, and contacts that have one. */
#ifndef ECCENTRIC_H
#define ECCENTRIC_H

#include "probe.h"
#include "rwedge.h"

typedef struct {
    arb_ptr left, right;
} ball_edges;

/* What a patch carries, and how fast it changes with the edges: dP = u dr - v dl, pi s d delta =
 * u dr + v dl. */
enum { P_OF, M_OF, TILT_OF, U_OF, V_OF, M_MIDDLE, S_HALF, CARRIED };
void carried_by(arb_ptr c, const arb_t a, const ball_edges *e, slong prec);

/* Arguments of a contact that slips in one step of Q and sigma, the latter up to its limit.
 * result: the edges of the stick zone and of the contact, as the library finds them. false where
 * the arguments leave the domain. `made` receives the contact, if not NULL. */
enum { THETA, ROUNDING, COMPLIANCE, LOAD, MOMENT, FRICTION, SHEAR, TENSION };
bool draw_slipping(probe *call, rwedge_contact **made);

/* Both patches of such a call, of the drawn loads; indeterminate where none is proved. */
void ball_slipping(const ball_edges *stick, const ball_edges *whole, const probe *call, slong prec);

#endif
