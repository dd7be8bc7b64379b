/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The inner loops of the package's NumPy ufuncs. They have the signature that NumPy calls, and
 * need neither Python's nor NumPy's headers: rwedge/_ufuncs.py makes the ufuncs of them. Which
 * loops and rows there are, bindings/interface reads from rwedge.h and writes into loops.h.
 *
 * Where the arguments are refused the results are NaN and FE_INVALID is raised, as by sqrt(-1), so
 * that numpy.errstate(invalid=...) rules what happens. Where the result does not exist, or an
 * argument is NaN, they are NaN without it. No other exception leaves a loop. */
#include "rwedge.h"

#include "loops.h"

#include <fenv.h>
#include <math.h>
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>

/* The argument k at the point i of a loop. */
#define AT(type, k) (*(type *)(void *)(args[k] + i * steps[k]))

/* Is one of the doubles first <= k < end among the arguments not a number? */
static bool some_nan(char **args, const intptr_t *steps, intptr_t i, int first, int end)
{
    for (int k = first; k < end; k++)
        if (isnan(AT(const double, k)))
            return true;
    return false;
}

/* Leaves the exceptions as they were before the loop, but for this one. */
static void leave_exceptions(const fexcept_t *before, bool invalid)
{
    fesetexceptflag(before, FE_ALL_EXCEPT);
    if (invalid)
        feraiseexcept(FE_INVALID);
}

/* ---- Formulas: one result, by value ---------------------------------------------------------- */

/* The loops for functions of these types, given as data, of which the first arguments are
 * doubles. The result comes last, as it may overwrite an argument. The quiet loop raises nothing:
 * its caller looks at the one number. */
#define FORMULA_LOOP(name, inputs, doubles, types, values)                                         \
    static void name##_loop(char **args, const intptr_t *dimensions, const intptr_t *steps,        \
                            void *data, bool raises)                                               \
    {                                                                                              \
        double(*formula) types;                                                                    \
        memcpy(&formula, &data, sizeof formula);                                                   \
        fexcept_t before;                                                                          \
        fegetexceptflag(&before, FE_ALL_EXCEPT);                                                   \
        bool invalid = false;                                                                      \
        for (intptr_t i = 0; i < *dimensions; i++) {                                               \
            const double value = formula values;                                                   \
            invalid |= isnan(value) && !some_nan(args, steps, i, 0, doubles);                      \
            AT(double, inputs) = value;                                                            \
        }                                                                                          \
        leave_exceptions(&before, invalid ? raises : false);                                       \
    }                                                                                              \
    RWEDGE_API void rwedge_loop_##name(char **args, const intptr_t *dimensions,                    \
                                       const intptr_t *steps, void *data)                          \
    {                                                                                              \
        name##_loop(args, dimensions, steps, data, true);                                          \
    }                                                                                              \
    RWEDGE_API void rwedge_loop_quiet_##name(char **args, const intptr_t *dimensions,              \
                                             const intptr_t *steps, void *data)                    \
    {                                                                                              \
        name##_loop(args, dimensions, steps, data, false);                                         \
    }

/* NumPy's integers have 64 bits, the library's 32. */
static int32_t narrow(int64_t n)
{
    return n < 0 || n > INT32_MAX ? -1 : (int32_t)n;
}

#define IN(k) AT(const double, k)
FORMULA_LOOPS

/* ---- Functions with a status, several results, or an object ---------------------------------- */

enum { BLOCK = 256 };

/* Evaluates n points of one object with the same shared arguments. */
typedef int32_t points_function(const void *object, const double shared[], size_t n,
                                double *const in[], double *const out[]);

/* The arguments of the ufunc are these: the object's address, the shared doubles, the inputs,
 * the outputs. */
struct points {
    points_function *function;
    int objects, shared, inputs, outputs;
    intptr_t at_once; /* how many points it takes */
};

/* Where point j of an argument stands. */
static void *element(char **args, const intptr_t *steps, int argument, intptr_t j)
{
    return args[argument] + j * steps[argument];
}

/* Evaluates n points from i on. Where one of them fails they go one by one. Was one outside the
 * domain? */
static bool block(const struct points *points, char **args, const intptr_t *steps, intptr_t i,
                  intptr_t n)
{
    const int first_input = points->objects + points->shared,
              first_output = first_input + points->inputs;
    double shared[MAX_SHARED], inputs[MAX_INPUTS][BLOCK], outputs[MAX_OUTPUTS][BLOCK];
    double *in[MAX_INPUTS], *out[MAX_OUTPUTS];
    for (int k = 0; k < points->outputs; k++)
        out[k] = outputs[k];
    const void *object = points->objects ? AT(const void *const, 0) : NULL;
    for (int k = 0; k < points->shared; k++)
        shared[k] = AT(const double, points->objects + k);
    for (int k = 0; k < points->inputs; k++) {
        in[k] = inputs[k];
        for (intptr_t j = 0; j < n; j++)
            in[k][j] = *(const double *)element(args, steps, first_input + k, i + j);
    }
    const int32_t status = points->function(object, shared, (size_t)n, in, out);
    bool invalid = false;
    if (status != RWEDGE_OK && n > 1) {
        for (intptr_t j = 0; j < n; j++)
            invalid |= block(points, args, steps, i + j, 1);
        return invalid;
    }
    if (status != RWEDGE_OK) {
        invalid =
            status != RWEDGE_EABSENT && !some_nan(args, steps, i, points->objects, first_output);
        for (int k = 0; k < points->outputs; k++)
            out[k][0] = NAN;
    }
    for (int k = 0; k < points->outputs; k++)
        for (intptr_t j = 0; j < n; j++)
            *(double *)element(args, steps, first_output + k, i + j) = out[k][j];
    return invalid;
}

