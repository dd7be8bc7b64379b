/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "shared.h"
#include "system/system.h"

#include <errno.h>
#include <io.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* ---- Links ---- */

/* The name of what a symbolic link leads to. */
static char *name_of_file(const char *path)
{
    enum { LONGEST = 32768 }; /* of a name in Windows */
    const HANDLE file = open_shared(path, 0, OPEN_EXISTING, FILE_FLAG_BACKUP_SEMANTICS);
    if (file == INVALID_HANDLE_VALUE)
        return NULL;
    char *name = malloc(LONGEST);
    if (name != NULL && GetFinalPathNameByHandleA(file, name, LONGEST, 0) == 0)
        name[0] = '\0';
    CloseHandle(file);
    return name;
}

char *target_of_links(const char *path)
{
    const DWORD attributes = GetFileAttributesA(path);
    const bool is_link =
        attributes != INVALID_FILE_ATTRIBUTES && (attributes & FILE_ATTRIBUTE_REPARSE_POINT) != 0;
    return is_link ? name_of_file(path) : strdup(path);
}

/* ---- The same file ---- */

static bool look_at(const char *path, DWORD standard_stream, BY_HANDLE_FILE_INFORMATION *file)
{
    const bool standard = strcmp(path, "-") == 0;
    const HANDLE handle =
        standard ? GetStdHandle(standard_stream) : open_shared(path, 0, OPEN_EXISTING, 0);
    if (handle == INVALID_HANDLE_VALUE)
        return false;
    const bool known =
        GetFileType(handle) == FILE_TYPE_DISK && GetFileInformationByHandle(handle, file) != 0;
    if (!standard)
        CloseHandle(handle);
    return known;
}

bool target_is_input(const char *to, const char *from)
{
    BY_HANDLE_FILE_INFORMATION out, in;
    return look_at(to, STD_OUTPUT_HANDLE, &out) && look_at(from, STD_INPUT_HANDLE, &in) &&
           out.dwVolumeSerialNumber == in.dwVolumeSerialNumber &&
           out.nFileIndexHigh == in.nFileIndexHigh && out.nFileIndexLow == in.nFileIndexLow;
}

/* ---- The unfinished file ---- */

static size_t folder_length(const char *path)
{
    size_t length = 0;
    for (size_t i = 0; path[i] != '\0'; i++)
        if (strchr("/\\:", path[i]) != NULL)
            length = i + 1;
    return length;
}

/* Opens a file that was not there; its name is in *name. */
static HANDLE open_new(const char *target, char **name)
{
    enum { TRIES = 1000 };
    const size_t folder = folder_length(target), size = folder + sizeof ".rwedge-00000000";
    const DWORD first = GetTickCount() * 7919 ^ GetCurrentProcessId();
    HANDLE file = INVALID_HANDLE_VALUE;
    *name = malloc(size);
    for (DWORD i = 0; *name != NULL && i < TRIES && file == INVALID_HANDLE_VALUE; i++) {
        snprintf(*name, size, "%.*s.rwedge-%08lX", (int)folder, target, first + i);
        file = open_shared(*name, GENERIC_WRITE, CREATE_NEW, FILE_ATTRIBUTE_NORMAL);
        if (errno != EEXIST)
            break;
    }
    return file;
}

/* Renaming would replace a file that is protected from writing, or in use: it is opened as if to be
 * written to. */
static bool may_be_written(const char *target)
{
    const HANDLE file = open_shared(target, GENERIC_WRITE | DELETE, OPEN_EXISTING, 0);
    if (file == INVALID_HANDLE_VALUE)
        return errno == ENOENT;
    CloseHandle(file);
    return true;
}

FILE *target_open_beside(const char *target, char **unfinished)
{
    if (!may_be_written(target))
        return NULL;
    const HANDLE file = open_new(target, unfinished);
    return file != INVALID_HANDLE_VALUE ? stream_of(file, "wb") : NULL;
}

int target_sync(FILE *file)
{
    return _commit(_fileno(file)) == 0 ? 0 : errno;
}

/* ReplaceFile() keeps the attributes of the file that was there. It does not work where there is
 * none, nor on every file system; moving does. */
int target_replace(const char *target, const char *unfinished)
{
    if (ReplaceFileA(target, unfinished, NULL, REPLACEFILE_WRITE_THROUGH, NULL, NULL) ||
        MoveFileExA(unfinished, target, MOVEFILE_REPLACE_EXISTING | MOVEFILE_WRITE_THROUGH))
        return 0;
    const int reason = errno_of(GetLastError());
    remove(unfinished);
    return reason;
}
