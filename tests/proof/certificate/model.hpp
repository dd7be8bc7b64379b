/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A real function on a square as a quadratic polynomial and a bound of the rest. The square's
 * coordinates are xi and eta in [-1, 1]. Coefficients are doubles; `rest` takes in what their
 * arithmetic rounds off, so that the enclosure is rigorous. */
#ifndef MODEL_HPP
#define MODEL_HPP

struct model {
    double one, x, y, xx, xy, yy; /* one + x xi + y eta + xx xi^2 + xy xi eta + yy eta^2 */
    double rest;

    double at(double xi, double eta) const; /* of the polynomial alone */
};

/* An upper bound of the function's modulus. */
double model_bound(const model &m);

model operator*(const model &a, const model &b);
model operator*(double weight, const model &a);
model operator+(const model &a, const model &b);
model operator-(const model &a, const model &b);

/* Sum of weight[i] * term[i]. */
model model_combination(int terms, const double *weight, const model *term);

/* An upper bound of the function: sharp, but for the rest. HUGE_VAL where there is none. */
double model_maximum(const model &m);

/* The highest point of the polynomial alone, and its height, to rounding. */
struct summit {
    double value, xi, eta;
};
summit model_summit(const model &m);

#endif
