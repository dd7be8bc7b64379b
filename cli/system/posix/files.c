/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "system/system.h"

#include <errno.h>
#include <fcntl.h>
#include <string.h>
#include <sys/stat.h>

file_kind file_kind_of(const char *path)
{
    struct stat file;
    if (stat(path, &file) != 0)
        return errno == ENOENT ? FILE_ABSENT : FILE_NOT_KNOWN;
    return S_ISREG(file.st_mode) ? FILE_REGULAR : S_ISDIR(file.st_mode) ? FILE_FOLDER : FILE_OTHER;
}

int file_to_read(const char *path)
{
    return open(path, O_RDONLY | O_CLOEXEC);
}

int file_to_write(const char *path)
{
    return open(path, O_WRONLY | O_CLOEXEC);
}

const char *file_problem(int reason)
{
    return strerror(reason);
}
