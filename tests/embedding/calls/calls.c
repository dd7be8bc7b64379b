/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "calls.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#define BIT(status) (1u << (status))

int array_size = 3;

const entry_argument which_object = {
    .name = "object", .low = INT32_MIN, .high = INT32_MAX, .finite = 1, .whole = 1};

void (*on_call)(bool begins);

/* ---- Objects ---- */

/* A contact before its loads, and after some; one is held then. A flat pad where theta is 0. */
static const struct {
    double theta, a, A, f;
    double load[4][4]; /* P, M, Q, sigma, to the first P that is 0 */
} contact_cases[OBJECTS] = {
    {0.5, 0.3, 1, 0.5, {{0}}},
    {0.5, 0.3, 1, 0.5, {{4, 0, 0, 0}}},
    {0.5, 0.3, 1, 0.5, {{4, 0, 0, 0}, {4, 0, 1.4, 0}, {6, 0, -1, 0}, {5, 0, -0.7, 0}}},
    {0.5, 0, 1, 0.5, {{4, 0, 0, 0}, {4, 0, 1, 0}}},
    {0.5, 3e-60, 1.5, 0.5, {{2, 0, 0, 0}}},
    {1e-30, 1e-9, 1e-40, 1e-5, {{1e3, 0, 0, 0}, {1e3, 0, 1e-3, 0}}},
    {0.5, 0.3, 1, 0.5, {{4, 0.2, 0, 0}, {4, 0.2, 1, 0.01}, {4.5, 0.3, 0.5, 0.01}}},
    {0, 0.4, 0.5, 0.5, {{0.2, 0.03, 0, 0}, {0.2, 0.03, 0.06, 0.002}}},
    {0.5, 0.3, 1, 0.5, {{4, 0, 0, 0}, {4, 0, 2, 0}}}, /* it slides */
    {0.5, 0.3, 1, 0.5, {{4, 0, 0, 0}}},               /* held */
    {0.5, 0.3, 1, 0.5, {{4, 0, 0, 0}, {4, 0, 0.5, 2}}},
};

static rwedge_contact *contact_of_case(int i)
{
    rwedge_contact *contact = NULL;
    if (contact_cases[i].theta > 0)
        rwedge_contact_create(contact_cases[i].theta, contact_cases[i].a, contact_cases[i].A,
                              contact_cases[i].f, &contact);
    else
        rwedge_contact_create_flat(contact_cases[i].a, 10, contact_cases[i].A, contact_cases[i].f,
                                   &contact);
    if (i == COMPUTED)
        rwedge_contact_allow_error(contact, 1e-2);
    for (int k = 0; k < 4 && contact_cases[i].load[k][0] > 0; k++) {
        const double *to = contact_cases[i].load[k];
        if (rwedge_contact_apply(contact, to[0], to[1], to[2], to[3]) != RWEDGE_OK)
            abort();
    }
    rwedge_contact_set_rotation(contact, i == HELD);
    return contact;
}

/* From half of its Q, or from a first load, to the contact's loads. */
static rwedge_cycle *cycle_of(const rwedge_contact *contact)
{
    double P, M, Q, sigma;
    rwedge_cycle *cycle = NULL;
    rwedge_contact_loads(contact, &P, &M, &Q, &sigma);
    const double p = P > 0 ? P : 4, q = P > 0 ? Q : 1;
    const double P2[] = {p, p}, M2[] = {M, M}, Q2[] = {q / 2, q}, sigma2[] = {sigma, sigma};
    if (rwedge_cycle_create(contact, OBJECT_LOADS, P2, M2, Q2, sigma2, &cycle) != RWEDGE_OK)
        abort();
    return cycle;
}

static rwedge_series *series_of_case(int i)
{
    static const struct {
        double alpha;
        int32_t terms;
    } cases[] = {{0.3, 1}, {0, 7}, {0.3, 60}};
    rwedge_series *series = NULL;
    rwedge_series_create(cases[i % 3].alpha, cases[i % 3].terms, &series);
    return series;
}

void *object_of(const entry *e, double number)
{
    static rwedge_contact *contacts[OBJECTS];
    static rwedge_cycle *cycles[OBJECTS];
    static rwedge_series *series[OBJECTS];
    const int i = (int)fabs(fmod(number, OBJECTS));
    if (contacts[0] == NULL)
        for (int k = OBJECTS - 1; k >= 0; k--) {
            series[k] = series_of_case(k);
            contacts[k] = contact_of_case(k);
            cycles[k] = cycle_of(contacts[k]);
        }
    return strcmp(e->object, "contact") == 0 ? (void *)contacts[i]
           : strcmp(e->object, "cycle") == 0 ? (void *)cycles[i]
                                             : (void *)series[i];
}

/* ---- A function as a call ---- */

/* Whether a size is the number of loads of a cycle. */
static bool is_of_loads(const entry *e, int k)
{
    return e->size[k].teller != NULL && strcmp(e->size[k].teller, "cycle_loads") == 0;
}

