/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The profile of a pad by its slopes at places, linear between them. */
#ifndef CLI_PAD_PROFILE_H
#define CLI_PAD_PROFILE_H

#include <stdbool.h>
#include <stddef.h>

enum { PROFILE_PLACES = 1000 };

typedef struct {
    size_t count;
    double x[PROFILE_PLACES], slope[PROFILE_PLACES];
} pad_profile;

/* What is wrong with it, and at which of the places that were given; or what the hull has changed.
 */
typedef struct {
    size_t place;
    char text[450];
} profile_remark;

/* Makes a profile from slopes. False, with the remark, where they are not convex. */
bool pad_profile_of_slopes(size_t n, const double x[], const double slope[], pad_profile *to,
                           profile_remark *remark);

/* Makes a profile from heights above the surface: the slope of the line between two places is the
 * slope in their middle. Where the hull is asked for, heights that are not convex are lowered to
 * it, and the remark says by how much. False, with the remark, where they are not convex. */
bool pad_profile_of_heights(size_t n, const double x[], const double height[], bool takes_hull,
                            pad_profile *to, profile_remark *remark);

#endif
