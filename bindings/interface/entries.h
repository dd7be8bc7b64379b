/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Written by bindings/interface/generate.py from include/rwedge.h: change that, not this.
 *
 * Every function of the header that has a number among its arguments or results, or makes an
 * object, as a call of one form. Not here are rwedge_version() and those that free. */
/* clang-format off */
#ifndef RWEDGE_ENTRIES_H
#define RWEDGE_ENTRIES_H

#include "rwedge.h"

#include <float.h>
#include <math.h>
#include <string.h>

enum {
    ENTRY_ARGUMENTS = 12, /* the most that a function has */
    ENTRY_RESULTS = 5,
    ENTRY_SIZES = 2
};

/* v: the numbers, each a pointer to one or to an array; n: the sizes; r: the results likewise. An
 * integer is a double that is whole and fits. A function with a value has the status RWEDGE_OK. The
 * value of a function with a text is the text's length. */
typedef int32_t entry_call(void *object, const size_t n[], const double *const v[],
                           double *const r[], void **made);
typedef const char *entry_text(const void *object, const double *const v[]);

typedef struct {
    const char *name;
    const char *allowed; /* the header's conditions */
    double low, high;
    double smallest; /* but for 0, nothing smaller in magnitude is inside */
    char low_open, high_open; /* the bound itself is outside */
    char or_zero;             /* 0 is inside, though below low */
    char finite;              /* infinity is outside */
    char whole;               /* an int32_t */
    char any;                 /* any double, not a number too */
    signed char sizes[2];     /* of an array, as of a result */
} entry_argument;

typedef struct {
    const char *name;
    signed char sizes[2]; /* of an array, or of two dimensions: which of the sizes; -1 for none */
    char optional;        /* may be NULL */
} entry_result;

typedef struct {
    const char *name;
    const char *teller; /* the function that tells the size, or NULL where an array does */
    const char *allowed;
} entry_size;

typedef struct {
    const char *name;
    const char *family; /* "contact", "series", or "" */
    entry_call *call;
    entry_text *text; /* or NULL where there is none */
    char takes_object, changes_object, makes_object, has_status;
    char pointwise;       /* all its arrays are of one size, point by point */
    char refuses_more;    /* arguments too of which each by itself is inside */
    char may_be_infinite; /* its value */
    unsigned errors;      /* 1 << status, for those that the header names */
    const char *array_of; /* the function whose results it gives for many points, or NULL */
    int arguments, results, sizes;
    const entry_argument *argument;
    const entry_result *result;
    const entry_size *size;
} entry;

/* Whether a number is inside the domain of an argument, by itself. */
static inline int entry_allows(const entry_argument *a, double v)
{
    if (a->any)
        return 1;
    if (isnan(v) || isinf(v))
        return !isnan(v) && !a->finite && v > 0;
    if (a->whole && (v != floor(v) || v < INT32_MIN || v > INT32_MAX))
        return 0;
    if (v == 0 && a->or_zero)
        return 1;
    return v >= a->low && v <= a->high && !(a->low_open && v == a->low) &&
           !(a->high_open && v == a->high) && (v == 0 || fabs(v) >= a->smallest);
}

#define ENTRY(name, statements)                                                                    \
    static int32_t entry_##name(void *object, const size_t n[], const double *const v[],           \
                                double *const r[], void **made)                                    \
    {                                                                                              \
        (void)object, (void)n, (void)v, (void)r, (void)made;                                       \
        statements;                                                                                \
    }

#define TEXT_ENTRY(name, value)                                                                    \
    static const char *text_##name(const void *object, const double *const v[])                    \
    {                                                                                              \
        (void)object, (void)v;                                                                     \
        return value;                                                                              \
    }                                                                                              \
    ENTRY(name, const char *const text = text_##name(object, v);                                   \
          r[0][0] = text ? (double)strlen(text) : NAN; return RWEDGE_OK)

TEXT_ENTRY(strerror, rwedge_strerror((int32_t)v[0][0]))
static const entry_argument strerror_arguments[] = {
    {"status", "whole, any integer", -INFINITY, INFINITY, 0.0, 0, 0, 0, 1, 1, 1, {-1, -1}}};
static const entry_result strerror_results[] = {
    {"value", {-1, -1}, 0}};

ENTRY(compliance, r[0][0] = rwedge_compliance(v[0][0], v[1][0], v[2][0], v[3][0]); return RWEDGE_OK)
static const entry_argument compliance_arguments[] = {
    {"E1", "1e-60 to 1e60, or infinite", 0.0, 1e+60, 1e-60, 1, 0, 0, 0, 0, 0, {-1, -1}},
    {"nu1", "-1 < nu <= 0.5", -1.0, 0.5, 0.0, 1, 0, 0, 1, 0, 0, {-1, -1}},
    {"E2", "1e-60 to 1e60, or infinite", 0.0, 1e+60, 1e-60, 1, 0, 0, 0, 0, 0, {-1, -1}},
    {"nu2", "-1 < nu <= 0.5", -1.0, 0.5, 0.0, 1, 0, 0, 1, 0, 0, {-1, -1}}};
static const entry_result compliance_results[] = {
    {"value", {-1, -1}, 0}};

ENTRY(dundurs_beta, r[0][0] = rwedge_dundurs_beta(v[0][0], v[1][0], v[2][0], v[3][0]); return
      RWEDGE_OK)
static const entry_argument dundurs_beta_arguments[] = {
    {"E1", "1e-60 to 1e60, or infinite", 0.0, 1e+60, 1e-60, 1, 0, 0, 0, 0, 0, {-1, -1}},
    {"nu1", "-1 < nu <= 0.5", -1.0, 0.5, 0.0, 1, 0, 0, 1, 0, 0, {-1, -1}},
    {"E2", "1e-60 to 1e60, or infinite", 0.0, 1e+60, 1e-60, 1, 0, 0, 0, 0, 0, {-1, -1}},
    {"nu2", "-1 < nu <= 0.5", -1.0, 0.5, 0.0, 1, 0, 0, 1, 0, 0, {-1, -1}}};
static const entry_result dundurs_beta_results[] = {
    {"value", {-1, -1}, 0}};

ENTRY(load, r[0][0] = rwedge_load(v[0][0]); return RWEDGE_OK)
static const entry_argument load_arguments[] = {
    {"alpha", "0, or 1e-60 to 1e60", 0.0, 1e+60, 1e-60, 0, 0, 0, 1, 0, 0, {-1, -1}}};
static const entry_result load_results[] = {
    {"value", {-1, -1}, 0}};

ENTRY(a_over_b, r[0][0] = rwedge_a_over_b(v[0][0]); return RWEDGE_OK)
static const entry_argument a_over_b_arguments[] = {
    {"AP_over_theta_a", "> 0, finite", 0.0, INFINITY, 0.0, 1, 0, 0, 1, 0, 0, {-1, -1}}};
static const entry_result a_over_b_results[] = {
    {"value", {-1, -1}, 0}};

ENTRY(pressure, r[0][0] = rwedge_pressure(v[0][0], v[1][0]); return RWEDGE_OK)
static const entry_argument pressure_arguments[] = {
    {"alpha", "0, or 1e-60 to 1e60", 0.0, 1e+60, 1e-60, 0, 0, 0, 1, 0, 0, {-1, -1}},
    {"x", "0, or 1e-60 to 1e60 in magnitude", -1e+60, 1e+60, 1e-60, 0, 0, 0, 1, 0, 0, {-1, -1}}};
static const entry_result pressure_results[] = {
    {"value", {-1, -1}, 0}};

ENTRY(peak_pressure, r[0][0] = rwedge_peak_pressure(v[0][0]); return RWEDGE_OK)
static const entry_argument peak_pressure_arguments[] = {
    {"alpha", "0, or 1e-60 to 1e60", 0.0, 1e+60, 1e-60, 0, 0, 0, 1, 0, 0, {-1, -1}}};
static const entry_result peak_pressure_results[] = {
    {"value", {-1, -1}, 0}};

ENTRY(transition_pressure, r[0][0] = rwedge_transition_pressure(v[0][0]); return RWEDGE_OK)
static const entry_argument transition_pressure_arguments[] = {
    {"alpha", "0, or 1e-60 to 1e60", 0.0, 1e+60, 1e-60, 0, 0, 0, 1, 0, 0, {-1, -1}}};
static const entry_result transition_pressure_results[] = {
    {"value", {-1, -1}, 0}};

ENTRY(coefficient, r[0][0] = rwedge_coefficient(v[0][0], (int32_t)v[1][0]); return RWEDGE_OK)
static const entry_argument coefficient_arguments[] = {
    {"alpha", "0, or 1e-60 to 1e60", 0.0, 1e+60, 1e-60, 0, 0, 0, 1, 0, 0, {-1, -1}},
    {"n", "whole, >= 0", 0.0, INFINITY, 0.0, 0, 0, 0, 1, 1, 0, {-1, -1}}};
static const entry_result coefficient_results[] = {
    {"value", {-1, -1}, 0}};

ENTRY(stick_width, r[0][0] = rwedge_stick_width(v[0][0], v[1][0]); return RWEDGE_OK)
static const entry_argument stick_width_arguments[] = {
    {"alpha", "0, or 1e-60 to 1e60", 0.0, 1e+60, 1e-60, 0, 0, 0, 1, 0, 0, {-1, -1}},
    {"Q_over_fP", "0 <= Q/(fP) <= 1", 0.0, 1.0, 0.0, 0, 0, 0, 1, 0, 0, {-1, -1}}};
static const entry_result stick_width_results[] = {
    {"value", {-1, -1}, 0}};

