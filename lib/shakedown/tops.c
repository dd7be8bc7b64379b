/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "shakedown/tops.h"

#include "base/domain.h"

/* Three neighbouring places of the path, which were brought closer together so many times. */
typedef struct {
    double t[3], square[3];
    int narrowed;
} triple;

static int highest_of(const triple *p)
{
    const int first = p->square[0] > p->square[1] ? 0 : 1;
    return p->square[2] > p->square[first] ? 2 : first;
}

/* The top of the parabola, or the highest place where there is none. */
static double top_of(const triple *p)
{
    const double left = p->t[1] - p->t[0], right = p->t[2] - p->t[1];
    if (!(left > 0 && right > 0)) /* beside a mark they may be the same double */
        return p->t[highest_of(p)];
    const double rise = (p->square[1] - p->square[0]) / left,
                 fall = (p->square[1] - p->square[2]) / right;
    if (!(rise + fall > 0))
        return p->t[highest_of(p)];
    const double top = p->t[1] + (rise * right - fall * left) / (2 * (rise + fall));
    return fmin(fmax(top, p->t[0]), p->t[2]);
}

/* The parts by which the steps around a top become smaller, time after time. */
static const double PARTS[] = {0.25, 0.1, 0.03, 0.03};
enum { NARROWINGS = 4 };

/* The step to the neighbours of the next middle. Where the highest is not in the middle, the top is
 * beyond: the triple moves there as wide as it is. */
static double next_step(triple *p)
{
    const double step = (p->t[2] - p->t[0]) / 2;
    if (highest_of(p) != 1 || p->narrowed == NARROWINGS)
        return step;
    return PARTS[p->narrowed++] * step;
}

/* The triples around their tops. */
static void narrow(const rw_pass_path *path, const double centre[2], int n, triple around[],
                   rw_top tops[])
{
    double x[3 * RW_TOPS];
    rw_point at[3 * RW_TOPS];
    for (int i = 0; i < n; i++) {
        triple *p = &around[i];
        const double top = top_of(p), step = next_step(p);
        for (int k = 0; k < 3; k++) {
            p->t[k] = top + (k - 1) * step;
            x[3 * i + k] = rw_pass_place(path, p->t[k]);
        }
    }
    rw_pass_stresses(path->pass, path->y, (size_t)(3 * n), x, at);
    for (int i = 0; i < n; i++) {
        for (int k = 0; k < 3; k++)
            around[i].square[k] = rw_square_from(centre, &at[3 * i + k]);
        const int best = highest_of(&around[i]);
        if (around[i].square[best] > tops[i].square)
            tops[i] = (rw_top){around[i].t[best], at[3 * i + best], around[i].square[best]};
    }
}

static bool are_narrow(int n, const triple around[])
{
    for (int i = 0; i < n; i++)
        if (around[i].narrowed < NARROWINGS)
            return false;
    return true;
}

/* What the grid may hide is less than HIDDEN of the fall to the lower neighbour. */
static bool may_exceed(double square, double before, double here, double after)
{
    static const double HIDDEN = 0.5;
    return here > before && here >= after && here + HIDDEN * (here - fmin(before, after)) >= square;
}

int rw_tops(const rw_pass_path *path, const double centre[2], double square, rw_top tops[])
{
    enum { ROUNDS = 2 * NARROWINGS };
    const size_t n = path->n;
    const double round = 4 * path->turn;
    triple around[RW_TOPS];
    int count = 0;
    double before = rw_square_from(centre, &path->path[n - 1]),
           here = rw_square_from(centre, path->path);
    for (size_t i = 0; i < n && count < RW_TOPS; i++) {
        const size_t next = i + 1 < n ? i + 1 : 0;
        const double after = rw_square_from(centre, &path->path[next]);
        if (may_exceed(square, before, here, after)) {
            const double t0 = i > 0 ? path->t[i - 1] : path->t[n - 1] - round,
                         t2 = next > 0 ? path->t[next] : path->t[0] + round;
            around[count] = (triple){{t0, path->t[i], t2}, {before, here, after}, 0};
            tops[count++] = (rw_top){path->t[i], path->path[i], here};
        }
        before = here;
        here = after;
    }
    for (int k = 0; k < ROUNDS && !are_narrow(count, around); k++)
        narrow(path, centre, count, around, tops);
    return count;
}
