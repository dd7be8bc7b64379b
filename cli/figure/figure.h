/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef CLI_FIGURE_H
#define CLI_FIGURE_H

#include "history/history.h"
#include "model/cycle/cycle.h"
#include "picture/picture.h"

/* A kind of figure: what it depends on, the numbers behind it, and the drawing of them. */

/* Those of tables, and two more. */
enum { C_OVER_B = VARIABLE_COUNT, SIGMA_OVER_MAX, FIGURE_VARIABLES };

/* How a figure depends on a variable: the default, NULL where it does not depend on it, "" where
 * it may be left out. */
typedef struct {
    const char *usual;
    int most; /* how many values it takes */
} figure_use;

enum { FIGURE_CURVES_MAX = 12 };

/* Where a measure is drawn: along the surface, below its worst place, below the contact. */
enum { OVER_SURFACE, OVER_DEPTH, OVER_FIELD, OVER_COUNT };

/* What is asked for; a count of 0 where a variable is not given. */
typedef struct {
    const char *name; /* of the figure */
    range value[FIGURE_VARIABLES];
    const contact_history *history; /* of a figure that has one; NULL otherwise */
    const places *at;
    double half_width; /* the largest of the contact, in its cycles */
    const criteria *asked;
    int measure, over; /* of figure measure: a column of "rwedge fretting", and where */
} figure_case;

double case_value(const figure_case *inputs, int variable);

/* Ends the command where the library has not answered. */
void case_check(const figure_case *inputs, int32_t status);

/* A value as the name of its curve: with all digits where fewer do not tell the values apart. */
const char *case_text(const figure_case *inputs, int variable, int64_t i, char text[NUMBER_SIZE]);

typedef struct {
    const char *name, *summary;
    figure_use use[FIGURE_VARIABLES];
    bool has_history; /* it needs a contact and a table of loads in place of variables */
    bool needs_point; /* and one point */
    int64_t cycles;   /* how often it goes through the table by default */
    const char *const *column;
    const char *text_column;
    void (*compute)(const figure_case *inputs, dataset *rows);
    /* returns NULL, or why there is nothing to draw */
    const char *(*draw)(const figure_case *inputs, const dataset *rows, drawing *plot);
} figure;

/* Those of the paper, 2 to 7, and more. Each is defined in a file of its subject. */
extern const figure figure_pressure, figure_normal, figure_sliding, figure_yield_point,
    figure_tension, figure_shear, figure_field, figure_loop, figure_eccentric, figure_history,
    figure_any_loop, figure_fretting, figure_measure;

/* A round step that gives 8 to 20 levels up to the top. */
double step_of_levels(double top);

/* Style of the curve i of a family: colour and dashes both change, so that either tells
 * neighbours apart. */
void style_of_family(curve *line, int i);

/* The curve n of a family over the columns x and y, named by the value of its variable after some
 * words; and all of them. */
curve *draw_member(const figure_case *inputs, int variable, int n, const char *words,
                   const dataset *rows, int x, int y, drawing *plot);
void draw_family(const figure_case *inputs, int variable, const dataset *rows, int x, int y,
                 drawing *plot);

#endif
