/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Cells with a formula. */
#ifndef CLI_FORMULA_H
#define CLI_FORMULA_H

#include "sheet/xlsx.h"

/* A formula or a text put together. */
#ifdef __GNUC__
__attribute__((format(printf, 2, 3)))
#endif
const char *
compose(char text[], const char *format, ...);
enum { FORMULA_SIZE = 1200 };

/* A formula and its value, to ten digits; an empty text where there is no such number. */
void formula_cell(xlsx *book, int row, int column, const char *formula, double value,
                  xlsx_style style);

#endif
