/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef CLI_LOOP_H
#define CLI_LOOP_H

#include "history/history.h"

/* ---- loop_fit ---- Friction, compliance and offset from Q over the displacement. */

enum { LOOP_F, LOOP_COMPLIANCE, LOOP_OFFSET, LOOP_PARTS };

typedef enum { LOOP_STICKS, LOOP_PARTIAL, LOOP_GROSS } loop_regime;

/* The value of each part, and the standard deviation that the noise of Q gives it: NAN where the
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

/* ---- loop_area ---- The energy of a loop. */

/* The area that Q encloses over the displacement between two rows, and its standard deviation under
 * a noise of Q. */
double loop_area(const load row[], size_t from, size_t to);
double loop_area_noise(const load row[], size_t from, size_t to, double noise);

#endif
