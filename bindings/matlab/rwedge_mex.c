/* SPDX-License-Identifier: GPL-3.0-or-later */
/* rwedge for MATLAB and GNU Octave, by the C Matrix API alone: [results] =
 * rwedge_mex('function', arguments...). Users call the functions and classes in functions/; each
 * makes one call to this file. What functions there are, with which arguments, is in the table of
 * entries.h, which is written from rwedge.h as they are.
 *
 * A function of numbers is taken over the elements of its arguments: arrays of one size, or of
 * size 1 in a dimension, which go with all along it. So is one of points. Other functions of
 * arrays take them whole. mexErrMsgIdAndTxt() does not return; nothing that must be freed is held
 * where it is called. */
#include "entries.h"
#include "rwedge.h"

#include <math.h>
#include <mex.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

/* ---- Errors ---------------------------------------------------------------------------------- */

static void fail(const char *reason, const char *format, ...)
{
    char id[32], text[1200];
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(text, sizeof text, format, arguments);
    va_end(arguments);
    snprintf(id, sizeof id, "rwedge:%s", reason);
    mexErrMsgIdAndTxt(id, "%s", text);
}

/* A whole number as the library takes it; false where it is none. */
static bool is_int32(double v)
{
    return v >= INT32_MIN && v <= INT32_MAX && v == floor(v);
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

static char message[1200]; /* of an error, in parts */

static void add(const char *format, ...)
{
    const size_t used = strlen(message);
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(message + used, sizeof message - used, format, arguments);
    va_end(arguments);
}

/* The arguments v[j][at[j]], and what is allowed: of the one that is to blame, the only one if
 * need be, or of all where it is none alone. Sizes are told where n is given. */
static void add_arguments(const entry *call, const double *const v[], const size_t at[],
                          const size_t n[])
{
    char number[32];
    const int sizes = n ? call->sizes : 0;
    for (int j = 0; j < call->arguments; j++)
        if (call->arguments + sizes == 1 || !entry_allows(&call->argument[j], v[j][at[j]])) {
            add(": %s = %s; allowed is %s", call->argument[j].name, text_of(v[j][at[j]], number),
                call->argument[j].allowed);
            return;
        }
    const char *between = ": ";
    for (int j = 0; j < call->arguments; j++, between = ", ")
        if (!n || call->argument[j].sizes[0] < 0)
            add("%s%s = %s", between, call->argument[j].name, text_of(v[j][at[j]], number));
    for (int j = 0; j < sizes; j++)
        add(", %s = %lu", call->size[j].name, (unsigned long)n[j]);
    between = "; allowed is ";
    for (int j = 0; j < call->arguments; j++, between = ", ")
        add("%s%s %s", between, call->argument[j].name, call->argument[j].allowed);
    for (int j = 0; j < sizes; j++)
        add(", %s %s", call->size[j].name, call->size[j].allowed);
}

/* Why there is no closed form, and what to do instead. */
static const char *obstacle(const entry *call, const void *object, const double *const v[],
                            const size_t at[])
{
    double loads[4];
    if (!object || !call->changes_object ||
        rwedge_contact_loads(object, loads, loads + 1, loads + 2, loads + 3) != RWEDGE_OK)
        return call->path;
    for (int j = 0; j < call->arguments; j++) /* P and Q, or all */
        loads[call->arguments > 2 ? j : 2 * j] = v[j][at[j]];
    return rwedge_contact_obstacle(object, loads[0], loads[1], loads[2], loads[3]);
}

/* The library's text, the arguments v[j][at[j]] where they are to blame, and which element of
 * several it is, counted from 0; -1 for none. */
static void fail_with(int32_t status, const entry *call, const void *object,
                      const double *const v[], const size_t at[], const size_t n[], long element)
{
    message[0] = '\0';
    add("rwedge_%s: %s", call->name, rwedge_strerror(status));
    if (status == RWEDGE_EABSENT && strcmp(call->object, "contact") == 0 && object &&
        rwedge_contact_half_width(object) == 0)
        add(": the contact is unloaded");
    const char *why = status == RWEDGE_EPATH ? obstacle(call, object, v, at) : NULL;
    if (why)
        add(": %s", why);
    if (status == RWEDGE_EDOMAIN || status == RWEDGE_ERANGE || status == RWEDGE_ESLIDING)
        add_arguments(call, v, at, n);
    if (element >= 0)
        add(" (element %ld)", element + 1);
    fail(entry_reasons[status], "%s", message);
}

/* ---- Handles: two numbers that a class holds, and forgets when it is deleted --------------- */

static double alive;

static void destroy_contact(void *object)
{
    rwedge_contact_destroy(object);
}

static void destroy_cycle(void *object)
{
    rwedge_cycle_destroy(object);
}

static void destroy_series(void *object)
{
    rwedge_series_destroy(object);
}

/* The families of objects: the function that frees one, as a command and in C. */
enum { FAMILIES = 3 };
static const struct {
    const char *name, *command;
    void (*destroy)(void *object);
} families[FAMILIES] = {{"contact", "contact_destroy", destroy_contact},
                        {"cycle", "cycle_destroy", destroy_cycle},
                        {"series", "series_destroy", destroy_series}};

/* The first number: when and where this copy of the file was loaded, as after build_rwedge there
 * may be two, that of the old objects and the new; times 1, 2 or 3 for the family. */
static double owner_of(const char *family)
{
    static double number;
    int i = 0;
    if (number == 0)
        number = ldexp((double)time(NULL), 20) + (double)((uintptr_t)&number >> 12 & 0xfffff);
    while (strcmp(families[i].name, family) != 0)
        i++;
    return (i + 1) * number;
}

static void *find(const char *family, const mxArray *handle)
{
    if (!mxIsDouble(handle) || mxIsComplex(handle) || mxGetNumberOfElements(handle) != 2)
        return NULL;
    const double *number = mxGetPr(handle);
    return number[0] == owner_of(family) ? (void *)(uintptr_t)number[1] : NULL;
}

/* The library stays in memory while there are objects of its own: "clear all" must not take it
 * from them. */
static mxArray *keep(const char *family, void *object)
{
    if (alive++ == 0)
        mexLock();
    mxArray *handle = mxCreateDoubleMatrix(1, 2, mxREAL);
    mxGetPr(handle)[0] = owner_of(family);
    mxGetPr(handle)[1] = (double)(uintptr_t)object;
    return handle;
}

/* ---- Arrays ---------------------------------------------------------------------------------- */

/* The sizes of the results. */
enum { MAX_DIMENSIONS = 32 };
typedef struct {
    mwSize count, size[MAX_DIMENSIONS];
} shape;

static mwSize size_in(const mxArray *array, mwSize dimension)
{
    return dimension < mxGetNumberOfDimensions(array) ? mxGetDimensions(array)[dimension] : 1;
}

/* Takes an array's sizes into those of the results: in each dimension the same, or 1, which goes
 * with all. */
static void extend(shape *all, const entry *call, int j, const mxArray *array)
{
    const mwSize dimensions = mxGetNumberOfDimensions(array);
    if (dimensions > MAX_DIMENSIONS)
        fail("size", "rwedge_%s: %s has more than %d dimensions", call->name,
             call->argument[j].name, (int)MAX_DIMENSIONS);
    for (; all->count < dimensions; all->count++)
        all->size[all->count] = 1;
    for (mwSize k = 0; k < all->count; k++) {
        const mwSize size = size_in(array, k);
        if (size != 1 && all->size[k] != 1 && size != all->size[k])
            fail("size",
                 "rwedge_%s: %s has the size %lu in dimension %lu, where those before it have %lu",
                 call->name, call->argument[j].name, (unsigned long)size, (unsigned long)k + 1,
                 (unsigned long)all->size[k]);
        if (all->size[k] == 1)
            all->size[k] = size;
    }
}

/* The element of an array that goes with element i of the results. */
static size_t place(const mxArray *array, const shape *all, size_t i)
{
    size_t at = 0, step = 1;
    for (mwSize k = 0; k < all->count; k++, i /= (size_t)all->size[k - 1]) {
        const size_t size = (size_t)size_in(array, k);
        at += size == 1 ? 0 : i % size * step;
        step *= size;
    }
    return at;
}

/* The numbers of an argument. Those of another class are converted by MATLAB, which frees them. */
static const double *numbers_of(const entry *call, int j, const mxArray *array)
{
    const bool numbers = mxIsNumeric(array) || mxIsLogical(array);
    if (!numbers || mxIsComplex(array) || mxIsSparse(array))
        fail("class", "rwedge_%s: %s is not a full array of real numbers, but %s %s", call->name,
             call->argument[j].name,
             mxIsSparse(array)    ? "sparse"
             : mxIsComplex(array) ? "complex"
                                  : "of class",
             mxGetClassName(array));
    if (mxIsDouble(array))
        return mxGetPr(array);
    mxArray *original = (mxArray *)(uintptr_t)array, *converted = NULL; /* not changed by it */
    mexCallMATLAB(1, &converted, 1, &original, "double");
    return mxGetPr(converted);
}

/* The function that takes n points such as these at once: this one, or that of its arrays; or
 * NULL. */
static const entry *array_function(const entry *call, const mxArray *const arguments[], size_t n)
{
    const entry *many = call->pointwise ? call : entry_of_arrays(call->name);
    for (int j = 0; many && j < many->arguments; j++)
        if (mxGetNumberOfElements(arguments[j]) != (many->argument[j].sizes[0] < 0 ? 1 : n))
            return NULL;
    return many;
}

/* No call where a number is not whole that must be: outside the domain. */
static int32_t status_of(const entry *call, void *object, const size_t n[], const double *const v[],
                         double *const r[], void **made)
{
    for (int j = 0; j < call->arguments; j++)
        if (call->argument[j].whole && !is_int32(*v[j]))
            return RWEDGE_EDOMAIN;
    return call->call(object, n, v, r, made);
}

/* One element, v[j][at[j]]. A formula gives NaN outside its domain, and a branch of yield that
 * does not exist is an answer, NaN: a sweep goes on. */
static void map_element(const entry *call, void *object, const double *const v[], const size_t at[],
                        double *const r[], size_t i, size_t n)
{
    static const size_t single[ENTRY_SIZES] = {1};
    const double *w[ENTRY_ARGUMENTS];
    double *s[ENTRY_RESULTS];
    for (int j = 0; j < call->arguments; j++)
        w[j] = &v[j][at[j]];
    for (int j = 0; j < call->results; j++)
        s[j] = &r[j][i];
    const int32_t status = status_of(call, object, single, w, s, NULL);
    const bool is_answer = !call->has_status || (status == RWEDGE_EABSENT && !call->takes_object);
    if (status != RWEDGE_OK && !is_answer)
        fail_with(status, call, object, v, at, NULL, n > 1 ? (long)i : -1);
    for (int j = 0; status != RWEDGE_OK && j < call->results; j++)
        *s[j] = NAN;
}

static void map(const entry *call, void *object, const mxArray *const arguments[],
                mxArray *results[])
{
    const double *v[ENTRY_ARGUMENTS];
    double *r[ENTRY_RESULTS];
    size_t n = 1, at[ENTRY_ARGUMENTS];
    shape all = {2, {1, 1}};
    for (int j = 0; j < call->arguments; j++)
        extend(&all, call, j, arguments[j]);
    for (mwSize k = 0; k < all.count; k++)
        n *= (size_t)all.size[k];
    for (int j = 0; j < call->arguments; j++)
        v[j] = numbers_of(call, j, arguments[j]);
    for (int j = 0; j < call->results; j++) {
        results[j] = mxCreateNumericArray(all.count, all.size, mxDOUBLE_CLASS, mxREAL);
        r[j] = mxGetPr(results[j]);
    }
    /* where it fails, the loop finds out which point it is */
    const entry *many = n > 1 ? array_function(call, arguments, n) : NULL;
    if (many && many->call(object, &n, v, r, NULL) == RWEDGE_OK)
        return;
    for (size_t i = 0; i < n; i++) {
        for (int j = 0; j < call->arguments; j++)
            at[j] = mxGetNumberOfElements(arguments[j]) == n ? i : place(arguments[j], &all, i);
        map_element(call, object, v, at, r, i, n);
    }
}

/* ---- Functions of whole arrays, and what makes objects --------------------------------------- */

/* Takes a size of an argument, which must agree with those before. */
static void take_size(const entry *call, int j, int size, size_t count, size_t n[], bool known[])
{
    if (known[size] && n[size] != count)
        fail("size", "rwedge_%s: %s has the size %lu, where %lu is needed", call->name,
             call->argument[j].name, (unsigned long)count, (unsigned long)n[size]);
    n[size] = count;
    known[size] = true;
}

/* The arguments of a function that tells a size: those of the call, by their names. */
static void arguments_of_teller(const entry *teller, const entry *call, const double *const v[],
                                const double *own[])
{
    for (int i = 0; i < teller->arguments; i++)
        for (int j = 0; j < call->arguments; j++)
            if (strcmp(teller->argument[i].name, call->argument[j].name) == 0)
                own[i] = v[j];
}

/* Those that a function tells, or that are fixed. 0 is told where any size will do, or where the
 * function is going to refuse. */
static void tell_sizes(const entry *call, void *object, const double *const v[], size_t n[],
                       bool known[])
{
    for (int j = 0; j < call->sizes; j++) {
        double told = call->size[j].count ? (double)call->size[j].count(v) : 0;
        double *const r[] = {&told};
        if (call->size[j].teller) {
            const entry *teller = entry_named(call->size[j].teller);
            const double *own[ENTRY_ARGUMENTS] = {NULL};
            arguments_of_teller(teller, call, v, own);
            teller->call(object, NULL, own, r, NULL);
        }
        n[j] = (size_t)told;
        known[j] = call->size[j].teller || told > 0;
    }
}

/* The sizes of the arrays, which must agree, or what a function tells. Numbers must be scalars.
 * An array of two sizes has the points down and the loads across: MATLAB's columns come first. */
static void measure(const entry *call, void *object, const mxArray *const arguments[],
                    const double *const v[], size_t n[])
{
    bool known[ENTRY_SIZES] = {false};
    for (int j = 0; j < call->arguments; j++)
        if (call->argument[j].sizes[0] < 0 && mxGetNumberOfElements(arguments[j]) != 1)
            fail("size", "rwedge_%s: %s is a scalar", call->name, call->argument[j].name);
    tell_sizes(call, object, v, n, known);
    for (int j = 0; j < call->arguments; j++) {
        const signed char *sizes = call->argument[j].sizes;
        const size_t count = mxGetNumberOfElements(arguments[j]),
                     rows = (size_t)mxGetDimensions(arguments[j])[0];
        if (sizes[0] >= 0)
            take_size(call, j, sizes[0], sizes[1] < 0 ? count : rows ? count / rows : 0, n, known);
        if (sizes[1] >= 0)
            take_size(call, j, sizes[1], rows, n, known);
    }
}

static mxArray *result_array(const entry_result *result, const size_t n[])
{
    const size_t rows = result->sizes[0] < 0 ? 1 : n[result->sizes[result->sizes[1] < 0 ? 0 : 1]],
                 columns = result->sizes[1] < 0 ? 1 : n[result->sizes[0]];
    return mxCreateDoubleMatrix((mwSize)rows, (mwSize)columns, mxREAL);
}

/* Ends with the first element of an array that is outside its domain, or with all numbers. */
static void fail_whole(int32_t status, const entry *call, const void *object,
                       const double *const v[], const size_t n[])
{
    size_t at[ENTRY_ARGUMENTS] = {0};
    for (int j = 0; status == RWEDGE_EDOMAIN && j < call->arguments; j++) {
        const signed char *sizes = call->argument[j].sizes;
        const size_t count = sizes[0] < 0 ? 0 : n[sizes[0]] * (sizes[1] < 0 ? 1 : n[sizes[1]]);
        for (at[j] = 0; at[j] < count; at[j]++)
            if (!entry_allows(&call->argument[j], v[j][at[j]]))
                fail_with(status, call, object, v, at, n, (long)at[j]);
        at[j] = 0;
    }
    fail_with(status, call, object, v, at, n, -1);
}

static void whole(const entry *call, void *object, const mxArray *const arguments[],
                  mxArray *results[], void **made)
{
    const double *v[ENTRY_ARGUMENTS];
    double *r[ENTRY_RESULTS];
    size_t n[ENTRY_SIZES] = {0};
    for (int j = 0; j < call->arguments; j++)
        v[j] = numbers_of(call, j, arguments[j]);
    measure(call, object, arguments, v, n);
    for (int j = 0; j < call->results; j++) {
        results[j] = result_array(&call->result[j], n);
        r[j] = mxGetPr(results[j]);
    }
    const int32_t status = status_of(call, object, n, v, r, made);
    if (status != RWEDGE_OK)
        fail_whole(status, call, object, v, n);
}

/* ---- Calls by name --------------------------------------------------------------------------- */

/* What entries.h does not have. Nothing is freed where nothing is: a destructor must not fail. How
 * many objects are alive is for the tests. */
static mxArray *run_command(const char *name, int count, const mxArray *const arguments[])
{
    if (strcmp(name, "version") == 0)
        return mxCreateString(rwedge_version());
    if (strcmp(name, "alive") == 0)
        return mxCreateDoubleScalar(alive);
    int i = 0;
    while (i < FAMILIES && strcmp(name, families[i].command) != 0)
        i++;
    if (count != 1 || i == FAMILIES)
        fail("arguments", "rwedge_%s: no such function", name);
    void *object = find(families[i].name, arguments[0]);
    if (object) {
        families[i].destroy(object);
        if (--alive == 0)
            mexUnlock();
    }
    return NULL;
}

/* The text for numbers. Where one must be whole and is not, that for -1, which is none. */
static mxArray *call_text(const entry *call, const void *object, const mxArray *const arguments[])
{
    static const double none = -1;
    const double *v[ENTRY_ARGUMENTS];
    for (int j = 0; j < call->arguments; j++) {
        v[j] = numbers_of(call, j, arguments[j]);
        if (mxGetNumberOfElements(arguments[j]) != 1)
            fail("size", "rwedge_%s: %s is a scalar", call->name, call->argument[j].name);
        if (call->argument[j].whole && !is_int32(*v[j]))
            v[j] = &none;
    }
    return mxCreateString(call->text(object, v));
}

static void call_entry(const entry *call, int nlhs, mxArray *plhs[], int nrhs,
                       const mxArray *const prhs[])
{
    void *object = NULL, *made = NULL;
    if (call->takes_object) {
        object = nrhs > 0 ? find(call->object, prhs[0]) : NULL;
        if (!object)
            fail("handle", "rwedge_%s: there is no such %s (any more)", call->name, call->object);
        nrhs--;
        prhs++;
    }
    const int count = call->makes_object ? 1 : call->results;
    if (nrhs != call->arguments || (nlhs != count && !(nlhs == 0 && count == 1)))
        fail("arguments", "rwedge_%s takes %d argument(s) and gives %d result(s), not %d and %d",
             call->name, call->arguments, count, nrhs, nlhs);
    if (call->text)
        plhs[0] = call_text(call, object, prhs);
    else if (call->makes_object || (call->sizes > 0 && !call->pointwise))
        whole(call, object, prhs, plhs, &made);
    else
        map(call, object, prhs, plhs);
    if (call->makes_object)
        plhs[0] = keep(call->family, made);
}

void mexFunction(int nlhs, mxArray *plhs[], int nrhs, const mxArray *prhs[])
{
    char name[40];
    if (nrhs < 1 || mxGetString(prhs[0], name, sizeof name) != 0)
        fail("arguments", "rwedge_mex('function', arguments...): see the functions rwedge_*");
    const entry *call = entry_named(name);
    if (call) {
        call_entry(call, nlhs, plhs, nrhs - 1, prhs + 1);
        return;
    }
    mxArray *result = run_command(name, nrhs - 1, (const mxArray *const *)prhs + 1);
    if (result)
        plhs[0] = result;
}
