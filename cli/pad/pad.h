/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef CLI_PAD_H
#define CLI_PAD_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include <rwedge.h>

/* ---- profile ---- The profile of a pad by its slopes at places, linear between them. */

enum { PROFILE_PLACES = 1000 };

typedef struct {
    size_t count;
    double x[PROFILE_PLACES], slope[PROFILE_PLACES];
    double left, right; /* the outermost heights; of slopes, which stay beyond, infinite */
    bool is_cut;        /* flanks beyond them were left out */
    /* of heights: where they were measured, and how far they are above the profile that was made
     * of them by hull or fit; none where they are convex */
    size_t scanned;
    double *scan_x, *above;
    int32_t arcs; /* of a fit; 0 of none */
    double rms;   /* of what a fit leaves */
} pad_profile;

void pad_profile_free(pad_profile *profile);

/* Places as a file has them, from left to right, and the line of each. */
typedef struct {
    size_t count;
    double *x, *value; /* slopes or heights */
    int64_t *line;
} scan;

/* Puts places in order; those of heights that are equal become one, with the mean of the heights.
 * Returns how many that were. */
size_t scan_settle(scan *all, bool are_heights);

/* How a profile is made of a scan. */
typedef struct {
    bool takes_hull;     /* of heights that are not convex */
    bool fits;           /* the convex profile nearest to the heights */
    int32_t arcs;        /* of the fit; 0 for as many as the heights ask for */
    bool is_down;        /* heights point away from body 2 */
    bool is_from_lowest; /* x is to be 0 at the lowest place */
    bool keeps_places;   /* those of the file stay, as they are there */
    bool takes_unnamed;  /* columns without names are x and height */
    bool is_command;     /* messages may name options */
} profile_making;

/* What is wrong with it, and in which line; or what is to be known of it. */
typedef struct {
    int64_t line; /* 0 for none */
    char text[450];
} profile_remark;

/* Makes a profile from slopes. False, with the remark, where they are not convex. */
bool pad_profile_of_slopes(const scan *given, const profile_making *how, pad_profile *to,
                           profile_remark *remark);

/* Makes a profile from heights above the surface: the slope of the line between two places is the
 * slope in their middle. Where the hull or a fit is asked for, the remark says what it changes.
 * False, with the remark, where no profile can be made of them. */
bool pad_profile_of_heights(const scan *given, const profile_making *how, pad_profile *to,
                            profile_remark *remark);

/* Its height at x above its lowest place. */
double pad_profile_height(const pad_profile *profile, double x);

/* What the hull that was taken of it changes between left and right, at most, over the rise from
 * its lowest place to the farther of the two; 0 where none was taken. */
double pad_profile_hull_share(const pad_profile *profile, double left, double right);

/* Its lowest place, the middle of a flat one; NAN where an end is the lowest. */
double pad_profile_lowest(const pad_profile *profile);

/* ---- pad_fit ---- What a fit leaves, and what other fits of the same heights are. */

/* The largest distance of the heights from the fit between two places, and where; 0 for none. */
double pad_fit_residue(const pad_profile *profile, double left, double right, double *x);

/* How far the outer arc rises from its inner end to the right edge of the contact, or the left one,
 * where it is curved more than the arc beside it, so that the pressure has a lobe there; else
 * HUGE_VAL. */
double pad_fit_lobe(const pad_profile *profile, double left, double right, bool is_right);

/* Fits the same heights by another number of arcs. False where that cannot be. Free the profile. */
bool pad_fit_again(const pad_profile *profile, int32_t arcs, pad_profile *to);

/* ---- pad ---- The shape of body 2. */

typedef enum { PAD_WEDGE, PAD_CYLINDER, PAD_FLAT, PAD_PROFILE } pad_kind;

/* NAN where a kind has no such size. */
typedef struct {
    pad_kind kind;
    double theta, a; /* of the wedge; a cylinder is one of the angle 1, only its rounding touches */
    double flat;     /* half the width of the flat */
    double radius;   /* of the rounding, the cylinder, the edges of the flat */
    const pad_profile *places;
} pad;

pad pad_wedge(double theta, double a);
pad pad_cylinder(double radius);
pad pad_flat(double flat, double radius);
pad pad_of_profile(const pad_profile *places);

/* Whether the formulas of the wedge hold, with its theta and a. */
bool pad_has_formulas(const pad *shape);

/* Makes a contact of the pad, without loads; returns the library's status. Destroy the contact also
 * after an error. */
int32_t pad_contact(const pad *shape, double A, double f, rwedge_contact **contact);

/* The half-width of its contact under P alone; NAN where the pad cannot bear P. */
double pad_half_width(const pad *shape, double A, double P);

/* Its height over its lowest place, as it is before it touches. */
double pad_height(const pad *shape, double x);

/* Whether the pressure is infinite at x, where x is in contact. */
bool pad_is_kink(const pad *shape, double x);

/* The steepest slope of the profile between left and right; that of a wedge is theta. */
double pad_steepest(const pad *shape, double left, double right);

#endif
