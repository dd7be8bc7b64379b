/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Branch and bound over the half-plane, for all entries of one contact at once. */
#ifndef SEARCH_HPP
#define SEARCH_HPP

#include "entry.hpp"

/* How far the highest J2 anywhere is proved not to lower the limit below what the stated place
 * gives, relatively. */
static const double GAP = 1e-13;

/* Judges the entries, which are of one a/b, and whose limits may be so far from what is stated,
 * relatively. Returns how many squares were looked at. */
size_t search(entry *entries, size_t count, double tolerance);

/* The six functions of the place of which J2 = sum of weight[i] term[i], weight = 1, f, f^2,
 * kappa, kappa f, kappa f^2. */
enum { TERMS = 6 };
void enclose_terms(model term[TERMS], const field &over);

#endif
