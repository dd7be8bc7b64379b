/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A small incremental boundary-element solver of the same contact, to check the library's closed
 * forms with: it knows Eq. (1) and (17), Coulomb's law and nothing else. The pressure and the
 * shear traction are constant over each of n equal elements of 0 < x < width, and even.
 * Everything is first order in the elements' width and in the step. */
#ifndef BOUNDARY_ELEMENT_H
#define BOUNDARY_ELEMENT_H

#include <stddef.h>

enum { BOUNDARY_ELEMENTS_MAX = 160 };

typedef struct {
    double theta, a, A, f;
    size_t n, touching; /* the first `touching` elements are in contact */
    double width;
    double x[BOUNDARY_ELEMENTS_MAX], p[BOUNDARY_ELEMENTS_MAX], q[BOUNDARY_ELEMENTS_MAX];
    double displacement[BOUNDARY_ELEMENTS_MAX]; /* tangential, relative, less the rigid one */
    double slip[BOUNDARY_ELEMENTS_MAX];         /* since the element came into contact */
    double rigid;                               /* tangential displacement */
    double energy, P, Q;
} boundary_element;

void boundary_element_start(boundary_element *solver, double theta, double a, double A, double f,
                            size_t n, double width);

/* One straight step of the load; |Q| < f P. 0, or 1 where the iteration for the zones of slip
 * did not end. */
int boundary_element_step(boundary_element *solver, double P, double Q);

#endif
