/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "fronts/fronts.h"

#include "base/complex.h"
#include "base/domain.h"
#include "base/linear.h"
#include "base/processor.h"
#include "base/tuned.h"

#include <string.h>

/* Terms of X on a gap, and points there: at most. */
enum { GAP_TERMS = 48, GAP_POINTS = 40 };

/* An edge that moves by less than this part of the half-width has the same D before and after. */
static const double LEAST_GROWTH = 1e-6;

/* The layers that have a given D at the edges that stick: D after the step is an unknown of
 * Newton's method; D before it is `ratio`, where that is known. There are as many layers as
 * conditions. layer_of[0] is for D = 0 after the step, the others are added for each D. */
static bool find_layers(rw_fronts *f, const double ratio[2])
{
    const rw_problem *p = f->problem;
    double A[RW_LAYERS * RW_LAYERS], B[3][RW_LAYERS] = {{0}};
    int n = 0, column = 1;
    int row_side[RW_LAYERS], row_after[RW_LAYERS];
    for (int side = 0; side < 2; side++) {
        if (!f->sticks_to_edge[side])
            continue;
        row_side[n] = side, row_after[n] = 1;
        B[column++][n++] = 1;
        if (!isfinite(ratio[side]) || p->growth[side] < LEAST_GROWTH * p->half)
            continue;
        row_side[n] = side, row_after[n] = 0;
        B[0][n++] = ratio[side];
    }
    for (int i = 0; i < 3; i++) {
        f->layer_of[i].count = n;
        for (int row = 0; row < n; row++)
            for (int k = 0; k < n; k++)
                A[row * n + k] = p->ratio[k][row_side[row]][row_after[row]];
        if (!rw_solve((size_t)n, 1, A, B[i]))
            return false;
        memcpy(f->layer_of[i].weight, B[i], sizeof B[i]);
    }
    return true;
}

bool rw_fronts_begin(rw_fronts *f, const rw_problem *p, const rw_zones *zones,
                     const double ratio[2])
{
    if (f->problem != p)
        rw_fronts_forget(f);
    f->problem = p;
    f->zones = zones->count;
    f->fronts = zones->count - 1;
    f->sticks = 0;
    f->segments = 0;
    f->count = 0;
    for (int i = 0; i < zones->count; i++) {
        f->label[i] = zones->zone[i].label;
        f->sticks += f->label[i] == 0;
    }
    f->sticks_to_edge[0] = f->label[0] == 0;
    f->sticks_to_edge[1] = f->label[f->zones - 1] == 0;
    f->unknowns = f->fronts + f->sticks_to_edge[0] + f->sticks_to_edge[1];
    if (f->sticks == 0 || f->unknowns != 2 * f->sticks || f->unknowns > RW_MOST_FRONTS)
        return false;
    for (int i = 0; i < 2; i++)
        if (f->sticks_to_edge[i] && !p->grows[i])
            return false;
    for (int i = 0; i < f->fronts; i++)
        f->y[i] = rw_angle_of(p, zones->zone[i].right);
    for (int side = 0, i = f->fronts; side < 2; side++)
        if (f->sticks_to_edge[side])
            f->y[i++] = isfinite(ratio[side]) ? ratio[side] : 0;
    return find_layers(f, ratio);
}

rw_layers rw_fronts_zones(const rw_fronts *f, rw_zones *zones)
{
    zones->count = f->zones;
    for (int i = 0; i < f->zones; i++)
        zones->zone[i] =
            (rw_zone){f->label[i], i == 0 ? f->problem->to.left : zones->zone[i - 1].right,
                      i == f->fronts ? f->problem->to.right : rw_place_of(f->problem, f->y[i])};
    rw_layers layers = f->layer_of[0];
    for (int i = f->fronts; i < f->unknowns; i++)
        for (int k = 0; k < layers.count; k++)
            layers.weight[k] += f->y[i] * f->layer_of[1 + i - f->fronts].weight[k];
    return layers;
}

/* ---- The polynomial ---- */

/* How many terms the series of a gap takes. It falls by rho from term to term, the faster the
 * further the zones beside the gap reach. */
