/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "parts.h"

#include <errno.h>

void xlsx_keep(xlsx *book, lxw_error error)
{
    if (error == LXW_NO_ERROR &&
        (errno == ENOMEM || errno == ENOSPC || errno == EIO || errno == EINTR || errno == EFBIG))
        error = errno == ENOMEM ? LXW_ERROR_MEMORY_MALLOC_FAILED : LXW_ERROR_CREATING_TMPFILE;
    if (book->error == LXW_NO_ERROR)
        book->error = error;
}
