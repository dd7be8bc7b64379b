/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A drawing in the language of gnuplot 5. */
#ifndef CLI_GNUPLOT_SCRIPT_H
#define CLI_GNUPLOT_SCRIPT_H

#include "drawing.h"

#include <stdbool.h>
#include <stdio.h>

typedef struct {
    const char *name; /* of the format, and of the file's extension */
    /* what gnuplot is told, with the picture's height over its width as %g */
    const char *terminal;
    double width;              /* in the terminal's unit */
    double line;               /* the height of a line of text over that */
    const char *begins, *ends; /* how a whole file starts, and what is in its last bytes */
    size_t begins_length, ends_length;
    bool needs_spaces; /* its viewers have to be told to keep them */
} picture_format;

enum { PICTURE_FORMATS = 3 };
extern const picture_format picture_formats[PICTURE_FORMATS];

/* Writes the drawing in gnuplot's language. */
void gnuplot_script(const drawing *plot, const picture_format *format, FILE *script);

#endif
