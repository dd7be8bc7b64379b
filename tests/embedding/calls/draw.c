/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "calls.h"

#include <float.h>
#include <math.h>
#include <string.h>

#define COUNT(array) (sizeof(array) / sizeof(array)[0])
#define ANY NAN

/* ---- Numbers in the domain ---- */

/* Functions that have no result for most random arguments: some that have, an array's all the
 * same. NAN is drawn. */
static const struct {
    const char *name;
    double usual[ENTRY_ARGUMENTS];
} hints[] = {
    {"subsurface_yield", {0.3, 0.05, NAN}},
    {"profile_fit", {NAN, NAN, 1}},
    {"subsurface_shakedown", {0.3, 0.05, NAN}},
    {"contact_permanent_stick", {3, 0, 0.1, 0, 4, 0, 0.05, NAN}},
    {"contact_worn_zone", {0.01}},
    {"contact_deepest_wear", {0.01}},
    {"contact_full_wear", {0.01, NAN}},
    {"contact_set_bodies", {4, 0, 4, 0}},
    {"contact_set_thickness", {100, 1}},
    {"contact_guide", {4.2, 0, 0, 0}},
    {"contact_stress_history", {4, 0.05, 0, 0, 0.5, NAN}},
    {"cycle_create", {4, 0.05, 0, 0}},
    {"cycle_create_guided", {4, 0.05, 0, 0}},
    {"cycle_create_driven", {4, 0.05, 0, 0.01, 0.01}},
    {"cycle_shakedown", {0.3, 1}},
    {"cycle_below", {0.3, 0.2, 0.1, 1}},
    {"cycle_growth", {0.2, 0, RWEDGE_FACES_MODE_I, 1, 0.01, 0.02}},
    {"cycle_closing_growth", {0.2, 0, RWEDGE_FACES_MODE_I, 1, 0.01, 0.02}},
    {"cycle_worst", {RWEDGE_MEASURE_FATEMI_SOCIE, 1, 0.1, 1, 0, 0.3, 0}},
    {"constant_usual", {RWEDGE_MEASURE_MODIFIED_WOHLER, 2}},
    {"criterion", {RWEDGE_MEASURE_MODIFIED_WOHLER, ANY, ANY, ANY, ANY, ANY, ANY}},
    {"criterion_field", {RWEDGE_MEASURE_MODIFIED_WOHLER, ANY, ANY, ANY, ANY, ANY, ANY}},
    {"criterion_factor", {RWEDGE_MEASURE_MODIFIED_WOHLER, ANY, 3, ANY, ANY, ANY, ANY, ANY}},
    {"life", {RWEDGE_MEASURE_FATEMI_SOCIE, ANY, ANY}},
    {"damage", {RWEDGE_MEASURE_FATEMI_SOCIE, ANY, ANY, ANY, ANY, ANY, ANY}},
    {"damage_field", {RWEDGE_MEASURE_FATEMI_SOCIE, ANY, ANY, ANY, ANY, ANY, ANY}},
};

/* The next of a sequence in [0, 1): splitmix64. */
static double fraction(uint64_t *state)
{
    uint64_t z = *state += UINT64_C(0x9e3779b97f4a7c15);
    z = (z ^ (z >> 30)) * UINT64_C(0xbf58476d1ce4e5b9);
    z = (z ^ (z >> 27)) * UINT64_C(0x94d049bb133111eb);
    return (double)((z ^ (z >> 31)) >> 11) * 0x1p-53;
}

/* Without narrow bounds it is 0 at times, mostly of the order of 1, and at times far smaller. */
double draw_number(const entry_argument *a, uint64_t *state)
{
    enum { NARROW = 2, MOST_WHOLE = 60 };
    const double u = fraction(state), kind = fraction(state), side = fraction(state);
    if (a == &which_object)
        return floor(OBJECTS * u);
    if (a->whole)
        return fmax(a->low, -1) + floor(u * fmin(a->high, MOST_WHOLE));
    if (a->high - a->low <= NARROW)
        return a->low + u * (a->high - a->low);
    if (kind < 0.1 && entry_allows(a, 0))
        return 0;
    const double size = kind > 0.9 ? ldexp(1 + u, -(int)(25 * side)) : 0.01 + 2 * u;
    return a->low < 0 && side < 0.5 ? -size : size;
}

