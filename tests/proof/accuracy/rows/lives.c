/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Lives: how far the curve at the life is from the value, over its slope. */
#include "rows/rows.h"
#include "rwedge.h"

enum { VALUE, MODULUS, STRENGTH, B, DUCTILITY, C };

static void draw_curve(probe *call, const char *const names[6], double strength, double modulus)
{
    argument(call, names[VALUE], log_between(call, 1e-4, 10));
    argument(call, names[MODULUS], modulus * between(call, 0.5, 2));
    argument(call, names[STRENGTH], strength * between(call, 0.5, 2));
    argument(call, names[B], -between(call, 0.05, 0.2));
    argument(call, names[DUCTILITY], between(call, 0.05, 2));
    argument(call, names[C], -between(call, 0.4, 0.9));
}

static bool draw_smith_watson_topper(probe *call)
{
    static const char *const NAMES[] = {"swt", "E", "sf", "b", "ef", "c"};
    const double *v = call->value;
    draw_curve(call, NAMES, 1000, 150e3);
    call->result[0] = rwedge_smith_watson_topper_life(v[VALUE], v[MODULUS], v[STRENGTH], v[B],
                                                      v[DUCTILITY], v[C], 0);
    return isnan(call->result[0]) || (call->result[0] > 1e-20 && call->result[0] < 1e40);
}

static bool draw_fatemi_socie(probe *call)
{
    static const char *const NAMES[] = {"fatemi_socie", "G", "tf", "b", "gf", "c"};
    const double *v = call->value;
    draw_curve(call, NAMES, 600, 60e3);
    call->result[0] =
        rwedge_fatemi_socie_life(v[VALUE], v[MODULUS], v[STRENGTH], v[B], v[DUCTILITY], v[C], 0);
    return isnan(call->result[0]) || (call->result[0] > 1e-20 && call->result[0] < 1e40);
}

/* factor (2N)^exponent; adds it to sum[0], and its slope to sum[1]. */
static void add_power(arb_ptr sum, arb_t factor, arb_t exponent, double life, slong prec)
{
    arb_t power;
    arb_init(power);
    arb_set_d(power, life);
    arb_mul_2exp_si(power, power, 1);
    arb_pow(power, power, exponent, prec);
    arb_mul(power, power, factor, prec);
    arb_add(sum, sum, power, prec);
    arb_addmul(sum + 1, power, exponent, prec);
    arb_clear(power);
}

/* (sum - value)/slope, the relative error of the life to first order. */
static void judge_sum(arb_t error, arb_ptr sum, double value, slong prec)
{
    arb_t wanted;
    arb_init(wanted);
    arb_set_d(wanted, value);
    arb_sub(wanted, sum, wanted, prec);
    arb_div(error, wanted, sum + 1, prec);
    arb_abs(error, error);
    arb_clear(wanted);
}

static void judge(arb_t error, const probe *call, bool is_energy, slong prec)
{
    arb_ptr t = _arb_vec_init(7);
    for (int i = MODULUS; i <= C; i++)
        arb_set_d(t + i, call->value[i]);
    arb_ptr sum = _arb_vec_init(2);
    if (is_energy)
        arb_mul(t + DUCTILITY, t + DUCTILITY, t + STRENGTH, prec);
    arb_div(t + 6, t + STRENGTH, t + MODULUS, prec);
    if (is_energy) {
        arb_mul(t + 6, t + 6, t + STRENGTH, prec);
        arb_add(t + C, t + C, t + B, prec);
        arb_mul_2exp_si(t + B, t + B, 1);
    }
    add_power(sum, t + 6, t + B, call->result[0], prec);
    add_power(sum, t + DUCTILITY, t + C, call->result[0], prec);
    judge_sum(error, sum, call->value[VALUE], prec);
    _arb_vec_clear(sum, 2);
    _arb_vec_clear(t, 7);
}

static void judge_smith_watson_topper(arb_t error, const probe *call, slong prec)
{
    judge(error, call, true, prec);
}

static void judge_fatemi_socie(arb_t error, const probe *call, slong prec)
{
    judge(error, call, false, prec);
}

#define METALS "constants of metals, no limit"

const row LIFE_ROWS[] = {
    {"smith_watson_topper_life", METALS, "relative", 1e-11, "1e-11", 1, draw_smith_watson_topper,
     judge_smith_watson_topper},
    {"fatemi_socie_life", METALS, "relative", 1e-11, "1e-11", 1, draw_fatemi_socie,
     judge_fatemi_socie},
    {0},
};
