/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef CLI_PAD_H
#define CLI_PAD_H

#include <stdbool.h>
#include <stddef.h>

#include <rwedge.h>

/* ---- pad ---- The profile of a pad by its slopes at places, linear between them. */

enum { PROFILE_PLACES = 1000 };

typedef struct {
    size_t count;
    double x[PROFILE_PLACES], slope[PROFILE_PLACES];
} pad_profile;

/* What is wrong with it, and at which of the places that were given; or what the hull has changed.
 */
typedef struct {
    size_t place;
    char text[450];
} profile_remark;

/* Makes a profile from slopes. False, with the remark, where they are not convex. */
bool pad_profile_of_slopes(size_t n, const double x[], const double slope[], pad_profile *to,
                           profile_remark *remark);

/* Makes a profile from heights above the surface: the slope of the line between two places is the
 * slope in their middle. Where the hull is asked for, heights that are not convex are lowered to
 * it, and the remark says by how much. False, with the remark, where they are not convex. */
bool pad_profile_of_heights(size_t n, const double x[], const double height[], bool takes_hull,
                            pad_profile *to, profile_remark *remark);

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

/* Whether the pressure is infinite at x, where x is in contact. */
bool pad_is_kink(const pad *shape, double x);

/* Places at which the curvature of the profile changes, or may be infinite: how many, and one of
 * them. */
size_t pad_corners(const pad *shape);
double pad_corner(const pad *shape, size_t i);

/* The steepest slope of the profile between left and right; that of a wedge is theta. */
double pad_steepest(const pad *shape, double left, double right);

#endif
