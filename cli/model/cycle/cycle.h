/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef CLI_CYCLE_H
#define CLI_CYCLE_H

#include "model/model.h"

#include <stdbool.h>
#include <stdint.h>

/* ---- criterion_numbers ---- */

/* A criterion is the number that the library gives it; that plus DAMAGE is its damage. NO_CRITERION
 * is what is none: the range of sxx, and measures of friction. */
enum { NO_CRITERION = -1, DAMAGE = 32, CRITERION_COUNT = 2 * DAMAGE };

/* Whether there is a criterion of that number. */
bool criterion_exists(int criterion);
bool criterion_is_damage(int criterion);

/* "modified-wohler", "swt-damage": as --criteria has it. */
const char *criterion_name(int criterion);

/* ---- measures ---- What a cycle of loads does to a place: the columns of "rwedge fretting", in
 * words. */

/* The columns of a criterion: its value, the angles of its plane in degrees, and of damage the
 * number of cycles. What is no criterion is a value; so many times a value is a multiple. */
typedef enum {
    PART_VALUE,
    PART_ANGLE,
    PART_OUT_OF_PLANE,
    PART_CYCLES,
    CRITERION_PARTS,
    PART_MULTIPLE = CRITERION_PARTS
} measure_part;

/* When a column is there. */
typedef enum { COLUMN_ALWAYS, COLUMN_OF_CRITERION, COLUMN_OF_ARCHARD } column_condition;

/* Room for the columns, also of criteria that the library gets. */
enum { COLUMN_MAX = 48 };

struct criteria;
enum { MEASURE_NAME_SIZE = 48, MEASURE_TITLE_SIZE = 80 };
typedef struct {
    char column[MEASURE_NAME_SIZE];
    const char *meaning, *unit;
    int32_t number; /* as the library calls the measure */
    bool is_damage; /* by that measure */
    measure_part part;
    column_condition condition;
    bool is_of_friction; /* of the surface in contact, no criterion of fatigue */
    int criterion;
    char title[MEASURE_TITLE_SIZE];                /* of a value, as a picture has it */
    double (*times)(const struct criteria *asked); /* of a multiple */
} measure_kind;

/* The columns, in their order; there are measure_count(). */
int measure_count(void);
const measure_kind *measure_kind_of(int column);

/* Whether a column is written. */
bool column_is_wanted(const struct criteria *asked, int column);

/* The column of a name; -1 where there is none. */
int measure_column_named(const char *name);

/* The column of a part of a library's measure, which is no multiple; -1 where there is none. */
int measure_column_of(int32_t number, bool is_damage, measure_part part);

/* A part of a criterion; -1 where it has none. */
int measure_column(int criterion, measure_part part);

/* The criterion that a column has the value of; NO_CRITERION for other columns. */
int measure_criterion(int column);

/* The damage of a criterion; the same for damage itself and for criteria without a life. */
int measure_damage(int criterion);

/* ---- material ---- A material's constants, by name: those of all criteria, what these must not
 * exceed, and what a contact or a critical distance has. */

enum { MATERIAL_MAX = 48 };

typedef struct {
    double value[MATERIAL_MAX]; /* NAN where not given */
} material;

/* How many there are, and their names. */
int material_count(void);
const char *material_name(int constant);

/* Whether a constant may have this value; in words, "0, or 1e-60 to 1e60". */
bool material_is_in_range(int constant, double value);
const char *material_allowed(int constant);

/* What a constant is, in a few words. */
const char *material_meaning(int constant);

/* Its dimension, as that of a column; "" where it is that of a law. */
const char *material_unit(int constant);

/* Whether one of the criteria has it, and the contact has not: an option gives it. */
bool material_is_option(int constant);

/* Takes the text of a constant, which may have its unit; one of a K must have. False, with the rest
 * of a sentence about it. */
bool material_take(int constant, const char *text, char decimal_sign, const unit_system *units,
                   material *constants, complaint *why);

/* A name and its text, as they were read. */
typedef struct {
    char *name, *text;
} constant_words;

/* Takes all constants of a material but remarks; with "units" it says those of its bare stresses.
 * False, with the words that are wrong, and the rest of a sentence about them. */
bool material_take_all(size_t count, const constant_words words[], const unit_system *units,
                       material *constants, const constant_words **fault, complaint *why);

/* What the number of a constant is multiplied by to be in other units; m is the exponent of the
 * growth of a crack, on which the unit of its factor depends. */
double material_conversion(int constant, double m, const unit_system *from, const unit_system *to);

/* A material without any constant. */
material material_unknown(void);

/* The constant of a name; -1 where none is known. */
int material_constant(const char *name);

/* The constant of a name that is known. */
double material_value(const material *constants, const char *name);

/* Whether a name is a remark on the constants, such as their source; "units" is that of their
 * numbers. */
bool material_is_remark(const char *name);

/* The allowable value of a criterion; NAN where it is not known. */
double material_allowable(const material *constants, int criterion);

/* ---- criteria ---- Criteria of fatigue: which are asked for, and their constants. */

enum { CONSTANTS_MAX = 16 }; /* of a criterion and its curve of life */

typedef struct criteria {
    bool is_listed;                  /* by --criteria; otherwise what has its constants is wanted */
    bool is_wanted[CRITERION_COUNT]; /* with columns of its own */
    bool is_computed[CRITERION_COUNT];
    bool is_plane_stress;
    double nu;                               /* of body 1 */
    double archard;                          /* depth worn per energy and area; NAN for none */
    material given;                          /* by options, or by --material */
    double constants[DAMAGE][CONSTANTS_MAX]; /* of each criterion, then of its curve of life */
} criteria;

