/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "system/system.h"

#include <fcntl.h>
#include <unistd.h>

bool stream_is_terminal(FILE *stream)
{
    return isatty(fileno(stream)) == 1;
}

FILE *stream_temporary(void)
{
    FILE *stream = tmpfile();
    if (stream != NULL)
        fcntl(fileno(stream), F_SETFD, FD_CLOEXEC);
    return stream;
}

/* It has no name in a folder: nothing is left of it, however the program ends. */
bool spool_begin(spool *file)
{
    file->stream = stream_temporary();
    if (file->stream == NULL)
        return false;
    snprintf(file->name, sizeof file->name, "/dev/fd/%d", fileno(file->stream));
    return true;
}

FILE *spool_read(spool *file)
{
    rewind(file->stream);
    return file->stream;
}

void spool_end(spool *file)
{
    if (file->stream != NULL)
        fclose(file->stream);
}
