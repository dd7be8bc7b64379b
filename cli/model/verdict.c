/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "verdict.h"

#include "text/list.h"

#include <stdio.h>

#include <rwedge.h>

/* NAN, of an empty cell, is in no order. */
static const char *yields(double factor, double safety)
{
    if (factor < 1)
        return "YIELDS: the stress under these loads is above the yield stress.";
    if (safety < 1 && isnan(factor))
        return "YIELDS: P is above the load at first yield.";
    return "";
}

verdict verdict_of(const results *answer)
{
    const double factor = answer->value[RESULT_YIELD_FACTOR].number;
    const double safety = answer->value[RESULT_SAFETY].number;
    const bool strong = answer->value[RESULT_LOAD_OVER_BK].text == NULL; /* k is given */
    verdict result = {.colour = "red"};
    snprintf(result.text, sizeof result.text, "%s", yields(factor, safety));
    if (result.text[0] == '\0')
        result.colour = answer->warnings[0] != '\0' || !strong ? "amber" : "green";
    if (answer->warnings[0] != '\0')
        list_add(result.text, sizeof result.text, " ", "CAUTION: %s%s", answer->warnings,
                 safety < 1 && factor >= 1 ? "; under these loads it does not yield" : "");
    else if (!strong)
        list_add(result.text, sizeof result.text, " ",
                 "CAUTION: no yield stress is given, so there is no safety");
    if (result.text[0] == '\0')
        snprintf(result.text, sizeof result.text, "OK");
    return result;
}

verdict verdict_of_fault(int32_t status, const char *complaint)
{
    verdict result = {.colour = "red"};
    const char *why = status == RWEDGE_ESLIDING ? "SLIDES: Q is above f P, there is no equilibrium."
                      : status == RWEDGE_EPATH  ? "NO CLOSED FORM:"
                                                : "CHECK THE INPUTS:";
    snprintf(result.text, sizeof result.text, "%s %s", why, complaint);
    return result;
}
