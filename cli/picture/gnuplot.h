/* SPDX-License-Identifier: GPL-3.0-or-later */
/* gnuplot draws the pictures. It is looked for on PATH when one is drawn; nothing else needs it.
 * gnuplot.c runs it, gnuplot_script.c speaks its language, and no other file knows of it. */
#ifndef CLI_GNUPLOT_H
#define CLI_GNUPLOT_H

#include "gnuplot_script.h"

#include "system/output.h"

/* Has gnuplot draw the picture into the output. */
void gnuplot_draw(const drawing *plot, const picture_format *format, output *out);

#endif
