/* SPDX-License-Identifier: GPL-3.0-or-later */
/* CSV and TSV. */
#ifndef CLI_DELIMITED_H
#define CLI_DELIMITED_H

#include "records.h"

extern const record_format delimited_format;

#endif
