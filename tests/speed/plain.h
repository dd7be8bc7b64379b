/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The plain way to stresses and elastic limits, which times are compared with: the paper's
 * series as it stands and a search on a grid. */
#ifndef PLAIN_H
#define PLAIN_H

enum { PLAIN_TERMS = 60, PLAIN_TERMS_MAX = 1000 };

typedef struct {
    int terms;
    double b[PLAIN_TERMS_MAX];
} plain_series;

void plain_coefficients(plain_series *s, double alpha, int terms);

/* J2 in full sliding: one evaluation of all stresses. */
double plain_J2(const plain_series *s, double f, double nu, double x, double y);

double plain_limit(double alpha, double f, double nu, int terms);

#endif
