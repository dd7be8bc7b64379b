/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Whether slip goes one way at every point that slips. */
#ifndef RW_ONE_WAY_H
#define RW_ONE_WAY_H

#include "formulas/size.h"
#include "history/memory.h"

/* The front of a departure has passed the layers of the path from the edges of the contact. Whether
 * all points between have slipped the way of the departure, to rounding; false where that is not
 * shown. The front's patch must be known, and the patches of the path nested from it on. */
bool rw_slips_one_way(const rw_memory *path, const rw_departure *departure,
                      const rw_geometry *geometry);

#endif
