/* SPDX-License-Identifier: GPL-3.0-or-later */
/* rwedge for MATLAB and GNU Octave, by the C Matrix API alone: [results] =
 * rwedge_mex('function', arguments...). The functions and classes that users call are written by
 * build_rwedge.m from rwedge.h; each makes one call to this file.
 *
 * Every function is one of doubles, and is taken over the elements of its arguments: arrays of
 * one size, or scalars, which go with every element. mexErrMsgIdAndTxt() does not return;
 * nothing that must be freed is held where it is called. */
#include "rwedge.h"

#include <float.h>
#include <math.h>
#include <mex.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

enum { MAX_ARGUMENTS = 6, MAX_RESULTS = 3 };

/* ---- Errors ---------------------------------------------------------------------------------- */

static void fail(const char *reason, const char *format, ...)
{
    char id[32], text[1024];
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(text, sizeof text, format, arguments);
    va_end(arguments);
    snprintf(id, sizeof id, "rwedge:%s", reason);
    mexErrMsgIdAndTxt(id, "%s", text);
}

static const char *reason_of(int32_t status)
{
    static const char *const reasons[] = {"ok",     "domain",  "null", "range", "noconv",
                                          "memory", "sliding", "rank", "absent"};
    return status > 0 && status < (int32_t)(sizeof reasons / sizeof reasons[0]) ? reasons[status]
                                                                                : "unknown";
}

/* What an argument of a function with a status is, and where it is defined: for the messages.
 * Whether a call is an error is for the library to say. */
typedef struct {
    const char *name;
    double low, high; /* finite, low <= value <= high */
    bool above;       /* and not low itself */
    const char *allowed;
} quantity;

static const quantity alpha = {"alpha", 0, DBL_MAX, false, "finite and >= 0"},
                      tip = {"alpha", 0, DBL_MAX, false, "0 or >= 1e-14"},
                      f = {"f", 0, 1e6, false, "0 to 1e6"}, nu = {"nu", 0, 0.5, false, "0 to 0.5"},
                      c = {"c", 0, 1, false, "0 to 1"},
                      x = {"x", -DBL_MAX, DBL_MAX, false, "finite"},
                      point = {"x", -DBL_MAX, DBL_MAX, false,
                               "finite, and (x, y) not the apex (0, 0) of a sharp wedge"},
                      y = {"y", 0, DBL_MAX, false, "finite and >= 0"},
                      theta = {"theta", 0, 1.5707963267948963, true, "> 0 and < pi/2"},
                      a = {"a", 0, DBL_MAX, false, "finite and >= 0"},
                      A = {"A", 0, DBL_MAX, true, "finite and > 0"},
                      k = {"k", 0, DBL_MAX, true, "finite and > 0, so that the factor is finite"},
                      P = {"P", 0, 1e148, false,
                           "0, or 1e-148 to 1e148 and at least 1e-8 of the last P"},
                      Q = {"Q", -DBL_MAX, DBL_MAX, false, "finite, |Q| <= f P"},
                      terms = {"terms", 1, 16777216, false, "whole, 1 to 2^24"},
                      fitted = {"terms", 1, 16777216, false,
                                "whole, 1 to 2^24, and samples * terms <= 2^27"},
                      surface = {"x", -DBL_MAX, DBL_MAX, false,
                                 "finite, and for a loaded sharp wedge not 0"},
                      inside = {"x", -DBL_MAX, DBL_MAX, false, "|x| <= b, the contact"},
                      abscissa = {"x", -1 + DBL_EPSILON / 2, 1 - DBL_EPSILON / 2, false, "|x| < 1"},
                      sample = {"p", -DBL_MAX, DBL_MAX, false, "finite"};

static bool is_in_domain(const quantity *q, double v)
{
    if ((q == &tip && v > 0 && v < 1e-14) || (q == &P && v > 0 && v < 1e-148) ||
        (q == &terms && v != floor(v)))
        return false;
    return v >= q->low && v <= q->high && !(q->above && v == q->low);
}

/* A number as MATLAB writes it. */
static const char *text_of(double v, char text[32])
{
    if (isnan(v) || isinf(v))
        strcpy(text, isnan(v) ? "NaN" : v > 0 ? "Inf" : "-Inf");
    else
        snprintf(text, 32, "%.15g", v);
    return text;
}

