/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What a traction is at places, and what it carries. */
#include "traction/traction.h"

#include "base/array.h"
#include "base/domain.h"
#include "base/processor.h"
#include "traction/legendre.h"

rw_traction rw_traction_copy(const rw_traction *t, bool *is_whole)
{
    return (rw_traction){
        rw_copied(t->elements, t->count, sizeof *t->elements, is_whole), t->count, t->count,
        rw_copied(t->clusters, t->cluster_count, sizeof *t->clusters, is_whole), t->cluster_count};
}

void rw_traction_destroy(rw_traction *t)
{
    free(t->elements);
    free(t->clusters);
    *t = (rw_traction){0};
}

/* ---- Values ---- */

/* Values of an element at a block of places, by Clenshaw's recurrence, which takes two terms a
 * turn: compilers do not make vector instructions of one that moves b1 to b2. The two halves of a
 * block do not wait for each other. */
enum { BLOCK = RW_TERMS };

RW_INLINE void clenshaw(const rw_element *e, size_t n, const double x[], double value[])
{
    double v[BLOCK], b1[BLOCK] = {0}, b2[BLOCK] = {0};
    RW_EACH (i, n) {
        const double u = sqrt(rw_larger(0, (x[i] - e->end) / e->scale));
        v[i] = (2 * u - e->first - e->last) / (e->last - e->first);
    }
    for (int k = (e->terms - 1) | 1; k > 0; k -= 2) {
        RW_EACH (i, n)
            b2[i] = e->coefficient[k] + RW_LEGENDRE_RISE[k] * v[i] * b1[i] -
                    RW_LEGENDRE_FALL[k] * b2[i];
        RW_EACH (i, n)
            b1[i] = e->coefficient[k - 1] + RW_LEGENDRE_RISE[k - 1] * v[i] * b2[i] -
                    RW_LEGENDRE_FALL[k - 1] * b1[i];
    }
    RW_EACH (i, n)
        value[i] = b1[i];
}

RW_INLINE void clenshaw_of(const rw_element *e, bool is_half, const double x[], double value[])
{
    if (is_half)
        clenshaw(e, BLOCK / 2, x, value);
    else
        clenshaw(e, BLOCK, x, value);
}

RW_DISPATCH(read_block, clenshaw_of,
            (const rw_element *e, bool is_half, const double x[], double value[]),
            (e, is_half, x, value))

size_t rw_traction_index(const rw_traction *t, double x)
{
    size_t low = 0, high = t->count;
    while (low + 1 < high) {
        const size_t middle = low + (high - low) / 2;
        if (t->elements[middle].low <= x)
            low = middle;
        else
            high = middle;
    }
    return low;
}

/* Whether rounding alone parts an element from the next one. */
static bool is_joined(const rw_element *e)
{
    return e[1].low - e->high <= RW_SAME_PLACE * fmax(fabs(e->high), e->high - e->low);
}

/* The element at x; NULL where there is none. */
static const rw_element *element_at(const rw_traction *t, double x)
{
    if (t->count == 0)
        return NULL;
    const size_t i = rw_traction_index(t, x);
    const rw_element *e = t->elements + i;
    const bool is_before_next = i + 1 < t->count && is_joined(e);
    return x >= e->low && (x <= e->high || is_before_next) ? e : NULL;
}

/* Reads fewer places than a block has. */
static void read_some(const rw_element *e, size_t count, const double x[], double value[])
{
    const bool is_half = count <= BLOCK / 2;
    const size_t size = is_half ? BLOCK / 2 : BLOCK;
    double place[BLOCK], there[BLOCK];
    for (size_t i = 0; i < size; i++)
        place[i] = x[i < count ? i : 0];
    read_block(e, is_half, place, there);
    for (size_t i = 0; i < count; i++)
        value[i] = there[i];
}

void rw_traction_values(const rw_traction *t, size_t n, const double x[], double value[])
{
    for (size_t i = 0, count; i < n; i += count) {
        const rw_element *e = element_at(t, x[i]);
        count = 1;
        if (!e) {
            value[i] = 0;
            continue;
        }
        while (count < BLOCK && i + count < n && x[i + count] >= e->low && x[i + count] <= e->high)
            count++;
        if (count == BLOCK || count == BLOCK / 2)
            read_block(e, count < BLOCK, x + i, value + i);
        else
            read_some(e, count, x + i, value + i);
    }
}

double rw_traction_at(const rw_traction *t, double x)
{
    double value;
    rw_traction_values(t, 1, &x, &value);
    return value;
}

/* ---- The load ---- */

double rw_traction_total(const rw_traction *t)
{
    double sum = 0;
    for (size_t i = 0; i < t->count; i++)
        for (int k = 0; k < RW_TERMS; k++)
            sum += t->elements[i].load[k];
    return sum;
}

/* The primitive of an element, from `first` on, by Clenshaw's recurrence. */
static double primitive_at(const rw_element *e, double u)
{
    const double v = (2 * u - e->first - e->last) / (e->last - e->first);
    double b1 = 0, b2 = 0;
    for (int k = RW_TERMS + 1; k >= 0; k--) {
        const double b =
            e->primitive[k] + (2.0 * k + 1) / (k + 1) * v * b1 - (k + 1.0) / (k + 2) * b2;
        b2 = b1;
        b1 = b;
    }
    return b1;
}

double rw_traction_load_to(const rw_traction *t, double x)
{
    double sum = 0;
    for (size_t i = 0; i < t->count && t->elements[i].low < x; i++) {
        const rw_element *e = &t->elements[i];
        const double whole = primitive_at(e, e->last);
        const double part = x >= e->high ? whole : primitive_at(e, rw_element_u(e, x));
        sum += e->scale > 0 || x >= e->high ? part : whole - part;
    }
    return sum;
}
