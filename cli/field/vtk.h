/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A grid of stresses as a file for ParaView. */
#ifndef CLI_VTK_H
#define CLI_VTK_H

#include "grid.h"

/* A rows_writer of output_options.h: legacy VTK, ASCII. The records say only where it goes, and
 * with how many digits. */
bool vtk_write(void *of_grid, records *rows, bool show_progress);

#endif