/* The library's text, then the argument that is to blame, the only one if need be, or all of
 * them where it is none alone; and what is allowed. */
static void fail_with(int32_t status, const char *function, int arguments,
                      const quantity *const of[], const double v[], size_t i, size_t n)
{
    const bool is_outside = status == RWEDGE_EDOMAIN || status == RWEDGE_ERANGE;
    char blamed[640] = "", place[40] = "", number[32];
    size_t length = 0;
    for (int j = 0; is_outside && j < arguments && !length; j++)
        if (arguments == 1 || !is_in_domain(of[j], v[j]))
            length = (size_t)snprintf(blamed, sizeof blamed, ": %s = %s; allowed is %s",
                                      of[j]->name, text_of(v[j], number), of[j]->allowed);
    for (int j = 0; !length && j < arguments; j++)
        snprintf(blamed + strlen(blamed), sizeof blamed - strlen(blamed), "%s%s = %s",
                 j ? ", " : ": ", of[j]->name, text_of(v[j], number));
    for (int j = 0; !length && is_outside && j < arguments; j++)
        snprintf(blamed + strlen(blamed), sizeof blamed - strlen(blamed), "%s%s %s",
                 j ? ", " : "; allowed is ", of[j]->name, of[j]->allowed);
    if (n > 1)
        snprintf(place, sizeof place, " (element %lu)", (unsigned long)(i + 1));
    fail(reason_of(status), "rwedge_%s: %s%s%s", function, rwedge_strerror(status), blamed, place);
}

/* ---- Handles: pairs of numbers that are never used twice ------------------------------------- */

typedef enum { NOTHING, CONTACT, SERIES } kind;

typedef struct {
    kind of;
    void *object;
    double number[2]; /* which copy of this file, and which of its objects */
} handle;

static handle *handles;
static size_t handle_count, alive;
static double last_number;

/* When and where this copy of the file was loaded: after build_rwedge there may be two, that of
 * the old objects and the new. */
static double this_copy(void)
{
    static double number;
    if (number == 0)
        number = ldexp((double)time(NULL), 20) + (double)((uintptr_t)&number >> 12 & 0xfffff);
    return number;
}

static void destroy(handle *h)
{
    if (h->of == CONTACT)
        rwedge_contact_destroy(h->object);
    else
        rwedge_series_destroy(h->object);
    h->of = NOTHING;
    if (--alive == 0)
        mexUnlock();
}

static void destroy_all(void)
{
    for (size_t i = 0; i < handle_count; i++)
        if (handles[i].of != NOTHING)
            destroy(&handles[i]);
    free(handles);
    handles = NULL;
    handle_count = 0;
}

/* A slot that is free, or NULL where there is no memory for more. Asked for before an object is
 * made, so that none is lost. */
static handle *free_slot(void)
{
    for (size_t i = 0; i < handle_count; i++)
        if (handles[i].of == NOTHING)
            return &handles[i];
    const size_t more = 2 * handle_count + 8;
    handle *larger = realloc(handles, more * sizeof *larger);
    if (!larger)
        return NULL;
    handles = larger;
    for (size_t i = handle_count; i < more; i++)
        handles[i].of = NOTHING;
    larger = &handles[handle_count];
    handle_count = more;
    return larger;
}

/* The library stays in memory while there are objects of its own: "clear all" must not take it
 * from them. */
static mxArray *keep(handle *slot, kind of, void *object)
{
    *slot = (handle){of, object, {this_copy(), ++last_number}};
    if (alive++ == 0)
        mexLock();
    mxArray *number = mxCreateDoubleMatrix(1, 2, mxREAL);
    memcpy(mxGetPr(number), slot->number, sizeof slot->number);
    return number;
}

static handle *find(kind of, const mxArray *number)
{
    if (!mxIsDouble(number) || mxIsComplex(number) || mxGetNumberOfElements(number) != 2)
        return NULL;
    for (size_t i = 0; i < handle_count; i++)
        if (handles[i].of == of &&
            memcmp(handles[i].number, mxGetPr(number), sizeof handles[i].number) == 0)
            return &handles[i];
    return NULL;
}

static void fail_without(const char *function, kind of)
{
    fail("handle", "rwedge_%s: there is no such %s (any more)", function,
         of == CONTACT ? "contact" : "series");
}

