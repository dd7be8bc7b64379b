/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A patch of any profile whose slope is piecewise linear, and its potential from sums over the
 * breakpoints. */
#ifndef BREAKPOINTS_HPP
#define BREAKPOINTS_HPP

#include <vector>

#include "balls/complex_ball.hpp"

/* A breakpoint inside: its jump, psi and phi. */
struct breakpoint {
    ball k, psi, cosine, sine, constant; /* (cos phi - psi sin phi)/pi */
};

struct profile_patch {
    ball middle, half, a, tilt;
    ball rate; /* of the slope, left of the first end inside: k_left */
    std::vector<breakpoint> ends;
};

/* Of a place over the half-width, from the middle. */
breakpoint breakpoint_at(const ball &place, const ball &k);

/* G, y G'. */
complex_ball potential_at(const profile_patch &p, const complex_ball &z);
complex_ball depth_slope_at(const profile_patch &p, const complex_ball &z);

#endif
