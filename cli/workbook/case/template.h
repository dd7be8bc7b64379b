/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Formulas as they are written in the table of cells, with calls of templates. */
#ifndef CLI_TEMPLATE_H
#define CLI_TEMPLATE_H

#include <stddef.h>

enum { FORMULA_SIZE = 5000 };

/* The length of the name, function or number that a text begins with; 0 for another character. */
size_t word_length(const char *text);

/* The formula with "=" in front, and what each call stands for. */
const char *template_expand(const char *formula, char text[FORMULA_SIZE]);

#endif
