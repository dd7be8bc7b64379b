/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A log as it was measured, made fit: loads that friction cannot carry are clipped, and loads
 * between which nothing turns are left out. */
#include "history.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* What is read once may be asked for again: a filter changes its own copy. */
static void own_loads(load_history *loads)
{
    load *own = memory_zeroed(loads->count, sizeof *own);
    memcpy(own, loads->load, loads->count * sizeof *own);
    loads->load = own;
}

/* ---- Clipping ---- */

/* The number of rows, and the largest excess. */
typedef struct {
    size_t rows;
    double most;
} excess;

static void note(double by, excess *all)
{
    all->rows++;
    all->most = fmax(all->most, by);
}

static void clip(load *to, double f, excess *below, excess *beyond)
{
    const double limit = f * fmax(to->P, 0);
    if (to->P < 0)
        note(-to->P, below);
    if (to->P > 0 && fabs(to->Q) > limit)
        note(fabs(to->Q) - limit, beyond);
    if (to->P <= 0)
        to->P = to->M = to->Q = 0;
    to->Q = fmax(-limit, fmin(to->Q, limit));
}

static void clip_all(double f, load_history *loads)
{
    excess below = {0, 0}, beyond = {0, 0};
    own_loads(loads);
    for (size_t i = 0; i < loads->count; i++)
        clip(&loads->load[i], f, &below, &beyond);
    if (below.rows + beyond.rows == 0)
        notice("--clip: no row of %zu needs it", loads->count);
    if (below.rows > 0)
        notice("--clip: P below 0, by %.4g at most, is separated: %zu of %zu rows", below.most,
               below.rows, loads->count);
    if (beyond.rows > 0)
        notice("--clip: |Q| above f P, by %.4g at most, slides: %zu of %zu rows", beyond.most,
               beyond.rows, loads->count);
}

/* ---- Turning points ---- */

/* Each of these turns for itself. */
enum { PARTS = 6 };
static const char *const part_words[PARTS] = {"the largest P",         "the range of M",
                                              "the range of Q",        "the range of sigma",
                                              "the range of the tilt", "the range of displacement"};

static double part_of(const load *at, int part)
{
    const double all[PARTS] = {at->P, at->M, at->Q, at->sigma, at->tilt, at->displacement};
    return all[part];
}

/* Its range in the log; P counts from 0, because a log in which it stays has a range of noise. */
static double size_of(const load_history *loads, int part)
{
    double least = part == 0 ? 0 : HUGE_VAL, most = -HUGE_VAL;
    for (size_t i = 0; i < loads->count; i++) {
        least = fmin(least, part_of(&loads->load[i], part));
        most = fmax(most, part_of(&loads->load[i], part));
    }
    return most - least;
}

/* Marks the loads at which a part turns by more than the threshold. */
static void mark_turns(const load_history *loads, int part, double threshold, bool kept[])
{
    size_t low = 0, high = 0; /* since it turned last */
    int rises = 0;            /* 1, or -1 where it falls; 0 is not known */
    for (size_t i = 1; i < loads->count; i++) {
        const double now = part_of(&loads->load[i], part);
        low = now < part_of(&loads->load[low], part) ? i : low;
        high = now > part_of(&loads->load[high], part) ? i : high;
        if (rises >= 0 && part_of(&loads->load[high], part) - now > threshold) {
            kept[high] = true;
            rises = -1;
            low = i;
        } else if (rises <= 0 && now - part_of(&loads->load[low], part) > threshold) {
            kept[low] = true;
            rises = 1;
            high = i;
        }
    }
    kept[rises > 0 ? high : low] = true; /* where it goes last */
}

/* How much a part turns at most between two loads that are kept: against the way from one to the
 * other, where it has one. */
static double turn_between(const load_history *loads, int part, size_t from, size_t to)
{
    const double first = part_of(&loads->load[from], part),
                 way = part_of(&loads->load[to], part) < first ? -1 : 1;
    double reached = way * first, turn = 0;
    for (size_t i = from + 1; i <= to; i++) {
        const double now = way * part_of(&loads->load[i], part);
        reached = fmax(reached, now);
        turn = fmax(turn, reached - now);
    }
    return turn;
}

/* The largest turn that is left out, over the size of its part. */
static double left_out(const load_history *loads, const double size[PARTS], const bool kept[],
                       int *of)
{
    double most = 0;
    for (int part = 0; part < PARTS; part++) {
        size_t from = 0;
        for (size_t i = 1; i < loads->count && size[part] > 0; i++) {
            if (!kept[i])
                continue;
            const double turn = turn_between(loads, part, from, i) / size[part];
            *of = turn > most ? part : *of;
            most = fmax(most, turn);
            from = i;
        }
    }
    return most;
}

static void keep_marked(const bool kept[], load_history *loads)
{
    csv_row *row = memory_zeroed(loads->count, sizeof *row);
    size_t count = 0;
    own_loads(loads);
    for (size_t i = 0; i < loads->count; i++)
        if (kept[i]) {
            loads->load[count] = loads->load[i];
            row[count++] = loads->row[i];
        }
    loads->row = row;
    loads->count = count;
}

static void keep_turning_points(double tolerance, load_history *loads)
{
    const size_t all = loads->count;
    bool *kept = memory_zeroed(all, sizeof *kept);
    double size[PARTS];
    int of = 0;
    kept[0] = kept[all - 1] = true;
    for (int part = 0; part < PARTS; part++) {
        size[part] = size_of(loads, part);
        if (size[part] > 0)
            mark_turns(loads, part, tolerance * size[part], kept);
    }
    const double turn = left_out(loads, size, kept, &of);
    keep_marked(kept, loads);
    if (turn > 0)
        notice("--turning-points: %zu of %zu rows are left; what is left out turns by %.3g of "
               "%s at most",
               loads->count, all, turn, part_words[of]);
    else
        notice("--turning-points: %zu of %zu rows are left; nothing turns in between", loads->count,
               all);
    free(kept);
}

/* ---- Both ---- */

void loads_filter(const arguments *line, double f, load_history *loads)
{
    const char *text = line->value[OPTION_TURNING_POINTS];
    double tolerance = 0;
    if (text != NULL && !(number_read(text, &tolerance) && tolerance > 0 && tolerance < 1))
        usage_error("--turning-points %s: must be a number between 0 and 1, of the range", text);
    if (line->value[OPTION_CLIP] != NULL)
        clip_all(f, loads);
    if (text != NULL)
        keep_turning_points(tolerance, loads);
}
