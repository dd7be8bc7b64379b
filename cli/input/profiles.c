/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "input.h"

#include <inttypes.h>
#include <stdlib.h>
#include <string.h>

typedef struct {
    char *name;
    pad_profile places;
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

static void take(const pairs *rows, bool takes_hull, entry *to)
{
    static const char hull[] = "; --hull takes it";
    profile_remark remark;
    const bool taken =
        strcmp(rows->column, "height") == 0
            ? pad_profile_of_heights(rows->count, rows->first, rows->second, takes_hull,
                                     &to->places, &remark)
            : pad_profile_of_slopes(rows->count, rows->first, rows->second, &to->places, &remark);
    complaint text = {""};
    if (remark.text[0] != '\0')
        complain(&text, "%.200s: line %" PRId64 ": %s%s", to->name, rows->line[remark.place],
                 remark.text, !taken && strstr(remark.text, "hull") != NULL ? hull : "");
    strcpy(taken ? to->remark : to->problem.text, text.text);
    if (rows->unused.text[0] != '\0')
        list_add(to->remark, sizeof to->remark, "; ", "%.200s: %s", to->name, rows->unused.text);
}

const char *profiles_read(const char *name, char decimal_sign, bool takes_hull, bool takes_unnamed)
{
    static const char *const usual[] = {"x", "height"};
    const pair_columns wanted = {.first = "x",
                                 .second = "slope",
                                 .instead = "height",
                                 .usual = takes_unnamed ? usual : NULL,
                                 .needed = "x, and slope or height",
                                 .rows = "places",
                                 .most = PROFILE_PLACES + 1};
    pairs rows;
    if (entry_named(name) != NULL)
        return "";
    entry *to = memory_zeroed(1, sizeof *to);
    to->name = memory_zeroed(strlen(name) + 1, 1);
    strcpy(to->name, name);
    entries = memory_for_one_more(entries, entry_count, sizeof *entries);
    entries[entry_count++] = to;
    pairs_read(name, NULL, decimal_sign, &wanted, &rows);
    if (rows.problem.text[0] == '\0')
        take(&rows, takes_hull, to);
    else
        to->problem = rows.problem;
    pairs_free(&rows);
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
        free(last);
    }
}
