/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Charts of points with straight lines between them. */
#ifndef CLI_CHART_H
#define CLI_CHART_H

#include "xlsx.h"

enum { XLSX_SERIES_MAX = 24 };
typedef enum {
    XLSX_LINE,
    XLSX_THICK_LINE,
    XLSX_DASHED_LINE,
    XLSX_MARK,
    XLSX_OUTLINE,    /* black */
    XLSX_BAR_GROUND, /* wide lines */
    XLSX_BAR_GOOD,
    XLSX_BAR_BAD,
    XLSX_LABEL /* the name, at an invisible point */
} xlsx_drawing;
typedef struct {
    const char *name;  /* in the legend, or a cell that has it, "='Sheet'!$A$1"; NULL for none */
    const char *x, *y; /* ranges, "='Sheet'!$A$1:$A$9" */
    xlsx_drawing drawing;
} xlsx_series;
typedef struct {
    const char *title, *x_title, *y_title; /* NULL for none */
    double x_min, x_max, x_step, y_min, y_max;
    int width, height; /* pixels */
    int right, down;   /* pixels from the corner of the cell */
    bool bare;         /* no axes, no legend */
    const char
        *x_format; /* of the numbers along x: a bare picture has them too; NULL for the usual */
    xlsx_series series[XLSX_SERIES_MAX];
    int series_count;
} xlsx_chart;
void xlsx_draw(xlsx *book, int row, int column, const xlsx_chart *chart);

#endif
