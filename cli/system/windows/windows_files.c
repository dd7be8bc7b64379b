/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "shared.h"
#include "system/system.h"

#include <errno.h>
#include <io.h>
#include <stdlib.h>
#include <string.h>
#include <windows.h>

file_kind file_kind_of(const char *path)
{
    BY_HANDLE_FILE_INFORMATION known;
    const HANDLE file = open_shared(path, 0, OPEN_EXISTING, FILE_FLAG_BACKUP_SEMANTICS);
    if (file == INVALID_HANDLE_VALUE)
        return errno == ENOENT ? FILE_ABSENT : FILE_NOT_KNOWN;
    const bool on_disk = GetFileType(file) == FILE_TYPE_DISK;
    const bool is_folder = on_disk && GetFileInformationByHandle(file, &known) != 0 &&
                           (known.dwFileAttributes & FILE_ATTRIBUTE_DIRECTORY) != 0;
    CloseHandle(file);
    return is_folder ? FILE_FOLDER : on_disk ? FILE_REGULAR : FILE_OTHER;
}

static FILE *open_by_name(const char *path, DWORD access, const char *mode)
{
    if (file_kind_of(path) == FILE_FOLDER) {
        errno = EISDIR;
        return NULL;
    }
    const HANDLE file = open_shared(path, access, OPEN_EXISTING, FILE_ATTRIBUTE_NORMAL);
    return file != INVALID_HANDLE_VALUE ? stream_of(file, mode) : NULL;
}

FILE *file_to_read(const char *path)
{
    return open_by_name(path, GENERIC_READ, "rb");
}

FILE *file_to_write(const char *path)
{
    return open_by_name(path, GENERIC_WRITE, "wb");
}

const char *file_problem(int reason)
{
    return reason == EACCES ? "Permission denied; it is protected, or open in another program"
                            : strerror(reason);
}

/* isatty() takes NUL for a terminal. */
bool stream_is_terminal(FILE *stream)
{
    DWORD mode;
    return GetConsoleMode((HANDLE)_get_osfhandle(_fileno(stream)), &mode) != 0;
}

/* tmpfile() would make it where only an administrator may. */
static bool new_name(char name[MAX_PATH])
{
    char folder[MAX_PATH + 1];
    return GetTempPathA(MAX_PATH + 1, folder) != 0 && GetTempFileNameA(folder, "rwe", 0, name) != 0;
}

/* Short-lived; the file goes with the stream. Other programs do not inherit it. */
static FILE *open_last_time(const char *name)
{
    return fopen(name, "r+bTDN");
}

FILE *stream_temporary(void)
{
    char name[MAX_PATH];
    return new_name(name) ? open_last_time(name) : NULL;
}

/* The one that is there; NULL for none. */
static spool *spooled;

static void end_spooled(void)
{
    if (spooled != NULL)
        spool_end(spooled);
}

/* Windows does not let a library write to what is open here: it is opened again afterwards. */
bool spool_begin(spool *file)
{
    file->stream = NULL;
    if (!new_name(file->name))
        return false;
    spooled = file;
    return atexit(end_spooled) == 0;
}

FILE *spool_read(spool *file)
{
    file->stream = open_last_time(file->name);
    return file->stream;
}

void spool_end(spool *file)
{
    spooled = NULL;
    if (file->stream != NULL)
        fclose(file->stream);
    else
        remove(file->name);
}
