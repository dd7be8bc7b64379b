/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Loops of which friction, compliance and offset are known: a cylinder under a constant P, by
 * Mindlin and Masing, with noise of a known size in Q. */
#include "histories.h"

static const double F = 0.5, R = 100, P = 1, COMPLIANCE = 0.3, OFFSET = 0.02;
enum { FRICTION, OF_RIG, OF_WAY, PARTS, HALF = 30, ROWS = 8 * HALF + HALF / 2 };

typedef struct {
    double P[ROWS], zero[ROWS], displacement[ROWS], Q[ROWS];
} measured;

typedef struct {
    double value[PARTS], uncertainty[PARTS], told[PARTS], regime, Q[ROWS];
} loop_fit;

/* The first loading to Q. */
static double mindlin(double Q)
{
    const double limit = F * P, rest = 1 - Q / limit;
    return A / (2 * PI) * (rest > 0 ? limit * rest * log(rest) + Q : Q) + COMPLIANCE * Q;
}

/* The sum of twelve is nearly normal, of the standard deviation 1. */
static double normal(uint64_t *seed)
{
    double sum = -6;
    for (int i = 0; i < 12; i++)
        sum += random_fraction(seed);
    return sum;
}

/* A half of the loop, from one end to the other in HALF rows: the first loading, twice as large;
 * in the last third the bodies slide. The first half begins in the middle, without shear. */
static void add_half(measured *log, int half, double peak, double slid, double start)
{
    const bool is_first = half == 0;
    const double sign = half % 2 == 0 ? 1 : -1, from = is_first ? 0 : -sign * peak,
                 times = is_first ? 1 : 2;
    const int rows = is_first ? HALF / 2 : HALF, before = is_first ? 0 : half * HALF - HALF / 2;
    for (int k = is_first ? 0 : 1; k <= rows && before + k < ROWS; k++) {
        const double part = (double)k / rows, turned = fmin(1, 1.5 * part);
        const double changed = (sign * peak - from) * (1 - cos(PI * turned)) / 2;
        log->P[before + k] = P;
        log->Q[before + k] = from + changed;
        log->displacement[before + k] =
            start + sign * (times * mindlin(fabs(changed) / times) + slid * fmax(0, 3 * part - 2));
    }
}

/* Q to and fro between parts of f P. */
static measured make_loop(double share, double slid, double noise)
{
    measured log = {.P = {0}};
    const double peak = share * F * P;
    uint64_t seed = 5;
    for (int half = 0; half <= 8; half++)
        add_half(&log, half, peak, slid,
                 half == 0 ? OFFSET : log.displacement[half * HALF - HALF / 2]);
    for (int i = 0; i < ROWS; i++)
        log.Q[i] += noise * peak * normal(&seed);
    return log;
}

static int32_t try_fit(const measured *log, size_t first, size_t n, loop_fit *fit)
{
    return rwedge_contact_loop_fit(create_flat(0, R, A, 0), n, log->P + first, log->zero, log->zero,
                                   log->displacement + first, log->Q + first, fit->value,
                                   fit->uncertainty, fit->told, &fit->regime, fit->Q);
}

static loop_fit fit_of(const measured *log, size_t first, size_t n)
{
    loop_fit fit = {.regime = -1};
    assert_ok(try_fit(log, first, n, &fit));
    return fit;
}

/* To four standard deviations. */
static void assert_known(const loop_fit *fit, int part, double expected)
{
    assert_true(fit->told[part] == 1);
    assert_true(fit->uncertainty[part] > 0);
    assert_true(fabs(fit->value[part] - expected) < 4 * fit->uncertainty[part]);
}

CLAIM(a_loop_of_partial_slip_tells_friction_compliance_and_offset)
{
    static const double noise[] = {0.001, 0.005, 0.01};
    for (int i = 0; i < 3; i++) {
        const measured log = make_loop(0.9, 0, noise[i]);
        const loop_fit fit = fit_of(&log, 0, ROWS);
        assert_close(fit.value[FRICTION], F, fmax(0.01, 2 * noise[i]));
        assert_known(&fit, FRICTION, F);
        assert_known(&fit, OF_RIG, COMPLIANCE);
        assert_known(&fit, OF_WAY, OFFSET);
        assert_true(fit.regime == RWEDGE_LOOP_PARTIAL_SLIP);
    }
}

