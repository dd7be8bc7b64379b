/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The rows of an elastic-limit table, as what they state. Numbers are the decimals that are
 * printed, not doubles near them. */
#ifndef ENTRY_HPP
#define ENTRY_HPP

#include "square.hpp"

#include <map>
#include <string>
#include <vector>

enum verdict {
    PROVED,
    /* a point has a higher J2, hence a lower limit, than is stated or than the stated place has */
    EXCEEDED,
    NOT_REACHED, /* J2 at the stated place is lower */
    MISNAMED,    /* the branch is not where the place is */
    OPEN         /* neither proved nor refuted */
};
enum { VERDICTS = OPEN + 1 };

/* The six functions of the place of which J2 = sum of weight[i] term[i], weight = 1, f, f^2,
 * kappa, kappa f, kappa f^2. */
enum { TERMS = 6 };

struct entry {
    std::string a_over_b; /* as printed */
    const char *file;
    size_t line;
    ball alpha, f, kappa; /* kappa = (1-2nu)^2/3 */
    ball limit;           /* P/(bk) */
    complex_ball place;   /* where, over b */
    bool at_surface;      /* what the column `branch` says */

    /* What is shown of it. */
    double weight[TERMS]; /* of the terms of J2 */
    /* J2, (theta/A)^2, to be proved an upper bound: a little above that at the place */
    double ceiling;
    ball least, most;          /* the enclosure of the limit, if PROVED */
    double beyond_x, beyond_y; /* where it is exceeded, if EXCEEDED */
    verdict is;
};

/* The entries of one a/b, and how many squares it took to judge them. */
struct group {
    std::vector<entry> entries;
    size_t squares;
};
typedef std::map<double, group> groups; /* by a/b */

/* Adds the rows of the file whose a/b is in the comma list, all without a list; false, with a
 * message, where it is not such a table. */
bool read_entries(groups *all, const char *file, const char *list);

/* How far the enclosure of the limit reaches from what is stated, relatively. */
double distance_of(const entry &e);

/* Is the whole enclosure within half a unit of the tenth digit, so that the rounding is proved
 * too? */
bool is_rounded(const entry &e);

#endif
