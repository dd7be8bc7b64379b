/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The stresses at points after each load as files for ParaView: one for each load, and one that
 * names them all. */
#ifndef CLI_SERIES_H
#define CLI_SERIES_H

#include "point_rows.h"

#include "rows/output_options.h"

/* Writes NAME_0001.vtk and so on, or NAME_b0001.vtk where the series that is replaced has those
 * names, beside NAME.vtk.series, which is the output and comes last. The files of the series that
 * is replaced are then removed. */
void series_write(const point_rows *points, const arguments *line, const output_options *how);

#endif
