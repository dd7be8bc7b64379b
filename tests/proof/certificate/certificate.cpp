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
        entries += g.entries.size();
        squares += g.squares;
        for (const entry &e : g.entries) {
            are[e.is]++;
            if (e.is == PROVED) {
                rounded += is_rounded(e);
                distance = fmax(distance, distance_of(e));
            }
        }
    }
};

static void print_group(const group &g)
{
    summary s;
    s.add(g);
    printf("a/b = %-5s %4zu of %4zu proved, %4zu to the tenth digit; %7zu squares\n",
           g.entries[0].a_over_b.c_str(), s.are[PROVED], s.entries, s.rounded, s.squares);
    for (const entry &e : g.entries)
        if (e.is != PROVED)
            print_unproved(e);
}

static int report(const groups &all)
{
    summary total;
    for (const auto &[alpha, g] : all) {
        print_group(g);
        total.add(g);
    }
    printf("%zu entries of %zu a/b, %zu squares: %zu proved, %zu exceeded, %zu not reached, %zu "
           "misnamed, %zu open\n",
           total.entries, all.size(), total.squares, total.are[PROVED], total.are[EXCEEDED],
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

    groups all;
    for (; i < argc; i++)
        if (!read_entries(&all, argv[i], list))
            return 2;
    std::vector<group *> parts;
    for (auto &[alpha, g] : all)
        parts.push_back(&g);
    in_parallel(parts.size(), [&](size_t part) { search(parts[part], tolerance); });
    return all.empty() ? 2 : report(all);
}
