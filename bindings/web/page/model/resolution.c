/* SPDX-License-Identifier: GPL-3.0-or-later */
/* How well a measured profile is resolved: places between the highest pressure and the edges, the
 * noise by a fit, and what the largest pressure becomes without every second place. */
#include "page.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { STATIONS = 200, PLACES = 17 };

/* The place of the largest pressure between two; the pressure is negative. */
static double largest_between(const rwedge_contact *contact, double from, double to)
{
    double x[STATIONS], p[STATIONS], q[STATIONS];
    int most = 0;
    for (int i = 0; i < STATIONS; i++)
        x[i] = from + (to - from) * (i + 0.5) / STATIONS;
    if (rwedge_contact_tractions(contact, STATIONS, x, p, q) != RWEDGE_OK)
        return NAN;
    for (int i = 1; i < STATIONS; i++)
        if (p[i] < p[most])
            most = i;
    return x[most];
}

static size_t count_between(const scan *all, double from, double to)
{
    size_t count = 0;
    for (size_t i = 0; i < all->count; i++)
        count += all->x[i] >= from && all->x[i] <= to;
    return count;
}

/* Places and heights, to be freed; every step-th of them. */
static scan scan_of(const pairs *places, size_t step)
{
    const size_t n = (places->count + step - 1) / step;
    scan all = {n, memory_zeroed(n + 1, sizeof(double)), memory_zeroed(n + 1, sizeof(double)),
                memory_zeroed(n + 1, sizeof(int64_t))};
    for (size_t i = 0; i < n; i++) {
        all.x[i] = places->first[i * step];
        all.value[i] = places->second[i * step];
    }
    return all;
}

static void free_scan(scan *all)
{
    free(all->x);
    free(all->value);
    free(all->line);
}

/* The share by which the largest pressure changes without every second place. */
static double change_without_half(const contact_case *setup, const pairs *places)
{
    static pad_profile half; /* is large */
    profile_remark remark = {0, ""};
    scan all = scan_of(places, 2);
    double change = NAN;
    half = (pad_profile){0};
    scan_settle(&all, true);
    if (pad_profile_of_heights(&all, field_making(), &half, &remark))
        change =
            case_peak_pressure(setup, &half) / case_peak_pressure(setup, setup->shape.places) - 1;
    pad_profile_free(&half);
    free_scan(&all);
    return change;
}

/* The answer for the places that were fitted last: a slider asks about the same ones again and
 * again. */
static struct {
    size_t count;
    double *x, *height;
    double rms;
    int arcs;
} fitted;

static bool is_fitted(const scan *all)
{
    const size_t bytes = all->count * sizeof *all->x;
    return fitted.count == all->count && memcmp(fitted.x, all->x, bytes) == 0 &&
           memcmp(fitted.height, all->value, bytes) == 0;
}

/* Takes the places over. */
static void fit(scan *all)
{
    double place[PLACES], slope[PLACES], level;
    if (is_fitted(all)) {
        free_scan(all);
        return;
    }
    free(fitted.x);
    free(fitted.height);
    fitted.count = all->count;
    fitted.x = all->x;
    fitted.height = all->value;
    fitted.arcs = 0;
    fitted.rms = NAN;
    free(all->line);
    if (all->count < 8 || rwedge_profile_fit(all->count, all->x, all->value, 0, PLACES, place,
                                             slope, &level, &fitted.rms) != RWEDGE_OK)
        return;
    for (int i = 1; i < PLACES; i++)
        fitted.arcs += place[i] > place[i - 1];
}

void resolution_write(const contact_case *setup)
{
    const pairs *places = field_profile() != NULL ? profiles_places(field_profile()) : NULL;
    double left, right;
    if (places == NULL || setup->shape.places == NULL || strcmp(places->column, "height") != 0 ||
        rwedge_contact_edges(setup->contact, &left, &right) != RWEDGE_OK || isnan(left))
        return;
    const double middle = (left + right) / 2;
    const double peak_left = largest_between(setup->contact, left, middle),
                 peak_right = largest_between(setup->contact, middle, right);
    scan all = scan_of(places, 1);
    scan_settle(&all, true);
    const profile_making *making = field_making();
    if (!making->is_from_lowest && !making->is_down)
        json_add("{'resolution':{'left':%n,'right':%n}}",
                 (double)count_between(&all, left, peak_left),
                 (double)count_between(&all, peak_right, right));
    fit(&all);
    json_add("{'resolution':{'arcs':%n,'noise':%n,'change':%n}}", (double)fitted.arcs, fitted.rms,
             change_without_half(setup, places));
}
