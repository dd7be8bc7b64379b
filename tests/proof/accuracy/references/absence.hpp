/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Looks for what the library says does not exist, without the library's answer. */
#ifndef ABSENCE_HPP
#define ABSENCE_HPP

/* Whether a local maximum of J2 below the surface is proved, other than the second one next to x
 * = a that lib/README.md describes. Where the maximum is flat, next to the fold, the search may
 * miss it: false is no proof of absence. */
bool has_maximum_below(double alpha, double f, double nu);

#endif
