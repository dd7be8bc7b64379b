/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "parts.h"

#include <math.h>
#include <string.h>

#define BIT(status) (1u << (status))

int array_size = 3;

const entry_argument which_object = {
    .name = "object", .low = INT32_MIN, .high = INT32_MAX, .finite = 1, .whole = 1};

/* ---- Objects: nothing yet, simple, with a history ---- */

static rwedge_contact *contact_of_loads(size_t count, const double loads[][2])
{
    rwedge_contact *contact = NULL;
    if (rwedge_contact_create(0.5, 0.3, 1, 0.5, &contact) != RWEDGE_OK)
        return NULL;
    for (size_t i = 0; i < count; i++)
        rwedge_contact_load(contact, loads[i][0], loads[i][1]);
    return contact;
}

/* They live as long as the program. */
static void *object_of(const entry *e, double number)
{
    static const double loads[][2] = {{4, 0}, {4, 1.4}, {6, -1}, {5, -0.7}};
    static rwedge_contact *contacts[OBJECTS];
    static rwedge_series *series[OBJECTS];
    const int i = (int)fabs(fmod(number, OBJECTS));
    if (contacts[0] == NULL) {
        contacts[0] = contact_of_loads(0, loads);
        contacts[1] = contact_of_loads(1, loads);
        contacts[2] = contact_of_loads(4, loads);
        rwedge_series_create(0.3, 1, &series[0]);
        rwedge_series_create(0, 7, &series[1]);
        rwedge_series_create(0.3, 60, &series[2]);
    }
    return strcmp(e->family, "contact") == 0 ? (void *)contacts[i] : (void *)series[i];
}

/* ---- A function as a call ---- */

static size_t size_of(const entry *e)
{
    return e->sizes > 1 ? 2 : (size_t)array_size;
}

static int count_of(const entry *e, const signed char sizes[2])
{
    int count = 1;
    for (int k = 0; k < 2; k++)
        count *= sizes[k] < 0 ? 1 : (int)size_of(e);
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
        p->n[j] = size_of(e);
        for (int i = 0; e->size[j].teller != NULL && i < ENTRY_COUNT; i++)
            if (strcmp(entries[i].name, e->size[j].teller) == 0) {
                double told, *const result[] = {&told};
                entries[i].call(p->object, NULL, NULL, result, NULL);
                p->n[j] = (size_t)told;
            }
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

/* What is changed is a copy, what is made is freed. */
static int32_t make(const public_call *call, const double given[], double out[])
{
    const entry *e = call->entry;
    if (e == NULL)
        return call->make(given, out);
    double v[CALL_ARGUMENTS];
    memcpy(v, given, (size_t)call->arguments * sizeof(double));
    keep_short(e, v);
    places p;
    take_places(e, v, out, &p);
    rwedge_contact *copy = NULL;
    if (e->changes_object) {
        rwedge_contact_copy(p.object, &copy);
        p.object = copy;
    }
    const int32_t status = call_at(e, &p, out);
    rwedge_contact_destroy(copy);
    free_object(e, p.made);
    return status;
}

static public_call call_of_entry(const entry *e)
{
    public_call call = {.name = e->name, .entry = e};
    if (e->takes_object)
        call.argument[call.arguments++] = &which_object;
    for (int j = 0; j < e->arguments; j++)
        for (int i = count_of(e, e->argument[j].sizes); i > 0; i--)
            call.argument[call.arguments++] = &e->argument[j];
    for (int j = 0; j < e->results; j++)
        call.outputs += count_of(e, e->result[j].sizes);
    call.gives_anything = e->sizes > 0 && e->size[0].teller != NULL;
    call.may_be_infinite = e->may_be_infinite;
    call.also_allowed = e->errors & ~(BIT(RWEDGE_EDOMAIN) | BIT(RWEDGE_ENULL) | BIT(RWEDGE_ENOMEM));
    if (e->refuses_more)
        call.also_allowed |= BIT(RWEDGE_EDOMAIN);
    return call;
}

static public_call call_of_sequence(const sequence *s)
{
    public_call call = {
        .name = s->name, .outputs = s->outputs, .also_allowed = s->allowed, .make = s->make};
    for (const char *kind = s->kinds; *kind != '\0'; kind++)
        call.argument[call.arguments++] = argument_of_letter(*kind);
    return call;
}

const public_call *public_calls(size_t *count)
{
    enum { SEQUENCES = 32 };
    static public_call calls[SEQUENCES + ENTRY_COUNT];
    static size_t made;
    if (made == 0) {
        for (int i = 0; i < ENTRY_COUNT; i++)
            calls[made++] = call_of_entry(&entries[i]);
        for (const sequence *s = sequences;
             s->name != NULL && made < sizeof calls / sizeof calls[0]; s++)
            calls[made++] = call_of_sequence(s);
    }
    *count = made;
    return calls;
}

/* ---- The rules for errors ---- */

bool is_sound(const entry_argument *a, double v)
{
    return entry_allows(a, v);
}

static bool are_in_their_domains(const public_call *call, const double v[])
{
    for (int i = 0; i < call->arguments; i++)
        if (!may_be_anything(call->argument[i]) && !entry_allows(call->argument[i], v[i]))
            return false;
    return true;
}

static const double MARK = -6.02214076e23; /* what an output is before: no result is that */

const char *complaint_of(const public_call *call, const double v[], double out[], int32_t *status)
{
    for (int i = 0; i < CALL_OUTPUTS; i++)
        out[i] = MARK;
    *status = make(call, v, out);
    const bool valid = are_in_their_domains(call, v);
    if (valid && *status != RWEDGE_OK && (call->also_allowed & BIT(*status)) == 0)
        return "an error, though all arguments are in the domain";
    if (!valid && *status == RWEDGE_OK)
        return "a result, though an argument is outside the domain";
    for (int i = 0; i < CALL_OUTPUTS; i++) {
        const bool wanted = *status == RWEDGE_OK && (call->gives_anything || i < call->outputs);
        if (wanted && !call->gives_anything && !isfinite(out[i]) &&
            !(call->may_be_infinite && isinf(out[i])))
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
    return e->has_status ? status == RWEDGE_ENULL : status == RWEDGE_EDOMAIN || value == 0;
}

const char *complaint_about_null(const public_call *call, const double v[])
{
    const entry *e = call->entry;
    double out[CALL_OUTPUTS];
    int32_t status;
    if (e == NULL || complaint_of(call, v, out, &status) != NULL || status != RWEDGE_OK)
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
        p = all, p.v[j] = NULL;
        if (e->argument[j].sizes[0] >= 0 && !minds_null(e, &p))
            return "an array that is NULL, and no error";
    }
    for (int j = 0; e->has_status && j < e->results; j++) {
        p = all, p.r[j] = NULL;
        if (!e->result[j].optional && !minds_null(e, &p))
            return "no place for a result, and no error";
    }
    return NULL;
}