ENTRY(shear_ratio, r[0][0] = rwedge_shear_ratio(v[0][0], v[1][0]); return RWEDGE_OK)
static const entry_argument shear_ratio_arguments[] = {
    {"alpha", "0, or 1e-60 to 1e60", 0.0, 1e+60, 1e-60, 0, 0, 0, 1, 0, 0, {-1, -1}},
    {"c", "0 <= c <= 1, 0 or at least 1e-60", 0.0, 1.0, 1e-60, 0, 0, 0, 1, 0, 0, {-1, -1}}};
static const entry_result shear_ratio_results[] = {
    {"value", {-1, -1}, 0}};

ENTRY(shear, r[0][0] = rwedge_shear(v[0][0], v[1][0], v[2][0]); return RWEDGE_OK)
static const entry_argument shear_arguments[] = {
    {"alpha", "0, or 1e-60 to 1e60", 0.0, 1e+60, 1e-60, 0, 0, 0, 1, 0, 0, {-1, -1}},
    {"c", "0 <= c <= 1, 0 or at least 1e-60", 0.0, 1.0, 1e-60, 0, 0, 0, 1, 0, 0, {-1, -1}},
    {"x", "0, or 1e-60 to 1e60 in magnitude", -1e+60, 1e+60, 1e-60, 0, 0, 0, 1, 0, 0, {-1, -1}}};
static const entry_result shear_results[] = {
    {"value", {-1, -1}, 0}};

ENTRY(stress, return rwedge_stress(v[0][0], v[1][0], v[2][0], v[3][0], v[4][0], r[0], r[1], r[2]))
static const entry_argument stress_arguments[] = {
    {"alpha", "0, or 1e-60 to 1e60", 0.0, 1e+60, 1e-60, 0, 0, 0, 1, 0, 0, {-1, -1}},
    {"f", "0 <= f <= 1e6, 0 or at least 1e-60", 0.0, 1000000.0, 1e-60, 0, 0, 0, 1, 0, 0, {-1, -1}},
    {"c", "0 <= c <= 1, 0 or at least 1e-60", 0.0, 1.0, 1e-60, 0, 0, 0, 1, 0, 0, {-1, -1}},
    {"x", "0, or 1e-60 to 1e60 in magnitude, not the apex (0, 0) of the sharp wedge", -1e+60, 1e+60, 1e-60, 0, 0, 0, 1, 0, 0, {-1, -1}},
    {"y", "0, or 1e-60 to 1e60, not the apex (0, 0) of the sharp wedge", 0.0, 1e+60, 1e-60, 0, 0, 0, 1, 0, 0, {-1, -1}}};
static const entry_result stress_results[] = {
    {"sxx", {-1, -1}, 0},
    {"syy", {-1, -1}, 0},
    {"txy", {-1, -1}, 0}};

ENTRY(stresses, return rwedge_stresses(v[0][0], v[1][0], v[2][0], n[0], v[3], v[4], r[0], r[1],
      r[2]))
static const entry_argument stresses_arguments[] = {
    {"alpha", "0, or 1e-60 to 1e60", 0.0, 1e+60, 1e-60, 0, 0, 0, 1, 0, 0, {-1, -1}},
    {"f", "0 <= f <= 1e6, 0 or at least 1e-60", 0.0, 1000000.0, 1e-60, 0, 0, 0, 1, 0, 0, {-1, -1}},
    {"c", "0 <= c <= 1, 0 or at least 1e-60", 0.0, 1.0, 1e-60, 0, 0, 0, 1, 0, 0, {-1, -1}},
    {"x", "0, or 1e-60 to 1e60 in magnitude, not the apex (0, 0) of the sharp wedge", -1e+60, 1e+60, 1e-60, 0, 0, 0, 1, 0, 0, {0, -1}},
    {"y", "0, or 1e-60 to 1e60, not the apex (0, 0) of the sharp wedge", 0.0, 1e+60, 1e-60, 0, 0, 0, 1, 0, 0, {0, -1}}};
static const entry_result stresses_results[] = {
    {"sxx", {0, -1}, 0},
    {"syy", {0, -1}, 0},
    {"txy", {0, -1}, 0}};
static const entry_size stresses_sizes[] = {
    {"n", NULL, ""}};

ENTRY(max_tension, r[0][0] = rwedge_max_tension(v[0][0]); return RWEDGE_OK)
static const entry_argument max_tension_arguments[] = {
    {"alpha", "0, or 1e-60 to 1e60", 0.0, 1e+60, 1e-60, 0, 0, 0, 1, 0, 0, {-1, -1}}};
static const entry_result max_tension_results[] = {
    {"value", {-1, -1}, 0}};

ENTRY(elastic_limit, r[0][0] = rwedge_elastic_limit(v[0][0], v[1][0], v[2][0]); return RWEDGE_OK)
static const entry_argument elastic_limit_arguments[] = {
    {"alpha", "0, or 1e-14 to 1e60", 1e-14, 1e+60, 1e-60, 0, 0, 1, 1, 0, 0, {-1, -1}},
    {"f", "0 <= f <= 1e6, 0 or at least 1e-60", 0.0, 1000000.0, 1e-60, 0, 0, 0, 1, 0, 0, {-1, -1}},
    {"nu", "0 <= nu <= 0.5", 0.0, 0.5, 0.0, 0, 0, 0, 1, 0, 0, {-1, -1}}};
static const entry_result elastic_limit_results[] = {
    {"value", {-1, -1}, 0}};

ENTRY(elastic_limits, return rwedge_elastic_limits(n[0], v[0], v[1], v[2][0], r[0]))
static const entry_argument elastic_limits_arguments[] = {
    {"alpha", "0, or 1e-14 to 1e60", 1e-14, 1e+60, 1e-60, 0, 0, 1, 1, 0, 0, {0, -1}},
    {"f", "0 <= f <= 1e6, 0 or at least 1e-60", 0.0, 1000000.0, 1e-60, 0, 0, 0, 1, 0, 0, {0, -1}},
    {"nu", "0 <= nu <= 0.5", 0.0, 0.5, 0.0, 0, 0, 0, 1, 0, 0, {-1, -1}}};
static const entry_result elastic_limits_results[] = {
    {"limit", {0, -1}, 0}};
static const entry_size elastic_limits_sizes[] = {
    {"n", NULL, ""}};

ENTRY(yield_point, return rwedge_yield_point(v[0][0], v[1][0], v[2][0], r[0], r[1], r[2]))
static const entry_argument yield_point_arguments[] = {
    {"alpha", "0, or 1e-14 to 1e60", 1e-14, 1e+60, 1e-60, 0, 0, 1, 1, 0, 0, {-1, -1}},
    {"f", "0 <= f <= 1e6, 0 or at least 1e-60", 0.0, 1000000.0, 1e-60, 0, 0, 0, 1, 0, 0, {-1, -1}},
    {"nu", "0 <= nu <= 0.5", 0.0, 0.5, 0.0, 0, 0, 0, 1, 0, 0, {-1, -1}}};
static const entry_result yield_point_results[] = {
    {"limit", {-1, -1}, 0},
    {"x", {-1, -1}, 0},
    {"y", {-1, -1}, 0}};

ENTRY(subsurface_yield, return rwedge_subsurface_yield(v[0][0], v[1][0], v[2][0], r[0], r[1], r[2]))
static const entry_argument subsurface_yield_arguments[] = {
    {"alpha", "0, or 1e-14 to 1e60", 1e-14, 1e+60, 1e-60, 0, 0, 1, 1, 0, 0, {-1, -1}},
    {"f", "0 <= f <= 1e6, 0 or at least 1e-60", 0.0, 1000000.0, 1e-60, 0, 0, 0, 1, 0, 0, {-1, -1}},
    {"nu", "0 <= nu <= 0.5", 0.0, 0.5, 0.0, 0, 0, 0, 1, 0, 0, {-1, -1}}};
static const entry_result subsurface_yield_results[] = {
    {"limit", {-1, -1}, 0},
    {"x", {-1, -1}, 0},
    {"y", {-1, -1}, 0}};

ENTRY(surface_yield, return rwedge_surface_yield(v[0][0], v[1][0], v[2][0], r[0], r[1]))
static const entry_argument surface_yield_arguments[] = {
    {"alpha", "0, or 1e-14 to 1e60", 1e-14, 1e+60, 1e-60, 0, 0, 1, 1, 0, 0, {-1, -1}},
    {"f", "0 <= f <= 1e6, 0 or at least 1e-60", 0.0, 1000000.0, 1e-60, 0, 0, 0, 1, 0, 0, {-1, -1}},
    {"nu", "0 <= nu <= 0.5", 0.0, 0.5, 0.0, 0, 0, 0, 1, 0, 0, {-1, -1}}};
static const entry_result surface_yield_results[] = {
    {"limit", {-1, -1}, 0},
    {"x", {-1, -1}, 0}};

ENTRY(critical_friction, r[0][0] = rwedge_critical_friction(v[0][0], v[1][0]); return RWEDGE_OK)
static const entry_argument critical_friction_arguments[] = {
    {"alpha", "0, or 1e-14 to 1e60", 1e-14, 1e+60, 1e-60, 0, 0, 1, 1, 0, 0, {-1, -1}},
    {"nu", "0 <= nu <= 0.5", 0.0, 0.5, 0.0, 0, 0, 0, 1, 0, 0, {-1, -1}}};
static const entry_result critical_friction_results[] = {
    {"value", {-1, -1}, 0}};

ENTRY(validity, r[0][0] = (double)rwedge_validity(v[0][0], v[1][0], v[2][0], v[3][0], v[4][0],
      v[5][0]); return RWEDGE_OK)
