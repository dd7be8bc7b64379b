/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "results.h"

#include <math.h>
#include <string.h>

const char inverse_names[] = "radius, a, P, f";

int inverse_input(const char *name)
{
    static const int inputs[] = {INPUT_RADIUS, INPUT_A, INPUT_P, INPUT_F};
    for (size_t i = 0; i < sizeof inputs / sizeof inputs[0]; i++)
        if (strcmp(name, input_kinds[inputs[i]].option) == 0)
            return inputs[i];
    return INPUT_COUNT;
}

static bool refuse(const char *reason, complaint *why)
{
    return complain(why, "no solution: %s", reason);
}

static double yield_load(const contact_case *setup, double f)
{
    return rwedge_yield_load(setup->shape.theta, setup->shape.a, setup->A, f, setup->nu1, setup->k);
}

/* ---- Friction ---- */

static const double FRICTION_MOST = 1e6; /* its domain's end */

/* P_yield falls as f grows. Halving ends 1e-21 wide. */
static bool find_friction(const contact_case *setup, double safety, double *value, complaint *why)
{
    const double most = yield_load(setup, 0), least = yield_load(setup, FRICTION_MOST);
    const double P_yield = safety * setup->P;
    double hi = FRICTION_MOST;
    if (!(most >= P_yield && least <= P_yield))
        return complain(why, "no solution: %s friction the safety is %.4g",
                        most < P_yield ? "even without" : "even with the most",
                        (most < P_yield ? most : least) / setup->P);
    *value = 0;
    for (int i = 0; i < 90; i++) {
        const double middle = 0.5 * (*value + hi);
        *(yield_load(setup, middle) >= P_yield ? value : &hi) = middle;
    }
    return true;
}

/* ---- Sizes and load ---- */

/* At first yield a/b is the same for wedges of one angle, so P_yield is proportional to a; and P
 * does not enter it. */
static bool find_in_proportion(const contact_case *setup, int input, double safety, double *value,
                               complaint *why)
{
    const double P_yield = yield_load(setup, setup->f);
    if (!(P_yield > 0) || isinf(P_yield))
        return refuse("no load yields, as far as is looked", why);
    if (input == INPUT_P)
        *value = P_yield / safety;
    else {
        const double a = setup->shape.a * (safety * setup->P / P_yield);
        *value = input == INPUT_A ? a : rwedge_radius(setup->shape.theta, a);
    }
    return true;
}

/* ---- Together ---- */

/* The rest of the case, with 1 for what is looked for, and without Q: that is judged with the
 * answer. */
static bool read_rest(const input_texts *texts, int input, contact_case *setup, complaint *why)
{
    static const int off_centre[] = {INPUT_M, INPUT_TILT, INPUT_SIGMA};
    input_texts rest = *texts;
    double value;
    for (int i = 0; i < 3; i++)
        if (input_is_given(texts, off_centre[i]) && input_read(texts, off_centre[i], &value, why) &&
            value != 0)
            return refuse("with M, a tilt or sigma there is no safety, only the yield factor", why);
    input_set(&rest, input, 1);
    rest.text[INPUT_Q] = NULL;
    if (!case_read(&rest, CASE_OF_SOLVE, setup, why))
        return false;
    return isnan(setup->k) ? refuse("no yield stress is given", why) : true;
}

bool inverse_find(const input_texts *texts, int input, double safety, contact_case *setup,
                  double *value, complaint *why)
{
    input_texts all = *texts;
    if (!read_rest(texts, input, setup, why))
        return false;
    const bool has_formulas = pad_has_formulas(&setup->shape) && !setup->is_coupled;
    *value = has_formulas ? NAN : sliding_find(setup, input, safety);
    if (!has_formulas && !(*value > 0))
        return refuse("none is found, as far as the pad is known", why);
    if (has_formulas && !(input == INPUT_F ? find_friction(setup, safety, value, why)
                                           : find_in_proportion(setup, input, safety, value, why)))
        return false;
    input_set(&all, input, *value);
    rwedge_contact_destroy(setup->contact);
    return case_read(&all, CASE_OF_SOLVE, setup, why);
}

/* ---- A factor on the stress ---- */

typedef struct {
    const input_texts *texts;
    int input;
    bool slides;
} stress_question;

/* The factor with that value of the input; NAN where the case has none. */
static double stress_factor(const stress_question *asked, double value)
{
    input_texts all = *asked->texts;
    contact_case setup;
    results answer;
    complaint why;
    double factor = NAN;
    input_set(&all, asked->input, value);
    const results_wanted wanted = {.yield_factor = !asked->slides, .edges = true};
    if (case_read(&all, CASE_OF_SOLVE, &setup, &why) && setup.status == RWEDGE_OK &&
        results_compute(&setup, wanted, &answer, &why))
        factor = asked->slides ? results_sliding_factor(&answer)
                               : answer.value[RESULT_YIELD_FACTOR].number;
    rwedge_contact_destroy(setup.contact);
    return factor;
}

/* The value, on a scale of logarithms, where the factor passes what is asked, between two that it
 * lies between. Halving ends at rounding. */
static double halve(const stress_question *asked, double factor, double from, double to)
{
    const bool rises = stress_factor(asked, to) >= factor;
    for (int i = 0; i < 60 && fabs(log(to / from)) > 1e-13; i++) {
        const double middle = sqrt(from) * sqrt(to);
        *((stress_factor(asked, middle) >= factor) == rises ? &to : &from) = middle;
    }
    return to;
}

bool inverse_find_stress(const input_texts *texts, int input, double factor, bool slides,
                         double *value, complaint *why)
{
    enum { DOUBLINGS = 30 };
    const stress_question asked = {texts, input, slides};
    double start = 1;
    if (input_is_given(texts, input) && !input_read(texts, input, &start, why))
        return false;
    if (!(start > 0))
        start = 1;
    const double here = stress_factor(&asked, start);
    double below = start, above = start, at_below = here, at_above = here;
    for (int i = 0; i < DOUBLINGS; i++) {
        const double down = stress_factor(&asked, below / 2), up = stress_factor(&asked, above * 2);
        if ((at_below - factor) * (down - factor) <= 0) {
            *value = halve(&asked, factor, below, below / 2);
            return true;
        }
        if ((at_above - factor) * (up - factor) <= 0) {
            *value = halve(&asked, factor, above, above * 2);
            return true;
        }
        below /= 2;
        above *= 2;
        at_below = down;
        at_above = up;
    }
    return isnan(here) ? refuse("the case as it stands has no such factor", why)
                       : refuse("no value is found that has this factor", why);
}
