/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Formulas as they are written in the table of cells, with calls of templates. */
#ifndef CLI_TEMPLATE_H
#define CLI_TEMPLATE_H

#include <stddef.h>

enum { FORMULA_SIZE = 5000 };

/* What a name, function or number becomes: writes it, and returns its end. */
typedef char *word_writer(char *end, const char *word, size_t length, const void *about);
word_writer word_copy; /* as it is */

/* The formula with "=" in front, and what each call stands for. */
const char *template_expand(const char *formula, word_writer *write, const void *about);

/* A copy that stays. */
const char *text_copy(const char *text);

#endif
