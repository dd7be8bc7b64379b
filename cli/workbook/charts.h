/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Figs. 3, 4 and 6 of the paper beside the calculator, with its case in them. */
#ifndef CLI_CHARTS_H
#define CLI_CHARTS_H

#include "sheet/xlsx.h"

/* A chart's height. */
enum { CHART_ROWS = 17 };

void sheet_charts(xlsx *book, int row, int column);

#endif