/* ---- The functions, each of doubles ---------------------------------------------------------- */

/* One call: a value, or a status and results. An object is what the function belongs to, or
 * NULL. */
typedef double value_function(const void *object, const double v[]);
typedef int32_t status_function(void *object, const double v[], double r[]);

/* Many points at once: scalars v[j][0], then arrays of n. */
typedef int32_t array_function(void *object, size_t n, const double *const v[], double *const r[]);

/* A whole number as the library takes it; false where it is none. */
static bool is_int32(double v)
{
    return v >= INT32_MIN && v <= INT32_MAX && v == floor(v);
}

#define VALUE(name, call)                                                                          \
    static double name(const void *object, const double v[])                                       \
    {                                                                                              \
        (void)object;                                                                              \
        (void)v;                                                                                   \
        return call;                                                                               \
    }
#define STATUS(name, call)                                                                         \
    static int32_t name(void *object, const double v[], double r[])                                \
    {                                                                                              \
        (void)object;                                                                              \
        (void)r;                                                                                   \
        return call;                                                                               \
    }
#define ARRAY(name, call)                                                                          \
    static int32_t name(void *object, size_t n, const double *const v[], double *const r[])        \
    {                                                                                              \
        (void)object;                                                                              \
        return call;                                                                               \
    }

VALUE(compliance, rwedge_compliance(v[0], v[1], v[2], v[3]))
VALUE(dundurs_beta, rwedge_dundurs_beta(v[0], v[1], v[2], v[3]))
VALUE(load, rwedge_load(v[0]))
VALUE(a_over_b, rwedge_a_over_b(v[0]))
VALUE(pressure, rwedge_pressure(v[0], v[1]))
VALUE(peak_pressure, rwedge_peak_pressure(v[0]))
VALUE(transition_pressure, rwedge_transition_pressure(v[0]))
VALUE(coefficient, is_int32(v[1]) ? rwedge_coefficient(v[0], (int32_t)v[1]) : NAN)
VALUE(stick_width, rwedge_stick_width(v[0], v[1]))
VALUE(shear_ratio, rwedge_shear_ratio(v[0], v[1]))
VALUE(shear, rwedge_shear(v[0], v[1], v[2]))
VALUE(max_tension, rwedge_max_tension(v[0]))
VALUE(elastic_limit, rwedge_elastic_limit(v[0], v[1], v[2]))
VALUE(critical_friction, rwedge_critical_friction(v[0], v[1]))
VALUE(radius, rwedge_radius(v[0], v[1]))
VALUE(rounding, rwedge_rounding(v[0], v[1]))
VALUE(half_width, rwedge_half_width(v[0], v[1], v[2], v[3]))
VALUE(normal_load, rwedge_normal_load(v[0], v[1], v[2], v[3]))
VALUE(yield_load, rwedge_yield_load(v[0], v[1], v[2], v[3], v[4], v[5]))
STATUS(stress, rwedge_stress(v[0], v[1], v[2], v[3], v[4], &r[0], &r[1], &r[2]))
ARRAY(stresses, rwedge_stresses(*v[0], *v[1], *v[2], n, v[3], v[4], r[0], r[1], r[2]))
STATUS(yield_point, rwedge_yield_point(v[0], v[1], v[2], &r[0], &r[1], &r[2]))
STATUS(subsurface_yield, rwedge_subsurface_yield(v[0], v[1], v[2], &r[0], &r[1], &r[2]))
STATUS(surface_yield, rwedge_surface_yield(v[0], v[1], v[2], &r[0], &r[1]))

STATUS(contact_load, rwedge_contact_load(object, v[0], v[1]))
VALUE(contact_half_width, rwedge_contact_half_width(object))
VALUE(contact_stick_half_width, rwedge_contact_stick_half_width(object))
VALUE(contact_memory, (double)rwedge_contact_memory(object))
STATUS(contact_tractions, rwedge_contact_tractions(object, 1, &v[0], &r[0], &r[1]))
ARRAY(contact_tractions_at, rwedge_contact_tractions(object, n, v[0], r[0], r[1]))
STATUS(contact_stresses, rwedge_contact_stresses(object, 1, &v[0], &v[1], &r[0], &r[1], &r[2]))
ARRAY(contact_stresses_at, rwedge_contact_stresses(object, n, v[0], v[1], r[0], r[1], r[2]))
STATUS(contact_slip, rwedge_contact_slip(object, 1, &v[0], &r[0]))
ARRAY(contact_slip_at, rwedge_contact_slip(object, n, v[0], r[0]))
VALUE(contact_dissipated_energy, rwedge_contact_dissipated_energy(object))
STATUS(contact_yield_factor, rwedge_contact_yield_factor(object, v[0], v[1], &r[0], &r[1], &r[2]))

