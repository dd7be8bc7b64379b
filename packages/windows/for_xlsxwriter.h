/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Read before libxlsxwriter's sources: their files are opened by cli/system/windows/streams.c. */
#include <stdio.h>

FILE *stream_temporary(void);
FILE *stream_by_name(const char *name, const char *mode);

#undef fopen64
#define tmpfile stream_temporary
#define fopen64 stream_by_name
