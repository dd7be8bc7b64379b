/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef CLI_FIGURE_H
#define CLI_FIGURE_H

#include "crack/crack.h"
#include "loop/loop.h"
#include "fretting/fretting.h"
#include "history/history.h"
#include "model/cycle/cycle.h"

#include <stdio.h>

/* ---- dataset ---- The numbers behind a figure: rows in memory, in groups of one curve each. What
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
    size_t across;             /* of a grid: how many rows are side by side; 0 for curves */
    data_row *row;
    size_t count;
    double error; /* the largest rwedge_contact_error() of the contacts that it is of */
    double
        worst[3]; /* of figure measure: x, y, and the largest value, which may lie between rows */
    double touched[2],
        stuck[2]; /* and where the cycle touches, and always sticks; both 0: nowhere */
} dataset;

void dataset_add(dataset *to, data_row row);

/* The largest finite number of a column; at least 0. */
double dataset_largest(const dataset *data, int column);

/* Writes it as rows. */
void dataset_write(const dataset *data, records *rows);

/* ---- kind ---- A kind of figure: what it depends on, the numbers behind it, and the script that
 * draws them. */

/* How a figure depends on a variable: the default, NULL where it does not depend on it, "" where
 * it may be left out. */
typedef struct {
    const char *usual;
    int most; /* how many values it takes */
} figure_use;

enum { FIGURE_CURVES_MAX = 12, FIGURE_DIGITS = 6 };

/* Where a measure is drawn: along the surface, below its worst place, below the contact. */
enum { OVER_SURFACE, OVER_DEPTH, OVER_FIELD, OVER_COUNT };

typedef struct figure figure;

/* What is asked for; a count of 0 where a variable is not given. */
typedef struct {
    const figure *kind;
    const char *format; /* of the picture; NULL for the numbers */
    bool no_title;
    range value[FIGURE_VARIABLES];
    contact_history history; /* of a figure that has one */
    places at;
    double half_width; /* the largest of the contact, in its cycles */
    double error;      /* that of the dataset */
    criteria asked;    /* of figure measure, which also has a column of "rwedge fretting" */
    material constants;
    int measure, over;
    /* of the figures of a state: the case under its loads; NULL is after the history */
    const contact_case *state;
    const char *length_unit, *stress_unit; /* NULL where not known */
    bool is_part;    /* of a page: SVG without what stands before it in a file */
    last_cycle last; /* of figure crack */
    crack_plan crack;
    const series_table *tests; /* of figure tests */
    log_fit fit;               /* of figure measured */
} figure_case;

double case_value(const figure_case *inputs, int variable);

/* Ends the command where the library has not answered. */
void case_check(const figure_case *inputs, int32_t status);

/* The values of a variable as the names of its curves, separated by blanks: with all digits where
 * fewer do not tell the values apart. */
enum { FIGURE_NAMES_SIZE = FIGURE_CURVES_MAX * NUMBER_SIZE };
void case_names(const figure_case *inputs, int variable, char names[FIGURE_NAMES_SIZE]);

struct figure {
    const char *name, *summary;
    figure_use use[FIGURE_VARIABLES];
    bool has_history; /* it needs a contact and a table of loads in place of variables */
    bool has_tests;   /* or a series of tests */
    bool has_loop;    /* or a log of a loop */
    int64_t cycles;   /* how often it goes through the table by default */
    const char *const *column;
    const char *text_column;
    void (*compute)(const figure_case *inputs, dataset *rows);
    /* The columns that are drawn, a bit for each, and why there is nothing to draw where all of
     * them are 0; NULL where there always is. */
    int drawn;
    const char *nothing;
    /* Gives the script what it cannot find in the rows, by name; NULL where it can find all. */
    void (*prepare)(const figure_case *inputs, const dataset *rows, FILE *script);
    const char *const *script; /* the lines of its file in scripts/, which draw the rows */
};

/* The figures of the paper, 2 to 7, and more. Each is defined in a file of its subject. */
extern const figure figure_pressure, figure_normal, figure_sliding, figure_yield_point,
    figure_tension, figure_shear, figure_field, figure_loop, figure_eccentric, figure_history,
    figure_any_loop, figure_fretting, figure_measure, figure_crack, figure_wear, figure_shakedown,
    figure_unlike_limit, figure_unlike_tension, figure_contact, figure_tractions, figure_stress,
    figure_tests, figure_measured;

/* The lines of the files in scripts/, which the build makes of them; NULL after the last: what
 * every script begins with, what stands for its line "frame", and the figures' own. */
typedef const char *const script_line;
extern script_line head_lines[], frame_lines[], pressure_lines[], normal_lines[], sliding_lines[],
    yield_point_lines[], tension_lines[], shear_lines[], field_lines[], loop_lines[],
    eccentric_lines[], history_lines[], any_loop_lines[], fretting_lines[], measure_lines[],
    crack_lines[], wear_lines[], shakedown_lines[], unlike_limit_lines[], unlike_tension_lines[],
    contact_lines[], tractions_lines[], stress_lines[], tests_lines[], measured_lines[];

/* A round step that gives 8 to 20 levels up to the top. */
double step_of_levels(double top);

/* ---- script ---- What gnuplot is told, in its own language. */

/* The name is a number from then on; or a text, in which *a* is italic and _c a subscript. */
void script_number(FILE *script, const char *name, double value);
void script_text(FILE *script, const char *name, const char *text);

/* The name is the rows from then on, all columns of them: an index for each curve, a blank line
 * after each row of a grid. */
void script_rows(FILE *script, const char *name, const dataset *rows);

/* Writes the script that draws the rows. */
void script_write(const figure_case *inputs, const dataset *rows, FILE *script);

/* ---- gnuplot ---- gnuplot draws the pictures. It is looked for on PATH when one is drawn; nothing
 * else needs it, and no other file runs it. What it draws is said in its own language. */

/* Has gnuplot draw a picture into the output. The script finds `terminal` in it, the format of the
 * case with the paper's width and height, and `paper` and `line`: that width, and the height of a
 * line of text over it. */
void gnuplot_draw(const figure_case *inputs, const dataset *rows, output *out);

#endif
