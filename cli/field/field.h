/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef CLI_FIELD_H
#define CLI_FIELD_H

#include "rows/rows.h"
#include "setup/setup.h"

/* ---- field ---- Points with their stresses as rows. */

/* The stress at a point; NAN where it is infinite, at a sharp edge. Ends the command where the
 * library has none. */
tensor point_stress(const rwedge_contact *contact, const pad *shape, double nu, double x, double y);

/* The header; the title, not copied, is that of a file for ParaView. On a grid so many points are
 * side by side; else 0. */
void point_columns_write(records *rows, const char *title, size_t across);

/* A row. */
void point_write(records *rows, double x, double y, const tensor *at);

#endif