static double terms_of(const rw_stuck *s, int gap, double middle, double half, double least)
{
    const double reach = fmin(middle - s->end[2 * gap], s->end[2 * gap + 3] - middle) / half;
    const double rho = fmax(1.001, reach + sqrt(fmax(0, reach * reach - 1))); /* log(1) is 0 */
    return fmax(4, 1 - log(least) / log(rho));
}

/* A row of angles takes one sine and one cosine, and a product for each angle. */
static rw_complex direction_of(double angle)
{
    return (rw_complex){cos(angle), sin(angle)};
}

/* X in the gap between two zones that stick, over the half-length of the gap, as a sum of sines.
 * Returns how many terms count, an even number. */
static int expand_gap(const rw_stuck *s, int gap, double least, double middle, double half,
                      double c[])
{
    double sampled[GAP_TERMS], sine[2 * (GAP_TERMS + 1)], most = 0, x[GAP_TERMS], X[GAP_TERMS];
    int terms = 1;
    const int n = (int)fmin(GAP_TERMS, terms_of(s, gap, middle, half, least)), turn = 2 * (n + 1);
    const rw_complex step = direction_of(2 * RW_PI / turn);
    rw_complex at_point = {1, 0};
    for (int i = 0; i < turn; i++, at_point = rw_product(at_point, step)) {
        sine[i] = at_point.im;
        if (i > 0 && i <= n)
            x[i - 1] = middle + half * at_point.re;
    }
    rw_X_values(s, (size_t)n, x, X);
    for (int i = 0; i < n; i++)
        sampled[i] = 4.0 / turn / half * X[i];
    for (int k = 0; k < n; k++) { /* sines are even or odd about the middle of the gap */
        const int way = k % 2 == 0 ? 1 : -1;
        c[k] = n % 2 > 0 ? sampled[n / 2] * sine[(k + 1) * (n / 2 + 1) % turn] : 0;
        for (int i = 0, at = k + 1; i < n / 2; i++, at += at + k + 1 < turn ? k + 1 : k + 1 - turn)
            c[k] += (sampled[i] + way * sampled[n - 1 - i]) * sine[at];
        most = fmax(most, fabs(c[k]));
    }
    for (int k = 0; k < n; k++)
        terms = fabs(c[k]) > least * most ? k + 1 : terms;
    if (terms % 2 > 0)
        c[terms++] = 0;
    return terms;
}

/* The integral over the gap, from -1 to 1, of X/(eta - x) dx/pi, with an even number of terms. The
 * points are all in the gap, or none. */
RW_INLINE void sum_gap(int terms, const double c[], const double eta[], double kernel[])
{
    double b1[RW_FRONT_LANES] = {0}, b2[RW_FRONT_LANES] = {0};
    if (fabs(eta[0]) <= 1) {
        for (int k = terms - 1; k > 0; k -= 2) { /* Clenshaw, of T_1 ... */
            for (int i = 0; i < RW_FRONT_LANES; i++)
                b2[i] = c[k] + 2 * eta[i] * b1[i] - b2[i];
            for (int i = 0; i < RW_FRONT_LANES; i++)
                b1[i] = c[k - 1] + 2 * eta[i] * b2[i] - b1[i];
        }
        for (int i = 0; i < RW_FRONT_LANES; i++)
            kernel[i] = eta[i] * b1[i] - b2[i];
        return;
    }
    double R[RW_FRONT_LANES];
    for (int i = 0; i < RW_FRONT_LANES; i++)
        R[i] = 1 / (eta[i] + copysign(sqrt(eta[i] * eta[i] - 1), eta[i]));
    for (int k = terms - 1; k >= 0; k--)
        for (int i = 0; i < RW_FRONT_LANES; i++)
            b1[i] = (b1[i] + c[k]) * R[i];
    for (int i = 0; i < RW_FRONT_LANES; i++)
        kernel[i] = b1[i];
}

RW_DISPATCH(gap_kernel, sum_gap, (int terms, const double c[], const double eta[], double kernel[]),
            (terms, c, eta, kernel))

