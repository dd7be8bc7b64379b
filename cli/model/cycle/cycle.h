/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef CLI_CYCLE_H
#define CLI_CYCLE_H

#include "model/model.h"

#include <stdbool.h>
#include <stdint.h>

/* ---- measures ---- What a cycle of loads does to a place: the columns of "rwedge fretting", in
 * words. */

/* Of fatigue; NO_CRITERION of what is none. */
enum {
    NO_CRITERION = -1,
    CRITERION_SWT,
    CRITERION_FATEMI_SOCIE,
    CRITERION_FINDLEY,
    CRITERION_MODIFIED_WOHLER,
    CRITERION_MCDIARMID,
    CRITERION_CROSSLAND,
    CRITERION_DANG_VAN,
    CRITERION_SWT_DAMAGE,
    CRITERION_FS_DAMAGE,
    CRITERION_COUNT
};

/* The columns of a criterion: its value, the angles of its plane in degrees, and of damage the
 * number of cycles. What is no criterion is a value. */
typedef enum { PART_VALUE, PART_ANGLE, PART_OUT_OF_PLANE, PART_CYCLES, PART_COUNT } measure_part;

/* Those without a name here are found by measure_column(). */
enum {
    MEASURE_STRESS_RANGE,
    MEASURE_SWT,
    MEASURE_SWT_ANGLE,
    MEASURE_SLIP_RANGE = 5,
    MEASURE_RUIZ_F1,
    MEASURE_RUIZ_F2,
    MEASURE_ENERGY_PER_AREA,
    MEASURE_COUNT, /* those that are always there; the others follow where they are asked for */
    COLUMN_WEAR = 30,
    COLUMN_COUNT
};

typedef struct {
    const char *column, *meaning, *unit;
    int criterion;
    measure_part part;
    int32_t number;    /* as the library calls the measure; -1 for none */
    const char *title; /* of a value, as a picture has it: *a* is italic, _c a subscript */
} measure_kind;
extern const measure_kind measure_kinds[COLUMN_COUNT];

/* A part of a criterion; -1 where it has none. */
int measure_column(int criterion, measure_part part);

/* The criterion that a column has the value of; NO_CRITERION for other columns. */
int measure_criterion(int column);

/* The damage of a criterion; the same for damage itself and for criteria without a life. */
int measure_damage(int criterion);

/* ---- material ---- A material's constants, by name. */

enum {
    MATERIAL_SWT_LIMIT,
    MATERIAL_FS_LIMIT,
    MATERIAL_FINDLEY_LIMIT,
    MATERIAL_LAMBDA,
    MATERIAL_CROSSLAND_LIMIT,
    MATERIAL_DANG_VAN_LIMIT,
    MATERIAL_SF,
    MATERIAL_B,
    MATERIAL_EF,
    MATERIAL_C,
    MATERIAL_G,
    MATERIAL_TF,
    MATERIAL_B0,
    MATERIAL_GF,
    MATERIAL_C0,
    MATERIAL_DK_TH,
    MATERIAL_DS0,
    MATERIAL_PARIS_C,
    MATERIAL_PARIS_M,
    MATERIAL_K_C,
    /* From here on an input or an option has the same. */
    MATERIAL_E,
    MATERIAL_NU,
    MATERIAL_YIELD_STRESS,
    MATERIAL_FS_K,
    MATERIAL_FINDLEY_K,
    MATERIAL_KAPPA,
    MATERIAL_T_A,
    MATERIAL_SU,
    MATERIAL_CROSSLAND_ALPHA,
    MATERIAL_DANG_VAN_ALPHA,
    MATERIAL_COUNT
};
extern const char *const material_names[MATERIAL_COUNT];

typedef struct {
    double value[MATERIAL_COUNT]; /* NAN where not given */
} material;

/* Without any constant. */
material material_unknown(void);

/* The constant of a name; -1 where none is known. */
int material_constant(const char *name);

/* Whether a name is a remark on the constants, such as their source. */
bool material_is_remark(const char *name);

/* The allowable value of a criterion; NAN where it is not known. */
double material_allowable(const material *constants, int criterion);

/* ---- criteria ---- Criteria of fatigue over all planes: which are asked for, and their
 * constants. */

typedef struct {
    const char *name;
    int constant; /* of the material; MATERIAL_COUNT: it needs none of its own */
    int limit;    /* what it must not exceed, of the material; MATERIAL_COUNT: 1 */
} criterion_kind;
extern const criterion_kind criterion_kinds[CRITERION_COUNT];

typedef struct {
    bool is_listed;                  /* by --criteria; otherwise what has its constants is wanted */
    bool is_wanted[CRITERION_COUNT]; /* with columns of its own */
    bool is_plane_stress;
    double nu;                 /* of body 1 */
    double archard;            /* depth worn per energy and area; NAN for none */
    const material *constants; /* NULL for none */
    /* Of the library's criteria; NAN: not known. Fatemi and Socie's is k over the yield stress. Of
     * damage it is that of its criterion. */
    double constant[CRITERION_COUNT], su;
} criteria;

/* Whether a column is written. */
bool column_is_wanted(const criteria *asked, int column);

/* The criteria by default: Smith, Watson and Topper's alone, in plane strain. */
criteria criteria_usual(const contact_case *setup);

/* Fatemi and Socie's constant, their k over the yield stress; NAN without a yield stress. */
double criteria_fatemi_socie(const contact_case *setup, double k);

/* ---- last_cycle ---- The last cycle of a history of loads, and what it does to a place. */

/* A place of body 1, y the depth, with its measures: NAN where a measure has no value. */
typedef struct {
    double x, y;
    bool is_shown; /* among the rows that are written */
    double value[COLUMN_COUNT];
} measured_place;

typedef struct {
    const contact_case *setup;
    criteria asked;
    rwedge_contact *before;    /* the contact before the cycle */
    rwedge_cycle *cycle;       /* what the contact goes through */
    size_t loads;              /* of the cycle */
    double *P, *M, *Q, *sigma; /* `loads` numbers each */
    double *edges;             /* of contact and stick zone, in no order */
    size_t edge_count;
    double left, right; /* the outermost; NAN where there is no contact */
    double error;       /* the largest rwedge_contact_error() of its states */
    bool slip_known;    /* it has a closed form after every load */
} last_cycle;

/* Begins a cycle of at most so many loads: copies the contact before it. */
void last_cycle_begin(const contact_case *setup, const criteria *asked,
                      const rwedge_contact *before, size_t most, last_cycle *cycle);

/* Adds a load, which the contact is under. */
void last_cycle_add(const rwedge_contact *contact, last_cycle *cycle);

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

/* The life by a criterion at a place, in passes of the loads: INFINITY for a run-out; NAN where its
 * damage is not known. */
double measured_life(const measured_place *at, int criterion);

/* ---- stops ---- The places along x at which a cycle is measured. The edges of contact and stick
 * zone after each load are among them, because stresses and slip have their peaks there. */

/* Lines along x, one after the other: each line has `line` places, all of one depth y, x
 * ascending. */
typedef struct {
    measured_place *place; /* freed by free() */
    size_t count, line;    /* line is 0 where they are no lines */
} measured;

/* The places by default, of the surface: across the contact and beyond. None where there is no
 * contact. */
measured stops_usual(const last_cycle *cycle);

/* The place with the largest value of a column, the first of several. */
size_t measured_best(const measured *result, int column);

/* The given places, in any order, and the edges between them, which are not shown. */
measured stops_at(const last_cycle *cycle, size_t n, const double x[]);

#endif