/* Of a size of the function. */
static size_t size_of(const entry *e, int k)
{
    const size_t FIT = 8, LAW = 5; /* a fit needs more heights than its unknowns */
    int given = 0;
    if (strcmp(e->name, "profile_fit") == 0)
        return FIT;
    if (strcmp(e->name, "cycle_growth") == 0 || strcmp(e->name, "cycle_closing_growth") == 0)
        return LAW;
    for (int j = 0; j < e->sizes; j++)
        given += e->size[j].count == NULL;
    if (e->size[k].count != NULL)
        return implied_count(e, k);
    return is_of_loads(e, k) ? OBJECT_LOADS : given > 1 ? 2 : (size_t)array_size;
}

static int count_of(const entry *e, const signed char sizes[2])
{
    int count = 1;
    for (int k = 0; k < 2; k++)
        count *= sizes[k] < 0 ? 1 : (int)size_of(e, sizes[k]);
    return count;
}

/* Where a call's numbers come from and go to. */
typedef struct {
    void *object;
    size_t n[ENTRY_SIZES];
    const double *v[ENTRY_ARGUMENTS];
    double *r[ENTRY_RESULTS];
    void *made, **made_at;
} places;

static void tell_sizes(const entry *e, places *p)
{
    for (int j = 0; j < e->sizes; j++) {
        double told = (double)size_of(e, j), *const result[] = {&told};
        if (e->size[j].teller != NULL && e->takes_object) /* other sizes may be any */
            entry_named(e->size[j].teller)->call(p->object, NULL, NULL, result, NULL);
        p->n[j] = told < CALL_OUTPUTS ? (size_t)told : 0;
    }
}

static void take_places(const entry *e, const double v[], double out[], places *p)
{
    if (e->takes_object)
        p->object = object_of(e, *v++);
    for (int j = 0; j < e->arguments; j++) {
        p->v[j] = v;
        v += count_of(e, e->argument[j].sizes);
    }
    for (int j = 0; j < e->results; j++) {
        p->r[j] = out;
        out += count_of(e, e->result[j].sizes);
    }
    tell_sizes(e, p);
    p->made = NULL;
    p->made_at = e->makes_object ? &p->made : NULL;
}

static void free_object(const entry *e, void *object)
{
    if (strcmp(e->family, "contact") == 0)
        rwedge_contact_destroy(object);
    else if (strcmp(e->family, "cycle") == 0)
        rwedge_cycle_destroy(object);
    else
        rwedge_series_destroy(object);
}

/* A pure formula has the status RWEDGE_EDOMAIN where it gives NaN. */
static int32_t call_at(const entry *e, const places *p, double *value)
{
    double got, *const only[] = {&got};
    if (e->has_status)
        return e->call(p->object, p->n, p->v, p->r, p->made_at);
    e->call(p->object, p->n, p->v, only, NULL);
    if (isnan(got))
        return RWEDGE_EDOMAIN;
    *value = got;
    return RWEDGE_OK;
}

/* More terms would take seconds. */
static void keep_short(const entry *e, double v[])
{
    enum { TERMS = 1001, LONG = 1 << 20 };
    for (int j = 0, at = e->takes_object; j < e->arguments; j++) {
        if (e->makes_object && e->argument[j].whole && v[at] > TERMS && v[at] <= LONG)
            v[at] = TERMS;
        at += count_of(e, e->argument[j].sizes);
    }
}

/* The numbers of a contact. */
typedef struct {
    size_t count;
    double *number;
} snapshot;

static snapshot snapshot_of(const rwedge_contact *contact)
{
    const size_t n = rwedge_contact_state_size(contact);
    snapshot s = {n, calloc(n + 1, sizeof(double))};
    if (s.number == NULL || (n > 0 && rwedge_contact_state(contact, n, s.number) != RWEDGE_OK))
        abort();
    return s;
}

static bool is_changed(const rwedge_contact *contact, const snapshot *before)
{
    const snapshot now = snapshot_of(contact);
    const bool is_same = now.count == before->count &&
                         memcmp(now.number, before->number, now.count * sizeof(double)) == 0;
    free(now.number);
    return !is_same;
}

static void tell(bool begins)
{
    if (on_call != NULL)
        on_call(begins);
}

/* The status of a call that changes a copy of its object; whether it has changed that. */
static int32_t call_with_copy(const entry *e, places *p, double out[], bool *changed)
{
    const snapshot before = snapshot_of(p->object);
    rwedge_contact *copy = NULL;
    tell(true);
    int32_t status = rwedge_contact_copy(p->object, &copy);
    p->object = copy;
    if (status == RWEDGE_OK)
        status = call_at(e, p, out);
    tell(false);
    *changed = copy != NULL && is_changed(copy, &before);
    tell(true);
    rwedge_contact_destroy(copy);
    tell(false);
    free(before.number);
    return status;
}

/* What is changed is a copy, what is made is freed. */
static int32_t make(const public_call *call, const double in[], double out[], bool *changed)
{
    const entry *e = call->entry;
    double v[CALL_ARGUMENTS];
    memcpy(v, in, (size_t)call->arguments * sizeof(double));
    keep_short(e, v);
    places p;
    take_places(e, v, out, &p);
    *changed = false;
    if (e->changes_object)
        return call_with_copy(e, &p, out, changed);
    tell(true);
    const int32_t status = call_at(e, &p, out);
    free_object(e, p.made);
    tell(false);
    return status;
}