static const entry_argument validity_arguments[] = {
    {"theta", "any number", -INFINITY, INFINITY, 0.0, 0, 0, 0, 1, 0, 1, {-1, -1}},
    {"alpha", "any number", -INFINITY, INFINITY, 0.0, 0, 0, 0, 1, 0, 1, {-1, -1}},
    {"beta", "any number", -INFINITY, INFINITY, 0.0, 0, 0, 0, 1, 0, 1, {-1, -1}},
    {"f", "any number", -INFINITY, INFINITY, 0.0, 0, 0, 0, 1, 0, 1, {-1, -1}},
    {"k_over_E", "any number", -INFINITY, INFINITY, 0.0, 0, 0, 0, 1, 0, 1, {-1, -1}},
    {"safety", "any number", -INFINITY, INFINITY, 0.0, 0, 0, 0, 1, 0, 1, {-1, -1}}};
static const entry_result validity_results[] = {
    {"value", {-1, -1}, 0}};

TEXT_ENTRY(validity_text, rwedge_validity_text((int32_t)v[0][0]))
static const entry_argument validity_text_arguments[] = {
    {"doubt", "whole, any integer", -INFINITY, INFINITY, 0.0, 0, 0, 0, 1, 1, 1, {-1, -1}}};
static const entry_result validity_text_results[] = {
    {"value", {-1, -1}, 0}};

ENTRY(radius, r[0][0] = rwedge_radius(v[0][0], v[1][0]); return RWEDGE_OK)
static const entry_argument radius_arguments[] = {
    {"theta", "0 < theta < pi/2, at least 1e-60", 0.0, 1.5707963267948966, 1e-60, 1, 1, 0, 1, 0, 0, {-1, -1}},
    {"a", "0, or 1e-60 to 1e60", 0.0, 1e+60, 1e-60, 0, 0, 0, 1, 0, 0, {-1, -1}}};
static const entry_result radius_results[] = {
    {"value", {-1, -1}, 0}};

ENTRY(rounding, r[0][0] = rwedge_rounding(v[0][0], v[1][0]); return RWEDGE_OK)
static const entry_argument rounding_arguments[] = {
    {"theta", "0 < theta < pi/2, at least 1e-60", 0.0, 1.5707963267948966, 1e-60, 1, 1, 0, 1, 0, 0, {-1, -1}},
    {"R", "0, or 1e-60 to 1e60", 0.0, 1e+60, 1e-60, 0, 0, 0, 1, 0, 0, {-1, -1}}};
static const entry_result rounding_results[] = {
    {"value", {-1, -1}, 0}};

ENTRY(half_width, r[0][0] = rwedge_half_width(v[0][0], v[1][0], v[2][0], v[3][0]); return RWEDGE_OK)
static const entry_argument half_width_arguments[] = {
    {"theta", "0 < theta < pi/2, at least 1e-60", 0.0, 1.5707963267948966, 1e-60, 1, 1, 0, 1, 0, 0, {-1, -1}},
    {"a", "0, or 1e-60 to 1e60", 0.0, 1e+60, 1e-60, 0, 0, 0, 1, 0, 0, {-1, -1}},
    {"A", "1e-60 to 1e60", 0.0, 1e+60, 1e-60, 1, 0, 0, 1, 0, 0, {-1, -1}},
    {"P", "0, or 1e-60 to 1e60", 0.0, 1e+60, 1e-60, 0, 0, 0, 1, 0, 0, {-1, -1}}};
static const entry_result half_width_results[] = {
    {"value", {-1, -1}, 0}};

ENTRY(normal_load, r[0][0] = rwedge_normal_load(v[0][0], v[1][0], v[2][0], v[3][0]); return
      RWEDGE_OK)
static const entry_argument normal_load_arguments[] = {
    {"theta", "0 < theta < pi/2, at least 1e-60", 0.0, 1.5707963267948966, 1e-60, 1, 1, 0, 1, 0, 0, {-1, -1}},
    {"a", "0, or 1e-60 to 1e60", 0.0, 1e+60, 1e-60, 0, 0, 0, 1, 0, 0, {-1, -1}},
    {"A", "1e-60 to 1e60", 0.0, 1e+60, 1e-60, 1, 0, 0, 1, 0, 0, {-1, -1}},
    {"b", "0, or 1e-60 to 1e60", 0.0, 1e+60, 1e-60, 0, 0, 0, 1, 0, 0, {-1, -1}}};
static const entry_result normal_load_results[] = {
    {"value", {-1, -1}, 0}};

ENTRY(yield_load, r[0][0] = rwedge_yield_load(v[0][0], v[1][0], v[2][0], v[3][0], v[4][0], v[5][0]);
      return RWEDGE_OK)
static const entry_argument yield_load_arguments[] = {
    {"theta", "0 < theta < pi/2, at least 1e-60", 0.0, 1.5707963267948966, 1e-60, 1, 1, 0, 1, 0, 0, {-1, -1}},
    {"a", "0, or 1e-60 to 1e60", 0.0, 1e+60, 1e-60, 0, 0, 0, 1, 0, 0, {-1, -1}},
    {"A", "1e-60 to 1e60", 0.0, 1e+60, 1e-60, 1, 0, 0, 1, 0, 0, {-1, -1}},
    {"f", "0 <= f <= 1e6, 0 or at least 1e-60", 0.0, 1000000.0, 1e-60, 0, 0, 0, 1, 0, 0, {-1, -1}},
    {"nu", "0 <= nu <= 0.5", 0.0, 0.5, 0.0, 0, 0, 0, 1, 0, 0, {-1, -1}},
    {"k", "1e-60 to 1e60", 0.0, 1e+60, 1e-60, 1, 0, 0, 1, 0, 0, {-1, -1}}};
static const entry_result yield_load_results[] = {
    {"value", {-1, -1}, 0}};

ENTRY(contact_create, return rwedge_contact_create(v[0][0], v[1][0], v[2][0], v[3][0],
      (rwedge_contact **)made))
static const entry_argument contact_create_arguments[] = {
    {"theta", "0 < theta < pi/2, at least 1e-60", 0.0, 1.5707963267948966, 1e-60, 1, 1, 0, 1, 0, 0, {-1, -1}},
    {"a", "0, or 1e-60 to 1e60", 0.0, 1e+60, 1e-60, 0, 0, 0, 1, 0, 0, {-1, -1}},
    {"A", "1e-60 to 1e60", 0.0, 1e+60, 1e-60, 1, 0, 0, 1, 0, 0, {-1, -1}},
    {"f", "0 <= f <= 1e6, 0 or at least 1e-60", 0.0, 1000000.0, 1e-60, 0, 0, 0, 1, 0, 0, {-1, -1}}};

ENTRY(contact_set_strain, return rwedge_contact_set_strain((rwedge_contact *)object, v[0][0]))
static const entry_argument contact_set_strain_arguments[] = {
    {"strain_per_tension", "0, or 1e-60 to 1e60", 0.0, 1e+60, 1e-60, 0, 0, 0, 1, 0, 0, {-1, -1}}};

ENTRY(contact_copy, return rwedge_contact_copy((const rwedge_contact *)object, (rwedge_contact
      **)made))

ENTRY(contact_load, return rwedge_contact_load((rwedge_contact *)object, v[0][0], v[1][0]))
static const entry_argument contact_load_arguments[] = {
    {"P", "0, or 1e-60 to 1e60, not below 1e-8 of the last P", 1e-60, 1e+60, 0.0, 0, 0, 1, 1, 0, 0, {-1, -1}},
    {"Q", "0, or 1e-60 to 1e60 in magnitude, |Q| <= f P", -1e+60, 1e+60, 1e-60, 0, 0, 0, 1, 0, 0, {-1, -1}}};

ENTRY(contact_apply, return rwedge_contact_apply((rwedge_contact *)object, v[0][0], v[1][0],
      v[2][0], v[3][0]))
static const entry_argument contact_apply_arguments[] = {
    {"P", "0, or 1e-60 to 1e60, 0, or at least 1e-8 of the last P", 0.0, 1e+60, 1e-60, 0, 0, 0, 1, 0, 0, {-1, -1}},
    {"M", "0, or 1e-60 to 1e60 in magnitude, 0 where P is 0", -1e+60, 1e+60, 1e-60, 0, 0, 0, 1, 0, 0, {-1, -1}},
    {"Q", "0, or 1e-60 to 1e60 in magnitude, |Q| <= f P", -1e+60, 1e+60, 1e-60, 0, 0, 0, 1, 0, 0, {-1, -1}},
    {"sigma", "0, or 1e-60 to 1e60 in magnitude", -1e+60, 1e+60, 1e-60, 0, 0, 0, 1, 0, 0, {-1, -1}}};

TEXT_ENTRY(contact_obstacle, rwedge_contact_obstacle((const rwedge_contact *)object, v[0][0],
      v[1][0], v[2][0], v[3][0]))
static const entry_argument contact_obstacle_arguments[] = {
    {"P", "0, or 1e-60 to 1e60, 0, or at least 1e-8 of the last P", 0.0, 1e+60, 1e-60, 0, 0, 0, 1, 0, 1, {-1, -1}},
    {"M", "0, or 1e-60 to 1e60 in magnitude, 0 where P is 0", -1e+60, 1e+60, 1e-60, 0, 0, 0, 1, 0, 1, {-1, -1}},
    {"Q", "0, or 1e-60 to 1e60 in magnitude, |Q| <= f P", -1e+60, 1e+60, 1e-60, 0, 0, 0, 1, 0, 1, {-1, -1}},
    {"sigma", "0, or 1e-60 to 1e60 in magnitude", -1e+60, 1e+60, 1e-60, 0, 0, 0, 1, 0, 1, {-1, -1}}};
static const entry_result contact_obstacle_results[] = {
    {"value", {-1, -1}, 0}};

ENTRY(contact_largest_tension_step, r[0][0] = rwedge_contact_largest_tension_step((const
      rwedge_contact *)object, v[0][0]); return RWEDGE_OK)
