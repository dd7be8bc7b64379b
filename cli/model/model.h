/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef CLI_MODEL_H
#define CLI_MODEL_H

#include "number/number.h"
#include "pad/pad.h"
#include "text/text.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include <rwedge.h>

/* ---- units ---- Units of quantities as people write them, and the working units of a command. */

/* Its size in newtons, metres and radians, and its powers of the root of both. */
typedef struct {
    double size;
    int half_force, half_length;
    bool is_angle;
} measuring_unit;

/* Reads a whole text, such as "N/mm", "kN", "MPa sqrt(m)". False where it is no unit. */
bool unit_read(const char *text, measuring_unit *to);

/* Whether a word of so many bytes looks like a unit; a power may follow, and the case of longer
 * words does not matter. */
bool unit_is_word(const char *word, size_t length);

/* The working units, and what forces of the whole contact are divided by. */
typedef struct {
    bool is_known;
    double length, force; /* in metres and newtons */
    double width;         /* of the contact out of the plane; NAN where it is not given */
    double section;       /* on which a tension acts that is given as a force; NAN */
    double K_length;      /* in metres, of the root in a bare stress intensity; NAN */
    bool has_options;     /* complaints name those of the tool */
} unit_system;
extern const unit_system units_unknown;

/* Reads "mm,N,MPa": the sizes of these. False, with the complaint. */
bool units_read(const char *text, unit_system *units, complaint *why);

/* Which quantities may be given for the whole contact. */
typedef enum { SHARE_NONE, SHARE_OF_WIDTH, SHARE_OF_SECTION } unit_share;

/* What a number with its own unit, NULL for none, is multiplied by to be one of the dimension,
 * "force/length", in the working units. False, with the complaint, where it cannot be. */
bool units_factor(const unit_system *units, const char *own, const char *dimension, unit_share of,
                  double *factor, complaint *why);

/* What a number of a dimension in one system is multiplied by to be in another; 1 where one of the
 * two is not known. */
double units_conversion(const unit_system *from, const unit_system *to, const char *dimension);

/* Reads a number that a unit may follow; *own is that part of the text, NULL for none. */
bool quantity_read(const char *text, char decimal_sign, double *value, const char **own);

/* ---- intensity ---- Stress intensities and the growth of cracks, with their units. */

/* Reads a K with its unit, "4.2 MPa sqrt(m)"; or a number whose root is of the K_length of the
 * units. In the working units, of mm where these are not known. False, with the complaint. */
bool intensity_read(const char *text, char decimal_sign, const unit_system *units, double *value,
                    complaint *why);

/* Reads a growth a cycle, "6.9e-12 m/(MPa sqrt(m))^3", the factor of K^m; or a number in the
 * working unit of length beside a K as above. False, with the complaint. */
bool growth_read(const char *text, char decimal_sign, double m, const unit_system *units,
                 double *value, complaint *why);

/* ---- inputs ---- The inputs that define a contact: for each its names as option and as column,
 * its domain, and how its text is read. */

enum {
    INPUT_E1,
    INPUT_NU1,
    INPUT_E2,
    INPUT_NU2,
    INPUT_THETA,
    INPUT_THETA_DEG,
    INPUT_A,
    INPUT_RADIUS,
    INPUT_RADIUS1, /* of both bodies, in place of the radius; negative where concave */
    INPUT_RADIUS2,
    INPUT_FLAT,
    INPUT_PROFILE, /* a name, not a number */
    INPUT_TILT,    /* the pad is held there, in place of a moment */
    INPUT_P,       /* the loads, up to sigma */
    INPUT_M,
    INPUT_Q,
    INPUT_SIGMA,
    INPUT_F,
    INPUT_K,
    INPUT_YIELD_STRESS,
    INPUT_COUNT
};

typedef struct {
    const char *option, *flag, *column; /* "theta-deg", "--theta-deg", "theta_deg" */
    const char *meaning, *argument;     /* as the help of an option has them */
    const char *unit;                   /* the dimension, as that of a result */
    const char *subject;                /* of a sentence */
    double lo, hi;
    bool open; /* the ends are not in the domain */
    const char *domain;
    unit_share of; /* whether it may be given for the whole contact */
} input_kind;
extern const input_kind input_kinds[INPUT_COUNT];

