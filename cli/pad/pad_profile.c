/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Profiles of pads from slopes or heights. The library does the mechanics; here is what is said of
 * them. */
#include "pad.h"

#include "number/number.h"
#include "text/text.h"

#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const double STEEPEST = 1.5707963267948966, SIZE_MOST = 1e60;

void pad_profile_free(pad_profile *profile)
{
    free(profile->scan_x);
    free(profile->above);
    profile->scan_x = profile->above = NULL;
}

/* "slope 0.1: " and what is wrong with it. */
static bool refuse(profile_remark *remark, int64_t line, const char *column, double value,
                   const char *why)
{
    remark->line = line;
    snprintf(remark->text, sizeof remark->text, "%s %.6g: %s", column, value + 0, why);
    return false;
}

static bool has_count(size_t n, const scan *given, const profile_making *how,
                      profile_remark *remark)
{
    remark->line = given->count > 0 ? given->line[given->count - 1] : 0;
    snprintf(remark->text, sizeof remark->text, "%zu place%s; allowed: 2 to %d%s", n,
             n == 1 ? "" : "s", PROFILE_PLACES,
             n > PROFILE_PLACES && how->is_command && !how->fits
                 ? "; of more heights, --fit makes a few arcs"
                 : "");
    return n >= 2 && n <= PROFILE_PLACES;
}

static bool has_sizes(const scan *given, const char *column, profile_remark *remark)
{
    for (size_t i = 0; i < given->count; i++) {
        if (!number_is_size(given->x[i]) || !(fabs(given->x[i]) <= SIZE_MOST))
            return refuse(remark, given->line[i], "x", given->x[i],
                          "must be 0, or 1e-60 to 1e60 in magnitude");
        if (!number_is_size(given->value[i]))
            return refuse(remark, given->line[i], column, given->value[i],
                          "must be 0, or 1e-60 to 1e60 in magnitude");
    }
    return true;
}

/* ---- The lowest place ---- */

double pad_profile_lowest(const pad_profile *profile)
{
    const double *x = profile->x, *slope = profile->slope;
    size_t first = 0, last = profile->count - 1;
    if (slope[first] > 0 || slope[last] < 0)
        return NAN;
    while (slope[first + 1] < 0)
        first++; /* the slope reaches 0 between this place and the next */
    while (slope[last - 1] > 0)
        last--;
    const double from = slope[first] == 0 ? x[first]
                                          : x[first] - slope[first] * (x[first + 1] - x[first]) /
                                                           (slope[first + 1] - slope[first]);
    const double to = slope[last] == 0 ? x[last]
                                       : x[last - 1] - slope[last - 1] * (x[last] - x[last - 1]) /
                                                           (slope[last] - slope[last - 1]);
    return from / 2 + to / 2;
}

/* The integral of the slope from the first place. */
static double height_from_first(const pad_profile *profile, double at)
{
    const double *x = profile->x, *slope = profile->slope;
    double height = 0;
    if (at <= x[0])
        return slope[0] * (at - x[0]);
    for (size_t i = 1; i < profile->count; i++) {
        if (x[i] == x[i - 1])
            continue;
        const double end = fmin(at, x[i]), length = end - x[i - 1];
        const double rate = (slope[i] - slope[i - 1]) / (x[i] - x[i - 1]);
        height += length * (slope[i - 1] + rate * length / 2);
        if (at <= x[i])
            return height;
    }
    return height + slope[profile->count - 1] * (at - x[profile->count - 1]);
}

double pad_profile_height(const pad_profile *profile, double x)
{
    const double lowest = pad_profile_lowest(profile);
    const double at = !isnan(lowest)          ? lowest
                      : profile->slope[0] > 0 ? profile->x[0]
                                              : profile->x[profile->count - 1];
    return height_from_first(profile, x) - height_from_first(profile, at);
}

