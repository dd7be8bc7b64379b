/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef CLI_LOOP_H
#define CLI_LOOP_H

#include "history/history.h"

/* ---- log_fit ---- Friction, compliance and offset from Q over the displacement. */

enum { LOOP_F, LOOP_COMPLIANCE, LOOP_OFFSET, LOOP_PARTS };

/* As rwedge_contact_loop_fit() tells it: NAN what the loop does not tell. */
typedef struct {
    double value[LOOP_PARTS], uncertainty[LOOP_PARTS];
    double noise; /* the root of the mean square of what is left of Q */
    int regime;
    double *Q; /* fitted, of each row; to be freed */
} log_fit;

/* Fits the rows, which have what was measured: loads that are not driven, with their displacement.
 * False, with the complaint. */
bool log_fit_find(const rwedge_contact *contact, size_t count, const load row[], log_fit *fit,
                  complaint *why);

/* ---- loop_area ---- The energy of a loop. */

/* The area that Q encloses over the displacement between two rows, and its standard deviation under
 * a noise of Q. */
double loop_area(const load row[], size_t from, size_t to);
double loop_area_noise(const load row[], size_t from, size_t to, double noise);

/* Whether the cycles of the rows dissipate, but for noise. False, with the complaint, where Q has
 * the sign of the other body, or stands in the place of the displacement. */
bool loop_dissipates(size_t count, const load row[], complaint *why);

#endif