static const entry_argument contact_largest_tension_step_arguments[] = {
    {"Q", "0, or 1e-60 to 1e60 in magnitude", -1e+60, 1e+60, 1e-60, 0, 0, 0, 1, 0, 0, {-1, -1}}};
static const entry_result contact_largest_tension_step_results[] = {
    {"value", {-1, -1}, 0}};

ENTRY(contact_loads, return rwedge_contact_loads((const rwedge_contact *)object, r[0], r[1], r[2],
      r[3]))
static const entry_result contact_loads_results[] = {
    {"P", {-1, -1}, 0},
    {"M", {-1, -1}, 0},
    {"Q", {-1, -1}, 0},
    {"sigma", {-1, -1}, 0}};

ENTRY(contact_edges, return rwedge_contact_edges((const rwedge_contact *)object, r[0], r[1]))
static const entry_result contact_edges_results[] = {
    {"left", {-1, -1}, 0},
    {"right", {-1, -1}, 0}};

ENTRY(contact_stick_zone, return rwedge_contact_stick_zone((const rwedge_contact *)object, r[0],
      r[1]))
static const entry_result contact_stick_zone_results[] = {
    {"left", {-1, -1}, 0},
    {"right", {-1, -1}, 0}};

ENTRY(contact_tilt, r[0][0] = rwedge_contact_tilt((const rwedge_contact *)object); return RWEDGE_OK)
static const entry_result contact_tilt_results[] = {
    {"value", {-1, -1}, 0}};

ENTRY(contact_edge_asymptotes, return rwedge_contact_edge_asymptotes((const rwedge_contact *)object,
      r[0], r[1], r[2], r[3]))
static const entry_result contact_edge_asymptotes_results[] = {
    {"normal_left", {-1, -1}, 0},
    {"normal_right", {-1, -1}, 0},
    {"shear_left", {-1, -1}, 0},
    {"shear_right", {-1, -1}, 0}};

ENTRY(permanent_stick, return rwedge_permanent_stick(v[0][0], v[1][0], v[2][0], v[3][0], v[4][0],
      v[5][0], v[6][0], v[7][0], v[8][0], v[9][0], v[10][0], v[11][0], r[0], r[1]))
static const entry_argument permanent_stick_arguments[] = {
    {"theta", "0 < theta < pi/2, at least 1e-60", 0.0, 1.5707963267948966, 1e-60, 1, 1, 0, 1, 0, 0, {-1, -1}},
    {"a", "0, or 1e-60 to 1e60", 0.0, 1e+60, 1e-60, 0, 0, 0, 1, 0, 0, {-1, -1}},
    {"A", "1e-60 to 1e60", 0.0, 1e+60, 1e-60, 1, 0, 0, 1, 0, 0, {-1, -1}},
    {"f", "0 <= f <= 1e6, 0 or at least 1e-60", 0.0, 1000000.0, 1e-60, 0, 0, 0, 1, 0, 0, {-1, -1}},
    {"P1", "0, or 1e-60 to 1e60", 0.0, 1e+60, 1e-60, 0, 0, 0, 1, 0, 0, {-1, -1}},
    {"M1", "0, or 1e-60 to 1e60 in magnitude, 0 where P is 0", -1e+60, 1e+60, 1e-60, 0, 0, 0, 1, 0, 0, {-1, -1}},
    {"Q1", "0, or 1e-60 to 1e60 in magnitude, |Q| <= f P", -1e+60, 1e+60, 1e-60, 0, 0, 0, 1, 0, 0, {-1, -1}},
    {"sigma1", "0, or 1e-60 to 1e60 in magnitude", -1e+60, 1e+60, 1e-60, 0, 0, 0, 1, 0, 0, {-1, -1}},
    {"P2", "0, or 1e-60 to 1e60", 0.0, 1e+60, 1e-60, 0, 0, 0, 1, 0, 0, {-1, -1}},
    {"M2", "0, or 1e-60 to 1e60 in magnitude, 0 where P is 0", -1e+60, 1e+60, 1e-60, 0, 0, 0, 1, 0, 0, {-1, -1}},
    {"Q2", "0, or 1e-60 to 1e60 in magnitude, |Q| <= f P", -1e+60, 1e+60, 1e-60, 0, 0, 0, 1, 0, 0, {-1, -1}},
    {"sigma2", "0, or 1e-60 to 1e60 in magnitude", -1e+60, 1e+60, 1e-60, 0, 0, 0, 1, 0, 0, {-1, -1}}};
static const entry_result permanent_stick_results[] = {
    {"left", {-1, -1}, 0},
    {"right", {-1, -1}, 0}};

ENTRY(contact_half_width, r[0][0] = rwedge_contact_half_width((const rwedge_contact *)object);
      return RWEDGE_OK)
static const entry_result contact_half_width_results[] = {
    {"value", {-1, -1}, 0}};

ENTRY(contact_stick_half_width, r[0][0] = rwedge_contact_stick_half_width((const rwedge_contact
      *)object); return RWEDGE_OK)
static const entry_result contact_stick_half_width_results[] = {
    {"value", {-1, -1}, 0}};

ENTRY(contact_memory, r[0][0] = (double)rwedge_contact_memory((const rwedge_contact *)object);
      return RWEDGE_OK)
static const entry_result contact_memory_results[] = {
    {"value", {-1, -1}, 0}};

ENTRY(contact_tractions, return rwedge_contact_tractions((const rwedge_contact *)object, n[0], v[0],
      r[0], r[1]))
static const entry_argument contact_tractions_arguments[] = {
    {"x", "0, or 1e-60 to 1e60 in magnitude, not the apex 0 of a loaded sharp wedge", -1e+60, 1e+60, 1e-60, 0, 0, 0, 1, 0, 0, {0, -1}}};
static const entry_result contact_tractions_results[] = {
    {"p", {0, -1}, 0},
    {"q", {0, -1}, 0}};
static const entry_size contact_tractions_sizes[] = {
    {"n", NULL, ""}};

ENTRY(contact_stresses, return rwedge_contact_stresses((const rwedge_contact *)object, n[0], v[0],
      v[1], r[0], r[1], r[2]))
static const entry_argument contact_stresses_arguments[] = {
    {"x", "0, or 1e-60 to 1e60 in magnitude, not the apex (0, 0) of a loaded sharp wedge", -1e+60, 1e+60, 1e-60, 0, 0, 0, 1, 0, 0, {0, -1}},
    {"y", "0, or 1e-60 to 1e60, not the apex (0, 0) of a loaded sharp wedge", 0.0, 1e+60, 1e-60, 0, 0, 0, 1, 0, 0, {0, -1}}};
static const entry_result contact_stresses_results[] = {
    {"sxx", {0, -1}, 0},
    {"syy", {0, -1}, 0},
    {"txy", {0, -1}, 0}};
static const entry_size contact_stresses_sizes[] = {
    {"n", NULL, ""}};

ENTRY(contact_stress_history, return rwedge_contact_stress_history((rwedge_contact *)object, n[0],
      v[0], v[1], v[2], v[3], n[1], v[4], v[5], r[0], r[1], r[2]))
static const entry_argument contact_stress_history_arguments[] = {
    {"P", "0, or 1e-60 to 1e60, 0, or at least 1e-8 of the last P", 0.0, 1e+60, 1e-60, 0, 0, 0, 1, 0, 0, {0, -1}},
    {"M", "0, or 1e-60 to 1e60 in magnitude", -1e+60, 1e+60, 1e-60, 0, 0, 0, 1, 0, 0, {0, -1}},
    {"Q", "0, or 1e-60 to 1e60 in magnitude", -1e+60, 1e+60, 1e-60, 0, 0, 0, 1, 0, 0, {0, -1}},
    {"sigma", "0, or 1e-60 to 1e60 in magnitude", -1e+60, 1e+60, 1e-60, 0, 0, 0, 1, 0, 0, {0, -1}},
    {"x", "0, or 1e-60 to 1e60 in magnitude", -1e+60, 1e+60, 1e-60, 0, 0, 0, 1, 0, 0, {1, -1}},
    {"y", "0, or 1e-60 to 1e60", 0.0, 1e+60, 1e-60, 0, 0, 0, 1, 0, 0, {1, -1}}};
static const entry_result contact_stress_history_results[] = {
    {"sxx", {0, 1}, 0},
    {"syy", {0, 1}, 0},
    {"txy", {0, 1}, 0}};
static const entry_size contact_stress_history_sizes[] = {
    {"loads", NULL, ""},
    {"n", NULL, ""}};

ENTRY(contact_state_size, r[0][0] = (double)rwedge_contact_state_size((const rwedge_contact
      *)object); return RWEDGE_OK)
static const entry_result contact_state_size_results[] = {
    {"value", {-1, -1}, 0}};

ENTRY(contact_state, return rwedge_contact_state((const rwedge_contact *)object, n[0], r[0]))
static const entry_result contact_state_results[] = {
    {"state", {0, -1}, 0}};
static const entry_size contact_state_sizes[] = {
    {"n", "contact_state_size", ""}};

ENTRY(contact_restore, return rwedge_contact_restore(n[0], v[0], (rwedge_contact **)made))
static const entry_argument contact_restore_arguments[] = {
    {"state", "not other than rwedge_contact_state() gave it", -INFINITY, INFINITY, 0.0, 0, 0, 0, 0, 0, 0, {0, -1}}};
static const entry_size contact_restore_sizes[] = {
    {"n", NULL, ""}};

ENTRY(contact_slip, return rwedge_contact_slip((const rwedge_contact *)object, n[0], v[0], r[0]))
static const entry_argument contact_slip_arguments[] = {
    {"x", "0, or 1e-60 to 1e60 in magnitude, |x| <= b", -1e+60, 1e+60, 1e-60, 0, 0, 0, 1, 0, 0, {0, -1}}};
