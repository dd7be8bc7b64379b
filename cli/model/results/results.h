/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef CLI_RESULTS_H
#define CLI_RESULTS_H

#include "model/model.h"

/* ---- results ---- What "rwedge solve" answers about one contact. */

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
    RESULT_LEFT,
    RESULT_RIGHT,
    RESULT_STICK_LEFT,
    RESULT_STICK_RIGHT,
    RESULT_TILT,
    RESULT_MOMENT, /* of a held pad alone */
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
    RESULT_YIELD_FACTOR, /* of the present state */
    RESULT_WARNINGS,
    RESULT_P0_X,
    RESULT_P_SHAKEDOWN,
    RESULT_SAFETY_SHAKEDOWN,
    RESULT_MU, /* of unlike bodies with friction, as the next */
    RESULT_SWING,
    RESULT_COUNT
};

extern const column_kind result_kinds[RESULT_COUNT];

/* Which results that not everybody asks for are wanted. */
typedef struct {
    bool yield_factor, edges, shakedown, moment, coupling;
} results_wanted;
bool results_include(results_wanted wanted, int result);

/* One contact's results; the warnings' text is kept in them, and which of them
 * are doubts of the contact. */
typedef struct {
    cell value[RESULT_COUNT];
    double hardest_x, hardest_y, hardest_von_mises; /* of results_find_hardest() */
    char warnings[512], bound[32];
    doubts doubts;
    bool is_doubtful; /* the warnings are more than an error up to the tolerance */
    bool is_of_body2; /* its strength, and its places */
} results;

/* False, with the complaint, where one cannot be computed. */
bool results_compute(const contact_case *setup, results_wanted wanted, results *answer,
                     complaint *why);

/* Adds the yield factor, where k is known, and where the stress under the loads is hardest. Returns
 * the library's status. */
int32_t results_find_hardest(const contact_case *setup, results *answer);

/* The factor on the stress in full sliding under this P, as the yield factor is. NAN where it is
 * not known. */
double results_sliding_factor(const results *answer);

/* Adds to the warnings. */
void results_warn(results *answer, const char *warning);

/* ---- other_body ---- The strength of body 2, the pad, whose own k is given. */

/* Body 2 becomes body 1. False, with the complaint, where it has no strength, or what is given has
 * a side or is of body 1. */
bool other_body_take(input_texts *texts, complaint *why);

/* The results of such texts in the axes and the order of the bodies as they were given: places have
 * the other sign, stresses their own. */
void other_body_mirror(results *answer);

/* ---- sliding ---- The strength of a pad in full sliding where it has no formulas: from its
 * contact. */

/* Adds the results for full sliding to those of the present state. Returns the library's status. */
int32_t results_of_sliding(const contact_case *setup, cell row[]);

/* The P with which it just shakes down. NAN where there is none within the known part of the pad,
 * 0 at a kink. */
double sliding_shakedown(const contact_case *setup);

/* The value of P, f or the radius with which first yield, in full sliding, is at `safety` times the
 * load of the case; the case has 1 for this input. NAN where there is none within the known part of
 * the pad. */
double sliding_find(const contact_case *setup, int input, double safety);

/* ---- inverse ---- The input with which a contact has a safety. */

/* The input of a name, "radius"; INPUT_COUNT where it is none that can be looked for. */
int inverse_input(const char *name);

/* The names that inverse_input() accepts, for a message. */
extern const char inverse_names[];

/* Finds the radius, a, P or f with which P_yield/P, in full sliding, is `safety`, and reads the
 * case with it. The texts give the other inputs; their text of this input and of its alternative is
 * ignored. False, with the complaint, where there is no such value. Destroy the contact also
 * then. */
bool inverse_find(const input_texts *texts, int input, double safety, contact_case *setup,
                  double *value, complaint *why);

/* ---- equations ---- The formulas of results, with their symbols and with the numbers put in. */

enum { EQUATIONS_MAX = 16 };

/* name = symbols = numbers = value; the numbers have six digits. */
typedef struct {
    const char *name;
    char symbols[160], numbers[240];
    double value;
    const char *unit; /* the dimension, as that of a column */
} equation;

/* Gives the equations whose right side is a formula of the pad and its loads, and tells how many.
 * What is searched for, as the load at first yield, has none. */
int equations_of(const contact_case *setup, const results *answer, equation to[EQUATIONS_MAX]);

/* Finds the value of the input with which the factor on the stress is that: under the loads as they
 * are, or in full sliding. The nearest one to the present value is taken. False, with the
 * complaint, where there is none. */
bool inverse_find_stress(const input_texts *texts, int input, double factor, bool slides,
                         double *value, complaint *why);

/* ---- assumptions ---- What a report says of a case beside its numbers. */

typedef void remark_teller(void *context, const char *text);

/* What was said of a case, beside its numbers. */
typedef struct {
    bool has_history, has_E2, has_f, fits, takes_hull, has_units, has_width, is_of_body2;
} case_said;

/* What was assumed, a sentence each. */
void assumptions_tell(const contact_case *setup, const case_said *said, remark_teller *tell,
                      void *context);

/* Which errors the numbers have that have these doubts. */
void errors_tell(const contact_case *setup, doubts all, bool lacks_slip, remark_teller *tell,
                 void *context);

/* ---- verdict ---- The verdict: a summary of all results of a contact. */

typedef struct {
    const char *colour; /* green, amber or red */
    char strength[600]; /* sentences: by which factor it is elastic, where it yields, passes */
    double factor;      /* the one that counts, of the first sentence; NAN where there is none */
    char text[1200];    /* its state in a word, and what is doubtful */
} verdict;

/* The verdict goes by the yield factor of the present loads; where that is not computed, by full
 * sliding. Its sentences have the decimal sign, and lengths the unit, or "". */
verdict verdict_of(const results *answer, char decimal_sign, const char *length_unit);

/* The verdict on a contact that the library refuses with this status; RWEDGE_OK means that its
 * inputs are wrong. */
verdict verdict_of_fault(int32_t status, const char *fault);

#endif
