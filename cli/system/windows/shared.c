/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "shared.h"

#include <errno.h>
#include <fcntl.h>
#include <io.h>

int errno_of(DWORD error)
{
    static const struct {
        DWORD error;
        int number;
    } known[] = {
        {ERROR_FILE_NOT_FOUND, ENOENT},      {ERROR_PATH_NOT_FOUND, ENOENT},
        {ERROR_INVALID_NAME, ENOENT},        {ERROR_BAD_PATHNAME, ENOENT},
        {ERROR_BAD_NETPATH, ENOENT},         {ERROR_INVALID_DRIVE, ENOENT},
        {ERROR_ACCESS_DENIED, EACCES},       {ERROR_SHARING_VIOLATION, EACCES},
        {ERROR_LOCK_VIOLATION, EACCES},      {ERROR_WRITE_PROTECT, EROFS},
        {ERROR_FILE_EXISTS, EEXIST},         {ERROR_ALREADY_EXISTS, EEXIST},
        {ERROR_DISK_FULL, ENOSPC},           {ERROR_HANDLE_DISK_FULL, ENOSPC},
        {ERROR_NOT_ENOUGH_MEMORY, ENOMEM},   {ERROR_OUTOFMEMORY, ENOMEM},
        {ERROR_TOO_MANY_OPEN_FILES, EMFILE}, {ERROR_FILENAME_EXCED_RANGE, ENAMETOOLONG},
        {ERROR_BROKEN_PIPE, EPIPE},          {ERROR_NO_DATA, EPIPE},
        {ERROR_BAD_EXE_FORMAT, ENOEXEC},
    };
    for (size_t i = 0; i < sizeof known / sizeof known[0]; i++)
        if (known[i].error == error)
            return known[i].number;
    return EIO;
}

HANDLE open_shared(const char *path, DWORD access, DWORD disposition, DWORD flags)
{
    const DWORD shared = FILE_SHARE_READ | FILE_SHARE_WRITE | FILE_SHARE_DELETE;
    const HANDLE file = CreateFileA(path, access, shared, NULL, disposition, flags, NULL);
    if (file == INVALID_HANDLE_VALUE)
        errno = errno_of(GetLastError());
    return file;
}

FILE *stream_of(HANDLE file, const char *mode)
{
    const int descriptor = _open_osfhandle((intptr_t)file, _O_BINARY);
    return descriptor >= 0 ? _fdopen(descriptor, mode) : NULL;
}
