/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What all files of this folder need of Windows: its characters, and its errors in C's words. */
#ifndef CLI_WIDE_H
#define CLI_WIDE_H

#include <stdbool.h>
#include <wchar.h>
#include <windows.h>

/* Free them. NULL with errno: EILSEQ where the text is not whole, ENOMEM. */
wchar_t *wide_of(const char *utf8);
char *utf8_of(const wchar_t *wide);

/* errno for an error of Windows. */
int errno_of(DWORD error);

/* As CreateFile(), for anyone else to read, write and remove the file too. Not inherited. It sets
 * errno. */
HANDLE open_shared(const wchar_t *path, DWORD access, DWORD disposition, DWORD flags);

#endif
