/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Rows that were pasted, read as the tool reads a file. */
#ifndef PAGE_PASTED_H
#define PAGE_PASTED_H

#include "input/input.h"

/* Cells stand between tabs as a spreadsheet gives them, or between ; or , as a file has them. The
 * text must outlive the input. */
csv_input *pasted_open(const char *text);

/* What a file that is opened next has in it, whatever its name. */
void pasted_offer(const char *text);

/* The next row, kept: with its fault in place of cells where its quotes are misplaced. False at the
 * end; problem says why where that is before the text's. */
bool pasted_next(csv_input *in, csv_row *row, const char **problem);

#endif