VALUE(series_terms, rwedge_series_terms(object))
VALUE(series_coefficient, is_int32(v[0]) ? rwedge_series_coefficient(object, (int32_t)v[0]) : NAN)
VALUE(series_residual, rwedge_series_residual(object))
VALUE(series_pressure, rwedge_series_pressure(object, v[0]))
STATUS(series_potential, rwedge_series_potential(object, v[0], v[1], v[2], &r[0], &r[1]))
STATUS(series_stress, rwedge_series_stress(object, v[0], v[1], v[2], &r[0], &r[1], &r[2]))

typedef struct {
    const char *name;
    kind of; /* what it belongs to, its first argument then, or NOTHING */
    int arguments, results;
    value_function *value; /* or */
    status_function *status;
    const quantity *quantities[MAX_ARGUMENTS]; /* of a status function */
    array_function *array;                     /* or NULL */
    /* how many of the arguments an array function takes once */
    int scalars;
} function;

static const function functions[] = {
    {"compliance", NOTHING, 4, 1, compliance, NULL, {0}, NULL, 0},
    {"dundurs_beta", NOTHING, 4, 1, dundurs_beta, NULL, {0}, NULL, 0},
    {"load", NOTHING, 1, 1, load, NULL, {0}, NULL, 0},
    {"a_over_b", NOTHING, 1, 1, a_over_b, NULL, {0}, NULL, 0},
    {"pressure", NOTHING, 2, 1, pressure, NULL, {0}, NULL, 0},
    {"peak_pressure", NOTHING, 1, 1, peak_pressure, NULL, {0}, NULL, 0},
    {"transition_pressure", NOTHING, 1, 1, transition_pressure, NULL, {0}, NULL, 0},
    {"coefficient", NOTHING, 2, 1, coefficient, NULL, {0}, NULL, 0},
    {"stick_width", NOTHING, 2, 1, stick_width, NULL, {0}, NULL, 0},
    {"shear_ratio", NOTHING, 2, 1, shear_ratio, NULL, {0}, NULL, 0},
    {"shear", NOTHING, 3, 1, shear, NULL, {0}, NULL, 0},
    {"max_tension", NOTHING, 1, 1, max_tension, NULL, {0}, NULL, 0},
    {"elastic_limit", NOTHING, 3, 1, elastic_limit, NULL, {0}, NULL, 0},
    {"critical_friction", NOTHING, 2, 1, critical_friction, NULL, {0}, NULL, 0},
    {"radius", NOTHING, 2, 1, radius, NULL, {0}, NULL, 0},
    {"rounding", NOTHING, 2, 1, rounding, NULL, {0}, NULL, 0},
    {"half_width", NOTHING, 4, 1, half_width, NULL, {0}, NULL, 0},
    {"normal_load", NOTHING, 4, 1, normal_load, NULL, {0}, NULL, 0},
    {"yield_load", NOTHING, 6, 1, yield_load, NULL, {0}, NULL, 0},
    {"stress", NOTHING, 5, 3, NULL, stress, {&alpha, &f, &c, &point, &y}, stresses, 3},
    {"yield_point", NOTHING, 3, 3, NULL, yield_point, {&tip, &f, &nu}, NULL, 0},
    {"subsurface_yield", NOTHING, 3, 3, NULL, subsurface_yield, {&tip, &f, &nu}, NULL, 0},
    {"surface_yield", NOTHING, 3, 2, NULL, surface_yield, {&tip, &f, &nu}, NULL, 0},
    {"contact_load", CONTACT, 2, 0, NULL, contact_load, {&P, &Q}, NULL, 0},
    {"contact_half_width", CONTACT, 0, 1, contact_half_width, NULL, {0}, NULL, 0},
    {"contact_stick_half_width", CONTACT, 0, 1, contact_stick_half_width, NULL, {0}, NULL, 0},
    {"contact_memory", CONTACT, 0, 1, contact_memory, NULL, {0}, NULL, 0},
    {"contact_tractions",
     CONTACT,
     1,
     2,
     NULL,
     contact_tractions,
     {&surface},
     contact_tractions_at,
     0},
    {"contact_stresses",
     CONTACT,
     2,
     3,
     NULL,
     contact_stresses,
     {&point, &y},
     contact_stresses_at,
     0},
    {"contact_slip", CONTACT, 1, 1, NULL, contact_slip, {&inside}, contact_slip_at, 0},
    {"contact_dissipated_energy", CONTACT, 0, 1, contact_dissipated_energy, NULL, {0}, NULL, 0},
    {"contact_yield_factor", CONTACT, 2, 3, NULL, contact_yield_factor, {&nu, &k}, NULL, 0},
    {"series_terms", SERIES, 0, 1, series_terms, NULL, {0}, NULL, 0},
    {"series_coefficient", SERIES, 1, 1, series_coefficient, NULL, {0}, NULL, 0},
    {"series_residual", SERIES, 0, 1, series_residual, NULL, {0}, NULL, 0},
    {"series_pressure", SERIES, 1, 1, series_pressure, NULL, {0}, NULL, 0},
    {"series_potential", SERIES, 3, 2, NULL, series_potential, {&f, &x, &y}, NULL, 0},
    {"series_stress", SERIES, 3, 3, NULL, series_stress, {&f, &x, &y}, NULL, 0},
};