double pad_profile_hull_share(const pad_profile *profile, double left, double right)
{
    double most = 0;
    for (size_t i = 0; i < profile->scanned && profile->arcs == 0; i++)
        if (profile->scan_x[i] > left && profile->scan_x[i] < right)
            most = fmax(most, profile->above[i]);
    return most == 0
               ? 0
               : most / fmax(pad_profile_height(profile, left), pad_profile_height(profile, right));
}

static bool move_origin(const profile_making *how, pad_profile *to, profile_remark *remark)
{
    if (!how->is_from_lowest)
        return true;
    const double lowest = pad_profile_lowest(to);
    if (isnan(lowest)) {
        remark->line = 0;
        snprintf(remark->text, sizeof remark->text,
                 "the lowest place is at an end: --origin lowest cannot find it");
        return false;
    }
    for (size_t i = 0; i < to->count; i++)
        to->x[i] -= lowest;
    for (size_t i = 0; i < to->scanned; i++)
        to->scan_x[i] -= lowest;
    to->left -= lowest;
    to->right -= lowest;
    return true;
}

/* ---- Slopes ---- */

static bool is_convex(const scan *given, profile_remark *remark)
{
    const double *slope = given->value;
    const size_t n = given->count;
    for (size_t i = 0; i < n; i++) {
        if (!(fabs(slope[i]) < STEEPEST))
            return refuse(remark, given->line[i], "slope", slope[i],
                          "must be below pi/2 in magnitude");
        if (i > 0 && slope[i] < slope[i - 1])
            return refuse(remark, given->line[i], "slope", slope[i],
                          "less than the slope before it: the profile is not convex there; "
                          "allowed: slopes that do not fall");
    }
    return slope[n - 1] > slope[0] || refuse(remark, given->line[n - 1], "slope", slope[n - 1],
                                             "all slopes are equal: a plane");
}

static void take(size_t n, const double x[], const double slope[], pad_profile *to)
{
    to->count = n;
    memcpy(to->x, x, n * sizeof *x);
    memcpy(to->slope, slope, n * sizeof *slope);
}

bool pad_profile_of_slopes(const scan *given, const profile_making *how, pad_profile *to,
                           profile_remark *remark)
{
    if (!has_count(given->count, given, how, remark) || !has_sizes(given, "slope", remark) ||
        !is_convex(given, remark))
        return false;
    take(given->count, given->x, given->value, to);
    to->left = -HUGE_VAL; /* the slope stays */
    to->right = HUGE_VAL;
    *remark = (profile_remark){0, ""};
    return move_origin(how, to, remark);
}

/* ---- Heights ---- */

/* The places above the hull, and how far. */
typedef struct {
    size_t count, first, worst;
    double most;
    char list[120]; /* "1, 2, 3 and 5 more" */
} excess;

static excess excess_of(const scan *given, const double hull[])
{
    enum { LISTED = 5 };
    excess above = {.count = 0};
    for (size_t i = 0; i < given->count; i++) {
        const double height = given->value[i] - hull[i];
        if (!(height > 0))
            continue;
        above.first = above.count == 0 ? i : above.first;
        above.worst = above.count == 0 || height > above.most ? i : above.worst;
        above.most = fmax(above.most, height);
        if (above.count++ < LISTED)
            list_add(above.list, sizeof above.list, ", ", "%.6g", given->x[i] + 0);
        else if (above.count == LISTED + 1)
            list_add(above.list, sizeof above.list, ", ", "...");
    }
    return above;
}

static bool refuse_status(int32_t status, profile_remark *remark)
{
    remark->line = 0;
    snprintf(remark->text, sizeof remark->text, "%s", rwedge_strerror(status));
    return false;
}

/* Heights point down where they are much nearer to a concave line than to a convex one. */
static bool points_down(const scan *given, double most)
{
    double *turned = memory_zeroed(2 * given->count, sizeof *turned), *hull = turned + given->count;
    double least = 0;
    for (size_t i = 0; i < given->count; i++)
        turned[i] = -given->value[i];
    if (rwedge_profile_hull(given->count, given->x, turned, hull) == RWEDGE_OK)
        for (size_t i = 0; i < given->count; i++)
            least = fmax(least, turned[i] - hull[i]);
    free(turned);
    return most > 4 * least;
}

