/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "results.h"

#include <stdio.h>

/* ---- Strength ---- */

/* A design needs so many digits. */
enum { DIGITS = 4 };

typedef struct {
    verdict *to;
    char decimal_sign;
    const char *length_unit;
} writer;

static const char *write(const writer *w, double value, char text[NUMBER_SIZE])
{
    number_write(value, DIGITS, w->decimal_sign, text);
    return text;
}

static void add_place(const writer *w, double x, double y)
{
    char x_text[NUMBER_SIZE], y_text[NUMBER_SIZE];
    list_add(w->to->strength, sizeof w->to->strength, "", " at x = %s, y = %s%s%s, %s the surface.",
             write(w, x, x_text), write(w, y, y_text), w->length_unit[0] != '\0' ? " " : "",
             w->length_unit,
             y > 0   ? "below"
             : y < 0 ? "in the pad, above"
                     : "at");
}

static int body_of(const results *answer)
{
    return answer->is_of_body2 ? 2 : 1;
}

static void add_present(const writer *w, const results *answer, double factor)
{
    char text[NUMBER_SIZE], other[NUMBER_SIZE];
    const double sliding = results_sliding_factor(answer);
    if (!(factor > 0)) {
        list_add(w->to->strength, sizeof w->to->strength, "",
                 "It yields: the stress at a sharp apex has no bound.");
        return;
    }
    list_add(w->to->strength, sizeof w->to->strength, "",
             factor < 1 ? "It yields: the stress is %s times what body %d bears"
                        : "Elastic with a factor of %s on the stress",
             write(w, factor < 1 ? 1 / factor : factor, text), body_of(answer));
    if (factor >= 1 && sliding >= 1)
        list_add(w->to->strength, sizeof w->to->strength, "", ", of %s if it slid",
                 write(w, sliding, other));
    list_add(w->to->strength, sizeof w->to->strength, "", factor < 1 ? "," : "; it yields first");
    add_place(w, answer->hardest_x, answer->hardest_y);
    if (sliding < 1)
        list_add(w->to->strength, sizeof w->to->strength, " ",
                 "If it slid, %s: the stress would be %s times what body %d bears.",
                 factor < 1 ? "more so" : "it would yield", write(w, 1 / sliding, other),
                 body_of(answer));
}

/* Adds the factor on the stress, where the present one is not known, and that on P, with which the
 * contact grows. */
static void add_sliding(const writer *w, const results *answer, bool alone)
{
    char text[NUMBER_SIZE];
    const cell safety = answer->value[RESULT_SAFETY];
    const double sliding = results_sliding_factor(answer);
    const bool has_place = answer->value[RESULT_YIELD_X].text == NULL;
    if (safety.text != NULL || isnan(safety.number)) /* none, or a bound that nothing reaches */
        return;
    if (alone && !isnan(sliding))
        list_add(w->to->strength, sizeof w->to->strength, " ",
                 sliding < 1 ? "If it slid, it would yield: the stress would be %s times what body "
                               "%d bears."
                             : "If it slid, it would be elastic with a factor of %s on the stress.",
                 write(w, sliding < 1 ? 1 / sliding : sliding, text), body_of(answer));
    list_add(w->to->strength, sizeof w->to->strength, " ",
             "The factor on P, in full sliding, is %s%s", write(w, safety.number, text),
             alone && has_place ? "; it yields first" : ".");
    if (alone && has_place)
        add_place(w, answer->value[RESULT_YIELD_X].number, answer->value[RESULT_YIELD_Y].number);
}

/* What repeated sliding passes do, beyond first yield. */
static void add_passes(const writer *w, const results *answer)
{
    char text[NUMBER_SIZE];
    const double passes = answer->value[RESULT_SAFETY_SHAKEDOWN].number;
    if (answer->value[RESULT_SAFETY_SHAKEDOWN].text != NULL)
        return;
    list_add(w->to->strength, sizeof w->to->strength, " ",
             passes < 1 ? "Sliding again and again, it would go on yielding: the factor on P is %s."
             : answer->value[RESULT_SAFETY].number < 1
                 ? "Sliding again and again, it yields at first, then carries it elastically up to "
                   "%s times P."
                 : "Sliding again and again, it would carry up to %s times P: elastically, once it "
                   "has yielded at first.",
             write(w, passes, text));
}

/* ---- The whole ---- */

/* NAN, of an empty cell, is in no order. */
static const char *yields(double factor, double safety)
{
    if (factor < 1)
        return "YIELDS: the stress under these loads is above the yield stress.";
    if (safety < 1 && isnan(factor))
        return "YIELDS: P is above the load at first yield in full sliding.";
    return "";
}

/* Without a doubt the only warning may be that it is computed, and how exactly. */
static void add_note(const results *answer, bool strong, verdict *result)
{
    if (!strong)
        list_add(result->text, sizeof result->text, " ",
                 "CAUTION: no yield stress is given, so there is no safety");
    if (result->text[0] == '\0')
        snprintf(result->text, sizeof result->text, "OK");
    if (answer->warnings[0] != '\0')
        list_add(result->text, sizeof result->text, "; ", "%s", answer->warnings);
}

verdict verdict_of(const results *answer, char decimal_sign, const char *length_unit)
{
    verdict result = {.colour = "red"};
    const double factor = answer->value[RESULT_YIELD_FACTOR].number;
    const double safety = answer->value[RESULT_SAFETY].number;
    const bool strong = answer->value[RESULT_LOAD_OVER_BK].text == NULL; /* k is given */
    const writer w = {&result, decimal_sign, length_unit};
    result.factor = isnan(factor) ? safety : factor;
    if (strong && answer->is_of_body2)
        list_add(result.strength, sizeof result.strength, "", "The strength of body 2, the pad. ");
    if (!isnan(factor))
        add_present(&w, answer, factor);
    if (strong) {
        add_sliding(&w, answer, isnan(factor));
        add_passes(&w, answer);
    } else
        list_add(result.strength, sizeof result.strength, "",
                 "No yield stress is given, so nothing is known of its strength.");
    snprintf(result.text, sizeof result.text, "%s", yields(factor, safety));
    if (result.text[0] == '\0')
        result.colour = answer->is_doubtful || !strong ? "amber" : "green";
    if (answer->is_doubtful)
        list_add(result.text, sizeof result.text, " ", "CAUTION: %s%s", answer->warnings,
                 safety < 1 && factor >= 1 ? "; under these loads it does not yield" : "");
    else
        add_note(answer, strong, &result);
    return result;
}

verdict verdict_of_fault(int32_t status, const char *fault)
{
    verdict result = {.colour = "red", .factor = NAN};
    const char *why = status == RWEDGE_ESLIDING ? "SLIDES: Q is above f P, there is no equilibrium."
                      : status == RWEDGE_EPATH  ? "NO CLOSED FORM:"
                                                : "CHECK THE INPUTS:";
    snprintf(result.text, sizeof result.text, "%s %s", why, fault);
    return result;
}
