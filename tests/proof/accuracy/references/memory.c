/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "references/memory.h"

static void corner_init(corner *c)
{
    arb_init(c->load), arb_init(c->shear), arb_init(c->ratio);
}

void path_init(path *p)
{
    for (int i = 0; i < CORNERS_MAX; i++)
        corner_init(&p->corners[i]);
    p->count = 1;
}

void path_copy(path *copy, const path *p)
{
    copy->count = p->count;
    for (int i = 0; i < p->count; i++) {
        arb_set(copy->corners[i].load, p->corners[i].load);
        arb_set(copy->corners[i].shear, p->corners[i].shear);
        arb_set(copy->corners[i].ratio, p->corners[i].ratio);
    }
}

void path_clear(path *p)
{
    for (int i = 0; i < CORNERS_MAX; i++)
        arb_clear(p->corners[i].load), arb_clear(p->corners[i].shear),
            arb_clear(p->corners[i].ratio);
}

int sign_beside(const arb_t value, const arb_t scale, slong prec)
{
    if (arf_is_zero(arb_midref(value)))
        return 0;
    if (ARF_EXP(arb_midref(value)) < ARF_EXP(arb_midref(scale)) - prec / 2)
        return 0;
    return arf_sgn(arb_midref(value));
}

static void push(path *p, const arb_t load, const arb_t shear, slong prec)
{
    corner *last = &p->corners[p->count - 1], *next = &p->corners[p->count++];
    arb_t run;
    arb_init(run);
    arb_sub(run, load, last->load, prec);
    if (sign_beside(run, load, prec) <= 0) { /* it is there already */
        p->count--;
    } else {
        arb_sub(next->ratio, shear, last->shear, prec);
        arb_div(next->ratio, next->ratio, run, prec);
        arb_set(next->load, load);
        arb_set(next->shear, shear);
    }
    arb_clear(run);
}

/* The last corner with a load that is not above. */
static int corner_below(const path *p, const arb_t load, slong prec)
{
    arb_t above;
    int i = p->count - 1;
    arb_init(above);
    for (; i > 0; i--) {
        arb_sub(above, p->corners[i].load, load, prec);
        if (sign_beside(above, load, prec) <= 0)
            break;
    }
    arb_clear(above);
    return i;
}

void path_shear(arb_t shear, const path *p, const arb_t load, slong prec)
{
    const int i = corner_below(p, load, prec);
    arb_set(shear, p->corners[i].shear);
    if (i + 1 < p->count) {
        arb_t run;
        arb_init(run);
        arb_sub(run, load, p->corners[i].load, prec);
        arb_addmul(shear, run, p->corners[i + 1].ratio, prec);
        arb_clear(run);
    }
}

/* Beyond the load nothing is left. */
static void cut_off(path *p, const arb_t load, slong prec)
{
    arb_t shear;
    arb_init(shear);
    path_shear(shear, p, load, prec);
    p->count = corner_below(p, load, prec) + 1;
    if (arb_is_zero(load))
        p->count = 1;
    else
        push(p, load, shear, prec);
    arb_clear(shear);
}

/* (load' - s) - slip (shear' - T(s)) at a corner: how far inside the line of slope `slip` that
 * ends at the new load. */
static void inside(arb_t depth, const corner *c, int slip, const arb_t load, const arb_t shear,
                   slong prec)
{
    arb_sub(depth, c->shear, shear, prec);
    arb_mul_si(depth, depth, slip, prec);
    arb_add(depth, depth, load, prec);
    arb_sub(depth, depth, c->load, prec);
}

/* Back along the path, which ends at the load, to where it meets the line. */
static void forget(path *p, int slip, const arb_t load, const arb_t shear, slong prec)
{
    arb_t depth, beyond, run;
    arb_init(depth), arb_init(beyond), arb_init(run);
    int last = p->count - 1;
    for (; last > 0; last--) {
        inside(depth, &p->corners[last], slip, load, shear, prec);
        if (sign_beside(depth, load, prec) >= 0)
            break;
    }
    inside(depth, &p->corners[last], slip, load, shear, prec);
    if (last + 1 < p->count && sign_beside(depth, load, prec) > 0) {
        const corner *before = &p->corners[last], *after = before + 1;
        corner meeting;
        corner_init(&meeting);
        inside(beyond, after, slip, load, shear, prec);
        arb_sub(run, after->load, before->load, prec);
        arb_mul(run, run, depth, prec);
        arb_sub(beyond, depth, beyond, prec);
        arb_div(run, run, beyond, prec);
        arb_add(meeting.load, before->load, run, prec);
        arb_set(meeting.shear, before->shear);
        arb_addmul(meeting.shear, run, after->ratio, prec);
        p->count = last + 1;
        push(p, meeting.load, meeting.shear, prec);
        arb_clear(meeting.load), arb_clear(meeting.shear), arb_clear(meeting.ratio);
    } else {
        p->count = last + 1;
    }
    arb_clear(depth), arb_clear(beyond), arb_clear(run);
}

void path_advance(path *p, const arb_t load, const arb_t shear, slong prec)
{
    corner *end = &p->corners[p->count - 1];
    arb_t rise, run;
    arb_init(rise), arb_init(run);
    arb_sub(run, load, end->load, prec);
    if (sign_beside(run, load, prec) < 0) {
        cut_off(p, load, prec);
        end = &p->corners[p->count - 1];
        arb_zero(run);
    }
    arb_sub(rise, shear, end->shear, prec);
    const int slip = arf_sgn(arb_midref(rise));
    arb_abs(rise, rise);
    arb_sub(rise, rise, run, prec);
    if (sign_beside(rise, load, prec) > 0)
        forget(p, slip, load, shear, prec);
    push(p, load, shear, prec);
    arb_clear(rise), arb_clear(run);
}
