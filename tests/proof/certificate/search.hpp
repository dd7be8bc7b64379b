/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Branch and bound over the half-plane, for all entries of one contact at once. */
#ifndef SEARCH_HPP
#define SEARCH_HPP

#include "entry.hpp"

/* How far the highest J2 anywhere is proved not to lower the limit below what the stated place
 * gives, relatively. */
static const double GAP = 1e-13;

/* Judges the entries, whose limits may be so far from what is stated, relatively. */
void search(group *judged, double tolerance);

void enclose_terms(model term[TERMS], const field &over);

#endif
