/* SPDX-License-Identifier: GPL-3.0-or-later */
/* gnuplot, which draws the figures. It is looked for on PATH when one is drawn; nothing else of
 * the program needs it. Only gnuplot.c, which runs it, and gnuplot_script.c, which speaks its
 * language, know of it. */
#ifndef CLI_GNUPLOT_H
#define CLI_GNUPLOT_H

#include "gnuplot_script.h"

/* Has gnuplot draw: the picture's bytes. False, with the reason said, where it is missing or
 * fails. */
bool gnuplot_draw(const drawing *what, const picture_format *format, bytes *picture);

#endif
