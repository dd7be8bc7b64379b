/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "numerical/pattern.h"

#include <math.h>
#include <string.h>

static double width(rw_zone zone)
{
    return zone.right - zone.left;
}

static void remove_at(rw_zones *z, int i)
{
    z->count--;
    memmove(z->zone + i, z->zone + i + 1, (size_t)(z->count - i) * sizeof *z->zone);
}

/* Gives a part of the zones its label. */
static void insert_part(rw_zones *z, rw_zone part)
{
    rw_zones new = {.count = 0};
    for (int i = 0; i < z->count; i++) {
        const rw_zone zone = z->zone[i];
        const double left = fmax(zone.left, part.left), right = fmin(zone.right, part.right);
        const bool is_changed = left < right && zone.label != part.label;
        const rw_zone pieces[3] = {{zone.label, zone.left, is_changed ? left : zone.right},
                                   {part.label, left, right},
                                   {zone.label, right, zone.right}};
        for (int k = 0; k < (is_changed ? 3 : 1); k++)
            if (pieces[k].right > pieces[k].left)
                rw_zones_insert(&new, new.count, pieces[k]);
    }
    *z = new;
}

void rw_pattern_clean(rw_zones *z, double least)
{
    for (int i = 0; i + 1 < z->count;) {
        rw_zone *a = &z->zone[i], *next = a + 1;
        if (a->label == next->label) {
            a->right = next->right;
            remove_at(z, i + 1);
            continue;
        }
        if (a->label != 0 && next->label != 0) {
            const double part = fmin(least, fmin(0.2 * width(*a), 0.2 * width(*next)));
            const double middle = a->right;
            a->right = middle - part;
            next->left = middle + part;
            rw_zones_insert(z, i + 1, (rw_zone){0, middle - part, middle + part});
        }
        i++;
    }
}

/* ---- At the edges ---- */

/* The sign of slip at an edge at first, by the singularity there if all stuck. */
static int edge_sign(const rw_problem *p, int side)
{
    const double from_load = p->shear / 3.14159265358979323846, from_stretch = p->stretch * p->half;
    return from_load - (side ? 1 : -1) * from_stretch > 0 ? 1 : -1;
}

/* The grid does not resolve a zone at an edge that is narrower than so many angles. */
enum { NARROW = 6 };

/* Makes a zone of slip, about an angle wide, at an edge that sticks; `flipped` turns its sign. A
 * narrow zone that slips already may be flipped too: slip may have turned round. false where there
 * is no such variant. */
static bool slip_at_edge(const rw_problem *p, rw_zones *z, int side, bool flipped, double angle)
{
    const rw_zone last = rw_zones_at_edge(z, side);
    const bool is_narrow = width(last) < NARROW * angle;
    if (last.label != 0) {
        z->zone[side ? z->count - 1 : 0].label *= flipped && is_narrow ? -1 : 1;
        return !flipped || is_narrow;
    }
    const int label = flipped ? -edge_sign(p, side) : edge_sign(p, side);
    const double part = fmin(0.3 * angle, 0.3 * width(last));
    insert_part(z, side ? (rw_zone){label, last.right - part, last.right}
                        : (rw_zone){label, last.left, last.left + part});
    return true;
}

/* Whether a growing edge sticks at first trial: its slip is only a few angles wide. */
static bool seems_stuck(const rw_problem *p, const rw_zones *z, int side, double angle)
{
    const rw_zone last = rw_zones_at_edge(z, side);
    return p->grows[side] &&
           (last.label == 0 || width(last) < NARROW * angle + 3 * p->growth[side]);
}

bool rw_pattern_variant(const rw_problem *p, const rw_zones *z, double angle, int number,
                        rw_zones *variant)
{
    *variant = *z;
    for (int side = 0; side < 2; side++) {
        const int bits = number >> (side ? 0 : 2) & 3;
        const bool may_stick = seems_stuck(p, z, side, angle);
        const bool sticks = may_stick && (bits & 2) == 0, flipped = (bits & 1) != 0;
        if ((!may_stick && (bits & 2) != 0) || (sticks && flipped))
            return false;
        if (sticks)
            variant->zone[side ? variant->count - 1 : 0].label = 0;
        else if (!slip_at_edge(p, variant, side, flipped, angle))
            return false;
    }
    return true;
}

/* ---- Inside ---- */

bool rw_pattern_simpler(const rw_problem *p, rw_zones *z, double least)
{
    if (z->count <= 3)
        return false;
    int narrow = 1;
    double narrowest = HUGE_VAL;
    for (int i = 1; i + 1 < z->count; i++) {
        const double angle = rw_angle_of(p, z->zone[i].right) - rw_angle_of(p, z->zone[i].left);
        if (angle < narrowest) {
            narrowest = angle;
            narrow = i;
        }
    }
    rw_zone *zone = &z->zone[narrow], *before = zone - 1, *next = zone + 1;
    if (zone->label != 0) {
        zone->label = 0;
    } else if (before->label == next->label) {
        zone->label = before->label;
    } else { /* between two ways: the wider takes the room of the other */
        rw_zone *wider = width(*before) < width(*next) ? next : before;
        rw_zone *narrower = wider == next ? before : next;
        const bool is_inner = narrower > z->zone && narrower < z->zone + z->count - 1;
        narrower->label = is_inner ? 0 : wider->label;
        zone->label = is_inner ? 0 : wider->label;
    }
    rw_pattern_clean(z, least);
    return true;
}

void rw_pattern_insert(rw_zones *z, const rw_zones *parts, double least)
{
    for (int i = 0; i < parts->count; i++)
        insert_part(z, parts->zone[i]);
    rw_pattern_clean(z, least);
}
