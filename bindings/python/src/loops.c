/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The inner loops of the package's NumPy ufuncs, over the table of functions in entries.h, which
 * bindings/interface writes from rwedge.h. They have the signature that NumPy calls, and need
 * neither Python's nor NumPy's headers: rwedge/_ufuncs.py makes the ufuncs of them.
 *
 * Where the arguments are refused the results are NaN and FE_INVALID is raised, as by sqrt(-1), so
 * that numpy.errstate(invalid=...) rules what happens. Where the result does not exist, or an
 * argument is NaN, they are NaN without it. No other exception leaves a loop. */
#include "entries.h"

#include <fenv.h>
#include <math.h>
#include <stdbool.h>
#include <stdlib.h>

enum { BLOCK = 256 }; /* how many points go into one call */

/* The row of a function, to be given to the loops as data: that of the function which takes its
 * arguments in arrays, where there is one. */
RWEDGE_API const void *rwedge_entry(const char *name)
{
    const entry *many = entry_of_arrays(name);
    return many ? many : entry_named(name);
}

/* How many numbers an argument or a result has. */
static size_t count_of(const signed char sizes[2], const size_t n[])
{
    return sizes[0] < 0 ? 1 : n[sizes[0]];
}

/* Evaluates one point, of arrays of the sizes n where they are not its own. Was it outside the
 * domain? */
static bool point(const entry *call, void *object, const size_t n[], const double *const v[],
                  double *const r[])
{
    const int32_t status = call->call(object, n, v, r, NULL);
    if (status == RWEDGE_OK && (call->has_status || !isnan(*r[0])))
        return false;
    bool nan = false;
    for (int k = 0; k < call->arguments; k++)
        for (size_t j = 0; j < count_of(call->argument[k].sizes, n); j++)
            nan |= isnan(v[k][j]);
    for (int k = 0; k < call->results; k++)
        for (size_t j = 0; j < count_of(call->result[k].sizes, n); j++)
            r[k][j] = NAN;
    return status != RWEDGE_EABSENT && !nan;
}

/* ---- Functions of points --------------------------------------------------------------------- */

/* Takes n numbers of an argument. NumPy's integers have 64 bits, the library's 32. */
static void gather(bool whole, const char *from, intptr_t step, size_t n, double to[])
{
    for (size_t j = 0; j < n; j++, from += step)
        if (whole) {
            const int64_t number = *(const int64_t *)(const void *)from;
            to[j] = number < 0 || number > INT32_MAX ? -1 : (double)number;
        } else
            to[j] = *(const double *)(const void *)from;
}

/* May n points go into one call? Their object and numbers are the same then. */
static bool is_shared(const entry *call, const intptr_t *steps)
{
    bool shared = call->pointwise;
    for (int k = 0; k < call->takes_object + call->arguments; k++)
        if (k < call->takes_object || call->argument[k - call->takes_object].sizes[0] < 0)
            shared &= steps[k] == 0;
    return shared;
}

/* Evaluates n points from i on: at once, or one by one where one of them fails. Was one outside
 * the domain? */
static bool block(const entry *call, char **args, const intptr_t *steps, intptr_t i, size_t n)
{
    static const size_t alone[ENTRY_SIZES] = {1};
    const int first = call->takes_object, results = first + call->arguments;
    double in[ENTRY_ARGUMENTS][BLOCK], out[ENTRY_RESULTS][BLOCK], *r[ENTRY_RESULTS];
    const double *v[ENTRY_ARGUMENTS];
    void *object = first ? *(void **)(void *)(args[0] + i * steps[0]) : NULL;
    for (int k = 0; k < call->arguments; k++) {
        gather(call->argument[k].whole, args[first + k] + i * steps[first + k], steps[first + k], n,
               in[k]);
        v[k] = in[k];
    }
    for (int k = 0; k < call->results; k++)
        r[k] = out[k];
    bool invalid = false;
    if (n == 1 || !is_shared(call, steps) || call->call(object, &n, v, r, NULL) != RWEDGE_OK)
        for (size_t j = 0; j < n; j++) {
            for (int k = 0; k < call->arguments; k++)
                v[k] = &in[k][j];
            for (int k = 0; k < call->results; k++)
                r[k] = &out[k][j];
            invalid |= point(call, object, alone, v, r);
        }
    for (int k = 0; k < call->results; k++)
        for (size_t j = 0; j < n; j++)
            *(double *)(void *)(args[results + k] + (i + (intptr_t)j) * steps[results + k]) =
                out[k][j];
    return invalid;
}

