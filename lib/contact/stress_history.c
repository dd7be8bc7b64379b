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
    size_t frame; /* where the fields of the patch are kept */
    bool is_new;  /* they were not there under the load before */
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
    size_t count = r->first[r->loads];
    if (r->capacity - count < memory->count) {
        const size_t capacity = count + count / 2 + memory->count;
        piece *pieces = realloc(r->pieces, capacity * sizeof *pieces);
        if (!pieces)
            return false;
        r->pieces = pieces;
        r->capacity = capacity;
    }
    for (size_t j = 1; j < memory->count; j++) {
        const double weight = rw_patch_weight(memory, j);
        if (weight != 0 || j + 1 == memory->count)
            r->pieces[count++] = (piece){.patch = memory->corners[j].patch, .weight = weight};
    }
    const size_t more = count - r->first[r->loads];
    r->most = more > r->most ? more : r->most;
    r->sigma[r->loads++] = contact->loads.sigma;
    r->first[r->loads] = count;
    return true;
}

/* ---- Where fields are kept from one load to the next ---- */

/* Twice as many as a load has pieces. */
typedef struct {
    rw_patch patch;
    size_t last; /* the load that needs it, from 1 on */
    rw_fields fields;
} frame;

/* The frame that has the patch since the load before, or the first that neither load needs. */
static void place(piece *p, size_t load, frame frames[], size_t count)
{
    p->is_new = true;
    for (size_t i = 0; i < count; i++) {
        const bool is_needed = frames[i].last > 0 && frames[i].last + 1 >= load;
        if (is_needed && memcmp(&frames[i].patch, &p->patch, sizeof p->patch) == 0) {
            p->frame = i;
            p->is_new = false;
            break;
        }
        if (!is_needed)
            p->frame = i;
    }
    frames[p->frame].patch = p->patch;
    frames[p->frame].last = load;
}

static frame *place_all(record *r)
{
    const size_t count = 2 * r->most + 1;
    frame *frames = calloc(count, sizeof *frames);
    for (size_t load = 0; frames && load < r->loads; load++)
        for (size_t j = r->first[load]; j < r->first[load + 1]; j++)
            place(&r->pieces[j], load + 1, frames, count);
    return frames;
}

/* ---- A block of points ---- */

static void sum_up(const record *r, size_t load, double a, frame frames[], int n, const double x[],
                   const double y[], rw_contact_fields *fields)
{
    rw_contact_fields_clear(fields, n);
    for (size_t j = r->first[load]; j < r->first[load + 1]; j++) {
        const piece *p = &r->pieces[j];
        rw_fields *of_patch = &frames[p->frame].fields;
        if (p->is_new)
            rw_patch_fields(a, p->patch, n, x, y, of_patch);
        rw_add_patch(of_patch, p->weight, j + 1 == r->first[load + 1], n, fields);
    }
}

static void roll(const rwedge_contact *contact, const record *r, frame frames[], size_t n,
                 const double x[], const double y[], double sxx[], double syy[], double txy[])
{
    for (size_t start = 0; start < n; start += RW_BATCH) {
        const int block = n - start < RW_BATCH ? (int)(n - start) : RW_BATCH;
        for (size_t load = 0; load < r->loads; load++) {
            rw_contact_fields fields;
            const size_t to = load * n + start;
            sum_up(r, load, contact->geometry.a, frames, block, x + start, y + start, &fields);
            rw_contact_stresses_from(contact, r->sigma[load], &fields, block, sxx + to, syy + to,
                                     txy + to);
        }
    }
}

/* ---- All loads ---- */

static bool have_stress(const rwedge_contact *contact, size_t n, const double x[], const double y[])
{
    for (size_t i = 0; i < n; i++)
        if (!rw_contact_has_stress(contact, x[i], y[i]))
            return false;
    return true;
}

/* Points have to be in the domain in units of the half-width too: of the least, of the largest. */
static int32_t load_all(rwedge_contact *contact, size_t loads, const double P[], const double M[],
                        const double Q[], const double sigma[], size_t n, const double x[],
                        const double y[], record *r)
{
    double least = HUGE_VAL, most = 0;
    for (size_t i = 0; i < loads; i++) {
        const int32_t status = rwedge_contact_apply(contact, P[i], M[i], Q[i], sigma[i]);
        if (status != RWEDGE_OK)
            return status;
        const double b = rwedge_contact_half_width(contact);
        if ((b == 0 || b < least || b > most) && !have_stress(contact, n, x, y))
            return RWEDGE_EDOMAIN;
        least = b > 0 ? fmin(b, least) : least;
        most = fmax(b, most);
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
    frame *frames = NULL;
    int32_t status = begin(&r, loads) ? RWEDGE_OK : RWEDGE_ENOMEM;
    if (status == RWEDGE_OK)
        status = load_all(contact, loads, P, M, Q, sigma, n, x, y, &r);
    if (status == RWEDGE_OK) {
        frames = place_all(&r);
        status = frames ? RWEDGE_OK : RWEDGE_ENOMEM;
    }
    if (status == RWEDGE_OK)
        roll(contact, &r, frames, n, x, y, sxx, syy, txy);
    free(frames);
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
