/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What the tests of contacts with a load history share: short names that fail the test where a
 * call fails, and random histories. */
#ifndef HISTORIES_H
#define HISTORIES_H

#include "claims.h"
#include "contact/contact.h"

static const double PI = 3.14159265358979323846;
static const double THETA = 0.1, A = 0.5; /* theta/A = 0.2 */

rwedge_contact *create(double a, double f);
void load(rwedge_contact *contact, double P, double Q);
void apply(rwedge_contact *contact, double P, double M, double Q, double sigma);

rw_patch edges_of(const rwedge_contact *contact);
rw_patch stick_zone_of(const rwedge_contact *contact);

/* At the point x of the surface. */
double pressure(const rwedge_contact *contact, double x);
double shear(const rwedge_contact *contact, double x);
double slip(const rwedge_contact *contact, double x);

/* A random history, the same in every test: geometry and loads of which every kind occurs. */
typedef struct {
    uint64_t seed;
    double f, P, Q;
} random_history;

rwedge_contact *begin(random_history *h, int number);
void go_on(random_history *h, rwedge_contact *contact);

enum { POINTS_MAX = 200 };

/* Ascending: 0, the ends of the patches, and a. Between them the tractions are smooth. Returns the
 * number of pieces. */
size_t breakpoints(const rwedge_contact *contact, double points[]);

#endif
