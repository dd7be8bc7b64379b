/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "pad.h"

#include "text/text.h"
#include "number/number.h"

#include <float.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

pad pad_wedge(double theta, double a)
{
    return (pad){PAD_WEDGE, theta, a, NAN, rwedge_radius(theta, a), NULL};
}

pad pad_cylinder(double radius)
{
    return (pad){PAD_CYLINDER, 1, radius, NAN, radius, NULL};
}

pad pad_flat(double flat, double radius)
{
    return (pad){PAD_FLAT, NAN, NAN, flat, radius, NULL};
}

pad pad_of_profile(const pad_profile *places)
{
    return (pad){PAD_PROFILE, NAN, NAN, NAN, NAN, places};
}

bool pad_has_formulas(const pad *shape)
{
    return shape->kind == PAD_WEDGE || shape->kind == PAD_CYLINDER;
}

int32_t pad_contact(const pad *shape, double A, double f, rwedge_contact **contact)
{
    *contact = NULL;
    if (shape->kind == PAD_WEDGE)
        return rwedge_contact_create(shape->theta, shape->a, A, f, contact);
    if (shape->kind == PAD_PROFILE)
        return rwedge_contact_create_profile(shape->places->count, shape->places->x,
                                             shape->places->slope, A, f, contact);
    return rwedge_contact_create_flat(shape->kind == PAD_FLAT ? shape->flat : 0, shape->radius, A,
                                      f, contact);
}

double pad_half_width(const pad *shape, double A, double P)
{
    rwedge_contact *contact = NULL;
    double b = NAN;
    if (shape->kind == PAD_WEDGE)
        return rwedge_half_width(shape->theta, shape->a, A, P);
    if (pad_contact(shape, A, 0, &contact) == RWEDGE_OK &&
        rwedge_contact_load(contact, P, 0) == RWEDGE_OK)
        b = rwedge_contact_half_width(contact);
    rwedge_contact_destroy(contact);
    return b;
}

bool pad_is_kink(const pad *shape, double x)
{
    const pad_profile *places = shape->places;
    if (places == NULL)
        return shape->a == 0 && x == 0;
    for (size_t i = 1; i < places->count; i++)
        if (places->x[i - 1] == x && places->x[i] == x && places->slope[i] > places->slope[i - 1])
            return true;
    return false;
}

size_t pad_corners(const pad *shape)
{
    return shape->places != NULL ? shape->places->count : 2;
}

double pad_corner(const pad *shape, size_t i)
{
    if (shape->places != NULL)
        return shape->places->x[i];
    const double end = shape->kind == PAD_FLAT ? shape->flat : shape->a;
    return i == 0 ? -end : end;
}

static double slope_at(const pad_profile *places, double x)
{
    size_t i = 0;
    while (i < places->count && places->x[i] <= x)
        i++;
    if (i == 0 || i == places->count)
        return places->slope[i == 0 ? 0 : i - 1];
    const double part = (x - places->x[i - 1]) / (places->x[i] - places->x[i - 1]);
    return places->slope[i - 1] + part * (places->slope[i] - places->slope[i - 1]);
}

double pad_steepest(const pad *shape, double left, double right)
{
    if (shape->kind == PAD_WEDGE)
        return shape->theta;
    if (shape->kind == PAD_PROFILE)
        return fmax(-slope_at(shape->places, left), slope_at(shape->places, right));
    const double from = shape->kind == PAD_FLAT ? shape->flat : 0;
    return (fmax(-left, right) - from) / shape->radius;
}

/* ---- Profiles ---- */

static const double STEEPEST = 1.5707963267948966, SIZE_MOST = 1e60;

/* "slope 0.1: " and what is wrong with it. */
static bool refuse(profile_remark *remark, size_t place, const char *column, double value,
                   const char *why)
{
    remark->place = place;
    snprintf(remark->text, sizeof remark->text, "%s %.6g: %s", column, value + 0, why);
    return false;
}

static bool has_count(size_t n, size_t most, profile_remark *remark)
{
    remark->place = n > 0 ? n - 1 : 0;
    snprintf(remark->text, sizeof remark->text, "%zu places; allowed: 2 to %zu", n, most);
    return n >= 2 && n <= most;
}

static bool has_order(size_t n, const double x[], bool apart, profile_remark *remark)
{
    for (size_t i = 0; i < n; i++) {
        if (!(fabs(x[i]) <= SIZE_MOST))
            return refuse(remark, i, "x", x[i], "must be at most 1e60 in magnitude");
        if (i > 0 && x[i] < x[i - 1])
            return refuse(remark, i, "x", x[i],
                          "left of the place before it; allowed: places from left to right");
        if (i > 0 && apart && x[i] == x[i - 1])
            return refuse(remark, i, "x", x[i], "there twice; heights need places apart");
    }
    return true;
}

/* ---- Slopes ---- */

