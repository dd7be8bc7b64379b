/* SPDX-License-Identifier: GPL-3.0-or-later */
/* States note the patches that follow those which the state before left as they were. Points are
 * computed block by block: the sums over the first patches, and the field of the contact itself,
 * are kept from state to state. */
#include "contact/record.h"

#include "base/array.h"
#include "stress/stress.h"

#include <stdlib.h>

void rw_record_destroy(rw_record *r)
{
    for (size_t i = 0; i < r->count; i++)
        if (!r->entries[i].is_lent) {
            rw_traction_destroy(&r->entries[i].shear);
            rw_traction_destroy(&r->entries[i].pressed);
        }
    free(r->own.all);
    free(r->now.all);
    free(r->entries);
}

static bool reserve(rw_pieces *p, size_t more)
{
    rw_piece *all = rw_grown(p->all, p->count, &p->capacity, more, sizeof *all);
    if (all)
        p->all = all;
    return all;
}

static bool is_same(const rw_piece *a, const rw_piece *b)
{
    return a->weight == b->weight && rw_patch_is_same(a->patch, b->patch);
}

bool rw_record_add(rw_record *r, const rwedge_contact *contact, const rw_entry *lender)
{
    const rw_memory *memory = &contact->memory;
    const size_t before = r->now.count;
    bool is_whole = true;
    rw_entry *entries = rw_grown(r->entries, r->count, &r->capacity, 1, sizeof *entries);
    if (!entries)
        return false;
    r->entries = entries;
    rw_entry *e = &r->entries[r->count++];
    *e = (rw_entry){.sigma = contact->loads.sigma, .is_lent = lender != NULL};
    r->now.count = 0;
    if (lender) {
        e->shear = lender->shear;
        e->pressed = lender->pressed;
    } else if (contact->phase == RW_COMPUTED) {
        e->shear = rw_traction_copy(&contact->computed.now->now.shear.traction, &is_whole);
        e->pressed = rw_traction_copy(&contact->computed.now->now.pressed, &is_whole);
    }
    if (!is_whole || !reserve(&r->own, memory->count) || !reserve(&r->now, memory->count))
        return false;
    for (size_t j = 1; j < memory->count; j++) {
        const rw_piece next = {memory->corners[j].patch, rw_patch_weight(memory, j)};
        if (next.weight == 0 && j + 1 < memory->count)
            continue;
        rw_piece *place = &r->now.all[r->now.count++];
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

/* The field of one rw_piece's patch, and the sum up to it. */
typedef struct {
    rw_patch patch;
    rw_fields field, sum;
} level;

/* The points, and a level for each rw_piece; levels[0] is for no rw_piece. */
typedef struct {
    const rwedge_contact *contact;
    int n;
    const double *x, *y;
    level *levels;
    size_t top; /* of the last load */
} block;

static void add_piece(const block *b, size_t at, const rw_piece *next)
{
    level *l = &b->levels[at];
    if (!rw_patch_is_same(l->patch, next->patch)) {
        const rw_arcs arcs = rw_arcs_of(&b->contact->geometry);
        const rw_sliding_way slides = {b->contact->unlike, next->weight < 0 ? -1 : 1};
        l->patch = next->patch;
        rw_sliding_fields(&arcs, slides, next->patch, b->n, b->x, b->y, &l->field);
    }
    l->sum = b->levels[at - 1].sum;
    rw_add_fields(&l->field, next->weight, b->n, &l->sum);
}

/* The contact is often the same, with more or fewer pieces inside it: its field is then kept. */
static void move_contact(const block *b, size_t to, const rw_piece *contact)
{
    const level *from = &b->levels[b->top];
    if (to == b->top || !rw_patch_is_same(from->patch, contact->patch))
        return;
    b->levels[to].patch = from->patch;
    b->levels[to].field = from->field;
}

static void follow_load(block *b, const rw_entry *e, const rw_piece own[])
{
    const size_t top = e->kept + e->own;
    if (e->own > 0)
        move_contact(b, top, &own[e->own - 1]);
    for (size_t i = 0; i < e->own; i++)
        add_piece(b, e->kept + i + 1, &own[i]);
    b->top = top;
}

static void compute_blocks(const rwedge_contact *contact, const rw_record *r, level levels[],
                           const rw_stress_points *p)
{
    for (size_t start = 0; start < p->n; start += RW_BATCH) {
        const int size = p->n - start < RW_BATCH ? (int)(p->n - start) : RW_BATCH;
        block b = {contact, size, p->x + start, p->y + start, levels, 0};
        for (size_t i = 0; i <= r->most; i++)
            levels[i].patch = (rw_patch){0, 0};
        const rw_piece *own = r->own.all;
        for (size_t load = 0; load < r->count; load++) {
            const rw_entry *e = &r->entries[load];
            const size_t to = load * p->n + start;
            follow_load(&b, e, own);
            own += e->own;
            rw_fields shear = levels[b.top].sum, pressure = levels[b.top].field;
            if (e->shear.count > 0)
                rw_add_traction(&e->shear, contact->f, size, b.x, b.y, &shear);
            if (e->pressed.count > 0) {
                rw_clear_fields(size, &pressure);
                rw_add_traction(&e->pressed, contact->f, size, b.x, b.y, &pressure);
            }
            rw_contact_stresses_from(contact, e->sigma, &pressure, &shear, size, p->sxx + to,
                                     p->syy + to, p->txy + to);
        }
    }
}

bool rw_record_stresses(const rw_record *r, const rwedge_contact *contact,
                        const rw_stress_points *points)
{
    level *levels = calloc(r->most + 1, sizeof *levels);
    if (levels)
        compute_blocks(contact, r, levels, points);
    free(levels);
    return levels != NULL;
}
