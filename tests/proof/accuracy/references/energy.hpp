/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The energy that friction dissipates in a load step, in closed form (lib/README.md, "Load
 * histories"). */
#ifndef ENERGY_HPP
#define ENERGY_HPP

#include "references/memory.hpp"

/* Over A f^2/pi; `ahead` is by how much Q/f gets ahead of what sticks. */
struct dissipation {
    ball energy, ahead;
};

/* In a straight line from the path's end to (load, shear); unit is theta/A. */
dissipation dissipation_to(const path &p, const ball &load, const ball &shear, const ball &a,
                           const ball &unit);

#endif