/* ---- Arrays ---------------------------------------------------------------------------------- */

static bool same_size(const mxArray *one, const mxArray *other)
{
    const mwSize n = mxGetNumberOfDimensions(one);
    return n == mxGetNumberOfDimensions(other) &&
           memcmp(mxGetDimensions(one), mxGetDimensions(other),
                  (size_t)n * sizeof *mxGetDimensions(one)) == 0;
}

static bool is_scalar(const mxArray *array)
{
    return mxGetNumberOfElements(array) == 1;
}

/* The numbers of the arguments; NULL, or the one that is not a scalar and says the size of the
 * results. */
static const mxArray *take(const char *name, int count, const mxArray *const arguments[],
                           const double *v[])
{
    const mxArray *size = NULL;
    for (int j = 0; j < count; j++) {
        if (!mxIsDouble(arguments[j]) || mxIsComplex(arguments[j]) || mxIsSparse(arguments[j]))
            fail("class", "rwedge_%s: argument %d is not a full array of real doubles, but %s %s",
                 name, j + 1,
                 mxIsSparse(arguments[j])    ? "sparse"
                 : mxIsComplex(arguments[j]) ? "complex"
                                             : "of class",
                 mxGetClassName(arguments[j]));
        v[j] = mxGetPr(arguments[j]);
        if (is_scalar(arguments[j]))
            continue;
        if (size && !same_size(size, arguments[j]))
            fail("size",
                 "rwedge_%s: argument %d is neither a scalar nor of the size of those before it",
                 name, j + 1);
        size = arguments[j];
    }
    return size;
}

/* The arguments as an array function takes them? */
static bool suits_array(const function *call, const mxArray *const arguments[], size_t n)
{
    if (!call->array || n < 2)
        return false;
    for (int j = 0; j < call->arguments; j++)
        if (is_scalar(arguments[j]) != (j < call->scalars))
            return false;
    return true;
}

/* One element. A branch of yield that does not exist is an answer, NaN: a sweep goes on. */
static void one(const function *call, void *object, const double v[], double r[], size_t i,
                size_t n)
{
    if (call->value) {
        r[0] = call->value(object, v);
        return;
    }
    const int32_t status = call->status(object, v, r);
    if (status == RWEDGE_EABSENT && call->of == NOTHING)
        r[0] = r[1] = r[2] = NAN;
    else if (status != RWEDGE_OK)
        fail_with(status, call->name, call->arguments, call->quantities, v, i, n);
}

