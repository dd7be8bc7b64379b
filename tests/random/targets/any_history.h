/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What the loads of any_history.c have come to so far. */
#ifndef ANY_HISTORY_H
#define ANY_HISTORY_H

typedef struct {
    long loads, computed, unsolved;
    double slowest, worst; /* load, in seconds of the processor; error that was told */
} any_history_tally;

extern any_history_tally tally;

#endif
