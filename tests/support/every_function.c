/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "every_function.h"

#include "entries.h"

#include <math.h>
#include <stdint.h>
#include <string.h>

enum {
    ARRAY = 21, /* numbers of an array: full vectors, and some left over */
    LOADS = 3,  /* the first size of an array of two */
    POINTS = 7,
    MOST = 1024, /* numbers of an array whose size a function tells */
    RARELY = 20, /* a function that takes long is called once in so many numbers */
    STEPS = 4    /* of a history */
};

typedef struct {
    uint64_t random;
    receiver *receive;
    void *context;
    bool also_long; /* whether functions that take long have their turn */
    bool is_slow;   /* whether a load of the contact may take a second, as an error is allowed */

    /* What a function gave last in a size that another one tells: for the one that takes it. */
    const char *kept_name;
    double kept[MOST];
    size_t kept_size;
} sample;

/* Functions that have no result for most random arguments: some that have. The last is drawn. */
static const struct {
    const char *name;
    double given[ENTRY_ARGUMENTS];
} hints[] = {
    {"subsurface_yield", {0.3, 0.05}},
    {"permanent_stick", {0.5, 0.3, 1, 0.5, 3, 0, 0.1, 0, 4, 0, 0.05}},
    {"contact_stress_history", {4, 0.05, 0, 0, 0.5}},
    {"contact_cycle_friction", {4, 0.05, 0, 0}},
    {"contact_keep_cycle", {4, 0.05, 0}},
    {"contact_cycle_below", {4, 0.05, 0, 0, 0.3, 0.2, 0.1}},
    {"contact_cycle_worst", {3, 4, 0.05, 0, 0, 0.1, 1, 0, 1, 0.3, 0, 1}},
};

static const char *const take_long[] = {"critical_friction",      "yield_load",
                                        "contact_yield_factor",   "contact_allow_error",
                                        "contact_create_profile", "contact_cycle_worst"};

/* The next of a sequence in [0, 1) that is the same on every machine: splitmix64. */
static double fraction(sample *s)
{
    uint64_t z = s->random += UINT64_C(0x9e3779b97f4a7c15);
    z = (z ^ (z >> 30)) * UINT64_C(0xbf58476d1ce4e5b9);
    z = (z ^ (z >> 27)) * UINT64_C(0x94d049bb133111eb);
    return (double)((z ^ (z >> 31)) >> 11) * 0x1p-53;
}

/* A number of the argument's domain. Without narrow bounds it is 0 at times, mostly of the order
 * of 1, and at times far smaller. */
static double number(sample *s, const entry_argument *a)
{
    enum { NARROW = 2, MOST_WHOLE = 60 };
    const double u = fraction(s), kind = fraction(s), side = fraction(s);
    if (a->whole)
        return fmax(a->low, -1) + floor(u * fmin(a->high, MOST_WHOLE));
    if (a->high - a->low <= NARROW)
        return a->low + u * (a->high - a->low);
    if (kind < 0.1 && entry_allows(a, 0))
        return 0;
    const double size = kind > 0.9 ? ldexp(1 + u, -(int)(25 * side)) : 0.01 + 2 * u;
    return a->low < 0 && side < 0.5 ? -size : size;
}

static bool is_kept(const sample *s, const entry_argument *a)
{
    return s->kept_name != NULL && strcmp(a->name, s->kept_name) == 0;
}

static size_t count_of(const signed char sizes[2], const size_t n[])
{
    size_t count = 1;
    for (int k = 0; k < 2; k++)
        count *= sizes[k] < 0 ? 1 : n[(int)sizes[k]];
    return count;
}

static size_t told_size(const char *teller, void *object)
{
    double told = 0;
    double *const result[] = {&told};
    for (int i = 0; i < ENTRY_COUNT; i++)
        if (strcmp(entries[i].name, teller) == 0)
            entries[i].call(object, NULL, NULL, result, NULL);
    return told < MOST ? (size_t)told : MOST;
}

static void set_sizes(const sample *s, const entry *call, void *object, size_t n[])
{
    for (int j = 0; j < call->sizes; j++)
        n[j] = call->size[j].teller != NULL ? told_size(call->size[j].teller, object)
               : call->sizes == 1           ? ARRAY
               : j == 0                     ? LOADS
                                            : POINTS;
    for (int j = 0; j < call->arguments; j++)
        if (is_kept(s, &call->argument[j]))
            n[(int)call->argument[j].sizes[0]] = s->kept_size;
}

static const double *hint_of(const entry *call)
{
    for (size_t i = 0; i < sizeof hints / sizeof hints[0]; i++)
        if (strcmp(hints[i].name, call->name) == 0)
            return hints[i].given;
    return NULL;
}

static void draw(sample *s, const entry *call, const size_t n[], double v[][MOST])
{
    const double *hint = hint_of(call);
    for (int j = 0; j < call->arguments; j++) {
        const entry_argument *a = &call->argument[j];
        if (is_kept(s, a))
            memcpy(v[j], s->kept, s->kept_size * sizeof(double));
        else
            for (size_t i = 0; i < count_of(a->sizes, n); i++)
                v[j][i] = hint != NULL && j < call->arguments - 1 ? hint[j] : number(s, a);
    }
}

/* The places and the slopes of a profile rise. */
static void sort_profile(const entry *call, const size_t n[], double v[][MOST])
{
    const double STEP = 0.01;
    if (strcmp(call->name, "contact_create_profile") != 0)
        return;
    for (size_t i = 1; i < n[0]; i++)
        for (int j = 0; j < 2; j++)
            v[j][i] = v[j][0] / 8 + STEP * (double)i;
}

