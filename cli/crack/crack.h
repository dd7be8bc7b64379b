/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef CLI_CRACK_H
#define CLI_CRACK_H

#include "fretting/fretting.h"

/* ---- crack_options ---- The crack, its lengths, and the constants of its growth. */

enum {
    OPTION_EDGE = OPTION_AFTER_CRITERIA,
    OPTION_ANGLE,
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

/* The constants in the unit of the lengths; NAN where not given. */
typedef struct {
    double dK_th, ds0, C, m, K_c;
} crack_law;

/* How K_II counts: RWEDGE_FACES_MODE_I and so on. */
enum { SHEARS = 3 };
extern const char *const shear_names[SHEARS];

/* The growth from one length to another. */
typedef struct {
    double end, cycles, least, least_at; /* as rwedge_cycle_growth() has them */
    double first;                        /* dK over the threshold at the first length */
    int32_t status;
} crack_growth;

typedef struct {
    const last_cycle *last;
    double x;
    bool has_angles; /* --angle-range: each row names its angle */
    range angles;    /* in degrees */
    double *length;
    size_t lengths;
    bool is_wanted[SHEARS];
    const char *unit; /* of length, for sentences */
    crack_law law;
    int threads;
    crack_growth
        *growth; /* of the angle i and the shear k at [SHEARS i + k]; NULL without verdict */
} crack_plan;

/* Reads the constants, those of a material too; a mistake ends the command. */
void crack_law_read(const arguments *line, const material *constants, crack_law *law);

/* Reads the crack. To be called when the cycle is there, because it has the edges. */
void crack_read(const arguments *line, const last_cycle *last, crack_plan *plan);

bool crack_has_threshold(const crack_plan *plan);
double crack_threshold(const crack_plan *plan, double length); /* NAN without */
bool crack_has_rate(const crack_plan *plan);

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

/* The growth of faces that press, or that pass through each other. */
crack_growth crack_growth_of(const crack_plan *plan, double degrees, bool presses, int shear,
                             double from, double to);

/* K of an angle after each load for each length; of loads times lengths numbers each, to be freed
 * at I. share is of the line where faces overlap, or touch where they press. */
typedef struct {
    double *I, *II, *share;
} crack_K;

crack_K crack_K_of(const crack_plan *plan, double degrees, bool presses);

/* What the cycle changes of K at each length, to be freed at I: of the shear k and the length j at
 * [lengths k + j]. */
typedef struct {
    double *I, *II, *K_max, *R;
} crack_ranges;

/* By K of faces that pass through each other; NULL where faces press. */
crack_ranges crack_ranges_of(const crack_plan *plan, double degrees, const crack_K *K);

#endif
