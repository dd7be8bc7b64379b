/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The rows of the report, one list for each section of the header; each ends with a row without
 * a function. */
#ifndef ROWS_HPP
#define ROWS_HPP

#include "probe.hpp"
#include "references/contact.hpp"

extern const row LAW_ROWS[], STRESS_ROWS[], GRADIENT_ROWS[], STRENGTH_ROWS[], DESIGN_ROWS[],
    HISTORY_ROWS[], ECCENTRIC_ROWS[], ECCENTRIC_FIELD_ROWS[], PAD_ROWS[], MEASURE_ROWS[],
    PLANE_ROWS[], LIFE_ROWS[];

#endif