static void map(const function *call, void *object, const mxArray *const arguments[],
                mxArray *results[])
{
    const double *v[MAX_ARGUMENTS];
    double *r[MAX_RESULTS] = {NULL, NULL, NULL};
    const mxArray *size = take(call->name, call->arguments, arguments, v);
    const size_t n = size ? mxGetNumberOfElements(size) : 1;
    for (int j = 0; j < call->results; j++) {
        results[j] = size ? mxCreateNumericArray(mxGetNumberOfDimensions(size),
                                                 mxGetDimensions(size), mxDOUBLE_CLASS, mxREAL)
                          : mxCreateDoubleMatrix(1, 1, mxREAL);
        r[j] = mxGetPr(results[j]);
    }
    /* where it fails, the loop finds out which point it is */
    if (suits_array(call, arguments, n) && call->array(object, n, v, r) == RWEDGE_OK)
        return;
    size_t step[MAX_ARGUMENTS];
    for (int j = 0; j < call->arguments; j++)
        step[j] = is_scalar(arguments[j]) ? 0 : 1;
    for (size_t i = 0; i < n; i++) {
        double w[MAX_ARGUMENTS], s[MAX_RESULTS];
        for (int j = 0; j < call->arguments; j++)
            w[j] = v[j][i * step[j]];
        one(call, object, w, s, i, n);
        for (int j = 0; j < call->results; j++)
            r[j][i] = s[j];
    }
}

/* ---- What makes objects, and the rest -------------------------------------------------------- */

static handle *slot_or_fail(const char *name)
{
    handle *slot = free_slot();
    if (!slot)
        fail_with(RWEDGE_ENOMEM, name, 0, NULL, NULL, 0, 1);
    return slot;
}

static void all_scalars(const char *name, int count, const mxArray *const arguments[], double v[])
{
    const double *numbers[MAX_ARGUMENTS];
    if (take(name, count, arguments, numbers))
        fail("size", "rwedge_%s takes scalars", name);
    for (int j = 0; j < count; j++)
        v[j] = *numbers[j];
}

static mxArray *contact_create(const mxArray *const arguments[])
{
    static const quantity *const of[] = {&theta, &a, &A, &f};
    double v[4];
    rwedge_contact *contact;
    all_scalars("contact", 4, arguments, v);
    handle *slot = slot_or_fail("contact");
    const int32_t status = rwedge_contact_create(v[0], v[1], v[2], v[3], &contact);
    if (status != RWEDGE_OK)
        fail_with(status, "contact", 4, of, v, 0, 1);
    return keep(slot, CONTACT, contact);
}

static mxArray *contact_copy(const mxArray *const arguments[])
{
    rwedge_contact *copy;
    handle *slot = slot_or_fail("contact_copy");
    const handle *from = find(CONTACT, arguments[0]); /* after free_slot(), which may move them */
    if (!from)
        fail_without("contact_copy", CONTACT);
    const int32_t status = rwedge_contact_copy(from->object, &copy);
    if (status != RWEDGE_OK)
        fail_with(status, "contact_copy", 0, NULL, NULL, 0, 1);
    return keep(slot, CONTACT, copy);
}

static mxArray *series_create(const mxArray *const arguments[])
{
    static const quantity *const of[] = {&alpha, &terms};
    double v[2];
    rwedge_series *series = NULL;
    all_scalars("series", 2, arguments, v);
    handle *slot = slot_or_fail("series");
    const int32_t status =
        is_int32(v[1]) ? rwedge_series_create(v[0], (int32_t)v[1], &series) : RWEDGE_EDOMAIN;
    if (status != RWEDGE_OK)
        fail_with(status, "series", 2, of, v, 0, 1);
    return keep(slot, SERIES, series);
}

/* For the first of n samples that is outside the domain. */
static void fail_at_sample(size_t n, const double *const samples[])
{
    static const quantity *const of[] = {&abscissa, &sample};
    size_t i = 0;
    while (i + 1 < n && is_in_domain(&abscissa, samples[0][i]) &&
           is_in_domain(&sample, samples[1][i]))
        i++;
    const double v[] = {samples[0][i], samples[1][i]};
    fail_with(RWEDGE_EDOMAIN, "series_fit", 2, of, v, i, n);
}

