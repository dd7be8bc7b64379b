/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The plain way to stresses and elastic limits, which times are compared with: the paper's series
 * as it stands and a search on a grid. */
#include "works.h"

#include <math.h>

enum { TERMS = 60 };

typedef struct {
    double b[TERMS];
} plain_series;

static const double PI = 3.14159265358979323846;

static void set_coefficients(plain_series *s, double alpha)
{
    const double phi0 = asin(fmin(alpha, 1));
    for (int n = 0; n < TERMS; n++) {
        const double m = 2 * n + 1;
        s->b[n] = n == 0 ? 2 / PI * (phi0 + alpha * cos(phi0)) / alpha
                         : 4 / PI * (n % 2 ? -1 : 1) *
                               (m * sin(m * phi0) / tan(phi0) - cos(m * phi0)) / (m * (m * m - 1));
    }
}

/* Eq. (30), (32), (33) as they stand; J2 for plane strain. */
static double plain_J2(const plain_series *s, double f, double nu, double x, double y)
{
    /* sqrt(z^2-1) with the branch that is z at infinity */
    const double a = x * x - y * y - 1, b = 2 * x * y, r = sqrt(hypot(a, b)),
                 angle = atan2(b, a) / 2;
    double X = r * cos(angle), Y = r * sin(angle);
    if (Y < 0 || (Y == 0 && X * x < 0)) {
        X = -X;
        Y = -Y;
    }
    const double R = x - X, I = y - Y;
    double G = 0, H = 0, U = 0, V = 0;
    for (int n = TERMS - 1; n >= 0; n--) {
        const double R2 = R * R - I * I, I2 = 2 * R * I, g = G * R2 - H * I2, u = U * R2 - V * I2;
        H = G * I2 + H * R2;
        G = g + s->b[n];
        V = U * I2 + V * R2;
        U = u + (2 * n + 1) * s->b[n];
    }
    const double Gr = G * R - H * I, Gi = G * I + H * R, Wr = U * R - V * I, Wi = U * I + V * R;
    const double X2 = fmax(X * X + Y * Y, 1e-300), dr = -(Wr * X + Wi * Y) / X2,
                 di = -(Wi * X - Wr * Y) / X2;
    const double D = -y * dr - y * f * di + f * Gr, E = -y * di + y * f * dr + f * Gi,
                 mean = Gi - f * Gr;
    return D * D + E * E + (1 - 2 * nu) * (1 - 2 * nu) / 3 * mean * mean;
}

/* A grid of 121 x 61 points and a pattern search from the best. */
static double plain_limit(double alpha, double f, double nu)
{
    plain_series s;
    set_coefficients(&s, alpha);
    double best = 0, at_x = 0, at_y = 0;
    for (int i = 0; i <= 120; i++)
        for (int j = 0; j <= 60; j++) {
            const double x = -1.2 + 0.02 * i, y = 0.02 * j, J2 = plain_J2(&s, f, nu, x, y);
            if (J2 > best) {
                best = J2;
                at_x = x;
                at_y = y;
            }
        }
    for (double step = 0.01; step > 1e-9; step /= 2)
        for (int k = 0; k < 4; k++) {
            const double x = at_x + (k == 0 ? step : k == 1 ? -step : 0);
            const double y = fmax(0, at_y + (k == 2   ? step
                                             : k == 3 ? -step
                                                      : 0)),
                         J2 = plain_J2(&s, f, nu, x, y);
            if (J2 > best) {
                best = J2;
                at_x = x;
                at_y = y;
            }
        }
    return (asin(fmin(alpha, 1)) / alpha + sqrt(fmax(0, 1 - alpha * alpha))) / sqrt(best);
}

double plain_points(const work *w)
{
    plain_series s;
    double sum = 0;
    set_coefficients(&s, 0.3);
    for (long i = 0; i < w->n; i++)
        sum += plain_J2(&s, 0.4, 0.3, xs[i], ys[i]);
    return sum;
}

double plain_limits(const work *w)
{
    double sum = 0;
    for (long i = 0; i < w->n; i++)
        sum += plain_limit(0.5, 0.05 * (double)i, 0.3);
    return sum;
}
