/* SPDX-License-Identifier: GPL-3.0-or-later */
/* In full sliding, G_T = f G and H = y G',
 *
 *     J2 = |f (G + iH) - H|^2 + kappa (Im G - f Re G)^2
 *
 * is a quadratic polynomial in f and linear in kappa. Its coefficients are six functions of the
 * place alone. They are enclosed once for a square, and serve all entries of one a/b. A square is
 * split in four as long as there is an entry that it might exceed. */
#include "search.h"

#include <math.h>
#include <stdlib.h>

/* Half the width of what is searched, and its depth; beyond is the far field. */
enum { REACH = 4 };

/* Squares are split down to 2^-49 and no further. */
enum { DEEPEST = 50, MOST_SQUARES = 20 * 1000 * 1000 };

/* An entry that is not done with yet. */
typedef struct {
    entry *of;
    double weight[TERMS];
} candidate;

typedef struct {
    contact c;
    size_t squares;
    double covered; /* the area of those done with */
    size_t count;
    candidate *candidates;
    size_t *lists; /* of candidates: one list of up to `count` for every depth */
} tree;

void enclose_terms(model term[TERMS], const field *over)
{
    static const double plus[2] = {1, 1}, minus[2] = {1, -1}, twice[2] = {-2, -2};
    const model *u = &over->u, *v = &over->v, *p = &over->p, *q = &over->q;
    const model p2_q2[2] = {model_product(p, p), model_product(q, q)};
    const model pu_qv[2] = {model_product(p, u), model_product(q, v)};
    const model u_q[2] = {*u, *q}, v_p[2] = {*v, *p};
    const model re = model_combination(2, minus, u_q), im = model_combination(2, plus, v_p);
    const model re2_im2[2] = {model_product(&re, &re), model_product(&im, &im)};
    const model uv = model_product(u, v);
    term[0] = model_combination(2, plus, p2_q2);
    term[1] = model_combination(2, twice, pu_qv);
    term[2] = model_combination(2, plus, re2_im2);
    term[3] = model_product(v, v);
    term[4] = model_combination(1, twice, &uv);
    term[5] = model_product(u, u);
}

/* Is J2 at the point, surely, above the ceiling? */
static bool is_exceeded_at(const contact *c, const entry *e, double x, double y)
{
    acb_t z;
    arb_t J2, ceiling;
    acb_init(z), arb_init(J2), arb_init(ceiling);
    acb_set_d_d(z, x, y);
    ball_J2(J2, c, z, e->f, e->kappa);
    arb_set_d(ceiling, e->ceiling);
    const bool exceeded = arb_gt(J2, ceiling);
    acb_clear(z), arb_clear(J2), arb_clear(ceiling);
    return exceeded;
}

/* Refutes the entry where the highest point of the square is above the ceiling for sure. */
static void try_to_refute(const contact *c, entry *e, square s, const model *J2)
{
    const summit top = model_summit(J2);
    if (!(top.value - J2->rest > e->ceiling))
        return;
    const double x = s.x + s.half * top.xi, y = fmax(0, s.y + s.half * top.eta);
    if (is_exceeded_at(c, e, x, y)) {
        e->is = EXCEEDED;
        e->beyond_x = x;
        e->beyond_y = y;
    }
}

/* True where the square is done with for this entry. */
static bool settles(const contact *c, const candidate *one, square s, const model term[TERMS])
{
    entry *e = one->of;
    if (e->is != PROVED)
        return true;
    const model J2 = model_combination(TERMS, one->weight, term);
    if (model_maximum(&J2) <= e->ceiling)
        return true;
    try_to_refute(c, e, s, &J2);
    return e->is != PROVED;
}

static void examine_quarters(tree *t, square s, int depth, size_t listed);

/* For the candidates in the list of this depth. */
static void examine(tree *t, square s, int depth, size_t listed)
{
    const size_t *list = t->lists + (size_t)depth * t->count;
    size_t *left = t->lists + (size_t)(depth + 1) * t->count;
    size_t remaining = 0;
    field over;
    model term[TERMS];
    t->squares++;
    field_enclose(&over, &t->c, s);
    enclose_terms(term, &over);
    for (size_t i = 0; i < listed; i++)
        if (!settles(&t->c, &t->candidates[list[i]], s, term))
            left[remaining++] = list[i];
    if (remaining > 0 && depth < DEEPEST && t->squares < MOST_SQUARES) {
        examine_quarters(t, s, depth + 1, remaining);
        return;
    }
    t->covered += 4 * s.half * s.half;
    for (size_t i = 0; i < remaining; i++)
        t->candidates[left[i]].of->is = OPEN;
}

