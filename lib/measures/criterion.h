/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef RW_CRITERION_H
#define RW_CRITERION_H

#include "measures/stress_cycles.h"

#include <stdint.h>

/* Whether there is such a criterion of stresses, and its constants are in their ranges. */
bool rw_has_constants(int32_t criterion, const double constants[]);

/* Whether it counts a mean stress also where nothing cycles. */
bool rw_counts_mean(int32_t criterion);

#endif
