/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "unlike/power_integral.h"

#include "base/domain.h"

/* ---- Gauss and Jacobi ---- */

enum { NODES = RW_POWER_NODES, TERMS = RW_POWER_TERMS };

/* Jacobi's polynomials P_n and P_(n-1) of the weight (1 + x)^b; then P_n over its derivative. */
typedef struct {
    double now, before, ratio;
} polynomial;

static polynomial jacobi(double b, double x)
{
    double now = (b + 2) / 2 * x - b / 2, before = 1;
    for (int n = 2; n <= NODES; n++) {
        const double m = 2 * n + b;
        const double next =
            ((m - 1) * (m * (m - 2) * x - b * b) * now - 2 * (n - 1) * (n + b - 1) * m * before) /
            (2 * n * (n + b) * (m - 2));
        before = now;
        now = next;
    }
    const double m = 2 * NODES + b;
    const double slope = NODES * (-b - m * x) * now + 2 * NODES * (NODES + b) * before;
    return (polynomial){now, before, now * m * (1 - x) * (1 + x) / slope};
}

/* Newton's method from Darboux's estimate. */
static void set_nodes(rw_power_rule *rule)
{
    enum { STEPS = 12 };
    const double b = rule->a - 1, most = 2 * NODES * (NODES + b) / (2 * NODES + b);
    double sum = 0;
    for (int i = 0; i < NODES; i++) {
        double x = cos((i + 0.75) * RW_PI / (NODES + (1 + b) / 2));
        for (int step = 0; step < STEPS; step++)
            x -= jacobi(b, x).ratio;
        const double last = most * jacobi(b, x).before;
        rule->node[i] = (1 + x) / 2;
        rule->weight[i] = (1 - x) * (1 + x) / (last * last);
        sum += rule->weight[i];
    }
    for (int i = 0; i < NODES; i++) /* their sum is 1/a */
        rule->weight[i] /= sum * rule->a;
}

/* ---- Next to w = 1 ---- */

/* The logarithmic derivative of the gamma function, x > 0: Stirling's series, from 10 on. */
static double digamma(double x)
{
    double sum = 0;
    for (; x < 10; x++)
        sum -= 1 / x;
    const double u = 1 / (x * x);
    return sum + log(x) - 1 / (2 * x) -
           u * (1.0 / 12 -
                u * (1.0 / 120 -
                     u * (1.0 / 252 - u * (1.0 / 240 - u * (1.0 / 132 - u * 691.0 / 32760)))));
}

static void set_series(rw_power_rule *rule)
{
    rule->coefficient[0] = 1;
    rule->shift[0] = digamma(1) - digamma(rule->a);
    for (int k = 1; k < TERMS; k++) {
        rule->coefficient[k] = rule->coefficient[k - 1] * (rule->a + k - 1) / k;
        rule->shift[k] = rule->shift[k - 1] + 1.0 / k - 1 / (rule->a + k - 1);
    }
}

void rw_power_rule_init(rw_power_rule *rule, double a)
{
    rule->a = a;
    set_nodes(rule);
    set_series(rule);
}

/* ---- Values ---- */

/* A term of the series is lost in rounding where the power is below exp(-DIGITS). */
static const double DIGITS = 36;

/* The square of a distance from w = 1 that is none. */
static const double LEAST = 1e-290;

static rw_complex series(const rw_power_rule *rule, rw_complex rest, double angle)
{
    const double size = rest.re * rest.re + rest.im * rest.im;
    const rw_complex logarithm = {rw_log_of_quotient(size + LEAST, 1) / 2, angle};
    rw_complex plain = {0, 0}, shifted = {0, 0};
    for (int k = (int)fmin(TERMS, 2 + DIGITS / -logarithm.re); k-- > 0;) {
        plain = rw_product(plain, rest);
        shifted = rw_product(shifted, rest);
        plain.re += rule->coefficient[k];
        shifted.re += rule->coefficient[k] * rule->shift[k];
    }
    return rw_sum(shifted, rw_multiple(-1, rw_product(logarithm, plain)));
}

static rw_complex sum_over_nodes(const rw_power_rule *rule, rw_complex w)
{
    enum { LANES = 4 };
    double re[LANES] = {0}, im[LANES] = {0};
    for (int i = 0; i < NODES; i += LANES)
        for (int k = 0; k < LANES; k++) {
            const double x = 1 - rule->node[i + k] * w.re, y = rule->node[i + k] * w.im;
            const double share = rule->weight[i + k] / (x * x + y * y);
            re[k] += share * x;
            im[k] += share * y;
        }
    return (rw_complex){re[0] + re[1] + (re[2] + re[3]), im[0] + im[1] + (im[2] + im[3])};
}

rw_complex rw_power_integral(const rw_power_rule *rule, rw_complex w, rw_complex rest, double angle)
{
    const bool is_near = rest.re * rest.re + rest.im * rest.im < 0.25;
    return is_near ? series(rule, rest, angle) : sum_over_nodes(rule, w);
}

double rw_power_integral_below(const rw_power_rule *rule, double w)
{
    double sum = 0;
    for (int i = 0; i < NODES; i++)
        sum += rule->weight[i] / (1 - rule->node[i] * w);
    return sum;
}
