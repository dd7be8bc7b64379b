/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What the tests of contacts with a load history share: short names that fail the test where a
 * call fails, and random histories. */
#ifndef HISTORIES_H
#define HISTORIES_H

#include "claims.h"
#include "contact/contact.h"

static const double THETA = 0.1, A = 0.5; /* theta/A = 0.2 */

/* Contacts, which live to the end of the claim. */
rwedge_contact *owned(rwedge_contact *contact);
rwedge_contact *create(double a, double f);
rwedge_contact *create_wedge(double theta, double a, double A, double f);
rwedge_contact *create_flat(double a, double R, double A, double f);
rwedge_contact *create_profile(size_t n, const double x[], const double slope[], double f);
rwedge_contact *copy_of(const rwedge_contact *contact);
rwedge_contact *allowing(rwedge_contact *contact, double tolerance); /* the contact itself */

/* A contact as numbers, to the end of the claim too; behind them there is room for one more. */
typedef struct {
    size_t size;
    double *number;
} contact_state;

contact_state state_of(const rwedge_contact *contact);
rwedge_contact *restored(contact_state state);
void assert_state(const rwedge_contact *contact, contact_state expected); /* bit by bit */

void load(rwedge_contact *contact, double P, double Q);
/* The wedge of a row of tests/data/, theta, A, a, f, after its loads, whose number comes first. */
rwedge_contact *recorded(const double wedge[], const double loads[]);
int32_t try_load(rwedge_contact *contact, rw_loads to); /* the status */
/* In a straight line, to these parts of it, or to n equal ones; the first status that is not OK. */
int32_t try_parts(rwedge_contact *contact, rw_loads to, int n, const double ends[]);
void apply(rwedge_contact *contact, double P, double M, double Q, double sigma);
/* The load has that status and leaves all as it was; that it has no closed form is explained. */
void refuse(rwedge_contact *contact, double P, double M, double Q, double sigma, int32_t status);
/* Loads {P, M, Q, sigma}, one after another; gives the contact. */
#define APPLY(contact, ...)                                                                        \
    apply_all(contact, sizeof((rw_loads[]){__VA_ARGS__}) / sizeof(rw_loads),                       \
              (const rw_loads[]){__VA_ARGS__})
rwedge_contact *apply_all(rwedge_contact *contact, size_t count, const rw_loads loads[]);

/* A cycle of at most CYCLE_LOADS loads, to the end of the claim. */
enum { CYCLE_LOADS = 120 };
rwedge_cycle *cycle_of(const rwedge_contact *contact, size_t loads, const rw_loads load[]);

rw_patch edges_of(const rwedge_contact *contact);
rw_patch stick_zone_of(const rwedge_contact *contact);

/* At the point x of the surface. */
double pressure(const rwedge_contact *contact, double x);
double shear(const rwedge_contact *contact, double x);
double slip(const rwedge_contact *contact, double x);

/* At 199 places between the edges. */
void assert_same_shear(const rwedge_contact *actual, const rwedge_contact *expected, double within);

typedef struct {
    double xx, yy, xy;
} stresses;

stresses stress_at(const rwedge_contact *contact, double x, double y);
double apart(stresses a, stresses b); /* of the components, the largest */

/* A random history, the same in every test: geometry and loads of which every kind occurs. */
typedef struct {
    uint64_t seed;
    double f, P, Q;
} random_history;

rwedge_contact *begin(random_history *h, int number);
void go_on(random_history *h, rwedge_contact *contact);

#endif
