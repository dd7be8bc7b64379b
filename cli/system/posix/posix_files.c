/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "system/system.h"

#include <errno.h>
#include <fcntl.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

file_kind file_kind_of(const char *path)
{
    struct stat file;
    if (stat(path, &file) != 0)
        return errno == ENOENT ? FILE_ABSENT : FILE_NOT_KNOWN;
    return S_ISREG(file.st_mode) ? FILE_REGULAR : S_ISDIR(file.st_mode) ? FILE_FOLDER : FILE_OTHER;
}

static FILE *stream_of(int descriptor, const char *mode)
{
    return descriptor >= 0 ? fdopen(descriptor, mode) : NULL;
}

FILE *file_to_read(const char *path)
{
    return stream_of(open(path, O_RDONLY | O_CLOEXEC), "rb");
}

FILE *file_to_write(const char *path)
{
    return stream_of(open(path, O_WRONLY | O_CLOEXEC), "wb");
}

const char *file_problem(int reason)
{
    return strerror(reason);
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