static mxArray *series_fit(const mxArray *const arguments[])
{
    static const quantity *const of[] = {&fitted};
    const double *samples[2];
    double count;
    rwedge_series *series = NULL;
    take("series_fit", 2, arguments, samples);
    all_scalars("series_fit", 1, arguments + 2, &count);
    if (!same_size(arguments[0], arguments[1]))
        fail("size", "rwedge_series_fit: x and p differ in size");
    handle *slot = slot_or_fail("series_fit");
    const size_t n = mxGetNumberOfElements(arguments[0]);
    const int32_t status =
        is_int32(count) ? rwedge_series_fit(n, samples[0], samples[1], (int32_t)count, &series)
                        : RWEDGE_EDOMAIN;
    if (status == RWEDGE_EDOMAIN && is_int32(count))
        fail_at_sample(n, samples);
    if (status != RWEDGE_OK)
        fail_with(status, "series_fit", 1, of, &count, 0, 1);
    return keep(slot, SERIES, series);
}

/* Nothing where there is nothing: a destructor must not fail. */
static mxArray *destroy_contact(const mxArray *const arguments[])
{
    handle *h = find(CONTACT, arguments[0]);
    if (h)
        destroy(h);
    return NULL;
}

static mxArray *destroy_series(const mxArray *const arguments[])
{
    handle *h = find(SERIES, arguments[0]);
    if (h)
        destroy(h);
    return NULL;
}

static mxArray *version(const mxArray *const arguments[])
{
    (void)arguments;
    return mxCreateString(rwedge_version());
}

static mxArray *error_text(const mxArray *const arguments[])
{
    double status;
    all_scalars("strerror", 1, arguments, &status);
    return mxCreateString(rwedge_strerror(is_int32(status) ? (int32_t)status : -1));
}

/* How many objects there are: for the tests. */
static mxArray *objects_alive(const mxArray *const arguments[])
{
    (void)arguments;
    return mxCreateDoubleScalar((double)alive);
}

static const struct {
    const char *name;
    int arguments;
    mxArray *(*run)(const mxArray *const arguments[]);
} commands[] = {
    {"contact_create", 4, contact_create},
    {"contact_copy", 1, contact_copy},
    {"contact_destroy", 1, destroy_contact},
    {"series_create", 2, series_create},
    {"series_fit", 3, series_fit},
    {"series_destroy", 1, destroy_series},
    {"version", 0, version},
    {"strerror", 1, error_text},
    {"alive", 0, objects_alive},
};

#define COUNT(array) (sizeof(array) / sizeof(array)[0])

static void need(const char *name, int arguments, int given)
{
    if (given != arguments)
        fail("arguments", "rwedge_%s takes %d argument%s, not %d", name, arguments,
             arguments == 1 ? "" : "s", given);
}

static void call(const function *of, int nlhs, mxArray *plhs[], int nrhs,
                 const mxArray *const prhs[])
{
    mxArray *results[MAX_RESULTS] = {NULL, NULL, NULL};
    void *object = NULL;
    if (of->of != NOTHING) {
        const handle *h = nrhs > 0 ? find(of->of, prhs[0]) : NULL;
        if (!h)
            fail_without(of->name, of->of);
        object = h->object;
        nrhs--;
        prhs++;
    }
    need(of->name, of->arguments, nrhs);
    if (nlhs > of->results)
        fail("arguments", "rwedge_%s gives %d result%s, not %d", of->name, of->results,
             of->results == 1 ? "" : "s", nlhs);
    map(of, object, prhs, results);
    for (int j = 0; j < of->results; j++)
        if (j == 0 || j < nlhs)
            plhs[j] = results[j];
        else
            mxDestroyArray(results[j]);
}

void mexFunction(int nlhs, mxArray *plhs[], int nrhs, const mxArray *prhs[])
{
    char name[40];
    mexAtExit(destroy_all);
    if (nrhs < 1 || mxGetString(prhs[0], name, sizeof name) != 0)
        fail("arguments", "rwedge_mex('function', arguments...): see the functions rwedge_*");
    for (size_t i = 0; i < COUNT(functions); i++)
        if (strcmp(name, functions[i].name) == 0) {
            call(&functions[i], nlhs, plhs, nrhs - 1, prhs + 1);
            return;
        }
    for (size_t i = 0; i < COUNT(commands); i++)
        if (strcmp(name, commands[i].name) == 0) {
            need(name, commands[i].arguments, nrhs - 1);
            mxArray *result = commands[i].run(prhs + 1);
            if (result)
                plhs[0] = result;
            return;
        }
    fail("arguments", "rwedge_%s: no such function", name);
}
