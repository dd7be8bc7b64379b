/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The columns of "rwedge fretting" as a file for ParaView. */
#ifndef CLI_PARAVIEW_H
#define CLI_PARAVIEW_H

#include "rows/records.h"
#include "surface.h"

typedef struct {
    const measured *all;
    const criteria *asked;
} measured_columns;

/* A rows_writer of a measured_columns: a grid of lines along x, else points. */
void paraview_write(void *of_columns, records *rows);

#endif
