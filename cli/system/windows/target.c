/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "system/target.h"

#include "wide.h"

#include <errno.h>
#include <fcntl.h>
#include <io.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* ---- Links ---- */

/* The name of what a symbolic link leads to. */
static char *name_of_file(const wchar_t *path)
{
    enum { LONGEST = 32768 }; /* of a name in Windows */
    const HANDLE file = open_shared(path, 0, OPEN_EXISTING, FILE_FLAG_BACKUP_SEMANTICS);
    wchar_t *name = file != INVALID_HANDLE_VALUE ? malloc(LONGEST * sizeof *name) : NULL;
    char *target = NULL;
    if (name != NULL && GetFinalPathNameByHandleW(file, name, LONGEST, 0) != 0)
        target = utf8_of(name);
    free(name);
    if (file != INVALID_HANDLE_VALUE)
        CloseHandle(file);
    return target;
}

char *target_of_links(const char *path)
{
    wchar_t *wide = wide_of(path);
    if (wide == NULL)
        return NULL;
    const DWORD attributes = GetFileAttributesW(wide);
    const bool is_link =
        attributes != INVALID_FILE_ATTRIBUTES && (attributes & FILE_ATTRIBUTE_REPARSE_POINT) != 0;
    char *target = is_link ? name_of_file(wide) : strdup(path);
    free(wide);
    return target;
}

/* ---- The same file ---- */

static bool look_at(const char *path, DWORD standard_stream, BY_HANDLE_FILE_INFORMATION *file)
{
    const bool standard = strcmp(path, "-") == 0;
    wchar_t *name = standard ? NULL : wide_of(path);
    const HANDLE handle = standard       ? GetStdHandle(standard_stream)
                          : name != NULL ? open_shared(name, 0, OPEN_EXISTING, 0)
                                         : INVALID_HANDLE_VALUE;
    free(name);
    if (handle == INVALID_HANDLE_VALUE)
        return false;
    const bool known =
        GetFileType(handle) == FILE_TYPE_DISK && GetFileInformationByHandle(handle, file) != 0;
    if (!standard)
        CloseHandle(handle);
    return known;
}

bool target_is_input(const char *output, const char *input)
{
    BY_HANDLE_FILE_INFORMATION out, in;
    return look_at(output, STD_OUTPUT_HANDLE, &out) && look_at(input, STD_INPUT_HANDLE, &in) &&
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
        wchar_t *wide = wide_of(*name);
        if (wide == NULL)
            break;
        file = open_shared(wide, GENERIC_WRITE, CREATE_NEW, FILE_ATTRIBUTE_NORMAL);
        free(wide);
        if (errno != EEXIST)
            break;
    }
    return file;
}

/* Renaming would replace a file that is protected from writing, or in use: it is opened as if to be
 * written to. */
static bool may_be_written(const char *target, bool *other_names)
{
    BY_HANDLE_FILE_INFORMATION known;
    wchar_t *name = wide_of(target);
    if (name == NULL)
        return false;
    const HANDLE file = open_shared(name, GENERIC_WRITE | DELETE, OPEN_EXISTING, 0);
    free(name);
    *other_names = false;
    if (file == INVALID_HANDLE_VALUE)
        return errno == ENOENT;
    *other_names = GetFileInformationByHandle(file, &known) != 0 && known.nNumberOfLinks > 1;
    CloseHandle(file);
    return true;
}

int target_open_beside(const char *target, char **unfinished, const char **lost)
{
    bool other_names;
    if (!may_be_written(target, &other_names))
        return -1;
    const HANDLE file = open_new(target, unfinished);
    if (file == INVALID_HANDLE_VALUE) {
        const int reason = errno;
        free(*unfinished);
        *unfinished = NULL;
        errno = reason;
        return -1;
    }
    *lost = other_names ? "it had other names (hard links), which keep the old content" : "";
    return _open_osfhandle((intptr_t)file, _O_WRONLY | _O_BINARY);
}

int target_sync(int descriptor)
{
    return _commit(descriptor) == 0 ? 0 : errno;
}

void target_remove(const char *unfinished)
{
    wchar_t *name = wide_of(unfinished);
    if (name != NULL)
        DeleteFileW(name);
    free(name);
}

/* ReplaceFile() keeps the attributes, access lists and streams of the file that was there. It does
 * not work where there is none, nor on every file system; moving does. */
static int replace(const wchar_t *target, const wchar_t *unfinished)
{
    if (ReplaceFileW(target, unfinished, NULL, REPLACEFILE_WRITE_THROUGH, NULL, NULL) ||
        MoveFileExW(unfinished, target, MOVEFILE_REPLACE_EXISTING | MOVEFILE_WRITE_THROUGH))
        return 0;
    return errno_of(GetLastError());
}

int target_replace(const char *target, const char *unfinished)
{
    wchar_t *to = wide_of(target), *from = wide_of(unfinished);
    const int reason = to != NULL && from != NULL ? replace(to, from) : ENOMEM;
    free(to);
    free(from);
    if (reason != 0)
        target_remove(unfinished);
    return reason;
}
