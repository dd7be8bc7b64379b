/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "input.h"

#include <inttypes.h>
#include <stdlib.h>
#include <string.h>

typedef struct {
    char *name;
    pad_profile places;
    pairs kept;
    bool is_offered;   /* and not yet read */
    complaint problem; /* why it is none; "" */
    char remark[900];
} entry;

/* All that have been read. */
static entry **entries;
static size_t entry_count;

static entry *entry_named(const char *name)
{
    for (size_t i = 0; i < entry_count; i++)
        if (strcmp(entries[i]->name, name) == 0)
            return entries[i];
    return NULL;
}

static void take(pairs *rows, const profile_making *how, entry *to)
{
    profile_remark remark;
    scan all = {rows->count, rows->first, rows->second, rows->line};
    const bool are_heights = strcmp(rows->column, "height") == 0;
    const size_t means = scan_settle(&all, are_heights);
    const bool taken = (are_heights ? pad_profile_of_heights
                                    : pad_profile_of_slopes)(&all, how, &to->places, &remark);
    complaint text = {""};
    if (remark.text[0] != '\0' && remark.line > 0)
        complain(&text, "%.200s: line %" PRId64 ": %s", to->name, remark.line, remark.text);
    else if (remark.text[0] != '\0')
        complain(&text, "%.200s: %s", to->name, remark.text);
    strcpy(taken ? to->remark : to->problem.text, text.text);
    if (means > 0)
        list_add(to->remark, sizeof to->remark, "; ",
                 "%.200s: %zu place%s more than once: their heights are averaged", to->name, means,
                 means > 1 ? "s are there" : " is there");
    if (rows->remark.text[0] != '\0')
        list_add(to->remark, sizeof to->remark, "; ", "%.200s: %s", to->name, rows->remark.text);
}

static const char *const *usual_names(size_t count)
{
    static const char *const names[] = {"x", "height"};
    return count == 2 ? names : NULL;
}

static entry *add(const char *name)
{
    entry *to = memory_zeroed(1, sizeof *to);
    to->name = memory_zeroed(strlen(name) + 1, 1);
    strcpy(to->name, name);
    entries = memory_for_one_more(entries, entry_count, sizeof *entries);
    entries[entry_count++] = to;
    return to;
}

static double *copy_of(size_t count, const double number[])
{
    double *copy = memory_zeroed(count + 1, sizeof *copy);
    memcpy(copy, number, count * sizeof *copy);
    return copy;
}

static pairs pairs_copy(const pairs *from)
{
    return (pairs){.count = from->count,
                   .first = copy_of(from->count, from->first),
                   .second = copy_of(from->count, from->second),
                   .column = from->column};
}

void profiles_offer(const char *name, pairs places)
{
    entry *to = add(name);
    to->kept = places;
    to->is_offered = true;
}

const pairs *profiles_places(const char *name)
{
    const entry *known = entry_named(name);
    return known != NULL && known->kept.count > 0 ? &known->kept : NULL;
}

/* Makes the profile of the places, unless there is a problem with them. */
static void settle(pairs *rows, const profile_making *how, entry *to)
{
    if (rows->problem.text[0] == '\0')
        take(rows, how, to);
    else
        to->problem = rows->problem;
    pairs_free(rows);
}

const char *profiles_read(const char *name, const reading *how, const profile_making *making)
{
    enum { MOST = 1000000 };
    const pair_columns wanted = {.first = "x",
                                 .second = "slope",
                                 .instead = "height",
                                 .dimension = "slope",
                                 .other = "length",
                                 .usual = making->takes_unnamed ? usual_names : NULL,
                                 .needed = "x, and slope or height",
                                 .rows = "places",
                                 .most = MOST};
    pairs rows;
    entry *to = entry_named(name);
    if (to != NULL && !to->is_offered)
        return "";
    if (to == NULL) {
        to = add(name);
        pairs_read(name, how, &wanted, &rows);
        if (making->keeps_places)
            to->kept = pairs_copy(&rows);
    } else {
        rows = pairs_copy(&to->kept);
        rows.line = memory_zeroed(rows.count + 1, sizeof *rows.line);
        to->is_offered = false;
    }
    settle(&rows, making, to);
    return to->remark;
}

const pad_profile *profiles_named(const char *name, complaint *why)
{
    const entry *known = entry_named(name);
    if (known != NULL && known->problem.text[0] == '\0')
        return &known->places;
    if (known == NULL)
        return complain(why, "profile %.380s: a cell may name a regular file alone", name), NULL;
    complain(why, "profile %.380s", known->problem.text);
    return NULL;
}

size_t profiles_count(void)
{
    return entry_count;
}

void profiles_forget(size_t count)
{
    while (entry_count > count) {
        entry *last = entries[--entry_count];
        free(last->name);
        pad_profile_free(&last->places);
        pairs_free(&last->kept);
        free(last);
    }
}
