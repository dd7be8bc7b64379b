/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Read before libxlsxwriter's sources: its temporary files are those of
 * cli/system/windows/windows_files.c. */
#include <stdio.h>

FILE *stream_temporary(void);

#define tmpfile stream_temporary
