/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The stresses at points after each load as files for ParaView: one for each load, and one that
 * names them all. */
#ifndef CLI_SERIES_H
#define CLI_SERIES_H

#include "point_rows.h"

#include "rows/output_options.h"

/* Writes NAME_0001.vtk and so on beside NAME.vtk.series, which is the output and comes last.
 * Returns the exit status. */
int series_write(const point_rows *what, const output_options *how);

#endif