static const entry_result contact_slip_results[] = {
    {"slip", {0, -1}, 0}};
static const entry_size contact_slip_sizes[] = {
    {"n", NULL, ""}};

ENTRY(contact_dissipated_energy, r[0][0] = rwedge_contact_dissipated_energy((const rwedge_contact
      *)object); return RWEDGE_OK)
static const entry_result contact_dissipated_energy_results[] = {
    {"value", {-1, -1}, 0}};

ENTRY(contact_yield_factor, return rwedge_contact_yield_factor((const rwedge_contact *)object,
      v[0][0], v[1][0], r[0], r[1], r[2]))
static const entry_argument contact_yield_factor_arguments[] = {
    {"nu", "0 <= nu <= 0.5", 0.0, 0.5, 0.0, 0, 0, 0, 1, 0, 0, {-1, -1}},
    {"k", "1e-60 to 1e60", 0.0, 1e+60, 1e-60, 1, 0, 0, 1, 0, 0, {-1, -1}}};
static const entry_result contact_yield_factor_results[] = {
    {"factor", {-1, -1}, 0},
    {"x", {-1, -1}, 1},
    {"y", {-1, -1}, 1}};

ENTRY(contact_cycle_fatigue, return rwedge_contact_cycle_fatigue((const rwedge_contact *)object,
      n[0], v[0], v[1], v[2], v[3], n[1], v[4], v[5], v[6][0], v[7][0], v[8][0], r[0], r[1], r[2],
      r[3], r[4]))
static const entry_argument contact_cycle_fatigue_arguments[] = {
    {"P", "0, or 1e-60 to 1e60, 0, or at least 1e-8 of the last P", 0.0, 1e+60, 1e-60, 0, 0, 0, 1, 0, 0, {0, -1}},
    {"M", "0, or 1e-60 to 1e60 in magnitude", -1e+60, 1e+60, 1e-60, 0, 0, 0, 1, 0, 0, {0, -1}},
    {"Q", "0, or 1e-60 to 1e60 in magnitude", -1e+60, 1e+60, 1e-60, 0, 0, 0, 1, 0, 0, {0, -1}},
    {"sigma", "0, or 1e-60 to 1e60 in magnitude", -1e+60, 1e+60, 1e-60, 0, 0, 0, 1, 0, 0, {0, -1}},
    {"x", "0, or 1e-60 to 1e60 in magnitude, not the apex (0, 0) of a loaded sharp wedge", -1e+60, 1e+60, 1e-60, 0, 0, 0, 1, 0, 0, {1, -1}},
    {"y", "0, or 1e-60 to 1e60, not the apex (0, 0) of a loaded sharp wedge", 0.0, 1e+60, 1e-60, 0, 0, 0, 1, 0, 0, {1, -1}},
    {"E", "1e-60 to 1e60", 1e-60, 1e+60, 0.0, 0, 0, 0, 1, 0, 0, {-1, -1}},
    {"nu", "0 <= nu <= 0.5", 0.0, 0.5, 0.0, 0, 0, 0, 1, 0, 0, {-1, -1}},
    {"k_over_sy", "0 or 1e-60 to 1e60", 1e-60, 1e+60, 0.0, 0, 0, 1, 1, 0, 0, {-1, -1}}};
static const entry_result contact_cycle_fatigue_results[] = {
    {"stress_range", {1, -1}, 0},
    {"swt", {1, -1}, 0},
    {"swt_angle", {1, -1}, 0},
    {"fatemi_socie", {1, -1}, 0},
    {"fs_angle", {1, -1}, 0}};
static const entry_size contact_cycle_fatigue_sizes[] = {
    {"loads", NULL, ""},
    {"n", NULL, ""}};

ENTRY(contact_cycle_friction, return rwedge_contact_cycle_friction((const rwedge_contact *)object,
      n[0], v[0], v[1], v[2], v[3], n[1], v[4], r[0], r[1], r[2], r[3]))
static const entry_argument contact_cycle_friction_arguments[] = {
    {"P", "0, or 1e-60 to 1e60, 0, or at least 1e-8 of the last P", 0.0, 1e+60, 1e-60, 0, 0, 0, 1, 0, 0, {0, -1}},
    {"M", "0, or 1e-60 to 1e60 in magnitude", -1e+60, 1e+60, 1e-60, 0, 0, 0, 1, 0, 0, {0, -1}},
    {"Q", "0, or 1e-60 to 1e60 in magnitude", -1e+60, 1e+60, 1e-60, 0, 0, 0, 1, 0, 0, {0, -1}},
    {"sigma", "0, or 1e-60 to 1e60 in magnitude", -1e+60, 1e+60, 1e-60, 0, 0, 0, 1, 0, 0, {0, -1}},
    {"x", "0, or 1e-60 to 1e60 in magnitude, not the apex 0 of a loaded sharp wedge", -1e+60, 1e+60, 1e-60, 0, 0, 0, 1, 0, 0, {1, -1}}};
static const entry_result contact_cycle_friction_results[] = {
    {"slip_range", {1, -1}, 0},
    {"ruiz_f1", {1, -1}, 0},
    {"ruiz_f2", {1, -1}, 0},
    {"energy", {1, -1}, 0}};
static const entry_size contact_cycle_friction_sizes[] = {
    {"loads", NULL, ""},
    {"n", NULL, ""}};

ENTRY(contact_cycle_worst, return rwedge_contact_cycle_worst((const rwedge_contact *)object,
      (int32_t)v[0][0], n[0], v[1], v[2], v[3], v[4], n[1], v[5], v[6], v[7][0], v[8][0], v[9][0],
      v[10][0], r[0], r[1]))
static const entry_argument contact_cycle_worst_arguments[] = {
    {"measure", "whole, 0 <= measure <= 6", 0.0, 6.0, 0.0, 0, 0, 0, 1, 1, 0, {-1, -1}},
    {"P", "0, or 1e-60 to 1e60, 0, or at least 1e-8 of the last P", 0.0, 1e+60, 1e-60, 0, 0, 0, 1, 0, 0, {0, -1}},
    {"M", "0, or 1e-60 to 1e60 in magnitude", -1e+60, 1e+60, 1e-60, 0, 0, 0, 1, 0, 0, {0, -1}},
    {"Q", "0, or 1e-60 to 1e60 in magnitude", -1e+60, 1e+60, 1e-60, 0, 0, 0, 1, 0, 0, {0, -1}},
    {"sigma", "0, or 1e-60 to 1e60 in magnitude", -1e+60, 1e+60, 1e-60, 0, 0, 0, 1, 0, 0, {0, -1}},
    {"x", "0, or 1e-60 to 1e60 in magnitude", -1e+60, 1e+60, 1e-60, 0, 0, 0, 1, 0, 0, {1, -1}},
    {"value", "0, or 1e-60 to 1e60, at least 0", 0.0, 1e+60, 1e-60, 0, 0, 0, 1, 0, 0, {1, -1}},
    {"y", "0, or 1e-60 to 1e60", 0.0, 1e+60, 1e-60, 0, 0, 0, 1, 0, 0, {-1, -1}},
    {"E", "1e-60 to 1e60", 1e-60, 1e+60, 0.0, 0, 0, 0, 1, 0, 0, {-1, -1}},
    {"nu", "0 <= nu <= 0.5", 0.0, 0.5, 0.0, 0, 0, 0, 1, 0, 0, {-1, -1}},
    {"k_over_sy", "0 or 1e-60 to 1e60", 1e-60, 1e+60, 0.0, 0, 0, 1, 1, 0, 0, {-1, -1}}};
static const entry_result contact_cycle_worst_results[] = {
    {"worst_x", {-1, -1}, 0},
    {"worst_value", {-1, -1}, 0}};
static const entry_size contact_cycle_worst_sizes[] = {
    {"loads", NULL, ""},
    {"n", NULL, ""}};

ENTRY(contact_displacement, r[0][0] = rwedge_contact_displacement((const rwedge_contact *)object,
      v[0][0]); return RWEDGE_OK)
static const entry_argument contact_displacement_arguments[] = {
    {"b", "1e-60 to 1e60", 0.0, 1e+60, 1e-60, 1, 0, 0, 1, 0, 0, {-1, -1}}};
static const entry_result contact_displacement_results[] = {
    {"value", {-1, -1}, 0}};

ENTRY(von_mises, r[0][0] = rwedge_von_mises(v[0][0], v[1][0], v[2][0], v[3][0]); return RWEDGE_OK)
static const entry_argument von_mises_arguments[] = {
    {"sxx", "of at most 1e60 in magnitude", -1e+60, 1e+60, 0.0, 0, 0, 0, 1, 0, 0, {-1, -1}},
    {"syy", "of at most 1e60 in magnitude", -1e+60, 1e+60, 0.0, 0, 0, 0, 1, 0, 0, {-1, -1}},
    {"txy", "of at most 1e60 in magnitude", -1e+60, 1e+60, 0.0, 0, 0, 0, 1, 0, 0, {-1, -1}},
    {"nu", "0 <= nu <= 0.5", 0.0, 0.5, 0.0, 0, 0, 0, 1, 0, 0, {-1, -1}}};
static const entry_result von_mises_results[] = {
    {"value", {-1, -1}, 0}};

ENTRY(out_of_plane_stress, r[0][0] = rwedge_out_of_plane_stress(v[0][0], v[1][0], v[2][0]); return
      RWEDGE_OK)
