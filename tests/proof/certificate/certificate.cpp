/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Proves the entries of elastic-limit tables, one by one, in ball arithmetic:
 *
 *     certificate [--a-over-b A,B,...] [--tolerance T] TABLE.csv ...
 *
 * An entry is proved if the limit lies within T (1e-9) of what is stated. To show this, the limit
 * is enclosed: it is at most what the stated place gives, and at least GAP below that. The
 * program prints a line per a/b, each entry that is not proved, and a summary. The exit status is
 * 0 if all are proved, 1 if not, 2 for an error in the command or a table. */
#include "balls/parallel.hpp"
#include "search.hpp"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* The entries of one a/b. */
struct group {
    entry *first;
    size_t count, squares;
};

static void print_unproved(const entry &e)
{
    printf("  %s:%zu: ", e.file, e.line);
    switch (e.is) {
    case EXCEEDED:
        printf("exceeded at x/b = %.17g, y/b = %.17g\n", e.beyond_x, e.beyond_y);
        break;
    case NOT_REACHED:
        printf("not reached: the stated place alone gives a limit of %.17g\n", lower_bound(e.most));
        break;
    case MISNAMED:
        printf("misnamed: the place is not on the stated branch\n");
        break;
    default:
        printf("open: neither proved nor refuted\n");
        break;
    }
}

struct summary {
    size_t entries = 0, squares = 0, rounded = 0, are[VERDICTS] = {};
    double distance = 0;

    void add(const group &g)
    {
        entries += g.count;
        squares += g.squares;
        for (const entry *e = g.first; e < g.first + g.count; e++) {
            are[e->is]++;
            if (e->is == PROVED) {
                rounded += is_rounded(*e);
                distance = fmax(distance, distance_of(*e));
            }
        }
    }
};

static void print_group(const group &g)
{
    summary s;
    s.add(g);
    printf("a/b = %-5s %4zu of %4zu proved, %4zu to the tenth digit; %7zu squares\n",
           g.first->a_over_b.c_str(), s.are[PROVED], s.entries, s.rounded, s.squares);
    for (const entry *e = g.first; e < g.first + g.count; e++)
        if (e->is != PROVED)
            print_unproved(*e);
}

/* Is the a/b in the comma list? NULL lists all. */
static bool is_wanted(const std::string &a_over_b, const char *list)
{
    return !list || ("," + std::string(list) + ",").find("," + a_over_b + ",") != std::string::npos;
}

static std::vector<group> groups_of(std::vector<entry> *entries, const char *list)
{
    std::vector<group> groups;
    entry *const end = entries->data() + entries->size();
    for (entry *first = entries->data(), *next; first < end; first = next) {
        for (next = first + 1; next < end && next->a_over_b == first->a_over_b; next++)
            ;
        if (is_wanted(first->a_over_b, list))
            groups.push_back({first, (size_t)(next - first), 0});
    }
    return groups;
}

static int report(const std::vector<group> &groups)
{
    summary total;
    for (const group &g : groups) {
        print_group(g);
        total.add(g);
    }
    printf("%zu entries of %zu a/b, %zu squares: %zu proved, %zu exceeded, %zu not reached, %zu "
           "misnamed, %zu open\n",
           total.entries, groups.size(), total.squares, total.are[PROVED], total.are[EXCEEDED],
           total.are[NOT_REACHED], total.are[MISNAMED], total.are[OPEN]);
    printf("of those proved, the limit is enclosed to %.0e and within %.2e of what is stated; %zu "
           "are proved to be rounded\n",
           GAP, total.distance, total.rounded);
    return total.entries > 0 && total.are[PROVED] == total.entries ? EXIT_SUCCESS : EXIT_FAILURE;
}

static int usage()
{
    fputs("usage: certificate [--a-over-b A,B,...] [--tolerance T] TABLE.csv ...\n", stderr);
    return 2;
}

int main(int argc, char **argv)
{
    const char *list = NULL;
    double tolerance = 1e-9;
    int i = 1;
    for (; i + 1 < argc && strncmp(argv[i], "--", 2) == 0; i += 2) {
        if (strcmp(argv[i], "--a-over-b") == 0)
            list = argv[i + 1];
        else if (strcmp(argv[i], "--tolerance") == 0)
            tolerance = strtod(argv[i + 1], NULL);
        else
            return usage();
    }
    if (i >= argc || !(tolerance > 0))
        return usage();

    std::vector<entry> entries;
    for (; i < argc; i++)
        if (!read_entries(&entries, argv[i]))
            return 2;
    if (entries.empty())
        return 2;
    sort_entries(&entries);
    std::vector<group> groups = groups_of(&entries, list);
    in_parallel(groups.size(), [&](size_t g) {
        groups[g].squares = search(groups[g].first, groups[g].count, tolerance);
    });
    return report(groups);
}
