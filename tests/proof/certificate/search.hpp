/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Branch and bound over the half-plane, for all entries of one contact at once. */
#ifndef SEARCH_HPP
#define SEARCH_HPP

#include "entry.hpp"

/* Relative to the limit. */
struct allowance {
    double tolerance; /* how far it may be from what is stated */
    /* how far the highest J2 anywhere is proved not to lower it below what the stated place
     * gives */
    double gap;
};

/* Judges the entries, which are of one a/b. Returns how many squares were looked at. */
size_t search(entry *entries, size_t count, allowance allowed);

/* The six functions of the place of which J2 = sum of weight[i] term[i], weight = 1, f, f^2,
 * kappa, kappa f, kappa f^2. */
enum { TERMS = 6 };
void enclose_terms(model term[TERMS], const field &over);

#endif