static const entry_argument out_of_plane_stress_arguments[] = {
    {"sxx", "of at most 1e60 in magnitude", -1e+60, 1e+60, 0.0, 0, 0, 0, 1, 0, 0, {-1, -1}},
    {"syy", "of at most 1e60 in magnitude", -1e+60, 1e+60, 0.0, 0, 0, 0, 1, 0, 0, {-1, -1}},
    {"nu", "0 <= nu <= 0.5", 0.0, 0.5, 0.0, 0, 0, 0, 1, 0, 0, {-1, -1}}};
static const entry_result out_of_plane_stress_results[] = {
    {"value", {-1, -1}, 0}};

ENTRY(largest_shear, r[0][0] = rwedge_largest_shear(v[0][0], v[1][0], v[2][0], v[3][0]); return
      RWEDGE_OK)
static const entry_argument largest_shear_arguments[] = {
    {"sxx", "of at most 1e60 in magnitude", -1e+60, 1e+60, 0.0, 0, 0, 0, 1, 0, 0, {-1, -1}},
    {"syy", "of at most 1e60 in magnitude", -1e+60, 1e+60, 0.0, 0, 0, 0, 1, 0, 0, {-1, -1}},
    {"txy", "of at most 1e60 in magnitude", -1e+60, 1e+60, 0.0, 0, 0, 0, 1, 0, 0, {-1, -1}},
    {"nu", "0 <= nu <= 0.5", 0.0, 0.5, 0.0, 0, 0, 0, 1, 0, 0, {-1, -1}}};
static const entry_result largest_shear_results[] = {
    {"value", {-1, -1}, 0}};

ENTRY(principal_stresses, return rwedge_principal_stresses(v[0][0], v[1][0], v[2][0], r[0], r[1],
      r[2]))
static const entry_argument principal_stresses_arguments[] = {
    {"sxx", "of at most 1e60 in magnitude", -1e+60, 1e+60, 0.0, 0, 0, 0, 1, 0, 0, {-1, -1}},
    {"syy", "of at most 1e60 in magnitude", -1e+60, 1e+60, 0.0, 0, 0, 0, 1, 0, 0, {-1, -1}},
    {"txy", "of at most 1e60 in magnitude", -1e+60, 1e+60, 0.0, 0, 0, 0, 1, 0, 0, {-1, -1}}};
static const entry_result principal_stresses_results[] = {
    {"s1", {-1, -1}, 0},
    {"s2", {-1, -1}, 0},
    {"angle", {-1, -1}, 0}};

ENTRY(smith_watson_topper, return rwedge_smith_watson_topper(n[0], v[0], v[1], v[2], v[3][0],
      v[4][0], r[0], r[1]))
static const entry_argument smith_watson_topper_arguments[] = {
    {"sxx", "of at most 1e60 in magnitude", -1e+60, 1e+60, 0.0, 0, 0, 0, 1, 0, 0, {0, -1}},
    {"syy", "of at most 1e60 in magnitude", -1e+60, 1e+60, 0.0, 0, 0, 0, 1, 0, 0, {0, -1}},
    {"txy", "of at most 1e60 in magnitude", -1e+60, 1e+60, 0.0, 0, 0, 0, 1, 0, 0, {0, -1}},
    {"E", "1e-60 to 1e60", 1e-60, 1e+60, 0.0, 0, 0, 0, 1, 0, 0, {-1, -1}},
    {"nu", "0 <= nu <= 0.5", 0.0, 0.5, 0.0, 0, 0, 0, 1, 0, 0, {-1, -1}}};
static const entry_result smith_watson_topper_results[] = {
    {"value", {-1, -1}, 0},
    {"angle", {-1, -1}, 0}};
static const entry_size smith_watson_topper_sizes[] = {
    {"n", NULL, ">= 1"}};

ENTRY(smith_watson_topper_field, return rwedge_smith_watson_topper_field(n[0], n[1], v[0], v[1],
      v[2], v[3][0], v[4][0], r[0], r[1]))
static const entry_argument smith_watson_topper_field_arguments[] = {
    {"sxx", "of at most 1e60 in magnitude", -1e+60, 1e+60, 0.0, 0, 0, 0, 1, 0, 0, {0, 1}},
    {"syy", "of at most 1e60 in magnitude", -1e+60, 1e+60, 0.0, 0, 0, 0, 1, 0, 0, {0, 1}},
    {"txy", "of at most 1e60 in magnitude", -1e+60, 1e+60, 0.0, 0, 0, 0, 1, 0, 0, {0, 1}},
    {"E", "1e-60 to 1e60", 1e-60, 1e+60, 0.0, 0, 0, 0, 1, 0, 0, {-1, -1}},
    {"nu", "0 <= nu <= 0.5", 0.0, 0.5, 0.0, 0, 0, 0, 1, 0, 0, {-1, -1}}};
static const entry_result smith_watson_topper_field_results[] = {
    {"value", {1, -1}, 0},
    {"angle", {1, -1}, 0}};
static const entry_size smith_watson_topper_field_sizes[] = {
    {"loads", NULL, ">= 1"},
    {"n", NULL, ""}};

ENTRY(fatemi_socie, return rwedge_fatemi_socie(n[0], v[0], v[1], v[2], v[3][0], v[4][0], v[5][0],
      r[0], r[1]))
static const entry_argument fatemi_socie_arguments[] = {
    {"sxx", "of at most 1e60 in magnitude", -1e+60, 1e+60, 0.0, 0, 0, 0, 1, 0, 0, {0, -1}},
    {"syy", "of at most 1e60 in magnitude", -1e+60, 1e+60, 0.0, 0, 0, 0, 1, 0, 0, {0, -1}},
    {"txy", "of at most 1e60 in magnitude", -1e+60, 1e+60, 0.0, 0, 0, 0, 1, 0, 0, {0, -1}},
    {"E", "1e-60 to 1e60", 1e-60, 1e+60, 0.0, 0, 0, 0, 1, 0, 0, {-1, -1}},
    {"nu", "0 <= nu <= 0.5", 0.0, 0.5, 0.0, 0, 0, 0, 1, 0, 0, {-1, -1}},
    {"k_over_sy", "0 or 1e-60 to 1e60", 1e-60, 1e+60, 0.0, 0, 0, 1, 1, 0, 0, {-1, -1}}};
static const entry_result fatemi_socie_results[] = {
    {"value", {-1, -1}, 0},
    {"angle", {-1, -1}, 0}};
static const entry_size fatemi_socie_sizes[] = {
    {"n", NULL, ">= 1"}};

ENTRY(fatemi_socie_field, return rwedge_fatemi_socie_field(n[0], n[1], v[0], v[1], v[2], v[3][0],
      v[4][0], v[5][0], r[0], r[1]))
static const entry_argument fatemi_socie_field_arguments[] = {
    {"sxx", "of at most 1e60 in magnitude", -1e+60, 1e+60, 0.0, 0, 0, 0, 1, 0, 0, {0, 1}},
    {"syy", "of at most 1e60 in magnitude", -1e+60, 1e+60, 0.0, 0, 0, 0, 1, 0, 0, {0, 1}},
    {"txy", "of at most 1e60 in magnitude", -1e+60, 1e+60, 0.0, 0, 0, 0, 1, 0, 0, {0, 1}},
    {"E", "1e-60 to 1e60", 1e-60, 1e+60, 0.0, 0, 0, 0, 1, 0, 0, {-1, -1}},
    {"nu", "0 <= nu <= 0.5", 0.0, 0.5, 0.0, 0, 0, 0, 1, 0, 0, {-1, -1}},
    {"k_over_sy", "0 or 1e-60 to 1e60", 1e-60, 1e+60, 0.0, 0, 0, 1, 1, 0, 0, {-1, -1}}};
static const entry_result fatemi_socie_field_results[] = {
    {"value", {1, -1}, 0},
    {"angle", {1, -1}, 0}};
static const entry_size fatemi_socie_field_sizes[] = {
    {"loads", NULL, ">= 1"},
    {"n", NULL, ""}};

ENTRY(series_create, return rwedge_series_create(v[0][0], (int32_t)v[1][0], (rwedge_series **)made))
static const entry_argument series_create_arguments[] = {
    {"alpha", "0, or 1e-60 to 1e60", 0.0, 1e+60, 1e-60, 0, 0, 0, 1, 0, 0, {-1, -1}},
    {"terms", "whole, 1 <= terms <= 2^24", 1.0, 16777216.0, 0.0, 0, 0, 0, 1, 1, 0, {-1, -1}}};

ENTRY(series_fit, return rwedge_series_fit(n[0], v[0], v[1], (int32_t)v[2][0], (rwedge_series
      **)made))
static const entry_argument series_fit_arguments[] = {
    {"x", "|x| < 1, 0 or at least 1e-60 in magnitude", -1.0, 1.0, 1e-60, 1, 1, 0, 1, 0, 0, {0, -1}},
    {"p", "0, or 1e-60 to 1e60 in magnitude", -1e+60, 1e+60, 1e-60, 0, 0, 0, 1, 0, 0, {0, -1}},
    {"terms", "whole, >= 1", 1.0, INFINITY, 0.0, 0, 0, 0, 1, 1, 0, {-1, -1}}};
static const entry_size series_fit_sizes[] = {
    {"samples", NULL, ">= terms, samples * terms <= 2^27, samples * terms^2 <= 2^33"}};

ENTRY(series_terms, r[0][0] = (double)rwedge_series_terms((const rwedge_series *)object); return
      RWEDGE_OK)
static const entry_result series_terms_results[] = {
    {"value", {-1, -1}, 0}};

ENTRY(series_coefficient, r[0][0] = rwedge_series_coefficient((const rwedge_series *)object,
      (int32_t)v[0][0]); return RWEDGE_OK)
static const entry_argument series_coefficient_arguments[] = {
    {"k", "whole, >= 0", 0.0, INFINITY, 0.0, 0, 0, 0, 1, 1, 0, {-1, -1}}};