static public_call call_of_entry(const entry *e)
{
    public_call call = {.entry = e};
    if (e->takes_object)
        call.argument[call.arguments++] = &which_object;
    for (int j = 0; j < e->arguments; j++)
        for (int i = count_of(e, e->argument[j].sizes); i > 0; i--)
            call.argument[call.arguments++] = &e->argument[j];
    for (int j = 0; j < e->results; j++)
        call.outputs += count_of(e, e->result[j].sizes);
    call.also_allowed = e->errors & ~(BIT(RWEDGE_EDOMAIN) | BIT(RWEDGE_ENULL) | BIT(RWEDGE_ENOMEM));
    if (e->errors & BIT(RWEDGE_EPATH)) /* or it is computed */
        call.also_allowed |= BIT(RWEDGE_ENOCONV);
    if (e->refuses_more)
        call.also_allowed |= BIT(RWEDGE_EDOMAIN);
    return call;
}

const public_call *public_calls(void)
{
    static public_call calls[ENTRY_COUNT];
    if (calls[0].entry == NULL)
        for (int i = ENTRY_COUNT - 1; i >= 0; i--)
            calls[i] = call_of_entry(&entries[i]);
    return calls;
}

/* ---- The rules for errors ---- */

/* How many numbers of an argument the function reads: constants that a criterion does not have are
 * there, but not read. */
static int read_of(const entry *e, int j, const places *p)
{
    const int size = e->argument[j].sizes[0], all = count_of(e, e->argument[j].sizes);
    if (size < 0 || e->size[size].count == NULL)
        return all;
    const size_t told = e->size[size].count(p->v);
    return told < (size_t)all ? (int)told : all;
}

static bool are_in_their_domains(const public_call *call, const double v[])
{
    const entry *e = call->entry;
    double out[CALL_OUTPUTS];
    places p;
    take_places(e, v, out, &p);
    for (int j = 0; j < e->arguments; j++)
        for (int i = 0; i < read_of(e, j, &p); i++)
            if (!entry_allows(&e->argument[j], p.v[j][i]))
                return false;
    return true;
}

static const double MARK = -6.02214076e23; /* what an output is before: no result is that */

const char *complaint_of(const public_call *call, const double v[], double out[], int32_t *status)
{
    const entry *e = call->entry;
    /* a state: numbers that say nothing by themselves */
    const bool any = e->sizes > 0 && e->size[0].teller && !is_of_loads(e, 0);
    for (int i = 0; i < CALL_OUTPUTS; i++)
        out[i] = MARK;
    bool changed;
    *status = make(call, v, out, &changed);
    const bool valid = are_in_their_domains(call, v);
    if (valid && *status != RWEDGE_OK && (call->also_allowed & BIT(*status)) == 0)
        return "an error, though all arguments are in the domain";
    if (!valid && *status == RWEDGE_OK)
        return "a result, though an argument is outside the domain";
    if (changed && *status != RWEDGE_OK)
        return "a call that was refused, and changed its object";
    for (int i = 0; i < CALL_OUTPUTS; i++) {
        const bool wanted = *status == RWEDGE_OK && (any || i < call->outputs);
        if (wanted && !any && !isfinite(out[i]) && !(e->may_be_infinite && isinf(out[i])))
            return "a result that is not finite";
        if (!wanted && out[i] != MARK)
            return "an output was touched that should not be";
    }
    return NULL;
}

/* A function with a value says nothing of an object that is NULL: NaN, or no coefficient and no
 * memory. */
static bool minds_null(const entry *e, const places *p)
{
    double value = MARK;
    const int32_t status = call_at(e, p, &value);
    return e->has_status ? status == RWEDGE_ENULL
                         : status == RWEDGE_EDOMAIN || value == 0 || value == -1;
}

const char *complaint_about_null(const public_call *call, const double v[])
{
    const entry *e = call->entry;
    double out[CALL_OUTPUTS];
    int32_t status;
    if (complaint_of(call, v, out, &status) != NULL || status != RWEDGE_OK)
        return NULL;
    places all, p;
    take_places(e, v, out, &all);
    p = all, p.object = NULL;
    if (e->takes_object && !minds_null(e, &p))
        return "no object, and no error";
    p = all, p.made_at = NULL;
    if (e->makes_object && !minds_null(e, &p))
        return "no place for an object, and no error";
    for (int j = 0; j < e->arguments; j++) {
        const int size = e->argument[j].sizes[0];
        const bool is_empty = size >= 0 && e->size[size].count && e->size[size].count(all.v) == 0;
        p = all, p.v[j] = NULL;
        if (size >= 0 && !is_empty && !minds_null(e, &p))
            return "an array that is NULL, and no error";
    }
    for (int j = 0; e->has_status && j < e->results; j++) {
        p = all, p.r[j] = NULL;
        if (!e->result[j].optional && !minds_null(e, &p))
            return "no place for a result, and no error";
    }
    return NULL;
}