/* Keeps how far the heights are above a profile that is `level` high at its first place. */
static void keep_excess(const scan *given, double level, pad_profile *to)
{
    to->scanned = given->count;
    to->scan_x = memory_zeroed(given->count, sizeof *to->scan_x);
    to->above = memory_zeroed(given->count, sizeof *to->above);
    for (size_t i = 0; i < given->count; i++) {
        to->scan_x[i] = given->x[i];
        to->above[i] = given->value[i] - level - height_from_first(to, given->x[i]);
    }
}

/* Slopes that are the same from place to place are a line between two of them. */
static size_t thin_out(size_t n, double x[], double slope[])
{
    size_t kept = 0;
    for (size_t i = 0; i < n; i++) {
        const bool is_inside =
            i > 0 && i + 1 < n && slope[i] == slope[i - 1] && slope[i] == slope[i + 1];
        if (is_inside || (i + 1 == n && i > 1 && slope[i] == slope[i - 1]))
            continue;
        x[kept] = x[i];
        slope[kept++] = slope[i];
    }
    return kept;
}

/* Leaves out flanks that are steeper than `steepest`, with the note. */
static void cut_flanks(scan *part, const double slope[], double steepest, pad_profile *to,
                       profile_remark *remark)
{
    size_t first = 0, last = part->count - 1;
    while (first < last && slope[first] <= -steepest)
        first++;
    while (last > first && slope[last - 1] >= steepest)
        last--;
    to->is_cut = first > 0 || last < part->count - 1;
    if (!to->is_cut || last < first + 1)
        return;
    snprintf(remark->text, sizeof remark->text,
             "flanks steeper than %.3g are left out: x below %.6g and above %.6g", steepest,
             part->x[first], part->x[last]);
    part->x += first;
    part->value += first;
    part->line += first;
    part->count = last - first + 1;
}

static bool refuse_down(const scan *given, size_t worst, const profile_making *how,
                        profile_remark *remark)
{
    return refuse(remark, given->line[worst], "height", given->value[worst],
                  how->is_command ? "the heights point down; --heights down turns them"
                                  : "the heights point down; they must rise away from x = 0");
}

/* What is wrong with a fit, and what may be behind it. */
static bool refuse_all(profile_remark *remark, const pad_profile *to, const char *why)
{
    remark->line = 0;
    snprintf(remark->text, sizeof remark->text, "%s%s", why,
             to->is_cut ? "; flanks that are too steep were left out: are heights and places in "
                          "one unit?"
                        : "");
    return false;
}

static bool take_fit(const scan *given, const excess *above, const profile_making *how,
                     pad_profile *to, profile_remark *remark)
{
    enum { PLACES = 17 };
    double place[PLACES], slope[PLACES], level;
    if (given->count < 8)
        return refuse_all(remark, to, "fewer than 8 heights; allowed: 8 and more for a fit");
    const int32_t status = rwedge_profile_fit(given->count, given->x, given->value, how->arcs,
                                              PLACES, place, slope, &level, &to->rms);
    if (status == RWEDGE_EABSENT && !how->is_down && points_down(given, above->most))
        return refuse_down(given, above->worst, how, remark);
    if (status == RWEDGE_EABSENT)
        return refuse_all(remark, to,
                          "the heights are not those of one convex pad, beyond their noise: two "
                          "contacts, with a pocket between them; allowed: the part of one of them");
    if (status != RWEDGE_OK)
        return refuse_status(status, remark);
    to->arcs = 1;
    while (to->arcs + 1 < PLACES && place[to->arcs + 1] > place[to->arcs])
        to->arcs++;
    if (!(fmax(fabs(slope[0]), fabs(slope[to->arcs])) < STEEPEST))
        return refuse_all(remark, to, "the fit has slopes of pi/2 and more");
    take((size_t)to->arcs + 1, place, slope, to);
    keep_excess(given, level, to);
    char cut[200];
    snprintf(cut, sizeof cut, "%.190s", remark->text);
    snprintf(remark->text, sizeof remark->text, "%s%sfitted by %d arc%s; rms of what is left %.3g",
             cut, cut[0] != '\0' ? "; " : "", (int)to->arcs, to->arcs > 1 ? "s" : "", to->rms);
    return true;
}

