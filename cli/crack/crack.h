/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef CLI_CRACK_H
#define CLI_CRACK_H

#include "fretting/fretting.h"
#include "model/cracks/cracks.h"

/* ---- crack_options ---- The crack, its lengths, and the constants of its growth. */

enum {
    OPTION_EDGE = OPTION_AFTER_SERIES, /* the angle is that of the critical distances */
    OPTION_ANGLE_RANGE,
    OPTION_LENGTHS,
    OPTION_FROM,
    OPTION_TO,
    OPTION_DK_TH,
    OPTION_DS0,
    OPTION_PARIS_C,
    OPTION_PARIS_M,
    OPTION_K_C,
    OPTION_SHEAR,
    OPTION_AFTER_CRACK
};

extern struct poptOption crack_option_table[];

typedef struct {
    crack_case crack;
    bool has_angles; /* --angle-range: each row names its angle */
    range angles;    /* in degrees */
    int threads;
    crack_growth
        *growth; /* of the angle i and the shear k at [SHEARS i + k]; NULL without verdict */
} crack_plan;

/* Reads the constants, those of a material too; a mistake ends the command. */
void crack_law_read(const arguments *line, const material *constants, crack_law *law);

/* Reads the crack. To be called when the cycle is there, because it has the edges. */
void crack_read(const arguments *line, const last_cycle *last, crack_plan *plan);

/* ---- crack_rows ---- What a cycle does to the crack at each length. */

extern const column_kind crack_columns[];
extern const int crack_column_count;

/* Writers of the rows of a crack_plan: ranges, and K after each load. */
void crack_rows_write(void *of_plan, records *rows);
void crack_loads_write(void *of_plan, records *rows);

/* ---- crack_verdict ---- Whether the crack stops, in a row and a sentence for each way in which
 * K_II counts. */

extern const column_kind verdict_columns[];
extern const int verdict_column_count;

void crack_verdict_write(void *of_plan, records *rows);

/* Says on standard error, once they are written, what they come to: a sentence for each angle, and
 * which is the worst. */
void crack_verdict_say(const crack_plan *plan);

/* Says on standard error what of the model is doubtful for this crack. */
void crack_doubts_say(const crack_plan *plan);

#endif