/* Whether the pad may turn; its own choice where no text says it. */
typedef enum { ROTATION_UNSAID, ROTATION_FREE, ROTATION_HELD } rotation;

/* Texts from options, or from the cells of a row, whose decimal sign may be a comma. */
typedef struct {
    const char *text[INPUT_COUNT]; /* NULL where not given; an empty cell is as good as none */
    bool is_cell[INPUT_COUNT];
    /* a number in place of a text, where there is one */
    bool has_number[INPUT_COUNT];
    double number[INPUT_COUNT];
    char cell_decimal_sign;
    /* what a number of a cell is multiplied by, as its column has it; 0 where nothing is known */
    double cell_factor[INPUT_COUNT];
    const unit_system *units; /* NULL where no unit is known */
    /* what messages advise where a unit is given and none is known, ": --units converts it" */
    const char *how_units;
    /* what messages about cells advise: how they may have a decimal comma, "with --decimal-comma";
     * where else inputs are given, "columns or options", or NULL */
    const char *how_comma, *where_else;
    /* the profile of a name; NULL with the complaint where there is none. NULL itself where no text
     * is that of a profile. */
    const pad_profile *(*profile_named)(const char *name, complaint *why);
    /* of q over f p0, to which loads without a closed form are computed; 0 refuses them, and NAN
     * is what is usual */
    double tolerance;
    bool is_plane_stress; /* in place of plane strain */
    rotation rotation;
    bool takes_as_similar;    /* neglects what friction of unlike bodies does to the pressure */
    const char *how_rotation; /* what messages advise where the rotation is not said */
} input_texts;

/* The tolerance where none is given. */
extern const double usual_tolerance;

/* The input that is an alternative to this one, as radius is to a; -1 where there is none. */
int input_alternative(int input);

/* The name of an input as the source of its text spells it: "theta_deg" in a file, "--theta-deg" as
 * an option. */
const char *input_name(const input_texts *texts, int input);

/* An input as it was given: its text, or the number that stands for it. */
const char *input_text(const input_texts *texts, int input, char number[NUMBER_SIZE]);

/* Whether a text is there; an empty cell is none. */
bool input_is_given(const input_texts *texts, int input);

/* Has a number stand for an input, in place of its text and of that of its alternative. */
void input_set(input_texts *texts, int input, double value);

/* Reads an input that is given. False, with the complaint, where it is outside its domain. E2 may
 * be HUGE_VAL, "inf"; the value of a profile is the number of its places. */
bool input_read(const input_texts *texts, int input, double *value, complaint *why);

/* ---- loads ---- A load, how it is applied, and what is wrong with it where it cannot be. */

typedef struct {
    double P, M, Q, sigma;
    bool is_guided; /* at the tilt, of a contact that is held; M is then a result */
    double tilt;
    bool is_driven; /* by a rig that gives way, to the displacement; Q is then a result */
    double displacement, compliance;
} load;

/* Whether a list has guided loads; and at more than one tilt; whether it has driven loads. */
bool loads_are_guided(const load to[], size_t count);
bool loads_are_driven(const load to[], size_t count);
bool loads_turn(const load to[], size_t count);

/* Reads how far a rig gives way, as a length over a force per unit length. A unit of its own may be
 * that of the whole contact, a length over a force, as a number without one is where the units have
 * a width. False, with the rest of a sentence about it. */
bool loads_read_compliance(const char *text, char decimal_sign, const unit_system *units,
                           double *value, complaint *why);

/* The loads of a contact. */
load loads_of(const rwedge_contact *contact);

/* The load after i of n equal steps from one load to another. */
load loads_between(load from, load to, int i, int n);

/* Returns the library's status. */
int32_t loads_apply(load to, rwedge_contact *contact);

