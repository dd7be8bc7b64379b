/* SPDX-License-Identifier: GPL-3.0-or-later */
/* In full sliding, G_T = f G and H = y G',
 *
 *     J2 = |f (G + iH) - H|^2 + kappa (Im G - f Re G)^2
 *
 * is a quadratic polynomial in f and linear in kappa. Its coefficients are six functions of the
 * place alone. They are enclosed once for a square, and serve all entries of one a/b. A square is
 * split in four as long as there is an entry that it might exceed. */
#include "search.hpp"

#include <math.h>

/* Half the width of what is searched, and its depth; beyond is the far field. */
enum { REACH = 4 };

/* Squares are split down to 2^-49 and no further. */
enum { DEEPEST = 50, MOST_SQUARES = 20 * 1000 * 1000 };

void enclose_terms(model term[TERMS], const field &over)
{
    const model &u = over.u, &v = over.v, &p = over.p, &q = over.q;
    const model real = u - q, imaginary = v + p;
    term[0] = p * p + q * q;
    term[1] = -2 * (p * u + q * v);
    term[2] = real * real + imaginary * imaginary;
    term[3] = v * v;
    term[4] = -2 * (u * v);
    term[5] = u * u;
}

namespace
{

/* f and kappa rounded to doubles are as good as exact: the combination allows for more roundings
 * than these. */
void set_weights(entry *e)
{
    const double f = lower_bound(e->f), kappa = lower_bound(e->kappa);
    const double weights[TERMS] = {1, f, f * f, kappa, kappa * f, kappa * f * f};
    for (int i = 0; i < TERMS; i++)
        e->weight[i] = weights[i];
}

/* Refutes the entry where the highest point of the square is above the ceiling for sure. */
void try_to_refute(const patch &c, entry *e, square s, const model &J2)
{
    const summit top = model_summit(J2);
    if (!(top.value - J2.rest > e->ceiling))
        return;
    const double x = s.x + s.half * top.xi, y = fmax(0, s.y + s.half * top.eta);
    if (J2_at(c, complex_ball(x, y), e->f, e->kappa) > e->ceiling) {
        e->is = EXCEEDED;
        e->beyond_x = x;
        e->beyond_y = y;
    }
}

/* True where the square is done with for this entry. */
bool settles(const patch &c, entry *e, square s, const model term[TERMS])
{
    if (e->is != PROVED)
        return true;
    const model J2 = model_combination(TERMS, e->weight, term);
    if (model_maximum(J2) <= e->ceiling)
        return true;
    try_to_refute(c, e, s, J2);
    return e->is != PROVED;
}

struct tree {
    const patch c;
    size_t squares = 0;
    double covered = 0; /* the area of those done with */

    /* For the entries that the square might exceed. */
    void examine(square s, int depth, const std::vector<entry *> &listed)
    {
        std::vector<entry *> left;
        model term[TERMS];
        squares++;
        enclose_terms(term, field_over(c, s));
        for (entry *open : listed)
            if (!settles(c, open, s, term))
                left.push_back(open);
        if (!left.empty() && depth < DEEPEST && squares < MOST_SQUARES) {
            examine_quarters(s, depth + 1, left);
            return;
        }
        covered += 4 * s.half * s.half;
        for (entry *open : left)
            open->is = OPEN;
    }

  private:
    void examine_quarters(square s, int depth, const std::vector<entry *> &listed)
    {
        const double half = s.half / 2;
        for (const double y : {s.y - half, s.y + half})
            for (const double x : {s.x - half, s.x + half})
                examine({x, y, half}, depth, listed);
    }
};

/* All around the squares. */
void examine_far_field(const patch &c, entry *e)
{
    if (!(far_J2(c, REACH - 1, e->f, e->kappa) <= e->ceiling))
        e->is = OPEN;
}

verdict verdict_of_place(const entry &e, double tolerance)
{
    if (is_zero(im(e.place)) != e.at_surface)
        return MISNAMED;
    if (!(e.most <= e.limit * (ball(tolerance) + 1)))
        return NOT_REACHED;
    return e.least >= e.limit * (ball(-tolerance) + 1) ? PROVED : EXCEEDED;
}

/* The limit is at most load/sqrt(J2) for the J2 of the place, and if no point has more than the
 * ceiling J2 (1+GAP)^2, it is no less than that over 1+GAP. */
void examine_place(const patch &c, entry *e, double tolerance)
{
    const ball J2 = J2_at(c, e->place, e->f, e->kappa), over = ball(GAP) + 1;
    e->most = c.load() / sqrt(J2);
    e->least = e->most / over;
    e->ceiling = lower_bound(J2 * over * over);
    e->is = verdict_of_place(*e, tolerance);
    e->beyond_x = lower_bound(re(e->place));
    e->beyond_y = lower_bound(im(e->place));
}

} // namespace

void search(group *judged, double tolerance)
{
    tree t = {patch(judged->entries[0].alpha, 1)};
    std::vector<entry *> all;
    for (entry &e : judged->entries) {
        examine_place(t.c, &e, tolerance);
        set_weights(&e);
        all.push_back(&e);
    }
    const double half = REACH / 2.0;
    for (const double x : {-half, half})
        t.examine({x, half, half}, 0, all);
    const bool all_covered = fabs(t.covered - 2 * REACH * REACH) < 1e-9;
    for (entry &e : judged->entries)
        if (e.is == PROVED) {
            e.is = all_covered ? PROVED : OPEN;
            examine_far_field(t.c, &e);
        }
    judged->squares = t.squares;
}