static const entry_result series_coefficient_results[] = {
    {"value", {-1, -1}, 0}};

ENTRY(series_residual, r[0][0] = rwedge_series_residual((const rwedge_series *)object); return
      RWEDGE_OK)
static const entry_result series_residual_results[] = {
    {"value", {-1, -1}, 0}};

ENTRY(series_pressure, r[0][0] = rwedge_series_pressure((const rwedge_series *)object, v[0][0]);
      return RWEDGE_OK)
static const entry_argument series_pressure_arguments[] = {
    {"x", "0, or 1e-60 to 1e60 in magnitude", -1e+60, 1e+60, 1e-60, 0, 0, 0, 1, 0, 0, {-1, -1}}};
static const entry_result series_pressure_results[] = {
    {"value", {-1, -1}, 0}};

ENTRY(series_potential, return rwedge_series_potential((const rwedge_series *)object, v[0][0],
      v[1][0], v[2][0], r[0], r[1]))
static const entry_argument series_potential_arguments[] = {
    {"f", "0 <= f <= 1e6, 0 or at least 1e-60", 0.0, 1000000.0, 1e-60, 0, 0, 0, 1, 0, 0, {-1, -1}},
    {"x", "0, or 1e-60 to 1e60 in magnitude", -1e+60, 1e+60, 1e-60, 0, 0, 0, 1, 0, 0, {-1, -1}},
    {"y", "0, or 1e-60 to 1e60", 0.0, 1e+60, 1e-60, 0, 0, 0, 1, 0, 0, {-1, -1}}};
static const entry_result series_potential_results[] = {
    {"re", {-1, -1}, 0},
    {"im", {-1, -1}, 0}};

ENTRY(series_stress, return rwedge_series_stress((const rwedge_series *)object, v[0][0], v[1][0],
      v[2][0], r[0], r[1], r[2]))
static const entry_argument series_stress_arguments[] = {
    {"f", "0 <= f <= 1e6, 0 or at least 1e-60", 0.0, 1000000.0, 1e-60, 0, 0, 0, 1, 0, 0, {-1, -1}},
    {"x", "0, or 1e-60 to 1e60 in magnitude", -1e+60, 1e+60, 1e-60, 0, 0, 0, 1, 0, 0, {-1, -1}},
    {"y", "0, or 1e-60 to 1e60", 0.0, 1e+60, 1e-60, 0, 0, 0, 1, 0, 0, {-1, -1}}};
static const entry_result series_stress_results[] = {
    {"sxx", {-1, -1}, 0},
    {"syy", {-1, -1}, 0},
    {"txy", {-1, -1}, 0}};