/* Holds the pad of a contact without loads at a tilt; returns the library's status. */
int32_t loads_hold(double tilt, rwedge_contact *contact);

/* Applies P and M, of unlike bodies P before M, then Q and sigma together under constant P and M;
 * returns the library's status. */
int32_t loads_apply_monotonic(load to, rwedge_contact *contact);

/* What is wrong with a load: which of its four numbers, INPUT_COUNT for none of them, and the rest
 * of the sentence about it. */
typedef struct {
    int input;
    complaint why;
} load_fault;

/* What is wrong with a load that the contact has refused with this status. The contact is as before
 * the load. */
load_fault loads_fault(int32_t status, load to, double f, const rwedge_contact *contact);

/* Applies the next load of a history to a contact of that pad. False, with the reason, where the
 * contact refuses it, which is then as before, or where it reaches flanks that were left out. */
bool loads_apply_next(load to, const pad *shape, double f, rwedge_contact *contact, complaint *why);

/* Whether the contact is of the pad as it was measured. False, with the reason, where it reaches
 * flanks that were left out as too steep. */
bool loads_spare_flanks(const pad *shape, const rwedge_contact *contact, complaint *why);

/* ---- contact_case ---- One contact and its load, from the texts that give it. */

typedef struct {
    double E1, nu1, E2, nu2; /* E2 is HUGE_VAL where body 2 is rigid */
    pad shape;
    double P, M, Q, sigma, f;
    double k;             /* NAN where not given */
    double A;             /* composite compliance */
    double beta;          /* Dundurs' second constant */
    bool is_coupled;      /* friction changes the pressure: beta is not 0, and not neglected */
    rotation rotation;    /* as it is said */
    double tolerance;     /* as the texts have it */
    bool is_plane_stress; /* nu1 and nu2 are 0 then */
    /* under these loads, which come as loads_apply_monotonic() has them, or by a history */
    rwedge_contact *contact;
    bool has_history;
    bool is_held; /* at the tilt; M is then a result */
    double tilt;
    int32_t status; /* of the library, when it was asked to apply the loads */
    int at_fault;   /* the input that it refused them for; INPUT_COUNT for none */
} contact_case;

/* The radius of a cylinder on a plane that touches as two cylinders do. */
double case_radius(double radius1, double radius2);

/* What must be given beside the bodies and their shape. */
typedef enum {
    CASE_LOADS_APART, /* nothing: a history has the loads, and f may be 0 */
    CASE_OF_HISTORY,  /* f: a history has the loads */
    CASE_WITH_LOADS,  /* P */
    CASE_OF_SOLVE     /* P; f too where Q, sigma or a yield stress is: 0 would look like a result */
} case_needs;

/* Checks which inputs are given. False, with the complaint, where two exclude each other, or a
 * needed one is missing. */
bool case_is_complete(const input_texts *texts, case_needs needs, complaint *why);

/* Reads a case, and makes its contact; loads and f are 0 where they are not given. False, with the
 * complaint, where a value is wrong. Loads that the library refuses for no input are no wrong
 * value: the status tells them. Destroy the contact also after an error. */
bool case_read(const input_texts *texts, case_needs needs, contact_case *setup, complaint *why);

/* The tolerance that the texts give, or the usual one, which is larger where bodies are coupled:
 * they take longer. */
double case_tolerance(const input_texts *texts, bool is_coupled);

/* Makes the contact of a case, without loads; returns the library's status. Destroy the contact
 * also after an error. */
int32_t case_contact(const contact_case *setup, rwedge_contact **contact);

/* The largest pressure of the case with another profile, under its P and M alone; NAN where it is
 * not known. */
double case_peak_pressure(const contact_case *setup, const pad_profile *places);

/* Q/(fP), of magnitude 1 at the most; 0 where f or Q is. */
double case_shear_ratio(const contact_case *setup);

/* ---- coupling ---- What friction of unlike bodies does to a contact. */

/* Against similar bodies under the same loads, which were pressed first: how far the contact
 * moves, over its half-width, below 0 towards the trailing edge; and by which part the tension
 * beside that edge is higher. NAN where it is not known; 0 where bodies are not coupled. */