static bool is_convex(size_t n, const double slope[], profile_remark *remark)
{
    for (size_t i = 0; i < n; i++) {
        if (!(fabs(slope[i]) < STEEPEST))
            return refuse(remark, i, "slope", slope[i], "must be below pi/2 in magnitude");
        if (i > 0 && slope[i] < slope[i - 1])
            return refuse(remark, i, "slope", slope[i],
                          "less than the slope before it: the profile is not convex there; "
                          "allowed: slopes that do not fall");
    }
    return slope[n - 1] > slope[0] ||
           refuse(remark, n - 1, "slope", slope[n - 1], "all slopes are equal: a plane");
}

bool pad_profile_of_slopes(size_t n, const double x[], const double slope[], pad_profile *to,
                           profile_remark *remark)
{
    if (!has_count(n, PROFILE_PLACES, remark) || !has_order(n, x, false, remark) ||
        !is_convex(n, slope, remark))
        return false;
    to->count = n;
    memcpy(to->x, x, n * sizeof *x);
    memcpy(to->slope, slope, n * sizeof *slope);
    remark->text[0] = '\0';
    return true;
}

/* ---- Heights ---- */

enum { HEIGHTS = PROFILE_PLACES + 1 };

typedef struct {
    size_t count, corner[HEIGHTS]; /* the places that are on the hull */
} hull;

static double rise(const double x[], const double h[], size_t i, size_t j)
{
    return (h[j] - h[i]) / (x[j] - x[i]);
}

/* Heights in a straight line stay on it to rounding. */
static hull hull_of(size_t n, const double x[], const double h[])
{
    hull lower = {.count = 0};
    for (size_t i = 0; i < n; i++) {
        while (lower.count > 1) {
            const size_t before = lower.corner[lower.count - 2],
                         last = lower.corner[lower.count - 1];
            const double size = fabs(h[before]) + fabs(h[last]) + fabs(h[i]);
            const double rounding =
                4 * DBL_EPSILON * size / fmin(x[i] - x[last], x[last] - x[before]);
            if (rise(x, h, last, i) >= rise(x, h, before, last) - rounding)
                break;
            lower.count--;
        }
        lower.corner[lower.count++] = i;
    }
    return lower;
}

/* The places above the hull, and how far. */
typedef struct {
    size_t count, first, worst;
    double most;
    char list[120]; /* "1, 2, 3 and 5 more" */
} excess;

static excess excess_of(const hull *lower, const double x[], const double h[])
{
    enum { LISTED = 5 };
    excess above = {.count = 0};
    for (size_t k = 1; k < lower->count; k++) {
        const size_t from = lower->corner[k - 1], to = lower->corner[k];
        for (size_t i = from + 1; i < to; i++) {
            const double height = h[i] - h[from] - rise(x, h, from, to) * (x[i] - x[from]);
            above.first = above.count == 0 ? i : above.first;
            above.worst = above.count == 0 || height > above.most ? i : above.worst;
            above.most = fmax(above.most, height);
            if (above.count++ < LISTED)
                list_add(above.list, sizeof above.list, ", ", "%.6g", x[i] + 0);
            else if (above.count == LISTED + 1)
                list_add(above.list, sizeof above.list, ", ", "...");
        }
    }
    return above;
}

/* Rounding may have let a slope fall. */
static void take_slopes(const hull *lower, const double x[], const double h[], double slope[])
{
    for (size_t k = 1; k < lower->count; k++) {
        double next = rise(x, h, lower->corner[k - 1], lower->corner[k]);
        if (k > 1)
            next = fmax(next, slope[lower->corner[k - 1] - 1]);
        for (size_t i = lower->corner[k - 1]; i < lower->corner[k]; i++)
            slope[i] = next;
    }
}

bool pad_profile_of_heights(size_t n, const double x[], const double height[], bool takes_hull,
                            pad_profile *to, profile_remark *remark)
{
    double middle[HEIGHTS], slope[HEIGHTS];
    char why[360];
    profile_remark changed = {.place = 0};
    if (!has_count(n, HEIGHTS, remark) || !has_order(n, x, true, remark))
        return false;
    const hull lower = hull_of(n, x, height);
    const excess above = excess_of(&lower, x, height);
    snprintf(
        why, sizeof why,
        "not convex at %zu place%s, x = %s; the convex hull %s lower by up to %.6g, at x = %.6g",
        above.count, above.count > 1 ? "s" : "", above.list, takes_hull ? "that is taken is" : "is",
        above.most, x[above.worst] + 0);
    if (above.count > 0)
        refuse(&changed, above.first, "height", height[above.first], why);
    take_slopes(&lower, x, height, slope);
    for (size_t i = 1; i < n; i++)
        middle[i - 1] = x[i - 1] / 2 + x[i] / 2;
    const bool done =
        (above.count == 0 || takes_hull) && pad_profile_of_slopes(n - 1, middle, slope, to, remark);
    if (done || !(above.count == 0 || takes_hull))
        *remark = changed;
    return done;
}
