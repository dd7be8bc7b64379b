/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "history.h"

#include <math.h>
#include <string.h>

struct poptOption place_option_table[] = {
    {VALUE("at", OPTION_AT), "At these points, y the depth", "x,y;x,y"},
    {VALUE("points", OPTION_POINTS), "At the points of a CSV file with the columns x and y",
     "FILE"},
    {VALUE("x", OPTION_X), "Or on a grid, with these x", "RANGE"},
    {VALUE("depth", OPTION_DEPTH), "And these depths below the surface (default 0)", "RANGE"},
    OTHER_NAME("y", OPTION_DEPTH),
    POPT_TABLEEND,
};

enum { PLACES_MAX = 1000000 };

static void add(places *to, double x, double y)
{
    to->x = memory_for_one_more(to->x, to->count, sizeof *to->x);
    to->y = memory_for_one_more(to->y, to->count, sizeof *to->y);
    to->x[to->count] = x;
    to->y[to->count++] = y;
}

/* NULL, or what is wrong with such a point. */
static const char *complaint_about(double x, double y)
{
    if (y < 0)
        return "y is a depth, and must not be below 0";
    if (fmax(fabs(x), y) > 1e60)
        return "must be at most 1e60 in magnitude";
    return NULL;
}

/* ---- --at ---- */

static void read_at(const char *text, places *to)
{
    const char *pair = text;
    bool said = false;
    for (bool last = false; !last;) {
        double at[2];
        pair += strspn(pair, " ");
        const size_t length = strcspn(pair, ";");
        if (number_read_list(pair, length, ',', 2, at) != 2)
            usage_error("--at %s: must be points x,y separated by semicolons", text);
        if (complaint_about(at[0], at[1]) != NULL)
            usage_error("--at %s: %s", text, complaint_about(at[0], at[1]));
        add(to, at[0], at[1]);
        said = said || (at[1] > 0 && range_say_pair("at", text, pair, length));
        last = pair[length] == '\0';
        pair += length + 1;
    }
}

/* ---- --points ---- */

static void read_file(const arguments *line, char decimal_sign, places *to)
{
    const char *path = line->value[OPTION_POINTS];
    const reading how = reading_of(line, decimal_sign);
    static const pair_columns wanted = {.first = "x",
                                        .second = "y",
                                        .dimension = "length",
                                        .needed = "x and y, the depth",
                                        .rows = "points",
                                        .most = PLACES_MAX,
                                        .complaint_about = complaint_about};
    pairs all;
    pairs_read(path, &how, &wanted, &all);
    if (all.problem.text[0] != '\0')
        failure("%s", all.problem.text);
    if (all.remark.text[0] != '\0')
        notice("%s: %s", path, all.remark.text);
    *to = (places){.x = all.first, .y = all.second, .count = all.count};
}

/* ---- --x and --depth ---- */

void places_read_depth(const arguments *line, range *depth)
{
    const char *text = line->value[OPTION_DEPTH];
    double outside;
    range_option("depth", text != NULL ? text : "0", depth);
    if (!range_within(depth, 0, 1e60, &outside))
        usage_error("--depth %s: depths must not be below 0", text);
}

static void read_grid(const arguments *line, places *to)
{
    const char *text = line->value[OPTION_X];
    range x, y;
    places_read_depth(line, &y);
    range_option("x", text, &x);
    if ((double)x.count * (double)y.count > PLACES_MAX)
        usage_error("--x %s: must not give more than %d points in all", text, PLACES_MAX);
    for (int64_t j = 0; j < y.count; j++)
        for (int64_t i = 0; i < x.count; i++)
            add(to, range_value(&x, i), range_value(&y, j));
    to->columns = (size_t)x.count;
}

/* ---- All ---- */

void places_read(const arguments *line, char decimal_sign, places *to)
{
    const char *at = line->value[OPTION_AT], *points = line->value[OPTION_POINTS];
    const char *x = line->value[OPTION_X], *depth = line->value[OPTION_DEPTH];
    *to = (places){0};
    if ((at != NULL) + (points != NULL) + (x != NULL || depth != NULL) > 1)
        usage_error("--%s %s: given together with --%s; allowed: one of the two",
                    at != NULL ? "at" : "points", at != NULL ? at : points,
                    at != NULL && points != NULL ? "points"
                    : x != NULL                  ? "x"
                                                 : "depth");
    if (at != NULL)
        read_at(at, to);
    else if (points != NULL)
        read_file(line, decimal_sign, to);
    else if (x != NULL)
        read_grid(line, to);
}