typedef struct {
    double swing, tension;
} coupling;

/* After a history the tension is not known. */
coupling coupling_of(const contact_case *setup, const rwedge_contact *contact, bool has_history);

/* ---- doubts ---- What makes results doubtful: the bits of rwedge_validity(), the error of a
 * computed contact, and their texts. */

typedef struct {
    int32_t bits;
    double error;     /* rwedge_contact_error(), 0 where there is a closed form */
    double tolerance; /* that was asked for; an error up to it is told, but is no doubt */
    double hull;      /* what the hull of a profile changes in the contact, over the pad's rise */
    coupling coupled; /* what friction of unlike bodies does, told as the error is */
} doubts;

/* The error of a contact. */
doubts doubts_of_error(const rwedge_contact *contact);

/* Whether there is more than an error up to the tolerance. */
bool doubts_matter(doubts all);

/* The doubts about a contact with these edges, both 0 where it is separated; safety is P_yield/P,
 * NAN where it is not known. */
doubts doubts_of(const contact_case *setup, double left, double right, double safety);

/* The doubts about the present state of a contact. It may yield by P, or by a tension or moment
 * under a P that alone would not make it yield. */
doubts doubts_of_state(const contact_case *setup, const rwedge_contact *contact);

/* The doubt of a contact in a history that slides fully, or none. */
int32_t doubt_of_sliding(const rwedge_contact *contact);

/* The doubt of a contact that a rig has driven further than its half-width, or none. */
int32_t doubt_of_way(const rwedge_contact *contact);

/* The doubt of a contact that sticks in several zones, or none. */
int32_t doubt_of_zones(const rwedge_contact *contact);

/* The same where rwedge_contact_yield_factor() is known; NAN is not known. */
doubts doubts_of_factor(const contact_case *setup, const rwedge_contact *contact, double factor);

/* Adds the doubts about another state; the error is the larger one. */
void doubts_add(doubts *all, doubts more);

/* Removes the first doubt and writes its text. False where none is left. */
enum { DOUBT_SIZE = 200 };
bool doubts_next(doubts *left, char text[DOUBT_SIZE]);

/* Adds the texts of the doubts to a list that is separated by "; ". */
void doubts_write(doubts all, char *text, size_t size);

/* ---- zones ---- The zones of a contact that stick, from left to right. */

typedef struct {
    size_t count;
    double *left, *right; /* their edges */
} stick_zones;

stick_zones stick_zones_of(const rwedge_contact *contact); /* to be freed */
bool stick_zones_have(const stick_zones *zones, double x); /* inside of one of them */
void stick_zones_free(stick_zones *zones);

/* ---- tensor ---- The stress at a point of body 1, and what follows from it. */

enum {
    TENSOR_SXX,
    TENSOR_SYY,
    TENSOR_TXY,
    TENSOR_VON_MISES,
    TENSOR_S1,
    TENSOR_SZZ,
    TENSOR_S2,
    TENSOR_TAU_MAX,
    TENSOR_S1_ANGLE, /* in degrees */
    TENSOR_COUNT
};

/* The columns; the first three need no words. */
extern const column_kind tensor_kinds[TENSOR_COUNT];

typedef struct {
    double value[TENSOR_COUNT];
} tensor;

tensor tensor_of(double sxx, double syy, double txy, double nu);

/* The edges of a contact, and sxx there. Returns the library's status. */
int32_t edge_tensions(const rwedge_contact *contact, double edge[2], double sxx[2]);

/* A place of first yield is found within rounding: what is rounding beside its other coordinate is
 * 0, so that the middle and the surface are told as such. */
void yield_place_settle(double *x, double *y);

/* The tensor where the stress is infinite: all NAN. */
tensor tensor_unknown(void);

/* C99 does not name them. */
static const double PI = 3.14159265358979323846, SQRT_3 = 1.7320508075688772;

/* An angle of the library, in degrees. */
double degrees(double angle);

#endif
