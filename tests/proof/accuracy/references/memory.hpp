/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The memory diagram of a load history in balls: the path T(s), T = Q/f, whose slopes D weight
 * the patches of shear traction (lib/README.md, "Load histories"). Loads closer than 2^-(bits/2)
 * of each other count as equal: what that leaves out is of the order of its square root. */
#ifndef MEMORY_HPP
#define MEMORY_HPP

#include <vector>

#include "balls/ball.hpp"

/* ratio is the slope D of the path from the corner before. */
struct corner {
    ball load, shear, ratio;
};

/* Corner 0 is the origin. */
struct path {
    std::vector<corner> corners{1}; /* of a contact without load */

    int count() const { return (int)corners.size(); }
    const corner &operator[](int i) const { return corners[(size_t)i]; }
    const corner &end() const { return corners.back(); }

    /* In a straight line to (load, shear). */
    void advance(const ball &load, const ball &shear);

  private:
    void push(const ball &load, const ball &shear);
    /* Goes back to where the function falls below 0. */
    template <typename Linear> void cut_off(const ball &scale, const Linear &inside);
};

/* -1, 0, 1; 0 for what is below 2^-(bits/2) of the scale. */
int sign_beside(const ball &value, const ball &scale);

#endif