static void examine_quarters(tree *t, square s, int depth, size_t listed)
{
    const double half = s.half / 2;
    for (int i = 0; i < 4; i++)
        examine(t, (square){s.x + (i % 2 ? half : -half), s.y + (i / 2 ? half : -half), half},
                depth, listed);
}

/* All around the squares. */
static void examine_far_field(const contact *c, entry *e)
{
    arb_t bound, ceiling;
    arb_init(bound), arb_init(ceiling);
    ball_far_J2(bound, c, REACH - 1, e->f, e->kappa);
    arb_set_d(ceiling, e->ceiling);
    if (!arb_le(bound, ceiling))
        e->is = OPEN;
    arb_clear(bound), arb_clear(ceiling);
}

/* a <= b (1 + relative), with sign -1 a >= b (1 - relative), for all of both balls. */
static bool is_within(const arb_t a, const arb_t b, int sign, double relative)
{
    arb_t edge;
    arb_init(edge);
    arb_set_d(edge, sign * relative);
    arb_add_ui(edge, edge, 1, BITS);
    arb_mul(edge, edge, b, BITS);
    const bool within = sign > 0 ? arb_le(a, edge) : arb_ge(a, edge);
    arb_clear(edge);
    return within;
}

static verdict verdict_of_place(const entry *e, double tolerance)
{
    if (arb_is_zero(acb_imagref(e->place)) != e->at_surface)
        return MISNAMED;
    if (!is_within(e->most, e->limit, 1, tolerance))
        return NOT_REACHED;
    return is_within(e->least, e->limit, -1, tolerance) ? PROVED : EXCEEDED;
}

/* The limit is at most load/sqrt(J2) for the J2 of the place, and if no point has more than the
 * ceiling J2 (1+gap)^2, it is no less than that over 1+gap. */
static void examine_place(const contact *c, entry *e, precision wanted)
{
    arb_t J2, over;
    arb_init(J2), arb_init(over);
    ball_J2(J2, c, e->place, e->f, e->kappa);
    arb_sqrt(e->most, J2, BITS);
    arb_div(e->most, c->load, e->most, BITS);
    arb_set_d(over, wanted.gap);
    arb_add_ui(over, over, 1, BITS);
    arb_div(e->least, e->most, over, BITS);
    arb_mul(J2, J2, over, BITS);
    arb_mul(J2, J2, over, BITS);
    e->ceiling = ball_lower(J2);
    e->is = verdict_of_place(e, wanted.tolerance);
    e->beyond_x = ball_lower(acb_realref(e->place));
    e->beyond_y = ball_lower(acb_imagref(e->place));
    arb_clear(J2), arb_clear(over);
}

/* f and kappa rounded to doubles are as good as exact: the combination allows for more roundings
 * than these. */
static candidate candidate_of(entry *e)
{
    const double f = ball_lower(e->f), kappa = ball_lower(e->kappa);
    return (candidate){e, {1, f, f * f, kappa, kappa * f, kappa * f * f}};
}

static void grow(tree *t, entry *entries)
{
    t->candidates = malloc(t->count * sizeof *t->candidates);
    t->lists = malloc((DEEPEST + 2) * t->count * sizeof *t->lists);
    if (!t->candidates || !t->lists)
        abort();
    for (size_t i = 0; i < t->count; i++) {
        t->candidates[i] = candidate_of(&entries[i]);
        t->lists[i] = i;
    }
    contact_init(&t->c, entries[0].alpha);
}

static void fell(tree *t)
{
    contact_clear(&t->c);
    free(t->candidates);
    free(t->lists);
}

size_t search(entry *entries, size_t count, precision wanted)
{
    tree t = {.count = count};
    grow(&t, entries);
    for (size_t i = 0; i < count; i++)
        examine_place(&t.c, &entries[i], wanted);
    const double half = REACH / 2.0;
    examine(&t, (square){-half, half, half}, 0, count);
    examine(&t, (square){half, half, half}, 0, count);
    const bool all_covered = fabs(t.covered - 2 * REACH * REACH) < 1e-9;
    for (size_t i = 0; i < count; i++)
        if (entries[i].is == PROVED) {
            entries[i].is = all_covered ? PROVED : OPEN;
            examine_far_field(&t.c, &entries[i]);
        }
    fell(&t);
    return t.squares;
}
