/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Proves the entries of elastic-limit tables, one by one, in ball arithmetic:
 *
 *     certificate [--jobs N] [--a-over-b A,B,...] [--tolerance T] [--gap D] TABLE.csv ...
 *
 * An entry is proved if the limit lies within T (1e-9) of what is stated. To show this, the limit
 * is enclosed: it is at most what the stated place gives, and at least D (1e-13) below that. The
 * program prints a line per a/b, each entry that is not proved, and a summary. The exit status is
 * 0 if all are proved, 1 if not, 2 for an error in the command or a table. */
#include "search.h"

#include <math.h>
#include <pthread.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* The entries of one a/b. */
typedef struct {
    entry *first;
    size_t count, squares;
} group;

typedef struct {
    group *groups;
    size_t count, next;
    precision wanted;
    pthread_mutex_t lock;
} work;

static void *judge_groups(void *context)
{
    work *w = context;
    for (;;) {
        pthread_mutex_lock(&w->lock);
        group *g = w->next < w->count ? &w->groups[w->next++] : NULL;
        pthread_mutex_unlock(&w->lock);
        if (!g)
            break;
        g->squares = search(g->first, g->count, w->wanted);
    }
    flint_cleanup();
    return NULL;
}

enum { MOST_JOBS = 64 };

static bool judge(work *w, long jobs)
{
    pthread_t thread[MOST_JOBS];
    long started = 0;
    pthread_mutex_init(&w->lock, NULL);
    while (started < jobs && pthread_create(&thread[started], NULL, judge_groups, w) == 0)
        started++;
    for (long i = 0; i < started; i++)
        pthread_join(thread[i], NULL);
    pthread_mutex_destroy(&w->lock);
    return started > 0;
}

static void print_unproved(const entry *e)
{
    printf("  %s:%zu: ", e->file, e->line);
    switch (e->is) {
    case EXCEEDED:
        printf("exceeded at x/b = %.17g, y/b = %.17g\n", e->beyond_x, e->beyond_y);
        break;
    case NOT_REACHED:
        printf("not reached: the stated place alone gives a limit of %.17g\n",
               entry_limit_there(e));
        break;
    case MISNAMED:
        printf("misnamed: the place is not on the stated branch\n");
        break;
    default:
        printf("open: neither proved nor refuted\n");
        break;
    }
}

typedef struct {
    size_t entries, squares, rounded, are[VERDICTS];
    double distance;
} summary;

static summary summary_of(const group *g)
{
    summary s = {.entries = g->count, .squares = g->squares};
    for (size_t i = 0; i < g->count; i++) {
        const entry *e = &g->first[i];
        s.are[e->is]++;
        if (e->is == PROVED) {
            s.rounded += entry_is_rounded(e);
            s.distance = fmax(s.distance, entry_distance(e));
        }
    }
    return s;
}

static void add(summary *total, const summary *s)
{
    total->entries += s->entries;
    total->squares += s->squares;
    total->rounded += s->rounded;
    total->distance = fmax(total->distance, s->distance);
    for (int i = 0; i < VERDICTS; i++)
        total->are[i] += s->are[i];
}

static void print_group(const group *g, const summary *s)
{
    printf("a/b = %-5s %4zu of %4zu proved, %4zu to the tenth digit; %7zu squares\n",
           g->first->a_over_b, s->are[PROVED], s->entries, s->rounded, s->squares);
    for (size_t i = 0; i < g->count; i++)
        if (g->first[i].is != PROVED)
            print_unproved(&g->first[i]);
}

/* Is the entry's a/b in the comma list? NULL lists all. */
static bool is_wanted(const entry *e, const char *list)
{
    const size_t length = strlen(e->a_over_b);
    for (const char *item = list; item; item = strchr(item, ',') ? strchr(item, ',') + 1 : NULL)
        if (strncmp(item, e->a_over_b, length) == 0 &&
            (item[length] == ',' || item[length] == '\0'))
            return true;
    return list == NULL;
}

static size_t make_groups(group *groups, entry *entries, size_t count, const char *list)
{
    size_t made = 0;
    for (size_t i = 0, n; i < count; i += n) {
        for (n = 1; i + n < count && strcmp(entries[i + n].a_over_b, entries[i].a_over_b) == 0; n++)
            ;
        if (is_wanted(&entries[i], list))
            groups[made++] = (group){.first = &entries[i], .count = n};
    }
    return made;
}

static int report(const work *w)
{
    summary total = {0};
    for (size_t i = 0; i < w->count; i++) {
        const summary s = summary_of(&w->groups[i]);
        print_group(&w->groups[i], &s);
        add(&total, &s);
    }
    printf("%zu entries of %zu a/b, %zu squares: %zu proved, %zu exceeded, %zu not reached, %zu "
           "misnamed, %zu open\n",
           total.entries, w->count, total.squares, total.are[PROVED], total.are[EXCEEDED],
           total.are[NOT_REACHED], total.are[MISNAMED], total.are[OPEN]);
    printf("of those proved, the limit is enclosed to %.0e and within %.2e of what is stated; %zu "
           "are proved to be rounded\n",
           w->wanted.gap, total.distance, total.rounded);
    return total.entries > 0 && total.are[PROVED] == total.entries ? EXIT_SUCCESS : EXIT_FAILURE;
}

static int usage(void)
{
    fputs("usage: certificate [--jobs N] [--a-over-b A,B,...] [--tolerance T] [--gap D] TABLE.csv "
          "...\n",
          stderr);
    return 2;
}

int main(int argc, char **argv)
{
    long jobs = 1;
    const char *list = NULL;
    work w = {.wanted = {.tolerance = 1e-9, .gap = 1e-13}};
    int i = 1;
    for (; i + 1 < argc && strncmp(argv[i], "--", 2) == 0; i += 2) {
        if (strcmp(argv[i], "--jobs") == 0)
            jobs = strtol(argv[i + 1], NULL, 10);
        else if (strcmp(argv[i], "--a-over-b") == 0)
            list = argv[i + 1];
        else if (strcmp(argv[i], "--tolerance") == 0)
            w.wanted.tolerance = strtod(argv[i + 1], NULL);
        else if (strcmp(argv[i], "--gap") == 0)
            w.wanted.gap = strtod(argv[i + 1], NULL);
        else
            return usage();
    }
    if (i >= argc || jobs < 1 || jobs > MOST_JOBS || !(w.wanted.tolerance > 0 && w.wanted.gap > 0))
        return usage();

    entry *entries = NULL;
    size_t count = 0;
    bool good = true;
    for (; i < argc && good; i++)
        good = entries_read(&entries, &count, argv[i]);
    int status = 2;
    if (good && count > 0) {
        entries_sort(entries, count);
        w.groups = malloc(count * sizeof *w.groups);
        if (!w.groups)
            abort();
        w.count = make_groups(w.groups, entries, count, list);
        if (judge(&w, jobs))
            status = report(&w);
        free(w.groups);
    }
    entries_free(entries, count);
    flint_cleanup();
    return status;
}
