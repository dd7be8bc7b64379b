/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A small incremental boundary-element solver of the same contact, to check the library's closed
 * forms with: it knows Eq. (1) and (17), Coulomb's law and nothing else. The pressure and the
 * shear traction are constant over each of n equal elements. Everything is first order in the
 * elements' width and in the step. */
#ifndef BOUNDARY_ELEMENT_H
#define BOUNDARY_ELEMENT_H

#include "histories.h"

enum { BOUNDARY_ELEMENTS_MAX = 200 };

typedef enum { STICKS, FORWARD, BACKWARD } motion;

typedef struct {
    double theta, a, A, f;
    double (*height)(double x); /* of another profile than the wedge's; NULL: the wedge's */
    size_t n, first, end;       /* elements `first` to `end` - 1 are in contact */
    double width;
    double x[BOUNDARY_ELEMENTS_MAX], p[BOUNDARY_ELEMENTS_MAX], q[BOUNDARY_ELEMENTS_MAX];
    double displacement[BOUNDARY_ELEMENTS_MAX]; /* tangential, relative, less the rigid one */
    double slip[BOUNDARY_ELEMENTS_MAX];         /* since the element came into contact */
    motion moves[BOUNDARY_ELEMENTS_MAX];        /* in the last step */
    double tilt;                                /* rad, positive lowers the right side */
    double rigid;                               /* tangential displacement */
    double energy;
    rw_loads loads;
} boundary_element;

/* The elements of -half < x < half. */
void boundary_element_start(boundary_element *solver, double theta, double a, double compliance,
                            double f, size_t n, double half);

/* To these loads in so many equal, straight steps; |Q| < f P. 0, or 1 where the iteration for the
 * edges or the zones of slip did not end. */
int boundary_element_go(boundary_element *solver, int steps, rw_loads to);

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