static void give(sample *s, const entry *call, const size_t n[], double results[][MOST])
{
    for (int j = 0; j < call->results; j++) {
        const size_t count = count_of(call->result[j].sizes, n);
        for (size_t i = 0; i < count; i++)
            s->receive(s->context, call->name, false, results[j][i]);
        if (call->sizes > 0 && call->size[0].teller != NULL) {
            s->kept_name = call->result[j].name;
            memcpy(s->kept, results[j], count * sizeof(double));
            s->kept_size = count;
        }
    }
}

/* Calls a function with random arguments. Whether it went well; what it makes is *made. */
static bool try(sample *s, const entry *call, void *object, void **made)
{
    double v[ENTRY_ARGUMENTS][MOST], results[ENTRY_RESULTS][MOST];
    const double *given[ENTRY_ARGUMENTS];
    double *result[ENTRY_RESULTS];
    size_t n[ENTRY_SIZES] = {0};
    for (int j = 0; j < ENTRY_ARGUMENTS; j++)
        given[j] = v[j];
    for (int j = 0; j < ENTRY_RESULTS; j++)
        result[j] = results[j];
    set_sizes(s, call, object, n);
    draw(s, call, n, v);
    sort_profile(call, n, v);
    const int32_t status = call->call(object, n, given, result, made);
    s->receive(s->context, call->name, true, status);
    if (status == RWEDGE_OK)
        give(s, call, n, results);
    return status == RWEDGE_OK;
}

static bool goes_through_loads(const entry *call)
{
    return strcmp(call->name, "contact_obstacle") == 0 ||
           (call->sizes > 0 && strcmp(call->size[0].name, "loads") == 0);
}

static bool has_its_turn(const sample *s, const entry *call)
{
    if (s->is_slow && goes_through_loads(call))
        return false;
    for (size_t i = 0; i < sizeof take_long / sizeof take_long[0]; i++)
        if (strcmp(take_long[i], call->name) == 0)
            return s->also_long;
    return true;
}

static bool is_of(const entry *call, const char *family)
{
    return strcmp(call->family, family) == 0;
}

/* Every function that has no object, or only reads it. */
static void read_all(sample *s, const char *family, void *object)
{
    for (int i = 0; i < ENTRY_COUNT; i++) {
        const entry *call = &entries[i];
        if (is_of(call, family) && !call->changes_object && !call->makes_object &&
            has_its_turn(s, call))
            try(s, call, object, NULL);
    }
}

static void free_object(const char *family, void *object)
{
    if (strcmp(family, "contact") == 0)
        rwedge_contact_destroy(object);
    else
        rwedge_series_destroy(object);
}

/* Each function that changes a contact, on a copy that is read then. No series can be changed. */
static void change_all(sample *s, const char *family, const void *object)
{
    for (int i = 0; i < ENTRY_COUNT; i++) {
        rwedge_contact *copy = NULL;
        if (!is_of(&entries[i], family) || !entries[i].changes_object ||
            !has_its_turn(s, &entries[i]) || rwedge_contact_copy(object, &copy) != RWEDGE_OK)
            continue;
        for (int step = 0; step < STEPS; step++)
            try(s, &entries[i], copy, NULL);
        s->is_slow = strcmp(entries[i].name, "contact_allow_error") == 0;
        read_all(s, family, copy);
        s->is_slow = false;
        rwedge_contact_destroy(copy);
    }
}

/* Every way to make an object, which is read and changed. What is made of another object, or of
 * what one has told, comes after the first. */
static void make_all(sample *s, const char *family)
{
    void *first = NULL;
    for (int i = 0; i < ENTRY_COUNT; i++) {
        const entry *call = &entries[i];
        void *made = NULL;
        if (!is_of(call, family) || !call->makes_object || !has_its_turn(s, call) ||
            !try(s, call, first, &made))
            continue;
        read_all(s, family, made);
        change_all(s, family, made);
        if (first == NULL)
            first = made;
        else
            free_object(family, made);
    }
    if (first != NULL)
        free_object(family, first);
}

bool shared_create(shared_handles *shared)
{
    *shared = (shared_handles){NULL, NULL};
    if (rwedge_contact_create(0.5, 0.3, 1, 0.5, &shared->contact) == RWEDGE_OK &&
        rwedge_contact_load(shared->contact, 4, 0) == RWEDGE_OK &&
        rwedge_contact_load(shared->contact, 4, 1.4) == RWEDGE_OK &&
        rwedge_contact_load(shared->contact, 6, -1) == RWEDGE_OK &&
        rwedge_contact_load(shared->contact, 5, -0.7) == RWEDGE_OK &&
        rwedge_series_create(0.3, 60, &shared->series) == RWEDGE_OK)
        return true;
    shared_destroy(shared);
    return false;
}

void shared_destroy(shared_handles *shared)
{
    rwedge_contact_destroy(shared->contact);
    rwedge_series_destroy(shared->series);
}

void every_function(const shared_handles *shared, int n, receiver *receive, void *context)
{
    sample s = {.random = (uint64_t)n << 32,
                .receive = receive,
                .context = context,
                .also_long = n % RARELY == 0};
    receive(context, "version", false, rwedge_version()[0]);
    read_all(&s, "", NULL);
    read_all(&s, "contact", shared->contact);
    read_all(&s, "series", shared->series);
    make_all(&s, "contact");
    make_all(&s, "series");
}

const char *function_of(int i)
{
    return i < ENTRY_COUNT ? entries[i].name : NULL;
}