/* How far two zones that stick would move apart by dt, without p: the integral over the gap (a, b)
 * between them of X (1/pi) int [dt/X]/(s - x) ds dx. The integral over x comes first, from a
 * Chebyshev series of X/sqrt((x - a)(b - x)). */
static double gap_of_change(const rw_fronts *f, const rw_stuck *s, int gap)
{
    const double a = s->end[2 * gap + 1], b = s->end[2 * gap + 2];
    const double half = (b - a) / 2, middle = (a + b) / 2;
    double c[GAP_TERMS];
    const double least = RW_LEAST_TERM * f->problem->frame->tolerance;
    const int terms = expand_gap(s, gap, least, middle, half, c);
    double sum = 0;
    for (size_t first = 0; first < f->count; first += RW_FRONT_LANES) {
        double eta[RW_FRONT_LANES], kernel[RW_FRONT_LANES];
        for (size_t i = 0; i < RW_FRONT_LANES; i++)
            eta[i] = (f->x[first + i] - middle) / half;
        gap_kernel(terms, c, eta, kernel);
        for (size_t i = 0; i < RW_FRONT_LANES; i++)
            sum += f->step[first + i] * f->change[first + i] / f->X[first + i] * kernel[i];
    }
    return half * sum;
}

/* The first n coefficients of product (1 - c/z)^(power), power +-1/2. */
static void expand_at_infinity(int n, int count, const double c[], double power, double series[])
{
    for (int i = 0; i < n; i++)
        series[i] = i == 0;
    for (int j = 0; j < count; j++) {
        double factor[RW_MOST_STICK + 1] = {1}, product[RW_MOST_STICK + 1];
        for (int k = 1; k < n; k++)
            factor[k] = factor[k - 1] * c[j] * (k - 1 - power) / k;
        for (int i = 0; i < n; i++) {
            product[i] = 0;
            for (int k = 0; k <= i; k++)
                product[i] += series[i - k] * factor[k];
        }
        memcpy(series, product, (size_t)n * sizeof *series);
    }
}

/* The moments of dt/X over the slip zones, in powers of the place. */
RW_INLINE void sum_moments(const rw_fronts *f, const rw_stuck *s, double moment[])
{
    const double per_half = 1 / s->half;
    double sum[RW_MOST_STICK + 1][RW_FRONT_LANES] = {{0}};
    for (size_t first = 0; first < f->count; first += RW_FRONT_LANES) {
        double at[RW_FRONT_LANES], power[RW_FRONT_LANES];
        RW_EACH (i, RW_FRONT_LANES) {
            at[i] = (f->x[first + i] - s->middle) * per_half;
            power[i] = f->step[first + i] * f->change[first + i] / f->X[first + i] * per_half;
        }
        for (int j = 0; j <= s->count; j++)
            RW_EACH (i, RW_FRONT_LANES) {
                sum[j][i] += power[i];
                power[i] *= at[i];
            }
    }
    for (int j = 0; j <= s->count; j++) {
        moment[j] = 0;
        for (size_t i = 0; i < RW_FRONT_LANES; i++)
            moment[j] += sum[j][i];
    }
}

RW_DISPATCH(set_moments, sum_moments, (const rw_fronts *f, const rw_stuck *s, double moment[]),
            (f, s, moment))

/* Omega + stretch is, at infinity, the stretch less the load over pi z: a row of A p = B for each
 * power of z from m - 1 to -1. */
static void conditions_at_infinity(const rw_fronts *f, const rw_stuck *s, double A[], double B[])
{
    const int m = s->count, n = 2 * m;
    double shear, stretch;
    rw_beside_layers(f->problem, &f->layers, &shear, &stretch);
    double moment[RW_MOST_STICK + 1], grown[RW_MOST_STICK + 1], shrunk[RW_MOST_STICK + 1];
    set_moments(f, s, moment);
    expand_at_infinity(m + 1, n, s->front, 0.5, grown);
    expand_at_infinity(m + 1, n, s->front, -0.5, shrunk);
    for (int row = 0; row <= m; row++) {
        const int power = m - 1 - row;
        for (int i = m + power; i < n; i++)
            A[row * n + i] = shrunk[i - m - power];
        B[row] = (power == 0 ? stretch : 0) - (power == -1 ? shear / (RW_PI * s->half) : 0);
        for (int j = 0; j <= row; j++)
            B[row] += grown[row - j] * moment[j] / RW_PI;
    }
}

