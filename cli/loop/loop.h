/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef CLI_LOOP_H
#define CLI_LOOP_H

#include "rows/rows.h"
#include "setup/setup.h"

/* ---- loop_fit ---- Friction, compliance and offset from Q over the displacement. */

enum { LOOP_F, LOOP_COMPLIANCE, LOOP_OFFSET, LOOP_PARTS };

typedef enum { LOOP_STICKS, LOOP_PARTIAL, LOOP_GROSS } loop_regime;

/* Of each part its value, and the standard deviation that the noise of Q gives it: NAN where the
 * loop does not tell it. */
typedef struct {
    double value[LOOP_PARTS], uncertainty[LOOP_PARTS];
    double noise; /* the root of the mean square of what is left of Q */
    loop_regime regime;
    double *Q; /* fitted, of each row; to be freed */
} loop_fit;

/* Fits the rows, which have what was measured: loads that are not driven, with their displacement.
 * The friction of the case counts for nothing. False, with the complaint. */
bool loop_fit_find(const contact_case *setup, size_t count, const load row[], loop_fit *fit,
                   complaint *why);

/* ---- loop_cycles ---- The cycles of a log, by its displacement. */

/* Where cycles begin: the displacement rises through the middle of its range. The last is where the
 * last whole one ends. To be freed. */
typedef struct {
    size_t *at;
    size_t count; /* one more than the whole cycles, or 0 */
} loop_cycles;

loop_cycles loop_cycles_find(size_t count, const load row[]);

/* The area that Q encloses over the displacement between two rows, and its standard deviation under
 * a noise of Q. */
double loop_area(const load row[], size_t from, size_t to);
double loop_area_noise(const load row[], size_t from, size_t to, double noise);

#endif
