/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A load from the cells of a row. */
#ifndef CLI_LOAD_ROW_H
#define CLI_LOAD_ROW_H

#include "header.h"
#include "model/loads.h"

/* Finds the columns of a load: P and Q, and M and sigma, which may lack. False, with the
 * complaint. */
bool load_header_find(const char *const name[], size_t count, header *names,
                      char complaint[COMPLAINT_SIZE]);

/* Reads a row of so many cells between separators. False, with the complaint, where it is no
 * load. */
bool load_row_read(const header *names, const char *const cell[], size_t count, char separator,
                   char decimal_sign, load *to, char complaint[COMPLAINT_SIZE]);

#endif
