/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "streams.h"

#include <fcntl.h>
#include <unistd.h>

bool streams_fill_closed(void)
{
    for (int stream = STDIN_FILENO; stream <= STDERR_FILENO; stream++)
        if (fcntl(stream, F_GETFD) < 0 &&
            open("/dev/null", stream == STDERR_FILENO ? O_WRONLY : O_RDONLY) != stream)
            return false;
    return true;
}

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

FILE *stream_with_name(char name[STREAM_NAME_SIZE])
{
    FILE *stream = stream_temporary();
    if (stream != NULL)
        snprintf(name, STREAM_NAME_SIZE, "/dev/fd/%d", fileno(stream));
    return stream;
}
