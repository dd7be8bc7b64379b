/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What "rwedge solve" answers about one contact. */
#ifndef CLI_RESULTS_H
#define CLI_RESULTS_H

#include "model/doubts.h"
#include "number/cell.h"

enum {
    RESULT_A,
    RESULT_BETA,
    RESULT_ROUNDING,
    RESULT_RADIUS,
    RESULT_B,
    RESULT_A_OVER_B,
    RESULT_AP_OVER_THETA_B,
    RESULT_P0,
    RESULT_P_TRANSITION,
    RESULT_Q_OVER_FP,
    RESULT_C,
    RESULT_C_OVER_B,
    RESULT_LEFT, /* up to the tilt, where there is moment or tension */
    RESULT_RIGHT,
    RESULT_STICK_LEFT,
    RESULT_STICK_RIGHT,
    RESULT_TILT,
    RESULT_TENSION,
    RESULT_TENSION_SLIDING,
    RESULT_VON_MISES_SLIDING,
    RESULT_F_CRITICAL,
    RESULT_LOAD_OVER_BK,
    RESULT_P_OVER_BK,
    RESULT_P_YIELD,
    RESULT_SAFETY,
    RESULT_YIELD_X,
    RESULT_YIELD_Y,
    RESULT_YIELD_BRANCH,
    RESULT_YIELD_FACTOR, /* of the present state: only where it is asked for, as it takes longest */
    RESULT_WARNINGS,
    RESULT_COUNT
};

extern const column_kind result_kinds[RESULT_COUNT];

/* Which results that not everybody asks for are wanted. */
typedef struct {
    bool yield_factor; /* takes longest */
    bool edges;        /* with the tilt */
} results_wanted;
bool results_include(results_wanted wanted, int result);

/* One contact's results; the warnings' text is kept in them, and which of them
 * are doubts of the contact. */
typedef struct {
    cell value[RESULT_COUNT];
    double hardest_x, hardest_y; /* the place of the yield factor, where that is known */
    char warnings[512], bound[32];
    doubts doubts;
} results;

/* False, with the complaint, where one cannot be computed. */
bool results_compute(const contact_case *setup, results_wanted wanted, results *answer,
                     char complaint[COMPLAINT_SIZE]);

/* Adds to the warnings. */
void results_warn(results *answer, const char *warning);

#endif
