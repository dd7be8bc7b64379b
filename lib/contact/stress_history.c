/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Stresses at many points through many loads. The loads come first: what each leaves is noted as a
 * list of weighted patches. Then the points, block by block: a patch that is in the lists of one
 * load and the next is evaluated once for both. */
#include "contact/contact.h"
#include "stress/stress.h"

#include <stdlib.h>
#include <string.h>

typedef struct {
    rw_patch patch;
    double weight;
} piece;

/* After each load: its pieces, from first[i] to first[i + 1] - 1, the last being the contact. */
typedef struct {
    piece *pieces;
    size_t *first;
    double *sigma;
    size_t loads, capacity, most;
} record;

static void discard(record *r)
{
    free(r->pieces);
    free(r->first);
    free(r->sigma);
}

static bool begin(record *r, size_t loads)
{
    *r = (record){.first = calloc(loads + 1, sizeof *r->first),
                  .sigma = calloc(loads + 1, sizeof *r->sigma)};
    return r->first && r->sigma;
}

static bool note(record *r, const rwedge_contact *contact)
{
    const rw_memory *memory = &contact->memory;
    const size_t more = memory->count - 1, count = r->first[r->loads];
    if (r->capacity - count < more) {
        const size_t capacity = count + count / 2 + more;
        piece *pieces = realloc(r->pieces, capacity * sizeof *pieces);
        if (!pieces)
            return false;
        r->pieces = pieces;
        r->capacity = capacity;
    }
    for (size_t j = 1; j < memory->count; j++)
        r->pieces[count + j - 1] = (piece){memory->corners[j].patch, rw_patch_weight(memory, j)};
    r->sigma[r->loads++] = contact->loads.sigma;
    r->first[r->loads] = count + more;
    r->most = more > r->most ? more : r->most;
    return true;
}

/* ---- A block of points ---- */

/* The fields of patches, kept from one load to the next. */
typedef struct {
    rw_patch patch;
    size_t last_used; /* by the load of this number, from 1 on; 0 is never */
    rw_fields fields;
} frame;

typedef struct {
    double a;
    frame *frames; /* twice as many as a load has pieces */
    size_t count;
} reel;

/* The frame of a patch under a load: that which the load before had, or the first that neither
 * needs. */
static const rw_fields *fields_of(reel *kept, rw_patch patch, size_t load, int n, const double x[],
                                  const double y[])
{
    frame *unused = NULL;
    for (size_t i = 0; i < kept->count; i++) {
        frame *f = &kept->frames[i];
        const bool is_kept = f->last_used > 0 && f->last_used + 1 >= load;
        if (is_kept && memcmp(&f->patch, &patch, sizeof patch) == 0) {
            f->last_used = load;
            return &f->fields;
        }
        if (!is_kept && !unused)
            unused = f;
    }
    unused->patch = patch;
    unused->last_used = load;
    rw_patch_fields(kept->a, patch, n, x, y, &unused->fields);
    return &unused->fields;
}

static void sum_up(const record *r, size_t load, reel *kept, int n, const double x[],
                   const double y[], rw_contact_fields *fields)
{
    for (int i = 0; i < n; i++)
        fields->normal[i] = fields->tangential[i] = (rw_field){0, 0, 0, 0};
    for (size_t j = r->first[load]; j < r->first[load + 1]; j++) {
        const bool whole = j + 1 == r->first[load + 1];
        if (r->pieces[j].weight != 0 || whole)
            rw_add_patch(fields_of(kept, r->pieces[j].patch, load + 1, n, x, y),
                         r->pieces[j].weight, whole, n, fields);
    }
}

static void roll(const rwedge_contact *contact, const record *r, reel *kept, size_t n,
                 const double x[], const double y[], double sxx[], double syy[], double txy[])
{
    for (size_t start = 0; start < n; start += RW_BLOCK) {
        const int block = n - start < RW_BLOCK ? (int)(n - start) : RW_BLOCK;
        for (size_t i = 0; i < kept->count; i++)
            kept->frames[i].last_used = 0;
        for (size_t load = 0; load < r->loads; load++) {
            rw_contact_fields fields;
            const size_t to = load * n + start;
            sum_up(r, load, kept, block, x + start, y + start, &fields);
            rw_contact_stresses_from(contact, r->sigma[load], &fields, block, sxx + to, syy + to,
                                     txy + to);
        }
    }
}

/* ---- All loads ---- */

static int32_t load_all(rwedge_contact *contact, size_t loads, const double P[], const double M[],
                        const double Q[], const double sigma[], size_t n, const double x[],
                        const double y[], record *r)
{
    for (size_t i = 0; i < loads; i++) {
        const int32_t status = rwedge_contact_apply(contact, P[i], M[i], Q[i], sigma[i]);
        if (status != RWEDGE_OK)
            return status;
        for (size_t j = 0; j < n; j++)
            if (!rw_contact_has_stress(contact, x[j], y[j]))
                return RWEDGE_EDOMAIN;
        if (!note(r, contact))
            return RWEDGE_ENOMEM;
    }
    return RWEDGE_OK;
}

static int32_t follow(rwedge_contact *contact, size_t loads, const double P[], const double M[],
                      const double Q[], const double sigma[], size_t n, const double x[],
                      const double y[], double sxx[], double syy[], double txy[])
{
    record r;
    reel kept = {.a = contact->geometry.a};
    int32_t status = begin(&r, loads) ? RWEDGE_OK : RWEDGE_ENOMEM;
    if (status == RWEDGE_OK)
        status = load_all(contact, loads, P, M, Q, sigma, n, x, y, &r);
    if (status == RWEDGE_OK) {
        kept.count = 2 * r.most + 1;
        kept.frames = malloc(kept.count * sizeof *kept.frames);
        status = kept.frames ? RWEDGE_OK : RWEDGE_ENOMEM;
    }
    if (status == RWEDGE_OK)
        roll(contact, &r, &kept, n, x, y, sxx, syy, txy);
    free(kept.frames);
    discard(&r);
    return status;
}

int32_t rwedge_contact_stress_history(rwedge_contact *contact, size_t loads, const double P[],
                                      const double M[], const double Q[], const double sigma[],
                                      size_t n, const double x[], const double y[], double sxx[],
                                      double syy[], double txy[])
{
    if (!contact || (loads > 0 && (!P || !M || !Q || !sigma)) || (n > 0 && (!x || !y)) ||
        (n > 0 && loads > 0 && (!sxx || !syy || !txy)))
        return RWEDGE_ENULL;
    rwedge_contact *ahead;
    int32_t status = rwedge_contact_copy(contact, &ahead);
    if (status != RWEDGE_OK)
        return status;
    status = follow(ahead, loads, P, M, Q, sigma, n, x, y, sxx, syy, txy);
    if (status == RWEDGE_OK) { /* the original takes its place */
        const rwedge_contact before = *contact;
        *contact = *ahead;
        *ahead = before;
    }
    rwedge_contact_destroy(ahead);
    return status;
}