static bool points(const entry *call, char **args, const intptr_t *dimensions,
                   const intptr_t *steps)
{
    const intptr_t most = call->takes_object && steps[0] != 0 ? 1 : BLOCK;
    bool invalid = false;
    for (intptr_t i = 0, left = *dimensions; left > 0; i += most, left -= most)
        invalid |= block(call, args, steps, i, (size_t)(left < most ? left : most));
    return invalid;
}

/* ---- Functions of arrays along axes of their own, such as a cycle ---------------------------- */

/* NumPy gives the sizes in the order in which arguments and results first have them. */
static void take_sizes(const entry *call, const intptr_t *dimensions, size_t n[])
{
    bool known[ENTRY_SIZES] = {false};
    int next = 1;
    for (int k = 0; k < call->arguments + call->results; k++) {
        const int size = k < call->arguments ? call->argument[k].sizes[0]
                                             : call->result[k - call->arguments].sizes[0];
        if (size >= 0 && !known[size]) {
            n[size] = (size_t)dimensions[next++];
            known[size] = true;
        }
    }
}

/* Whether no array is shorter than the function takes it for. */
static bool are_long_enough(const entry *call, const size_t n[], const double *const v[])
{
    for (int s = 0; s < call->sizes; s++)
        if (call->size[s].count && call->size[s].count(v) > n[s])
            return false;
    return true;
}

/* Puts the numbers of a result where NumPy wants them. */
static void scatter(const double from[], size_t n, char *to, intptr_t step)
{
    for (size_t j = 0; j < n; j++, to += step)
        *(double *)(void *)to = from[j];
}

/* Evaluates point i, whose arguments and results are put next to each other in `room`. Was it
 * outside the domain? */
static bool cycle(const entry *call, char **args, const intptr_t *steps, intptr_t i,
                  const size_t n[], double *room)
{
    const int inputs = call->arguments;
    const intptr_t *step = steps + inputs + call->results; /* from number to number of an array */
    const double *v[ENTRY_ARGUMENTS];
    double *r[ENTRY_RESULTS];
    for (int k = 0; k < inputs; k++) {
        const signed char *sizes = call->argument[k].sizes;
        const size_t count = count_of(sizes, n);
        gather(false, args[k] + i * steps[k], sizes[0] >= 0 ? *step++ : 0, count, room);
        v[k] = room;
        room += count + 1;
    }
    for (int k = 0; k < call->results; room += count_of(call->result[k++].sizes, n))
        r[k] = room;
    const bool fits = are_long_enough(call, n, v);
    const bool invalid = !fits || point(call, NULL, n, v, r);
    for (int k = 0; k < call->results; k++) {
        const signed char *sizes = call->result[k].sizes;
        const size_t count = count_of(sizes, n);
        for (size_t j = 0; j < count && !fits; j++)
            r[k][j] = NAN;
        scatter(r[k], count, args[inputs + k] + i * steps[inputs + k], sizes[0] >= 0 ? *step++ : 0);
    }
    return invalid;
}

/* Without memory the results are NaN, and the operation is invalid. */
static bool cycles(const entry *call, char **args, const intptr_t *dimensions,
                   const intptr_t *steps)
{
    size_t n[ENTRY_SIZES] = {0}, all = 0;
    take_sizes(call, dimensions, n);
    for (int k = 0; k < call->arguments; k++)
        all += count_of(call->argument[k].sizes, n) + 1;
    for (int k = 0; k < call->results; k++)
        all += count_of(call->result[k].sizes, n);
    double *room = malloc(all * sizeof *room);
    bool invalid = !room;
    for (intptr_t i = 0; i < *dimensions; i++)
        if (room)
            invalid |= cycle(call, args, steps, i, n, room);
        else
            for (int k = call->arguments; k < call->arguments + call->results; k++)
                *(double *)(void *)(args[k] + i * steps[k]) = NAN;
    free(room);
    return invalid;
}

/* ---- What NumPy calls ------------------------------------------------------------------------ */

/* LOOP(name, evaluate, raises): rwedge_loop_name, which leaves the exceptions as they were, but
 * raises FE_INVALID where it must. */
#define LOOP(name, evaluate, raises)                                                               \
    RWEDGE_API void rwedge_loop_##name(char **args, const intptr_t *dimensions,                    \
                                       const intptr_t *steps, void *data)                          \
    {                                                                                              \
        fexcept_t before;                                                                          \
        fegetexceptflag(&before, FE_ALL_EXCEPT);                                                   \
        const bool invalid = evaluate(data, args, dimensions, steps);                              \
        fesetexceptflag(&before, FE_ALL_EXCEPT);                                                   \
        if ((raises) && invalid)                                                                   \
            feraiseexcept(FE_INVALID);                                                             \
    }

LOOP(points, points, true)
LOOP(quiet, points, false) /* its caller looks at the one number */
LOOP(cycles, cycles, true)
