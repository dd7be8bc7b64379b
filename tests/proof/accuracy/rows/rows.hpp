/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The rows of the report, one list for each section of the header; each ends with a row without
 * a function. */
#ifndef ROWS_HPP
#define ROWS_HPP

#include <memory>

#include "probe.hpp"
#include "references/contact.hpp"
#include "rwedge.h"

/* A contact of the library, or none. */
typedef std::shared_ptr<rwedge_contact> shared_contact;

inline shared_contact shared(rwedge_contact *contact)
{
    return {contact, rwedge_contact_destroy};
}

extern const row LAW_ROWS[], STRESS_ROWS[], GRADIENT_ROWS[], STRENGTH_ROWS[], DESIGN_ROWS[],
    HISTORY_ROWS[], ECCENTRIC_ROWS[], ECCENTRIC_FIELD_ROWS[], PAD_ROWS[], MEASURE_ROWS[],
    PLANE_ROWS[], LIFE_ROWS[];

#endif
