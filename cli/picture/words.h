/* SPDX-License-Identifier: GPL-3.0-or-later */
/* How much room a text of a drawing takes. The unit is em, the size of the font. Fonts differ: this
 * is DejaVu Sans, one of the wide ones. */
#ifndef CLI_WORDS_H
#define CLI_WORDS_H

/* The width of a text of one line. */
double words_width(const char *text);

/* Ends lines after a comma or a semicolon, so that none is wider where that can be. Returns
 * how many lines there are. */
int words_wrap(char *text, double width);

#endif