CLAIM(a_loop_without_noise_is_met)
{
    const measured log = make_loop(0.9, 0, 0);
    const loop_fit fit = fit_of(&log, 0, ROWS);
    assert_close(fit.value[FRICTION], F, 1e-7);
    assert_close(fit.value[OF_RIG], COMPLIANCE, 1e-7);
    assert_close(fit.value[OF_WAY], OFFSET, 1e-6);
    for (int i = 0; i < ROWS; i++)
        assert_within(fit.Q[i], log.Q[i], 1e-7 * F * P);
}

/* A fit as of steady cycles has the better beginning here, and the worse end. */
CLAIM(the_beginning_of_a_short_log_is_told)
{
    enum { N = 11 };
    static const double way[N] = {1, 2, 3.2, 1, -1, -3, -1, 1, 3, 2, -2};
    measured log = {.P = {0}};
    loop_fit fit;
    rwedge_contact *wedge = create_wedge(0.01, 0.5, 0.018, 0.6), *driven = copy_of(wedge);
    load(driven, 2, 0);
    for (int i = 0; i < N; i++) {
        log.P[i] = 2;
        log.displacement[i] = 1e-3 * way[i];
        assert_ok(rwedge_contact_drive(driven, 2, 0, 0, log.displacement[i], 0.001, &log.Q[i]));
    }
    assert_ok(rwedge_contact_loop_fit(wedge, N, log.P, log.zero, log.zero, log.displacement, log.Q,
                                      fit.value, fit.uncertainty, fit.told, &fit.regime, fit.Q));
    assert_close(fit.value[FRICTION], 0.6, 1e-6);
    assert_close(fit.value[OF_RIG], 0.001, 1e-6);
}

CLAIM(a_loop_of_gross_slip_tells_friction_ten_times_better)
{
    const measured log = make_loop(1, 0.1, 0.005);
    const loop_fit fit = fit_of(&log, 0, ROWS);
    assert_close(fit.value[FRICTION], F, 1e-3);
    assert_known(&fit, FRICTION, F);
    assert_known(&fit, OF_RIG, COMPLIANCE);
    assert_known(&fit, OF_WAY, OFFSET);
    assert_true(fit.regime == RWEDGE_LOOP_GROSS_SLIP);
}

/* In steady gross slip the offset is anywhere: it is not told. */
CLAIM(a_log_may_begin_in_steady_cycles)
{
    const measured partial = make_loop(0.9, 0, 0.001), gross = make_loop(1, 0.1, 0.005);
    const size_t first = HALF, n = 6 * HALF; /* whole cycles, from within a half on */
    const loop_fit of_partial = fit_of(&partial, first, n), of_gross = fit_of(&gross, first, n);
    assert_known(&of_partial, FRICTION, F);
    assert_known(&of_partial, OF_WAY, OFFSET);
    assert_close(of_gross.value[FRICTION], F, 1e-3);
    assert_known(&of_gross, OF_RIG, COMPLIANCE);
    assert_true(of_gross.told[OF_WAY] == 0);
}

CLAIM(a_line_tells_no_friction)
{
    const measured log = make_loop(0.005, 0, 0.05);
    const loop_fit fit = fit_of(&log, 0, ROWS);
    assert_true(fit.regime == RWEDGE_LOOP_STICK);
    assert_true(fit.told[FRICTION] == 0 && fit.value[FRICTION] == 0 &&
                fit.uncertainty[FRICTION] == 0);
    assert_known(&fit, OF_RIG, COMPLIANCE);
}

CLAIM(what_is_no_loop_is_refused)
{
    measured log = make_loop(0.9, 0, 0);
    loop_fit fit = {.regime = -1};
    assert_int_equal(try_fit(&log, 0, 7, &fit), RWEDGE_ERANGE);
    log.zero[3] = NAN;
    assert_int_equal(try_fit(&log, 0, ROWS, &fit), RWEDGE_EDOMAIN);
    log.zero[3] = 0;
    log.P[5] = -1;
    assert_int_equal(try_fit(&log, 0, ROWS, &fit), RWEDGE_EDOMAIN);
    log.P[5] = P;
    for (int i = 0; i < ROWS; i++)
        log.displacement[i] = 1;
    assert_int_equal(try_fit(&log, 0, ROWS, &fit), RWEDGE_EABSENT);
    for (int i = 0; i < ROWS; i++) { /* a rig softer than any number */
        log.displacement[i] = 1e50 * sin(i);
        log.Q[i] = 1e-50 * sin(i);
    }
    assert_int_equal(try_fit(&log, 0, ROWS, &fit), RWEDGE_ENOCONV);
    assert_true(fit.regime == -1);
}
