/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "unlike/power_integral.h"

#include "base/domain.h"

enum { TERMS = RW_POWER_TERMS };

/* w Phi' + a Phi = 1/(1 - w) in u: u (1 + u) Phi' + a (1 - u) Phi = (1 + u)^2/(1 - u). */
static void set_far(rw_power_rule *rule)
{
    const double a = rule->a;
    rule->far[0] = 1 / a;
    for (int n = 1; n < TERMS; n++)
        rule->far[n] = ((n == 1 ? 3 : 4) - (n - 1 - a) * rule->far[n - 1]) / (n + a);
}

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

/* S = Phi + w^(-a) ln(1 - w): w S' + a S = (1 - w^(1-a))/(1 - w), in u of 1 - w
 *     (u^2 - 1)/4 S' + a S = h,   h = (1 + u)^2/(4 u) (1 - q),   q = ((1 - u)/(1 + u))^(2-2a),
 * and (1 - u^2) q' = -4 (1 - a) q. */
static void set_near(rw_power_rule *rule)
{
    const double a = rule->a, c = 4 * (1 - a);
    double q[TERMS + 1] = {1, -c};
    for (int n = 1; n < TERMS; n++)
        q[n + 1] = ((n - 1) * q[n - 1] - c * q[n]) / (n + 1);
    q[0] = 0; /* of q - 1 */
    rule->near[0] = digamma(1) - digamma(a);
    for (int n = 0; n + 1 < TERMS; n++) {
        const double h = -(q[n + 1] + 2 * q[n] + (n > 0 ? q[n - 1] : 0)) / 4;
        const double before = n > 0 ? (n - 1) * rule->near[n - 1] : 0;
        rule->near[n + 1] = (4 * (a * rule->near[n] - h) + before) / (n + 1);
    }
}

void rw_power_rule_init(rw_power_rule *rule, double a)
{
    rule->a = a;
    rule->whole = RW_PI / sin(RW_PI * a);
    set_far(rule);
    set_near(rule);
}

double rw_power_integral_below(const rw_power_rule *rule, double w)
{
    const double root = sqrt(1 - w), u = w / ((1 + root) * (1 + root));
    double sum = 0;
    for (int n = TERMS; n-- > 0;)
        sum = sum * u + rule->far[n];
    return sum;
}