static const entry entries[] = {
    {"strerror", "", entry_strerror, text_strerror, 0, 0, 0, 0, 0, 0, 0, 0x0,
     NULL, 1, 1, 0, strerror_arguments, strerror_results, NULL},
    {"compliance", "", entry_compliance, NULL, 0, 0, 0, 0, 0, 1, 0, 0x0,
     NULL, 4, 1, 0, compliance_arguments, compliance_results, NULL},
    {"dundurs_beta", "", entry_dundurs_beta, NULL, 0, 0, 0, 0, 0, 0, 0, 0x0,
     NULL, 4, 1, 0, dundurs_beta_arguments, dundurs_beta_results, NULL},
    {"load", "", entry_load, NULL, 0, 0, 0, 0, 0, 0, 0, 0x0,
     NULL, 1, 1, 0, load_arguments, load_results, NULL},
    {"a_over_b", "", entry_a_over_b, NULL, 0, 0, 0, 0, 0, 1, 0, 0x0,
     NULL, 1, 1, 0, a_over_b_arguments, a_over_b_results, NULL},
    {"pressure", "", entry_pressure, NULL, 0, 0, 0, 0, 0, 1, 0, 0x0,
     NULL, 2, 1, 0, pressure_arguments, pressure_results, NULL},
    {"peak_pressure", "", entry_peak_pressure, NULL, 0, 0, 0, 0, 0, 1, 0, 0x0,
     NULL, 1, 1, 0, peak_pressure_arguments, peak_pressure_results, NULL},
    {"transition_pressure", "", entry_transition_pressure, NULL, 0, 0, 0, 0, 0, 1, 0, 0x0,
     NULL, 1, 1, 0, transition_pressure_arguments, transition_pressure_results, NULL},
    {"coefficient", "", entry_coefficient, NULL, 0, 0, 0, 0, 0, 0, 0, 0x0,
     NULL, 2, 1, 0, coefficient_arguments, coefficient_results, NULL},
    {"stick_width", "", entry_stick_width, NULL, 0, 0, 0, 0, 0, 0, 0, 0x0,
     NULL, 2, 1, 0, stick_width_arguments, stick_width_results, NULL},
    {"shear_ratio", "", entry_shear_ratio, NULL, 0, 0, 0, 0, 0, 0, 0, 0x0,
     NULL, 2, 1, 0, shear_ratio_arguments, shear_ratio_results, NULL},
    {"shear", "", entry_shear, NULL, 0, 0, 0, 0, 0, 1, 0, 0x0,
     NULL, 3, 1, 0, shear_arguments, shear_results, NULL},
    {"stress", "", entry_stress, NULL, 0, 0, 0, 1, 0, 1, 0, 0x6,
     NULL, 5, 3, 0, stress_arguments, stress_results, NULL},
    {"stresses", "", entry_stresses, NULL, 0, 0, 0, 1, 1, 1, 0, 0x6,
     "stress", 5, 3, 1, stresses_arguments, stresses_results, stresses_sizes},
    {"max_tension", "", entry_max_tension, NULL, 0, 0, 0, 0, 0, 0, 0, 0x0,
     NULL, 1, 1, 0, max_tension_arguments, max_tension_results, NULL},
    {"elastic_limit", "", entry_elastic_limit, NULL, 0, 0, 0, 0, 0, 0, 0, 0x0,
     NULL, 3, 1, 0, elastic_limit_arguments, elastic_limit_results, NULL},
    {"elastic_limits", "", entry_elastic_limits, NULL, 0, 0, 0, 1, 1, 0, 0, 0x0,
     "elastic_limit", 3, 1, 1, elastic_limits_arguments, elastic_limits_results, elastic_limits_sizes},
    {"yield_point", "", entry_yield_point, NULL, 0, 0, 0, 1, 0, 0, 0, 0x6,
     NULL, 3, 3, 0, yield_point_arguments, yield_point_results, NULL},
    {"subsurface_yield", "", entry_subsurface_yield, NULL, 0, 0, 0, 1, 0, 0, 0, 0x106,
     NULL, 3, 3, 0, subsurface_yield_arguments, subsurface_yield_results, NULL},
    {"surface_yield", "", entry_surface_yield, NULL, 0, 0, 0, 1, 0, 0, 0, 0x106,
     NULL, 3, 2, 0, surface_yield_arguments, surface_yield_results, NULL},
    {"critical_friction", "", entry_critical_friction, NULL, 0, 0, 0, 0, 0, 0, 0, 0x0,
     NULL, 2, 1, 0, critical_friction_arguments, critical_friction_results, NULL},
    {"validity", "", entry_validity, NULL, 0, 0, 0, 0, 0, 0, 0, 0x0,
     NULL, 6, 1, 0, validity_arguments, validity_results, NULL},
    {"validity_text", "", entry_validity_text, text_validity_text, 0, 0, 0, 0, 0, 0, 0, 0x0,
     NULL, 1, 1, 0, validity_text_arguments, validity_text_results, NULL},
    {"radius", "", entry_radius, NULL, 0, 0, 0, 0, 0, 1, 0, 0x0,
     NULL, 2, 1, 0, radius_arguments, radius_results, NULL},
    {"rounding", "", entry_rounding, NULL, 0, 0, 0, 0, 0, 1, 0, 0x0,
     NULL, 2, 1, 0, rounding_arguments, rounding_results, NULL},
    {"half_width", "", entry_half_width, NULL, 0, 0, 0, 0, 0, 1, 0, 0x0,
     NULL, 4, 1, 0, half_width_arguments, half_width_results, NULL},
    {"normal_load", "", entry_normal_load, NULL, 0, 0, 0, 0, 0, 1, 0, 0x0,
     NULL, 4, 1, 0, normal_load_arguments, normal_load_results, NULL},
    {"yield_load", "", entry_yield_load, NULL, 0, 0, 0, 0, 0, 1, 1, 0x0,
     NULL, 6, 1, 0, yield_load_arguments, yield_load_results, NULL},
    {"contact_create", "contact", entry_contact_create, NULL, 0, 0, 1, 1, 0, 1, 0, 0x26,
     NULL, 4, 0, 0, contact_create_arguments, NULL, NULL},
    {"contact_set_strain", "contact", entry_contact_set_strain, NULL, 1, 1, 0, 1, 0, 1, 0, 0x6,
     NULL, 1, 0, 0, contact_set_strain_arguments, NULL, NULL},
    {"contact_copy", "contact", entry_contact_copy, NULL, 1, 0, 1, 1, 0, 0, 0, 0x24,
     NULL, 0, 0, 0, NULL, NULL, NULL},
    {"contact_load", "contact", entry_contact_load, NULL, 1, 1, 0, 1, 0, 1, 0, 0x26e,
     NULL, 2, 0, 0, contact_load_arguments, NULL, NULL},
    {"contact_apply", "contact", entry_contact_apply, NULL, 1, 1, 0, 1, 0, 1, 0, 0x26e,
     NULL, 4, 0, 0, contact_apply_arguments, NULL, NULL},
    {"contact_obstacle", "contact", entry_contact_obstacle, text_contact_obstacle, 1, 0, 0, 0, 0, 1, 0, 0x200,
     NULL, 4, 1, 0, contact_obstacle_arguments, contact_obstacle_results, NULL},
    {"contact_largest_tension_step", "contact", entry_contact_largest_tension_step, NULL, 1, 0, 0, 0, 0, 0, 1, 0x0,
     NULL, 1, 1, 0, contact_largest_tension_step_arguments, contact_largest_tension_step_results, NULL},
    {"contact_loads", "contact", entry_contact_loads, NULL, 1, 0, 0, 1, 0, 0, 0, 0x4,
     NULL, 0, 4, 0, NULL, contact_loads_results, NULL},
    {"contact_edges", "contact", entry_contact_edges, NULL, 1, 0, 0, 1, 0, 0, 0, 0x104,
     NULL, 0, 2, 0, NULL, contact_edges_results, NULL},
    {"contact_stick_zone", "contact", entry_contact_stick_zone, NULL, 1, 0, 0, 1, 0, 0, 0, 0x104,
     NULL, 0, 2, 0, NULL, contact_stick_zone_results, NULL},
    {"contact_tilt", "contact", entry_contact_tilt, NULL, 1, 0, 0, 0, 0, 0, 0, 0x0,
     NULL, 0, 1, 0, NULL, contact_tilt_results, NULL},
    {"contact_edge_asymptotes", "contact", entry_contact_edge_asymptotes, NULL, 1, 0, 0, 1, 0, 0, 0, 0x104,
     NULL, 0, 4, 0, NULL, contact_edge_asymptotes_results, NULL},
    {"permanent_stick", "", entry_permanent_stick, NULL, 0, 0, 0, 1, 0, 1, 0, 0x36e,
     NULL, 12, 2, 0, permanent_stick_arguments, permanent_stick_results, NULL},
    {"contact_half_width", "contact", entry_contact_half_width, NULL, 1, 0, 0, 0, 0, 0, 0, 0x0,
     NULL, 0, 1, 0, NULL, contact_half_width_results, NULL},
    {"contact_stick_half_width", "contact", entry_contact_stick_half_width, NULL, 1, 0, 0, 0, 0, 0, 0, 0x0,
     NULL, 0, 1, 0, NULL, contact_stick_half_width_results, NULL},
    {"contact_memory", "contact", entry_contact_memory, NULL, 1, 0, 0, 0, 0, 0, 0, 0x0,
     NULL, 0, 1, 0, NULL, contact_memory_results, NULL},
    {"contact_tractions", "contact", entry_contact_tractions, NULL, 1, 0, 0, 1, 1, 1, 0, 0x6,
     NULL, 1, 2, 1, contact_tractions_arguments, contact_tractions_results, contact_tractions_sizes},
    {"contact_stresses", "contact", entry_contact_stresses, NULL, 1, 0, 0, 1, 1, 1, 0, 0x6,
     NULL, 2, 3, 1, contact_stresses_arguments, contact_stresses_results, contact_stresses_sizes},
    {"contact_stress_history", "contact", entry_contact_stress_history, NULL, 1, 1, 0, 1, 0, 1, 0, 0x26e,
     NULL, 6, 3, 2, contact_stress_history_arguments, contact_stress_history_results, contact_stress_history_sizes},
    {"contact_state_size", "contact", entry_contact_state_size, NULL, 1, 0, 0, 0, 0, 0, 0, 0x0,
     NULL, 0, 1, 0, NULL, contact_state_size_results, NULL},
    {"contact_state", "contact", entry_contact_state, NULL, 1, 0, 0, 1, 0, 0, 0, 0xc,
     NULL, 0, 1, 1, NULL, contact_state_results, contact_state_sizes},
    {"contact_restore", "contact", entry_contact_restore, NULL, 0, 0, 1, 1, 0, 1, 0, 0x26,
     NULL, 1, 0, 1, contact_restore_arguments, NULL, contact_restore_sizes},
    {"contact_slip", "contact", entry_contact_slip, NULL, 1, 0, 0, 1, 1, 1, 0, 0x206,
     NULL, 1, 1, 1, contact_slip_arguments, contact_slip_results, contact_slip_sizes},
    {"contact_dissipated_energy", "contact", entry_contact_dissipated_energy, NULL, 1, 0, 0, 0, 0, 1, 0, 0x0,
     NULL, 0, 1, 0, NULL, contact_dissipated_energy_results, NULL},
    {"contact_yield_factor", "contact", entry_contact_yield_factor, NULL, 1, 0, 0, 1, 0, 0, 0, 0x10e,
     NULL, 2, 3, 0, contact_yield_factor_arguments, contact_yield_factor_results, NULL},
    {"contact_cycle_fatigue", "contact", entry_contact_cycle_fatigue, NULL, 1, 0, 0, 1, 0, 1, 0, 0x26e,
     NULL, 9, 5, 2, contact_cycle_fatigue_arguments, contact_cycle_fatigue_results, contact_cycle_fatigue_sizes},
    {"contact_cycle_friction", "contact", entry_contact_cycle_friction, NULL, 1, 0, 0, 1, 0, 1, 0, 0x26e,
     NULL, 5, 4, 2, contact_cycle_friction_arguments, contact_cycle_friction_results, contact_cycle_friction_sizes},
    {"contact_cycle_worst", "contact", entry_contact_cycle_worst, NULL, 1, 0, 0, 1, 0, 1, 0, 0xa,
     NULL, 11, 2, 2, contact_cycle_worst_arguments, contact_cycle_worst_results, contact_cycle_worst_sizes},
    {"contact_displacement", "contact", entry_contact_displacement, NULL, 1, 0, 0, 0, 0, 1, 0, 0x0,
     NULL, 1, 1, 0, contact_displacement_arguments, contact_displacement_results, NULL},
    {"von_mises", "", entry_von_mises, NULL, 0, 0, 0, 0, 0, 0, 0, 0x0,
     NULL, 4, 1, 0, von_mises_arguments, von_mises_results, NULL},
    {"out_of_plane_stress", "", entry_out_of_plane_stress, NULL, 0, 0, 0, 0, 0, 0, 0, 0x0,
     NULL, 3, 1, 0, out_of_plane_stress_arguments, out_of_plane_stress_results, NULL},
    {"largest_shear", "", entry_largest_shear, NULL, 0, 0, 0, 0, 0, 0, 0, 0x0,
     NULL, 4, 1, 0, largest_shear_arguments, largest_shear_results, NULL},
    {"principal_stresses", "", entry_principal_stresses, NULL, 0, 0, 0, 1, 0, 0, 0, 0x6,
     NULL, 3, 3, 0, principal_stresses_arguments, principal_stresses_results, NULL},
    {"smith_watson_topper", "", entry_smith_watson_topper, NULL, 0, 0, 0, 1, 0, 0, 0, 0xe,
     NULL, 5, 2, 1, smith_watson_topper_arguments, smith_watson_topper_results, smith_watson_topper_sizes},
    {"smith_watson_topper_field", "", entry_smith_watson_topper_field, NULL, 0, 0, 0, 1, 0, 0, 0, 0xe,
     NULL, 5, 2, 2, smith_watson_topper_field_arguments, smith_watson_topper_field_results, smith_watson_topper_field_sizes},
    {"fatemi_socie", "", entry_fatemi_socie, NULL, 0, 0, 0, 1, 0, 0, 0, 0xe,
     NULL, 6, 2, 1, fatemi_socie_arguments, fatemi_socie_results, fatemi_socie_sizes},
    {"fatemi_socie_field", "", entry_fatemi_socie_field, NULL, 0, 0, 0, 1, 0, 0, 0, 0xe,
     NULL, 6, 2, 2, fatemi_socie_field_arguments, fatemi_socie_field_results, fatemi_socie_field_sizes},
    {"series_create", "series", entry_series_create, NULL, 0, 0, 1, 1, 0, 0, 0, 0x2e,
     NULL, 2, 0, 0, series_create_arguments, NULL, NULL},
    {"series_fit", "series", entry_series_fit, NULL, 0, 0, 1, 1, 0, 1, 0, 0xbe,
     NULL, 3, 0, 1, series_fit_arguments, NULL, series_fit_sizes},
    {"series_terms", "series", entry_series_terms, NULL, 1, 0, 0, 0, 0, 0, 0, 0x0,
     NULL, 0, 1, 0, NULL, series_terms_results, NULL},
    {"series_coefficient", "series", entry_series_coefficient, NULL, 1, 0, 0, 0, 0, 0, 0, 0x0,
     NULL, 1, 1, 0, series_coefficient_arguments, series_coefficient_results, NULL},
    {"series_residual", "series", entry_series_residual, NULL, 1, 0, 0, 0, 0, 0, 1, 0x0,
     NULL, 0, 1, 0, NULL, series_residual_results, NULL},
    {"series_pressure", "series", entry_series_pressure, NULL, 1, 0, 0, 0, 0, 0, 0, 0x0,
     NULL, 1, 1, 0, series_pressure_arguments, series_pressure_results, NULL},
    {"series_potential", "series", entry_series_potential, NULL, 1, 0, 0, 1, 0, 0, 0, 0x6,
     NULL, 3, 2, 0, series_potential_arguments, series_potential_results, NULL},
    {"series_stress", "series", entry_series_stress, NULL, 1, 0, 0, 1, 0, 0, 0, 0x6,
     NULL, 3, 3, 0, series_stress_arguments, series_stress_results, NULL},
};
enum { ENTRY_COUNT = sizeof entries / sizeof entries[0] };

/* By its number: the reason in an identifier of an error, rwedge:domain. */
static const char *const entry_reasons[] = {"ok", "domain", "null", "range", "noconv", "memory", "sliding", "rank", "absent", "path"};

#endif
