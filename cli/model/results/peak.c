/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "results.h"

#include <math.h>
#include <stdlib.h>

typedef struct {
    double x, value;
} peak;

/* The interval shrinks around its best place: to a quarter in each round. */
enum { PARTS = 8, ROUNDS = 17 };

static peak peak_between(double from, double to, peak start, peak_function *f, const void *context)
{
    peak best = start;
    for (int round = 0; round < ROUNDS; round++) {
        const double step = (to - from) / PARTS;
        for (int i = 1; i < PARTS; i++) {
            const double x = from + i * step, value = f(context, x);
            if (value > best.value)
                best = (peak){x, value};
        }
        from = fmax(from, best.x - step);
        to = fmin(to, best.x + step);
    }
    return best;
}

/* The peak at ascending places, or between them. */
static peak peak_around(size_t n, const double place[], peak_function *f, const void *context)
{
    size_t best = 0;
    peak highest = {place[0], f(context, place[0])};
    for (size_t i = 1; i < n; i++) {
        const double value = f(context, place[i]);
        if (!(value > highest.value))
            continue;
        highest = (peak){place[i], value};
        best = i;
    }
    return peak_between(place[best > 0 ? best - 1 : 0], place[best + 1 < n ? best + 1 : n - 1],
                        highest, f, context);
}

enum { STEPS = 32, PLACES = 2 * STEPS + 1 };

static void set_places(double left, double right, double place[PLACES])
{
    const double middle = (left + right) / 2, half = (right - left) / 2;
    for (int i = 1; i < 2 * STEPS; i++)
        place[i] = middle + half * sin(PI / 2 * (i - STEPS) / STEPS);
    place[0] = left;
    place[2 * STEPS] = right;
}

double peak_over(double left, double right, peak_function *f, const void *context)
{
    double place[PLACES];
    set_places(left, right, place);
    return peak_around(PLACES, place, f, context).value;
}

/* ---- Pressure ---- */

static double pressure_at(const void *contact, double x)
{
    double p, q;
    return rwedge_contact_tractions(contact, 1, &x, &p, &q) == RWEDGE_OK ? -p : NAN;
}

static int ascending(const void *first, const void *second)
{
    const double a = *(const double *)first, b = *(const double *)second;
    return (a > b) - (a < b);
}

/* There is a top at each corner of a measured profile. */
static double largest_pressure(const pad *shape, const rwedge_contact *contact, double left,
                               double right)
{
    double place[PLACES + PROFILE_PLACES];
    size_t n = PLACES;
    set_places(left, right, place);
    for (size_t i = 0; i < pad_corners(shape); i++) {
        const double corner = pad_corner(shape, i);
        if (!(corner > left && corner < right))
            continue;
        if (pad_is_kink(shape, corner))
            return NAN;
        place[n++] = corner;
    }
    qsort(place, n, sizeof *place, ascending);
    return peak_around(n, place, pressure_at, contact).value;
}

double peak_pressure(const contact_case *setup, const rwedge_contact *contact)
{
    const pad *shape = &setup->shape;
    double left, right;
    if (shape->a == 0 || rwedge_contact_edges(contact, &left, &right) != RWEDGE_OK)
        return NAN; /* at the apex */
    if (!pad_has_formulas(shape))
        return largest_pressure(shape, contact, left, right);
    if (rwedge_contact_tilt(contact) != 0)
        return peak_over(left, right, pressure_at, contact);
    const double b = rwedge_contact_half_width(contact);
    return shape->theta / setup->A * rwedge_peak_pressure(shape->a / b);
}