/* Zones that stick do not move apart: a row of A p = B for each gap between two. */
static void conditions_of_gaps(const rw_fronts *f, const rw_stuck *s, double A[], double B[])
{
    const int m = s->count, n = 2 * m;
    const double least = RW_LEAST_TERM * f->problem->frame->tolerance;
    for (int k = 0; k + 1 < m; k++) {
        const double a = s->end[2 * k + 1], b = s->end[2 * k + 2], half = (b - a) / 2;
        /* a rule takes in twice as many terms as it has points, those of the powers too */
        const double terms = n + terms_of(s, k, (a + b) / 2, half, least);
        const int points = (int)fmin(GAP_POINTS, terms / 2 + 1);
        const rw_complex step = direction_of(RW_PI / points);
        rw_complex point = direction_of(RW_HALF_PI / points);
        double x[GAP_POINTS], X[GAP_POINTS], *row = A + (m + 1 + k) * n;
        for (int i = 0; i < points; i++, point = rw_product(point, step))
            x[i] = (a + b) / 2 + half * point.re;
        rw_X_values(s, (size_t)points, x, X);
        for (int i = 0; i < points; i++) {
            const double at = (x[i] - s->middle) / s->half;
            double share = sqrt((x[i] - a) * (b - x[i])) / X[i] * RW_PI / points / half;
            for (int j = 0; j < n; j++, share *= at)
                row[j] += share;
        }
        B[m + 1 + k] = -gap_of_change(f, s, k) / half;
    }
}

bool rw_fronts_polynomial(const rw_fronts *f, rw_stuck *s)
{
    double A[RW_MOST_FRONTS * RW_MOST_FRONTS] = {0};
    conditions_at_infinity(f, s, A, s->p);
    conditions_of_gaps(f, s, A, s->p);
    return rw_solve((size_t)(2 * s->count), 1, A, s->p);
}

double rw_polynomial_at(const rw_stuck *s, double place)
{
    double value = 0;
    for (int i = 2 * s->count - 1; i >= 0; i--)
        value = value * place + s->p[i];
    return value;
}

void rw_fronts_singular(const rw_stuck *s, double K[])
{
    const int n = 2 * s->count;
    for (int j = 0; j < n; j++) {
        double apart = 1;
        for (int i = 0; i < n; i++)
            apart *= i == j ? 1 : fabs(s->front[i] - s->front[j]);
        /* X has the sign (-1)^(m-1-k) on the k-th zone, times i */
        K[j] = ((s->count - 1 - j / 2) % 2 == 0 ? -1 : 1) * rw_polynomial_at(s, s->front[j]) /
               sqrt(apart);
    }
}

bool rw_fronts_residual(rw_fronts *f, double r[])
{
    rw_zones zones;
    const rw_layers layers = rw_fronts_zones(f, &zones);
    if (f->budget-- <= 0)
        return false;
    rw_fronts_collect(f, &zones, &layers, f->coarse);
    rw_stuck s = rw_stuck_of(f, &zones);
    const int n = 2 * s.count;
    double K[RW_MOST_FRONTS];
    if (!rw_fronts_polynomial(f, &s))
        return false;
    rw_fronts_singular(&s, K);
    int count = 0;
    for (int j = 0; j < n; j++)
        if (!isfinite(K[j]))
            return false;
        else if (!(j == 0 && f->sticks_to_edge[0]) && !(j == n - 1 && f->sticks_to_edge[1]))
            r[count++] = K[j];
    if (f->sticks_to_edge[0])
        r[count++] = K[0];
    if (f->sticks_to_edge[1])
        r[count++] = K[n - 1];
    return true;
}
