/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Cells with a formula. */
#ifndef CLI_FORMULA_H
#define CLI_FORMULA_H

#include "sheet/xlsx.h"
#include "text/printf_like.h"

/* A formula or a text put together. */
const char *compose(char text[], const char *format, ...) PRINTF_LIKE(2, 3);
enum { FORMULA_SIZE = 1200 };

/* A formula and its value, to ten digits; an empty text where there is no such number. */
void formula_cell(xlsx *book, int row, int column, const char *formula, double value,
                  xlsx_style style);

#endif
