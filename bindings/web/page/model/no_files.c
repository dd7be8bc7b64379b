/* SPDX-License-Identifier: GPL-3.0-or-later */
/* snprintf() shares code with what writes files, and so asks for the system's calls. There is no
 * system: each of them fails. Nothing calls them. */
#include <stdint.h>

enum { BAD_FILE = 8 };

uint16_t __wasi_fd_close(int file);
uint16_t __wasi_fd_seek(int file, int64_t offset, uint8_t whence, int64_t *place);
uint16_t __wasi_fd_write(int file, const void *parts, uint32_t count, uint32_t *written);

uint16_t __wasi_fd_close(int file)
{
    (void)file;
    return BAD_FILE;
}

uint16_t __wasi_fd_seek(int file, int64_t offset, uint8_t whence, int64_t *place)
{
    (void)file, (void)offset, (void)whence, (void)place;
    return BAD_FILE;
}

uint16_t __wasi_fd_write(int file, const void *parts, uint32_t count, uint32_t *written)
{
    (void)file, (void)parts, (void)count, (void)written;
    return BAD_FILE;
}
