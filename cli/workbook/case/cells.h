/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The cells of a case: inputs, working cells, results. Each is written once, here, with the names
 * that it has in the calculator. A row of the sheet Batch has the same formulas, with the cells of
 * the row instead of the names. */
#ifndef CLI_CELLS_H
#define CLI_CELLS_H

#include "sheet/xlsx.h"

#include <stddef.h>

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
    RESULTS_END,
    /* working cells */
    WORK_ANY = RESULTS_END,
    WORK_BAD,
    WORK_OK,
    WORK_THETA,
    WORK_ROUNDING,
    WORK_E2,
    WORK_NU2,
    WORK_COMPLIANCE,
    WORK_LOAD,
    WORK_F,
    WORK_Q,
    WORK_SLIDES,
    WORK_HAS_K,
    WORK_K,
    WORK_X, /* the contact */
    WORK_X1,
    WORK_N0,
    WORK_N5 = WORK_N0 + 5,
    WORK_COS,
    WORK_RATIO,
    WORK_B,
    WORK_STICK_LOAD, /* its stick zone */
    WORK_XC,
    WORK_XC1,
    WORK_C0,
    WORK_C5 = WORK_C0 + 5,
    WORK_COS_C,
    WORK_C,
    WORK_ROOT_C,
    WORK_G,
    WORK_NU_TABLE, /* the patch of the table */
    WORK_F_TABLE,
    WORK_NU_NODE,
    WORK_F_NODE,
    WORK_M,
    WORK_WEIGHT_NU,
    WORK_WEIGHT_F = WORK_WEIGHT_NU + 3,
    WORK_COLUMN = WORK_WEIGHT_F + 3,
    WORK_T, /* the limit at this a/b */
    WORK_TIP_NODE,
    WORK_U,
    WORK_WEIGHT_T,
    WORK_SURFACE = WORK_WEIGHT_T + 3,
    WORK_BELOW,
    WORK_LIMIT,
    WORK_OK_F,
    WORK_OK_TIP,
    WORK_STRENGTH, /* the load at yield, on the surface and below it */
    WORK_YIELD_S,
    WORK_YIELD_B = WORK_YIELD_S + 9,
    WORK_YIELD = WORK_YIELD_B + 9,
    WORK_BOUND,
    WORK_YIELD_T, /* the place of first yield */
    WORK_PLACE_U,
    WORK_PLACE_NODE,
    WORK_WEIGHT_PLACE,
    WORK_PLACE_ROW = WORK_WEIGHT_PLACE + 3,
    WORK_PLACE_UNIT,
    WORK_GAPS, /* critical friction */
    WORK_GAP_NODE,
    WORK_GAP_1,
    WORK_GAP_2,
    CELL_COUNT
};

/* The cells of a branch's yield, from WORK_YIELD_S and WORK_YIELD_B on. */
enum { YIELD_REACHED, YIELD_NODE, YIELD_K, YIELD_G = YIELD_K + 3, YIELD_D, YIELD_U, YIELD_LOAD };

typedef struct {
    const char *name;   /* in the calculator */
    const char *column; /* in Batch, as in "solve"; of a working cell NULL */
    const char *what, *unit;
    const char *formula; /* of an input NULL */
    xlsx_style style;
} case_cell;

extern const case_cell case_cells[CELL_COUNT];

/* What inputs and results show; NAN is an empty text. Working cells show nothing: they have no
 * value before a spreadsheet computes. */
typedef struct {
    double number[RESULTS_END];
    char branch[12]; /* the text of CELL_BRANCH */
} case_values;

/* What an input must be, for the message and for the check of what is typed. */
typedef struct {
    const char *wrong; /* the condition that it is not */
    const char *must;  /* the words for it */
    const char *hint;
} input_rule;
extern const input_rule input_rules[INPUT_CELLS];

/* For the charts: P/(bk) at the node rwt_i of a/b, for the f and nu1 of the case; and at the node
 * rwt_i of f, for its a/b and nu1. */
extern const char limit_at_tip[], limit_at_friction[];

#endif
