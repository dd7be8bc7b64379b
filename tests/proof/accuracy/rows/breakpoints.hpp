/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A patch of any profile whose slope is piecewise linear, and its potential from sums over the
 * breakpoints. */
#ifndef BREAKPOINTS_HPP
#define BREAKPOINTS_HPP

#include <vector>

#include "balls/complex_ball.hpp"
#include "rows/rows.hpp"
#include "rwedge.h"

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

/* ---- Stresses after one step of Q ---- */

/* What a call finds first: the edges of the stick zone and of the contact. */
enum { STICK_LEFT, STICK_RIGHT, WHOLE_LEFT, WHOLE_RIGHT, FOUND };

/* x next to an edge or one of these places, or anywhere. */
double place_among(probe *call, const std::vector<double> &places);

/* At x and a depth that is drawn; the contact is destroyed. */
void find_stresses(probe *call, rwedge_contact *contact, double x);

/* The largest error of a component: of the pressure and of the shear traction f (G - G of what
 * sticks), times unit, with a tension. A stress counts as the larger of itself and `least`/(1+|z|)
 * over `flat`, z from the middle of the contact in half-widths. */
struct stress_case {
    profile_patch whole, stick;
    double x, y;
    ball f, unit, tension, least, flat;
};

ball stress_error(const probe &call, const stress_case &of);

#endif
