/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Criteria of the smallest sphere around the path of the stress deviator. */
#ifndef RW_MESOSCOPIC_H
#define RW_MESOSCOPIC_H

#include "measures/stress_cycles.h"

rw_criterion_of_field rw_crossland, rw_dang_van;

#endif
