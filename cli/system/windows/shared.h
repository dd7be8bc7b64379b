/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Files as other programs may have them open too, and errors of Windows in C's words. */
#ifndef CLI_SHARED_H
#define CLI_SHARED_H

#include <stdio.h>
#include <windows.h>

/* errno for an error of Windows. */
int errno_of(DWORD error);

/* Opens as CreateFile() does, and lets anyone else read, write and remove the file. Children do not
 * inherit it. It sets
 * errno. */
HANDLE open_shared(const char *path, DWORD access, DWORD disposition, DWORD flags);

/* The file as a stream of bytes. */
FILE *stream_of(HANDLE file, const char *mode);

#endif
