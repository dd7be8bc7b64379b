/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A name stands on white in the middle of its curve. Of the places that are free it takes the one
 * farthest from other curves and where its own is level. All lengths are in em. */
#include "names.h"

#include "page.h"
#include "words.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static const double STEP = 0.25;     /* between the places that are tried */
static const double HALF_LINE = 0.6; /* of a name's height */
static const double APART = 0.2;     /* between two labels */
static const double FRAME = 0.8;     /* between a label and the axes, with their tics */
static const double MARK = 0.5;      /* half a mark */
static const double GRAIN = 0.05;    /* less makes no difference: last bits do not choose */

/* From the middle of a name to other curves, where 1 is the edge of the name: so much at least,
 * and farther is no better. */
static const double CLEAR = 0.5, ENOUGH = 2;
static const double STEEP = 0.7; /* so much is a level place better than an upright one */

typedef struct {
    double x, y, half_width, half_height;
} box;

enum { BOXES_MAX = 2 * DRAWING_LABELS_MAX };

typedef struct {
    drawing *on;
    page at;
    box taken[BOXES_MAX];
    int taken_count;
} search;

static void take(search *in, box what)
{
    if (in->taken_count < BOXES_MAX)
        in->taken[in->taken_count++] = what;
}

static bool point_of(const search *in, const curve *of, size_t i, double *x, double *y)
{
    if (i >= of->count)
        return false;
    const double *row = of->from->row[of->first + i].number;
    *x = page_x(&in->at, &in->on->x, row[of->x]);
    *y = page_y(&in->at, of->second_axis ? &in->on->second : &in->on->y, row[of->y]);
    return isfinite(*x) && isfinite(*y);
}

static void begin(drawing *on, search *in)
{
    *in = (search){.on = on, .at = page_of(on)};
    for (int i = 0; i < on->curve_count; i++) {
        double x, y;
        if (on->curve[i].style == STYLE_CIRCLES)
            for (size_t n = 0; n < on->curve[i].count; n++)
                if (point_of(in, &on->curve[i], n, &x, &y))
                    take(in, (box){x, y, MARK, MARK});
    }
}

static bool is_free(const search *in, const box *place)
{
    const page *at = &in->at;
    if (place->x - place->half_width < at->left + FRAME ||
        place->x + place->half_width > at->right ||
        place->y - place->half_height < at->bottom + FRAME ||
        place->y + place->half_height > at->top + APART)
        return false;
    for (int i = 0; i < in->taken_count; i++)
        if (fabs(in->taken[i].x - place->x) < in->taken[i].half_width + place->half_width + APART &&
            fabs(in->taken[i].y - place->y) < in->taken[i].half_height + place->half_height + APART)
            return false;
    return true;
}

/* From a place to the nearest point of a line, where 1 is the edge of the place. */
static double distance(const box *from, double x0, double y0, double x1, double y1)
{
    const double wide = from->half_width, high = from->half_height;
    const double ax = (x0 - from->x) / wide, ay = (y0 - from->y) / high, dx = (x1 - x0) / wide,
                 dy = (y1 - y0) / high;
    const double square = dx * dx + dy * dy;
    const double part = square > 0 ? fmin(fmax(-(ax * dx + ay * dy) / square, 0), 1) : 0;
    return hypot(ax + part * dx, ay + part * dy);
}

/* How far the nearest of the other curves is; it may be said too large where it is below CLEAR. */
static double clearance(const search *in, const box *place, int own)
{
    double nearest = ENOUGH, x0, y0, x1, y1;
    for (int i = 0; i < in->on->curve_count && nearest >= CLEAR; i++) {
        const curve *other = &in->on->curve[i];
        if (i == own || other->style != STYLE_LINE)
            continue;
        bool before = point_of(in, other, 0, &x0, &y0);
        for (size_t n = 1; n < other->count; n++) {
            const bool here = point_of(in, other, n, &x1, &y1);
            if (before && here)
                nearest = fmin(nearest, distance(place, x0, y0, x1, y1));
            x0 = x1, y0 = y1, before = here;
        }
    }
    return nearest;
}

/* Takes the place where it is better than the best; rise is that of the curve, 1 upright. */
static void try_place(const search *in, int number, const box *place, double rise, double *most,
                      box *best)
{
    const double clear = is_free(in, place) ? clearance(in, place, number) : 0;
    const double good = GRAIN * floor((clear - STEEP * rise) / GRAIN);
    if (clear >= CLEAR && good > *most) {
        *most = good;
        *best = *place;
    }
}

