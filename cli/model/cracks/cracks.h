/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef CLI_CRACKS_H
#define CLI_CRACKS_H

#include "model/cycle/cycle.h"

/* ---- crack_law ---- The constants of its growth. */

/* Numbers in the unit of the lengths; NAN where not given. */
typedef struct {
    double dK_th, ds0, C, m, K_c;
} crack_law;

/* The exponents m that the library takes. */
static const double crack_least_m = 0.1, crack_most_m = 100;

crack_law crack_law_of(const material *constants);

/* Which constant lacks beside another: its name as that of a material, and that of the other. NULL
 * where none does. */
const char *crack_law_lacks(const crack_law *law, const char **beside);

bool crack_has_threshold(const crack_law *law);
double crack_threshold(const crack_law *law, double length); /* NAN without */
bool crack_has_rate(const crack_law *law);

/* ---- crack_forces ---- What the cycle does to a crack of several lengths, as the library has it.
 * Angles are in degrees. */

/* How K_II counts: RWEDGE_FACES_MODE_I and so on. */
enum { SHEARS = 3 };
extern const char *const shear_names[SHEARS];

typedef struct {
    const last_cycle *last;
    double x;
    double *length; /* ascending */
    size_t lengths;
    bool is_wanted[SHEARS];
    const char *unit; /* of length, for sentences */
    crack_law law;
} crack_case;

/* Gives n lengths from one to another, each longer by the same factor. */
void crack_lengths(double from, double to, size_t n, double length[]);

/* K of an angle after each load for each length; of loads times lengths numbers each, to be freed
 * at I. share is of the line where faces overlap, or touch where they press. */
typedef struct {
    double *I, *II, *share;
    int32_t status; /* of the library */
} crack_K;
crack_K crack_K_of(const crack_case *crack, double angle, bool presses);

/* What the cycle changes of K at each length, to be freed at I: of the shear k and the length j at
 * [lengths k + j]; 0 where the shear is not wanted. */
typedef struct {
    double *I, *II, *K_max, *R;
    int32_t status;
} crack_ranges;

/* The ranges by K of faces that pass through each other; NULL where faces press. */
crack_ranges crack_ranges_of(const crack_case *crack, double angle, const crack_K *K);

/* The growth from one length to another. */
typedef struct {
    double end, cycles, least, least_at; /* as rwedge_cycle_growth() has them */
    double first;                        /* dK over the threshold at the first length */
    int32_t status;
} crack_growth;

/* The growth of faces that press, or that pass through each other; `first` is 0. */
crack_growth crack_growth_of(const crack_case *crack, double angle, bool presses, int shear,
                             double from, double to);

/* The growth from the first length to the last, of faces that press. */
crack_growth crack_verdict_of(const crack_case *crack, double angle, int shear);

bool crack_grows(const crack_growth *g); /* it does not stop */

/* ---- crack_words ---- What becomes of a crack, in sentences without their full stop. */

enum { CRACK_SENTENCE = 600 };

/* One way in which K_II counts. */
void crack_sentence(const crack_case *crack, int shear, const crack_growth *g,
                    char text[CRACK_SENTENCE]);

/* All ways that are wanted, in one sentence; how many they are. */
int crack_sentence_of_all(const crack_case *crack, const crack_growth growth[SHEARS],
                          char text[CRACK_SENTENCE]);

/* Says that the contact is as if there were no crack, where the crack is too long for it; else
 * empty. */
void crack_length_said(const crack_case *crack, char text[CRACK_SENTENCE]);

#endif
