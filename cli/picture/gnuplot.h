/* SPDX-License-Identifier: GPL-3.0-or-later */
/* gnuplot, which draws the figures. It is looked for on PATH when one is drawn; nothing else of
 * the program needs it. Only gnuplot.c, which runs it, and gnuplot_script.c, which speaks its
 * language, know of it. */
#ifndef CLI_GNUPLOT_H
#define CLI_GNUPLOT_H

#include "gnuplot_script.h"

#include "system/output.h"

/* Has gnuplot draw the picture into the output. False, with the reason said and nothing written,
 * where gnuplot is missing or fails. */
bool gnuplot_draw(const drawing *what, const picture_format *format, output *out);

#endif