/* The best place on a curve. False where none is clear. */
static bool find_place(const search *in, int number, box *best)
{
    const curve *own = &in->on->curve[number];
    box place = {.half_width = 0.5 * words_width(own->legend) + APART, .half_height = HALF_LINE};
    double most = -HUGE_VAL, since = STEP, x0, y0, x1, y1;
    for (size_t n = 0; n + 1 < own->count; n++) {
        if (!point_of(in, own, n, &x0, &y0) || !point_of(in, own, n + 1, &x1, &y1))
            continue;
        const double length = hypot(x1 - x0, y1 - y0);
        double at = STEP - since;
        for (; at < length; at += STEP) {
            place.x = x0 + (x1 - x0) * at / length;
            place.y = y0 + (y1 - y0) * at / length;
            try_place(in, number, &place, fabs(y1 - y0) / length, &most, best);
        }
        since = length - (at - STEP);
    }
    return most > -HUGE_VAL;
}

static void put_name(search *in, int number, const box *place)
{
    const drawing *on = in->on;
    const page *at = &in->at;
    const double across = (place->x - at->left) / (at->right - at->left),
                 up = (place->y - at->bottom) / (at->top - at->bottom);
    label *one =
        drawing_label(in->on, on->x.from + across * (on->x.to - on->x.from),
                      on->y.from + up * (on->y.to - on->y.from), "%s", on->curve[number].legend);
    one->align = ALIGN_CENTRE;
    one->boxed = true;
    one->colour = on->curve[number].colour;
    take(in, *place);
}

static void clear_legend(drawing *on)
{
    for (int i = 0; i < on->curve_count; i++)
        on->curve[i].legend[0] = '\0';
}

void names_on_curves(drawing *on)
{
    search in;
    box place;
    begin(on, &in);
    const int before = on->label_count;
    for (int i = 0; i < on->curve_count; i++) {
        if (on->curve[i].legend[0] == '\0')
            continue;
        if (!find_place(&in, i, &place)) {
            on->label_count = before;
            return;
        }
        put_name(&in, i, &place);
    }
    clear_legend(on);
}

void names_where_free(drawing *on)
{
    search in;
    box place;
    begin(on, &in);
    for (int i = on->curve_count - 1; i >= 0; i--)
        if (on->curve[i].legend[0] != '\0' && find_place(&in, i, &place))
            put_name(&in, i, &place);
    clear_legend(on);
}

static int lower_first(const void *one, const void *other)
{
    const double a = ((const label *)one)->y, b = ((const label *)other)->y;
    return (a > b) - (a < b);
}

/* Neighbours that are too near give way up and down by the same. */
static void move_apart(drawing *on, label *one, int count)
{
    const page at = page_of(on);
    const double lo = fmin(on->y.from, on->y.to), hi = fmax(on->y.from, on->y.to);
    const double line = PAGE_LINE * (hi - lo) / (at.top - at.bottom);
    double up[DRAWING_LABELS_MAX], down[DRAWING_LABELS_MAX];
    for (int i = 0; i < count; i++)
        up[i] = i > 0 ? fmax(one[i].y, up[i - 1] + line) : one[i].y;
    for (int i = count - 1; i >= 0; i--)
        down[i] = i + 1 < count ? fmin(one[i].y, down[i + 1] - line) : one[i].y;
    for (int i = 0; i < count; i++)
        one[i].y = fmax(0.5 * (up[i] + down[i]), lo + (i + 0.5) * line);
    for (int i = 0; i < count; i++)
        one[i].y = fmin(one[i].y, hi - (count - i - 0.5) * line);
}

static void lead(const label *from, double x, double y, drawing *on)
{
    const int number = dataset_curves(&on->outlines);
    dataset_add(&on->outlines,
                (data_row){.curve = number, .number = {from->x + 0.2 * (x - from->x), from->y}});
    dataset_add(&on->outlines, (data_row){.curve = number, .number = {x, y}});
    curve *line = drawing_curve(on, &on->outlines, number, 0, 1);
    line->width = 0.4;
    line->colour = from->colour;
}

void names_beside(drawing *on, int first, double x)
{
    const int count = on->label_count - first;
    label *one = &on->label[first];
    double y[DRAWING_LABELS_MAX];
    if (count < 1)
        return;
    qsort(one, (size_t)count, sizeof *one, lower_first);
    for (int i = 0; i < count; i++)
        y[i] = one[i].y;
    move_apart(on, one, count);
    for (int i = 0; i < count; i++)
        lead(&one[i], x, y[i], on);
}
