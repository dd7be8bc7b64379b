/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The fuzzer's bytes as a file without a name on a disk. */
#ifndef FILE_H
#define FILE_H

#include <stddef.h>

/* The path of a file with these bytes; it is the same file each time. */
const char *file_of(const void *data, size_t size);

#endif