static bool take_slopes(const scan *given, const excess *above, const profile_making *how,
                        double place[], double slope[], pad_profile *to, profile_remark *remark)
{
    const size_t n = thin_out(given->count, place, slope);
    if (!has_count(n, given, how, remark))
        return false;
    const scan slopes = {n, place, slope, given->line};
    if (!is_convex(&slopes, remark))
        return false;
    take(n, place, slope, to);
    if (above->count > 0 && how->takes_hull)
        keep_excess(given, given->value[0] + slope[0] * (place[0] - given->x[0]), to);
    return true;
}

/* What the hull changes; whether a profile may be made of the heights. */
static bool judge(const scan *given, const excess *above, const profile_making *how,
                  profile_remark *remark)
{
    char why[360];
    *remark = (profile_remark){0, ""};
    if (above->count == 0 || how->fits)
        return true;
    if (!how->takes_hull && !how->is_down && points_down(given, above->most))
        return refuse_down(given, above->worst, how, remark);
    snprintf(
        why, sizeof why,
        "not convex at %zu place%s, x = %s; the convex hull %s lower by up to %.6g, at x = %.6g%s",
        above->count, above->count > 1 ? "s" : "", above->list,
        how->takes_hull ? "that is taken is" : "is", above->most, given->x[above->worst] + 0,
        how->takes_hull || !how->is_command ? "" : "; of noise, --fit; --hull takes it");
    refuse(remark, given->line[above->first], "height", given->value[above->first], why);
    return how->takes_hull;
}

static bool make(scan *given, const profile_making *how, double room[], pad_profile *to,
                 profile_remark *remark)
{
    const double FIT_STEEPEST = 0.5; /* beyond what the theory allows in a contact, five times */
    double *place = room, *slope = room + given->count, *hull = slope + given->count;
    int32_t status = rwedge_profile_hull(given->count, given->x, given->value, hull);
    if (status == RWEDGE_OK)
        status = rwedge_profile_slopes(given->count, given->x, given->value, place, slope);
    if (status != RWEDGE_OK)
        return refuse_status(status, remark);
    const excess above = excess_of(given, hull);
    if (!judge(given, &above, how, remark))
        return false;
    const profile_remark changed = *remark;
    cut_flanks(given, slope, how->fits ? FIT_STEEPEST : STEEPEST, to, remark);
    if (how->fits)
        return take_fit(given, &above, how, to, remark);
    if (to->is_cut) {
        status = rwedge_profile_slopes(given->count, given->x, given->value, place, slope);
        if (status != RWEDGE_OK)
            return refuse_status(status, remark);
    }
    const profile_remark cut = *remark;
    if (!take_slopes(given, &above, how, place, slope, to, remark))
        return false;
    *remark = above.count > 0 ? changed : to->is_cut ? cut : (profile_remark){0, ""};
    return true;
}

bool pad_profile_of_heights(const scan *all, const profile_making *how, pad_profile *to,
                            profile_remark *remark)
{
    scan given = *all;
    if (given.count < 2)
        return has_count(given.count, all, how, remark);
    if (!has_sizes(&given, "height", remark))
        return false;
    for (size_t i = 0; how->is_down && i < given.count; i++)
        given.value[i] = -given.value[i];
    double *room = memory_zeroed(3 * given.count, sizeof *room);
    const bool done = make(&given, how, room, to, remark);
    free(room);
    if (!done)
        return false;
    to->left = given.x[0];
    to->right = given.x[given.count - 1];
    return move_origin(how, to, remark);
}
