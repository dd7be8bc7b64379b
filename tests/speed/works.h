/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What bench.c prints times of and test_speed.c compares: for a `work` of stopwatch.h. A call that
 * fails ends the program. */
#ifndef WORKS_H
#define WORKS_H

#include "rwedge.h"

#include <stdbool.h>
#include <stddef.h>

/* Points below a contact and beside it, and room for what is computed of them. */
static const double TURN = 2 * 3.14159265358979323846;

extern double *xs, *ys, *out[3];
bool reserve_points(long n);
void release_points(void);

extern int plain_terms; /* of the plain series, 60 if nothing else is said */

/* Ends the program unless the status is RWEDGE_OK. */
void must(int32_t status);

/* Stresses at points, in one call and one by one; c/b = 0 is full sliding. J2 by the plain
 * series. */
double array_of_points(double c, double unused, long n);
double points_one_by_one(double c, double unused, long n);
double plain_points(long n);

/* The i-th contact of the paper's table, a/b = 0.1 ... 1, f = 0 ... 0.8, in an order in which a few
 * are of all kinds. */
enum { PAPER_LIMITS = 650 };
double case_of(long i, double *f);

/* Elastic limits of these, every call cold; and by the plain search. */
double limits_one_by_one(long n);
double plain_limits(long n);

/* The contact of the times, without a load. */
rwedge_contact *new_contact(void);

/* It remembers as many corners: reversals of Q, each smaller than all before. */
rwedge_contact *worn_contact(double corners, double M);

/* Stresses at points of contacts after one step of Q: of that one, of a flat pad, of a profile of
 * 100 places with 99 arcs in contact. */
double points_of_a_wedge(long n);
double points_of_a_flat_pad(long n);
double points_of_a_profile(long n);

/* The yield factor of such a contact, n times. */
double yield_factors(double corners, double M, long n);

/* Loads whose tension lags behind Q by an eighth of a cycle, and the error at last: of that
 * contact, of one that a moment rocks, of that profile. P, Q and tension may scatter. */
double lagging(double tolerance, double scatter, long n);
double rocking(double tolerance, double scatter, long n);
double lagging_profile(double tolerance, double scatter, long n);

#endif
