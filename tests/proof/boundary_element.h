/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A small incremental boundary-element solver of the same contact, to check the library's closed
 * forms with: it knows Eq. (1) and (17), of unlike bodies what a pressure does along the surface
 * and a shear across it, Coulomb's law and nothing else. The pressure and the shear traction are
 * constant over each of n equal elements. Everything is first order in the elements' width and in
 * the step. */
#ifndef BOUNDARY_ELEMENT_H
#define BOUNDARY_ELEMENT_H

#include "histories.h"

enum { BOUNDARY_ELEMENTS_MAX = 200 };

/* Tractions between bounds, and behind them a rigid displacement and a tilt. Where a traction is
 * free, the displacement that all cause is the wanted one; it is more at the highest bound, less at
 * the lowest. Displacement and tilt are free: what is wanted is the sum of the tractions, and of
 * them times x. */
typedef enum { FREE, LOWEST, HIGHEST } bound;

enum { UNKNOWNS_MAX = BOUNDARY_ELEMENTS_MAX + 2 };
typedef struct {
    size_t count;
    double lowest[UNKNOWNS_MAX], highest[UNKNOWNS_MAX], wanted[UNKNOWNS_MAX];
    bound at[UNKNOWNS_MAX];
    double value[UNKNOWNS_MAX];
} unknowns;

typedef struct {
    double theta, a, A, f;
    double B; /* -Dundurs' beta: what each traction does to the displacement of the other */
    double (*height)(double x); /* of another profile than the wedge's; NULL: the wedge's */
    size_t n;
    double width;
    double x[BOUNDARY_ELEMENTS_MAX];
    double influence[BOUNDARY_ELEMENTS_MAX]; /* on an element so many elements away */
    unknowns p, q;
    double q_before[BOUNDARY_ELEMENTS_MAX];
    bool is_driven;                                        /* by boundary_element_drive() */
    double driven_to, displacement[BOUNDARY_ELEMENTS_MAX]; /* tangential, relative, less the rigid
                                                              one */
    double slip[BOUNDARY_ELEMENTS_MAX];                    /* since the element came into contact */
    double energy;
    double worn[BOUNDARY_ELEMENTS_MAX]; /* off the profile: boundary_element_wear() */
    rw_loads loads;
} boundary_element;

/* The elements of -half < x < half. */
void boundary_element_start(boundary_element *solver, double theta, double a, double compliance,
                            double f, size_t n, double half);

/* To these loads in so many equal, straight steps; |Q| < f P. 0, or 1 where the iteration for the
 * edges or the zones of slip did not end. */
int boundary_element_go(boundary_element *solver, int steps, rw_loads to);

/* From now on a rig prescribes displacements, as rwedge_contact_drive() counts them from the
 * half-width b. Of similar bodies. */
void boundary_element_hold(boundary_element *solver, double b, double compliance);

/* To P, M, sigma of the loads and a displacement, as boundary_element_go() does. */
int boundary_element_drive(boundary_element *solver, int steps, rw_loads to, double displacement);

/* What the tractions along the surface carry. */
double boundary_element_force(const boundary_element *solver);

/* Wear by Archard's law to its end: the depth grows by `rate` times pressure times slip, cycle by
 * cycle, while Q goes to and fro by Q_a. P and the tilt stay, and each cycle is steady: what slips
 * does so both ways. 0, or 1 as above. */
int boundary_element_wear(boundary_element *solver, double P, double tilt, double Q_a, double rate);

/* Differences summed up over the legs of a history, relative to friction's limit and to the largest
 * slip there could be; of the energy the last. */
typedef struct {
    double pressure, shear, slip, young_slip, energy; /* young: of what came later */
    int legs;
    rw_patch lasting; /* what has been in contact since the first leg */
} difference;

/* Adds those of the present state. */
void add_difference(const rwedge_contact *contact, const boundary_element *solver, double f,
                    difference *sum);

#endif
