/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Which places along x a cycle is looked at: the edges of contact and stick zone after each load
 * are always among them, as it is there that stresses and slip have their tops. */
#ifndef CLI_SURFACE_H
#define CLI_SURFACE_H

#include "history/places.h"
#include "worst.h"

/* The places of --x or, where it is not given, from one side of the contact to the other, at each
 * of the depths; of --at or --points as they are. Returns the exit status; free the places in
 * either case. */
int surface_places(const arguments *given, char decimal_sign, const last_cycle *of, measured *all);

/* The places by default, on the surface. False where there are none, or memory is short. */
bool surface_usual(const last_cycle *of, measured *all);

#endif