RWEDGE_API void rwedge_loop_points(char **args, const intptr_t *dimensions, const intptr_t *steps,
                                   void *data)
{
    const struct points *points = data;
    intptr_t at_once = points->at_once;
    for (int k = 0; k < points->objects + points->shared; k++)
        if (steps[k] != 0)
            at_once = 1;
    fexcept_t before;
    fegetexceptflag(&before, FE_ALL_EXCEPT);
    bool invalid = false;
    for (intptr_t i = 0; i < *dimensions; i += at_once)
        invalid |=
            block(points, args, steps, i, at_once < *dimensions - i ? at_once : *dimensions - i);
    leave_exceptions(&before, invalid);
}

/* POINTS(name, objects, shared, inputs, outputs, at_once, call): the function and its row of the
 * table, rwedge_points_name. */
#define POINTS(name, objects, shared, inputs, outputs, at_once, call)                              \
    static int32_t name(const void *o, const double s[], size_t n, double *const in[],             \
                        double *const out[])                                                       \
    {                                                                                              \
        (void)o, (void)s, (void)n;                                                                 \
        return call;                                                                               \
    }                                                                                              \
    RWEDGE_API const struct points rwedge_points_##name = {name,   objects, shared,                \
                                                           inputs, outputs, at_once};

/* A status for those that have none. */
static int32_t status_of(double value)
{
    return isnan(value) ? RWEDGE_EDOMAIN : RWEDGE_OK;
}

POINTS_ROWS

/* ---- Functions of a cycle: arrays along an axis of their own --------------------------------- */

/* n loads at one point: the arrays, the numbers and the results of the ufunc. */
typedef int32_t cycle_function(size_t n, double *const in[], const double numbers[],
                               double *const out[]);

struct cycles {
    cycle_function *function;
    int arrays, numbers, outputs;
};

/* The loads of the point i, next to each other. Is one of them not a number? */
static bool gather(const struct cycles *cycles, char **args, const intptr_t *steps, intptr_t i,
                   intptr_t loads, double *const in[])
{
    const intptr_t *core = steps + cycles->arrays + cycles->numbers + cycles->outputs;
    bool nan = false;
    for (int k = 0; k < cycles->arrays; k++)
        for (intptr_t load = 0; load < loads; load++) {
            in[k][load] = *(const double *)(const void *)(args[k] + i * steps[k] + load * core[k]);
            nan |= isnan(in[k][load]);
        }
    return nan;
}

/* Evaluates the point i. Was it outside the domain? */
static bool cycle(const struct cycles *cycles, char **args, const intptr_t *steps, intptr_t i,
                  intptr_t loads, double *const in[])
{
    const int inputs = cycles->arrays + cycles->numbers;
    double numbers[MAX_CYCLE], results[MAX_CYCLE], *out[MAX_CYCLE];
    const bool nan = gather(cycles, args, steps, i, loads, in) ||
                     some_nan(args, steps, i, cycles->arrays, inputs);
    for (int k = 0; k < cycles->numbers; k++)
        numbers[k] = AT(const double, cycles->arrays + k);
    for (int k = 0; k < cycles->outputs; k++)
        out[k] = &results[k];
    const int32_t status = nan ? RWEDGE_EDOMAIN : cycles->function((size_t)loads, in, numbers, out);
    for (int k = 0; k < cycles->outputs; k++)
        AT(double, inputs + k) = status == RWEDGE_OK ? results[k] : NAN;
    return status != RWEDGE_OK && status != RWEDGE_EABSENT && !nan;
}

/* Without memory the results are NaN, and the operation is invalid. */
RWEDGE_API void rwedge_loop_cycles(char **args, const intptr_t *dimensions, const intptr_t *steps,
                                   void *data)
{
    const struct cycles *cycles = data;
    const intptr_t loads = dimensions[1];
    double *in[MAX_CYCLE];
    fexcept_t before;
    fegetexceptflag(&before, FE_ALL_EXCEPT);
    double *memory = malloc((size_t)(loads * cycles->arrays + 1) * sizeof *memory);
    bool invalid = !memory;
    for (int k = 0; k < cycles->arrays; k++)
        in[k] = memory ? memory + k * loads : NULL;
    for (intptr_t i = 0; i < *dimensions; i++)
        if (memory)
            invalid |= cycle(cycles, args, steps, i, loads, in);
        else
            for (int k = 0; k < cycles->outputs; k++)
                AT(double, cycles->arrays + cycles->numbers + k) = NAN;
    free(memory);
    leave_exceptions(&before, invalid);
}

/* CYCLES(name, arrays, numbers, outputs, call): the function and its row, rwedge_cycles_name. */
#define CYCLES(name, arrays, numbers, outputs, call)                                               \
    static int32_t cycle_##name(size_t n, double *const in[], const double s[],                    \
                                double *const out[])                                               \
    {                                                                                              \
        return call;                                                                               \
    }                                                                                              \
    RWEDGE_API const struct cycles rwedge_cycles_##name = {cycle_##name, arrays, numbers, outputs};

CYCLES_ROWS
