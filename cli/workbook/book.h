/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The workbook as a file. */
#ifndef CLI_BOOK_H
#define CLI_BOOK_H

#include "system/output.h"

void book_write(output *out);

#endif
