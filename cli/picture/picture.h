/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef CLI_PICTURE_H
#define CLI_PICTURE_H

#include "rows/rows.h"
#include "text/text.h"

#include <stdbool.h>
#include <stdio.h>

/* ---- drawing ---- The numbers behind a figure: rows in memory, in groups of one curve each. What
 * is drawn and what --data writes are the same rows. */

enum { DATA_COLUMNS_MAX = 8 };

typedef struct {
    int curve;        /* which group it belongs to */
    const char *text; /* of the text column, where there is one; not copied */
    /* of the others, in their order; what is not finite is empty */
    double number[DATA_COLUMNS_MAX];
} data_row;

/* All zero is empty. */
typedef struct {
    const char *const *column; /* the names of the numbers; NULL after the last */
    const char *text_column;   /* the name of the text column, the last; NULL where there is none */
    data_row *row;
    size_t count;
} dataset;

void dataset_add(dataset *to, data_row row);

/* The rows of a curve: where they start, and how many. */
size_t dataset_curve(const dataset *data, int number, size_t *first);
int dataset_curves(const dataset *data);

/* The largest finite number of a column, for the sign -1 of their negatives; at least 0. */
double dataset_largest(const dataset *data, int column, double sign);

/* A rows_writer for a dataset. */
void dataset_write(void *of_dataset, records *rows);

/* ---- drawing ---- A picture, described without regard to what draws it: axes, curves over the
 * rows of a dataset, labels. Lengths on paper are for a column of 85 mm. In a text *a* is italic
 * and _c is a subscript. */

enum { DRAWING_CURVES_MAX = 60, DRAWING_LABELS_MAX = 60, DRAWING_TEXT = 200 };

typedef enum { STYLE_LINE, STYLE_CROSSES, STYLE_CIRCLES, STYLE_AREA } curve_style;

/* The palette of Okabe and Ito, which the colour-blind can tell apart, without its yellow, which is
 * too pale on paper. */
enum { BLACK, BLUE, VERMILLION, GREEN, PURPLE, ORANGE, SKY, PALETTE_SIZE };

enum { DASHES = 5 }; /* 0 is a solid line; the others differ in print without colour */

typedef struct {
    const dataset *from;
    size_t first, count;
    int x, y; /* columns; a row whose number is not finite breaks the line */
    curve_style style;
    int colour, dash;
    double width; /* of the line, in points */
    double grey;  /* of an area: 0 is black, 1 is white */
    bool second_axis;
    char legend[DRAWING_TEXT]; /* its name below the picture; empty where it has none */
} curve;

typedef enum { ALIGN_LEFT, ALIGN_CENTRE, ALIGN_RIGHT } alignment;

typedef struct {
    double x, y;
    alignment align;
    int colour;
    bool boxed; /* on white, so that it can stand on a line */
    bool second_axis;
    char text[DRAWING_TEXT];
} label;

typedef struct {
    char text[DRAWING_TEXT];
    double from, to;     /* from > to turns the axis round */
    double tic, tic_end; /* tics from 0 on up to there; tic_end 0 for the whole axis */
} axis;

/* Lines of equal height over a grid: rows of so many columns, the columns of the dataset with the
 * places and the heights, and the step from line to line up to the top. */
typedef struct {
    const dataset *from; /* NULL for none */
    int columns, x, y, height;
    double step, top;
} contours;

typedef struct {
    char title[DRAWING_TEXT];
    axis x, y, second;          /* the second is there where its text is */
    double height;              /* of the plot over its width; 0 for the same scale on both axes */
    char caption[DRAWING_TEXT]; /* below the x axis */
    contours field;             /* below the curves */
    curve curve[DRAWING_CURVES_MAX];
    int curve_count;
    dataset outlines; /* points of what is drawn that are no data: limits, zones */
    label label[DRAWING_LABELS_MAX];
    int label_count;
} drawing;

/* The next curve: a thin black line through all rows of one curve of the dataset. The caller may
 * change it. A curve for which there is no room is not drawn. */
curve *drawing_curve(drawing *plot, const dataset *from, int number, int x, int y);

/* The next curve, round a rectangle that is added to the outlines. */
curve *drawing_bar(drawing *plot, double from, double to, double top, double bottom);

/* The next label, its text made as by printf. */
label *drawing_label(drawing *plot, double x, double y, const char *format, ...) PRINTF_LIKE(4, 5);

/* An axis from 0 to a round number that is not below the largest value, a tic or between two. */
axis drawing_axis(double largest, const char *text);

/* A round distance between tics: four to seven of them in the span of an axis, mostly. */
double drawing_tic(double span);

/* A number as text, with at most `digits` digits; 1/6 for a sixth. */
enum { DRAWING_DIGITS = 6 };
void drawing_number(double value, int digits, char text[NUMBER_SIZE]);

/* ---- gnuplot ---- gnuplot draws the pictures. It is looked for on PATH when one is drawn; nothing
 * else needs it, and no other file knows of it. */

/* Has gnuplot draw the picture, as svg, png or pdf, into the output. */
void gnuplot_draw(const drawing *plot, const char *format, output *out);

#endif