/* The criteria by default: Smith, Watson and Topper's alone, in plane strain. */
criteria criteria_usual(const contact_case *setup);

/* The constants of a criterion or its damage, of the contact, of what is given, or the usual ones.
 * NULL where all are known, which may then be computed; or the name of the first that lacks. */
const char *criteria_take(const contact_case *setup, int criterion, criteria *asked);

/* ---- last_cycle ---- The last cycle of a history of loads, and what it does to a place. */

/* A place of body 1, y the depth, with its measures: NAN where a measure has no value. */
typedef struct {
    double x, y;
    bool is_shown;    /* among the rows that are written */
    double amplitude; /* of sqrt(J2); where it is next to nothing, nothing cycles */
    double value[COLUMN_MAX];
} measured_place;

typedef struct {
    const contact_case *setup;
    criteria asked;
    rwedge_contact *before;    /* the contact before the cycle */
    rwedge_cycle *cycle;       /* what the contact goes through */
    size_t loads;              /* of the cycle */
    double *P, *M, *Q, *sigma; /* `loads` numbers each */
    double *displacement;      /* likewise, of a cycle that is driven */
    double *tilt;              /* likewise, of one that is guided */
    bool is_driven, is_guided;
    double compliance;
    double left, right; /* the outermost edges; NAN where there is no contact */
    double error;       /* the largest rwedge_contact_error() of its states */
    bool slip_known;    /* it has a closed form after every load */
} last_cycle;

/* Begins a cycle of at most so many loads: copies the contact before it. Where memory is short
 * last_cycle_end() says so. Several threads may call it and the others here at a time, each for a
 * cycle of its own, once measure_count() has been called. */
void last_cycle_begin(const contact_case *setup, const criteria *asked,
                      const rwedge_contact *before, size_t most, last_cycle *cycle);

/* Adds a load, which the contact is under. */
void last_cycle_add(load to, const rwedge_contact *contact, last_cycle *cycle);

/* To be called after the last load, before the measures. Returns the library's status. */
int32_t last_cycle_end(last_cycle *cycle);

void last_cycle_free(last_cycle *cycle);

/* The measures at n places. Returns the library's status, or RWEDGE_ENOMEM. Several threads may
 * call it at a time. */
int32_t last_cycle_measure(const last_cycle *cycle, size_t n, measured_place at[]);

/* The criteria, with the range, of stresses after all loads at n places: of each load one place
 * after the other, sxx of all first, then syy and txy. The other measures become NAN. */
int32_t last_cycle_criteria(const last_cycle *cycle, size_t n, const double *stress,
                            measured_place at[]);

/* Where a measure is largest on a line along x of n ascending places, which have been measured.
 * Returns the library's status. */
int32_t last_cycle_worst(const last_cycle *cycle, int column, size_t n, const measured_place line[],
                         double *worst_x, double *worst_value);

/* ---- stops ---- The places along x at which a cycle is measured. Those of rwedge_cycle_edges()
 * are among them, because stresses and slip have their peaks there. */

/* Lines along x, one after the other: each line has `line` places, all of one depth y, x
 * ascending. */
typedef struct {
    measured_place *place; /* freed by free() */
    size_t count, line;    /* line is 0 where they are no lines */
} measured;

/* The places by default, those of rwedge_cycle_places(). None where there is no contact. */
measured stops_usual(const last_cycle *cycle);

/* The same; false where memory is short. Several threads may call it at a time. */
bool stops_find(const last_cycle *cycle, measured *all);

/* The place with the largest value of a column, the first of several. Of a criterion it is not
 * looked for where nothing cycles. */
size_t measured_best(const measured *result, int column);

/* The given places, in any order, and the edges between them, which are not shown. */
measured stops_at(const last_cycle *cycle, size_t n, const double x[]);

/* ---- worst_places ---- Where each column is worst, and what a criterion comes to there. */

/* The value is NAN where the column is not wanted, or nowhere above 0; cycles but for damage. */
typedef struct {
    double x, y, value, cycles;
} worst_row;

/* The worst of the places that are measured, and of those between them on their lines. Returns the
 * library's status. */
int32_t worst_places(const last_cycle *cycle, const measured *result, worst_row row[COLUMN_MAX]);

/* What a criterion comes to at a place: its value, what it must not exceed, that over the value;
 * the life by its damage, in passes of the loads, INFINITY for a run-out. NAN where not known. */
typedef struct {
    double value, allowable, safety, life;
} criterion_verdict;
criterion_verdict criterion_verdict_at(const criteria *asked, const measured_place *at,
                                       int criterion);

/* A part of a criterion at a place; NAN where it has no such part. */
double measured_part(const measured_place *at, int criterion, measure_part part);

/* ---- worst_verdict ---- What a criterion comes to at its worst place, or below it. */

/* The theory of critical distances: the stresses below a place of the surface, at half of a length,
 * or their means over twice the length. */
typedef struct {
    double length, angle; /* NAN for none; from the surface's normal towards +x, deg */
    bool is_line;         /* mean over twice the length; else the point at half of it */
} distance;

typedef struct {
    bool is_below;     /* the place; the rest is of the stresses there */
    measured_place at; /* at the place, or those of the stresses below it */
    criterion_verdict judged;
    /* on the stresses of all loads, with which a criterion has its allowable value; NAN of damage,
     * and where none is known */
    double load_factor;
} worst_verdict;

/* Returns the library's status. */
int32_t worst_verdict_of(const last_cycle *cycle, const distance *below, const worst_row *row,
                         int criterion, worst_verdict *verdict);

#endif
