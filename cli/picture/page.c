/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "page.h"

#include "words.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

/* The font of the PNG is the largest, against its width; SVG and PDF have more room. */
static const double WIDTH = 29;
static const double EDGE = 0.6;    /* of paper around all */
static const double TIC = 0.8;     /* with the space to its number */
static const double BETWEEN = 1.5; /* entries of a legend */

/* Of the numbers at the tics. */
static double tics_width(const axis *which)
{
    const double lo = fmin(which->from, which->to), hi = fmax(which->from, which->to);
    double widest = 0;
    for (double i = ceil(lo / which->tic - 1e-9); i * which->tic <= hi * (1 + 1e-9); i++) {
        char text[NUMBER_SIZE];
        snprintf(text, sizeof text, "%g", i * which->tic);
        widest = fmax(widest, words_width(text));
    }
    return widest;
}

/* The text of an axis stands upright beside the numbers. */
static double side_width(const axis *which)
{
    return EDGE + PAGE_LINE + tics_width(which) + TIC;
}

/* A text at the middle of the plot has so much room. */
static double room_at_middle(const page *on)
{
    const double middle = 0.5 * (on->left + on->right);
    return 2 * fmin(middle, on->width - middle) - 2 * EDGE;
}

static int set_legend(const drawing *plot, page *on)
{
    double widest = 0;
    int entries = 0;
    for (int i = 0; i < plot->curve_count; i++)
        if (plot->curve[i].legend[0] != '\0') {
            widest = fmax(widest, words_width(plot->curve[i].legend));
            entries++;
        }
    if (entries == 0)
        return 0;
    on->legend_step = PAGE_SAMPLE + PAGE_GAP + widest + BETWEEN;
    const int fit = (int)((on->width - 2 * EDGE + BETWEEN) / on->legend_step);
    on->legend_columns = fit < 1 ? 1 : fit > entries ? entries : fit;
    const int lines = (entries + on->legend_columns - 1) / on->legend_columns;
    on->legend_columns = (entries + lines - 1) / lines; /* lines of about the same length */
    return lines;
}

page page_of(const drawing *plot)
{
    page on = {.width = WIDTH};
    on.left = side_width(&plot->y);
    on.right = on.width - (plot->second.text[0] != '\0' ? side_width(&plot->second) : 2 * EDGE);
    memcpy(on.title, plot->title, sizeof on.title);
    memcpy(on.caption, plot->caption, sizeof on.caption);
    const double room = room_at_middle(&on);
    const int title = on.title[0] != '\0' ? words_wrap(on.title, room) : 0;
    const int caption = on.caption[0] != '\0' ? words_wrap(on.caption, room) : 0;
    const double across = on.right - on.left;
    const double up =
        plot->height > 0 ? plot->height * across
                         : across * fabs((plot->y.to - plot->y.from) / (plot->x.to - plot->x.from));
    /* below: the numbers, the text of the axis, caption, legend */
    on.bottom = EDGE + TIC + PAGE_LINE * (2 + caption + set_legend(plot, &on));
    on.top = on.bottom + up;
    on.height = on.top + EDGE + (title > 0 ? 0.5 + PAGE_LINE * title : 0);
    return on;
}

double page_legend_x(const page *on, int i)
{
    const double all = on->legend_columns * on->legend_step - BETWEEN;
    return 0.5 * (on->width - all) + (i % on->legend_columns) * on->legend_step + PAGE_SAMPLE +
           PAGE_GAP;
}

double page_legend_y(const page *on, int i, int entries)
{
    const int last = (entries - 1) / on->legend_columns;
    return EDGE + PAGE_LINE * (last - i / on->legend_columns + 0.5);
}
