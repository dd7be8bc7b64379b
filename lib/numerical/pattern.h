/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Patterns of zones that stick and slip. The grid proposes one; zones narrower than its angles are
 * tried as variants. */
#ifndef RW_PATTERN_H
#define RW_PATTERN_H

#include "fronts/problem.h"

/* Neighbours of one label become one zone; two zones that slip opposite ways get a place between
 * them that sticks, of at most the width `least` to either side. */
void rw_pattern_clean(rw_zones *zones, double least);

/* The variants at the two edges, numbered from 0 on: a narrow zone of slip, one way or the other,
 * where the grid saw none or a narrow one; stick up to the edge of a growing contact. false where
 * the variant does not exist, number < RW_VARIANTS. `angle` is the width of an angle of the grid at
 * the edge. */
enum { RW_VARIANTS = 16 };
bool rw_pattern_variant(const rw_problem *problem, const rw_zones *zones, double angle, int number,
                        rw_zones *variant);

/* Removes the narrowest zone that is not at an edge. false where there is none. */
bool rw_pattern_simpler(const rw_problem *problem, rw_zones *zones, double least);

/* Gives parts of the zones the labels of `parts`. */
void rw_pattern_insert(rw_zones *zones, const rw_zones *parts, double least);

#endif
