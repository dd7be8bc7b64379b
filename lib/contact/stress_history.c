/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Stresses at many points through many loads. First the contact goes through the loads: each load
 * leaves the first patches as they were, and the record notes the patches that follow, with their
 * weights. Then the points are computed, block by block: the sums over the first patches, and the
 * field of the contact itself, are kept from load to load. */
#include "base/array.h"
#include "contact/contact.h"
#include "stress/stress.h"

typedef struct {
    rw_patch patch;
    double weight;
} piece;

/* Pieces in a row. */
typedef struct {
    piece *all;
    size_t count, capacity;
} pieces;

/* For a load: how many pieces of the load before it keeps; how many more it has, the last being the
 * contact; its tension. */
typedef struct {
    size_t kept, own;
    double sigma;
    rw_traction shear; /* where it is no sum of pieces */
} entry;

typedef struct {
    pieces own, now; /* those of all loads; all pieces of the last load */
    entry *entries;
    size_t loads, most; /* most: pieces of one load */
} record;

static void discard(record *r)
{
    for (size_t i = 0; i < r->loads; i++)
        rw_traction_destroy(&r->entries[i].shear);
    free(r->own.all);
    free(r->now.all);
    free(r->entries);
}

static bool reserve(pieces *p, size_t more)
{
    piece *all = rw_grown(p->all, p->count, &p->capacity, more, sizeof *all);
    if (all)
        p->all = all;
    return all;
}

static bool is_same(const piece *a, const piece *b)
{
    return a->weight == b->weight && rw_patch_is_same(a->patch, b->patch);
}

static bool note(record *r, const rwedge_contact *contact)
{
    const rw_memory *memory = &contact->memory;
    const size_t before = r->now.count;
    bool is_whole = true;
    entry *e = &r->entries[r->loads++];
    *e = (entry){.sigma = contact->loads.sigma};
    r->now.count = 0;
    if (contact->phase == RW_COMPUTED)
        e->shear = rw_traction_copy(&contact->computed.now->now.shear.traction, &is_whole);
    if (!is_whole || !reserve(&r->own, memory->count) || !reserve(&r->now, memory->count))
        return false;
    for (size_t j = 1; j < memory->count; j++) {
        const piece next = {memory->corners[j].patch, rw_patch_weight(memory, j)};
        if (next.weight == 0 && j + 1 < memory->count)
            continue;
        piece *place = &r->now.all[r->now.count++];
        if (e->own == 0 && e->kept < before && is_same(&next, place)) {
            e->kept++;
        } else {
            *place = r->own.all[r->own.count++] = next;
            e->own++;
        }
    }
    r->most = r->now.count > r->most ? r->now.count : r->most;
    return true;
}

/* ---- A block of points ---- */

/* The field of one piece's patch, and the sum up to it. */
typedef struct {
    rw_patch patch;
    rw_fields field, sum;
} level;

/* The points, and a level for each piece; levels[0] is for no piece. */
typedef struct {
    const rw_geometry *geometry;
    int n;
    const double *x, *y;
    level *levels;
    size_t top; /* of the last load */
} block;

static void add_piece(const block *b, size_t at, const piece *next)
{
    level *l = &b->levels[at];
    if (!rw_patch_is_same(l->patch, next->patch)) {
        l->patch = next->patch;
        rw_patch_fields(b->geometry, next->patch, b->n, b->x, b->y, &l->field);
    }
    l->sum = b->levels[at - 1].sum;
    rw_add_fields(&l->field, next->weight, b->n, &l->sum);
}

/* The contact is often the same, with more or fewer pieces inside it: its field is then kept. */
static void move_contact(const block *b, size_t to, const piece *contact)
{
    const level *from = &b->levels[b->top];
    if (to == b->top || !rw_patch_is_same(from->patch, contact->patch))
        return;
    b->levels[to].patch = from->patch;
    b->levels[to].field = from->field;
}

static void follow_load(block *b, const entry *e, const piece own[])
{
    const size_t top = e->kept + e->own;
    if (e->own > 0)
        move_contact(b, top, &own[e->own - 1]);
    for (size_t i = 0; i < e->own; i++)
        add_piece(b, e->kept + i + 1, &own[i]);
    b->top = top;
}

