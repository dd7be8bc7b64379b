/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The cells of a case: inputs, results, working cells. Each is a line of one table, with the name
 * that it has in the calculator. A row of the sheet Batch has the same formulas, with the cells of
 * the row instead of the names. */
#ifndef CLI_CELLS_H
#define CLI_CELLS_H

#include "sheet/xlsx.h"

enum {
    CELL_E1,
    CELL_NU1,
    CELL_E2,
    CELL_NU2,
    CELL_THETA,
    CELL_THETA_DEG,
    CELL_ROUNDING,
    CELL_RADIUS,
    CELL_LOAD,
    CELL_Q,
    CELL_F,
    CELL_K,
    CELL_YIELD_STRESS,
    INPUT_CELLS,
    /* results, in the order of "solve" */
    CELL_COMPLIANCE = INPUT_CELLS,
    CELL_BETA,
    CELL_B,
    CELL_A_OVER_B,
    CELL_LOAD_NUMBER,
    CELL_P0,
    CELL_P_TRANSITION,
    CELL_P_MEAN,
    CELL_Q_OVER_FP,
    CELL_C,
    CELL_C_OVER_B,
    CELL_TENSION,
    CELL_TENSION_SLIDING,
    CELL_VON_MISES,
    CELL_F_CRITICAL,
    CELL_LOAD_OVER_BK,
    CELL_P_OVER_BK,
    CELL_P_YIELD,
    CELL_SAFETY,
    CELL_SAFETY_STRENGTH,
    CELL_YIELD_X,
    CELL_YIELD_Y,
    CELL_BRANCH,
    CELL_WARNINGS,
    CELL_ERROR,
    RESULTS_END /* working cells follow */
};

/* Formulas call templates: lower-case names with arguments. */
typedef struct {
    const char *name; /* in the calculator */
    const char *label;
    const char *formula; /* of an input NULL */
    const char *column;  /* in Batch, as in "solve"; of a working cell NULL */
    const char *unit;
    xlsx_style style;
} case_cell;

extern const case_cell case_cells[];
extern const int case_cell_count;

/* What a call stands for: $1 to $4 are its arguments, $1{+21} the first with +21 in place of #. A
 * call without a text is written in C. The last has no name. */
typedef struct {
    const char *name, *text;
} formula_template;
extern const formula_template formula_templates[];

/* What inputs and results show; NAN is an empty text. Working cells show nothing: they have no
 * value before a spreadsheet computes. */
typedef struct {
    double number[RESULTS_END];
    char branch[12];                  /* the text of CELL_BRANCH */
    char strength[400], figures[200]; /* of the calculator */
} case_values;

/* What an input must be, for the message and for the check of what is typed. */
typedef struct {
    const char *wrong; /* the condition that it is not */
    const char *must;  /* the words for it */
    const char *hint;
    bool is_needed;
} input_rule;
extern const input_rule input_rules[INPUT_CELLS];

/* For the charts: P/(bk) at the node rwt_i of a/b, for the f and nu1 of the case; and at the node
 * rwt_i of f, for its a/b and nu1. */
extern const char limit_at_tip[], limit_at_friction[];

#endif
