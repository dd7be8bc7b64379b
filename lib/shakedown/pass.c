/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "shakedown/pass.h"

#include "base/domain.h"
#include "base/select.h"
#include "stress/stress.h"

void rw_pass_stresses(const rw_pass *pass, double y, size_t n, const double x[], rw_point path[])
{
    double depth[RW_BATCH];
    rw_fields fields;
    for (int i = 0; i < RW_BATCH; i++)
        depth[i] = y;
    for (size_t first = 0; first < n; first += RW_BATCH) {
        const int count = n - first < RW_BATCH ? (int)(n - first) : RW_BATCH;
        rw_sliding_fields(&pass->arcs, pass->slides, pass->patch, count, x + first, depth, &fields);
        for (int i = 0; i < count; i++) {
            const rw_field normal = rw_field_in(&fields, i);
            const rw_stress_state s = rw_superpose(normal, rw_field_multiple(pass->f, normal));
            path[first + (size_t)i] = (rw_point){{s.difference, pass->weight * s.mean, s.shear}};
        }
    }
}

double rw_pass_place(const rw_pass_path *path, double t)
{
    static const double FARTHEST = 1e-9; /* its stresses count as none */
    const double turn = path->turn, round = 4 * turn;
    const double at = t > 2 * turn ? t - round : t < -2 * turn ? t + round : t;
    const double left = rw_larger(2 * turn - fabs(at), FARTHEST * turn);
    if (fabs(at) ==
        rw_patch_half_width(path->pass->patch)) /* beside it a power of what rounding leaves */
        return at < 0 ? path->pass->patch.left : path->pass->patch.right;
    return path->middle + (fabs(at) <= turn ? at : copysign(turn * (turn / left), at));
}

/* ---- The marks: the edges of the contact, and the ends of arcs inside ---- */

/* The nearest mark's distance. */
static double distance_to_mark(const rw_pass *pass, double x)
{
    double nearest = rw_smaller(fabs(x - pass->patch.left), fabs(x - pass->patch.right));
    for (size_t i = 0; i < pass->arcs.count; i++) {
        const rw_arc arc = rw_arc_at(&pass->arcs, i);
        if (rw_arc_is_inside(arc, pass->patch))
            nearest = rw_smaller(nearest, rw_smaller(fabs(x - arc.left), fabs(x - arc.right)));
    }
    return nearest;
}

static double length_at(const rw_pass_path *path, double distance)
{
    return rw_smaller(sqrt(distance * distance + path->y * path->y), path->turn / 2);
}

double rw_pass_length(const rw_pass_path *path, double t)
{
    return length_at(path, distance_to_mark(path->pass, rw_pass_place(path, t)));
}

/* ---- The grid ---- */

/* How far the next place is from a mark. On the surface places come close to it; those of a coarse
 * sample are farther apart there, where the path hardly varies any more. */
static double next_offset(const rw_pass_path *path, double offset)
{
    static const double COARSE = 0.5, NEAR = 1e-3, FARTHER = 3;
    const bool is_far = path->step >= COARSE && path->y == 0 && offset < NEAR * path->turn;
    return offset + (is_far ? FARTHER : 1) * path->step *
                        rw_larger(length_at(path, offset), path->closest * path->turn);
}

static void put(rw_pass_path *path, double t)
{
    if (path->n < RW_PASS_GRID)
        path->t[path->n++] = t;
}

static void reverse(size_t n, double t[])
{
    for (size_t i = 0; i < n / 2; i++) {
        const double first = t[i];
        t[i] = t[n - 1 - i];
        t[n - 1 - i] = first;
    }
}

/* Puts places from a mark up to `length` away, neither the mark nor the end itself; side -1 is
 * towards smaller t. The places are in the order of t. */
static void put_beside(rw_pass_path *path, double mark, double length, int side)
{
    const size_t before = path->n;
    for (double d = next_offset(path, 0); d < 0.999 * length && path->n < RW_PASS_GRID;
         d = next_offset(path, d))
        put(path, mark + side * d);
    if (side < 0)
        reverse(path->n - before, path->t + before);
}

static void put_between(rw_pass_path *path, double left, double right)
{
    put_beside(path, left, (right - left) / 2, 1);
    put(path, left + (right - left) / 2);
    put_beside(path, right, (right - left) / 2, -1);
    put(path, right);
}

static void put_inside(rw_pass_path *path, double s)
{
    double last = -s;
    for (size_t i = 0; i < path->pass->arcs.count; i++) {
        const rw_arc arc = rw_arc_at(&path->pass->arcs, i);
        const double ends[] = {arc.left - path->middle, arc.right - path->middle};
        for (int k = 0; k < 2; k++)
            if (ends[k] > last && ends[k] < s) {
                put_between(path, last, ends[k]);
                last = ends[k];
            }
    }
    put_between(path, last, s);
}

/* How close places come to a mark, so that all have room on the grid. */
static double closest_for(const rw_pass *pass, double step)
{
    static const double CLOSEST = 1e-12;
    size_t marks = 2;
    for (size_t i = 0; i < pass->arcs.count; i++)
        marks += rw_arc_is_inside(rw_arc_at(&pass->arcs, i), pass->patch) ? 2 : 0;
    const double room = (double)RW_PASS_GRID / (2 * (double)marks); /* on each side */
    return rw_larger(CLOSEST, exp(-log1p(step) * room) / (double)marks);
}

void rw_pass_path_at(rw_pass_path *path, const rw_pass *pass, double y)
{
    path->pass = pass;
    path->y = y;
    path->middle = rw_patch_middle(pass->patch);
    path->turn = 2 * (rw_patch_half_width(pass->patch) + y);
    path->n = 0;
}

void rw_pass_sample(rw_pass_path *path, const rw_pass *pass, double y, double step)
{
    const double s = rw_patch_half_width(pass->patch);
    rw_pass_path_at(path, pass, y);
    path->step = step;
    path->closest = closest_for(pass, step);
    if (y > 0) { /* on the surface the path outside is a straight line between the edges */
        put(path, -2 * path->turn);
        put_beside(path, -s, 2 * path->turn - s, -1);
    }
    put(path, -s);
    put_inside(path, s);
    if (y > 0)
        put_beside(path, s, 2 * path->turn - s, 1);
    for (size_t first = 0; first < path->n; first += RW_BATCH) {
        const size_t n = path->n - first < RW_BATCH ? path->n - first : RW_BATCH;
        double x[RW_BATCH];
        for (size_t i = 0; i < n; i++)
            x[i] = rw_pass_place(path, path->t[first + i]);
        rw_pass_stresses(pass, y, n, x, path->path + first);
    }
}