/* All points, and their stresses after each load. */
typedef struct {
    size_t n;
    const double *x, *y;
    double *sxx, *syy, *txy;
} points;

static void compute_blocks(const rwedge_contact *contact, const record *r, level levels[],
                           const points *p)
{
    for (size_t start = 0; start < p->n; start += RW_BATCH) {
        const int size = p->n - start < RW_BATCH ? (int)(p->n - start) : RW_BATCH;
        block b = {&contact->geometry, size, p->x + start, p->y + start, levels, 0};
        for (size_t i = 0; i <= r->most; i++)
            levels[i].patch = (rw_patch){0, 0};
        const piece *own = r->own.all;
        for (size_t load = 0; load < r->loads; load++) {
            const entry *e = &r->entries[load];
            const size_t to = load * p->n + start;
            follow_load(&b, e, own);
            own += e->own;
            rw_fields shear = levels[b.top].sum;
            if (e->shear.count > 0)
                rw_add_traction(&e->shear, contact->f, size, b.x, b.y, &shear);
            rw_contact_stresses_from(contact, e->sigma, &levels[b.top].field, &shear, size,
                                     p->sxx + to, p->syy + to, p->txy + to);
        }
    }
}

/* ---- All loads ---- */

static bool have_stress(const rwedge_contact *contact, const points *p)
{
    for (size_t i = 0; i < p->n; i++)
        if (!rw_contact_has_stress(contact, p->x[i], p->y[i]))
            return false;
    return true;
}

/* Points have to be in the domain in units of the half-width too, the least and the largest. */
static int32_t load_all(rwedge_contact *contact, const rw_load_history *loads, const points *p,
                        record *r)
{
    double least = HUGE_VAL, most = 0;
    for (size_t i = 0; i < loads->count; i++) {
        const rw_loads to = rw_loads_at(loads, i);
        const int32_t status = rwedge_contact_apply(contact, to.P, to.M, to.Q, to.sigma);
        if (status != RWEDGE_OK)
            return status;
        const double b = rwedge_contact_half_width(contact);
        if ((b == 0 || b < least || b > most) && !have_stress(contact, p))
            return RWEDGE_EDOMAIN;
        least = b > 0 ? fmin(b, least) : least;
        most = fmax(b, most);
        if (!note(r, contact))
            return RWEDGE_ENOMEM;
    }
    return RWEDGE_OK;
}

static int32_t follow(rwedge_contact *contact, const rw_load_history *loads, const points *p)
{
    record r = {.entries = calloc(loads->count + 1, sizeof *r.entries)};
    level *levels = NULL;
    int32_t status = r.entries ? RWEDGE_OK : RWEDGE_ENOMEM;
    if (status == RWEDGE_OK)
        status = load_all(contact, loads, p, &r);
    if (status == RWEDGE_OK) {
        levels = calloc(r.most + 1, sizeof *levels);
        status = levels ? RWEDGE_OK : RWEDGE_ENOMEM;
    }
    if (status == RWEDGE_OK)
        compute_blocks(contact, &r, levels, p);
    free(levels);
    discard(&r);
    return status;
}

int32_t rwedge_contact_stress_history(rwedge_contact *contact, size_t loads, const double P[],
                                      const double M[], const double Q[], const double sigma[],
                                      size_t n, const double x[], const double y[], double sxx[],
                                      double syy[], double txy[])
{
    const rw_load_history history = {loads, P, M, Q, sigma};
    const points p = {n, x, y, sxx, syy, txy};
    if (!contact || !rw_is_load_history(&history) || (n > 0 && (!x || !y)) ||
        (n > 0 && loads > 0 && (!sxx || !syy || !txy)))
        return RWEDGE_ENULL;
    rwedge_contact *ahead;
    int32_t status = rwedge_contact_copy(contact, &ahead);
    if (status != RWEDGE_OK)
        return status;
    status = follow(ahead, &history, &p);
    if (status == RWEDGE_OK)
        rw_contact_exchange(contact, ahead);
    rwedge_contact_destroy(ahead);
    return status;
}