double draw_argument(const entry *e, int j, uint64_t *state)
{
    for (size_t i = 0; i < COUNT(hints); i++)
        if (strcmp(hints[i].name, e->name) == 0 && !isnan(hints[i].usual[j]))
            return hints[i].usual[j];
    return draw_number(&e->argument[j], state);
}

size_t implied_count(const entry *e, int size)
{
    double usual[ENTRY_ARGUMENTS];
    const double *v[ENTRY_ARGUMENTS];
    for (int j = 0; j < e->arguments; j++) {
        usual[j] = 0;
        v[j] = &usual[j];
        for (size_t i = 0; i < COUNT(hints); i++)
            if (strcmp(hints[i].name, e->name) == 0 && !isnan(hints[i].usual[j]))
                usual[j] = hints[i].usual[j];
    }
    return e->size[size].count(v);
}

void draw_constants(const entry *e, int j, size_t n, double v[])
{
    uint64_t state = 0;
    if (strcmp(e->argument[j].name, "constants") != 0)
        return;
    for (int32_t k = 0; k < (int32_t)n; k++) {
        double low = 0, high = 0;
        rwedge_constant_range((int32_t)draw_argument(e, 0, &state), k, &low, &high);
        v[k] = high > 1 ? 1 + 0.1 * k : (low + high) / 2;
    }
}

/* The places and the slopes of a profile rise, its heights first fall. */
static void sort_profile(const public_call *call, double v[])
{
    const double STEP = 0.01;
    const char *name = call->entry->name;
    const bool by_heights = strncmp(name, "profile_", 8) == 0 && call->arguments > 1;
    const int n = by_heights ? call->arguments / 2 : array_size;
    if (strcmp(name, "contact_create_profile") != 0 && !by_heights)
        return;
    for (int i = 1; i < n; i++) {
        v[i] = v[0] / 8 + STEP * i;
        v[n + i] = by_heights ? v[n] / 8 + STEP * i * (i - 3) : v[n] / 8 + STEP * i;
    }
}

static void fill_constants(const public_call *call, double v[])
{
    for (int i = 0; i < call->arguments; i++) {
        const entry_argument *a = call->argument[i];
        int last = i;
        while (last + 1 < call->arguments && call->argument[last + 1] == a)
            last++;
        if (a != &which_object)
            draw_constants(call->entry, (int)(a - call->entry->argument), (size_t)(last - i + 1),
                           v + i);
        i = last;
    }
}

void draw_inside(const public_call *call, uint64_t *state, double v[])
{
    for (int i = 0; i < call->arguments; i++) {
        const entry_argument *a = call->argument[i];
        v[i] = a == &which_object
                   ? draw_number(a, state)
                   : draw_argument(call->entry, (int)(a - call->entry->argument), state);
    }
    sort_profile(call, v);
    fill_constants(call, v);
}

/* ---- Edges ---- */

static const double anything[] = {
    0,          -0.0,
    5e-324,     1e-310,
    1e-200,     9.9e-61,
    1e-60,      3e-60,
    1e-40,      1e-16,
    1e-14,      9.9e-15,
    3e-9,       1e-6,
    1e-3,       0.01,
    0.1,        0.25,
    0.3,        0.3605,
    0.5,        0.5 - DBL_EPSILON / 4,
    0.5 - 1e-9, 0.5 + DBL_EPSILON,
    0.9999,     1 - DBL_EPSILON / 2,
    1,          1 + DBL_EPSILON,
    1.5,        2,
    2.5,        100,
    1e5,        1e6,
    1.1e8,      1e10,
    1e18,       1e30,
    1e60,       1.1e60,
    1e200,      DBL_MAX,
    INFINITY,   NAN,
    -5e-324,    -1e-300,
    -1e-60,     -1e-9,
    -0.3,       -0.9999,
    -1,         -1 + DBL_EPSILON,
    -2,         -1e9,
    -DBL_MAX,   -INFINITY,
};

static const double numbers[] = {0,     1,       2,          3,         7,  50,       1001,
                                 65535, 1 << 20, 1073741823, INT32_MAX, -1, INT32_MIN};

size_t edge_count(const entry_argument *a)
{
    return a == &which_object ? COMPUTED : a->whole ? COUNT(numbers) : COUNT(anything);
}

double edge(const entry_argument *a, size_t i)
{
    return a == &which_object ? (double)i : a->whole ? numbers[i] : anything[i];
}
