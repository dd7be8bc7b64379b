/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "system/streams.h"

#include "wide.h"

#include <errno.h>
#include <fcntl.h>
#include <io.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

/* isatty() takes NUL for a terminal. */
bool stream_is_terminal(FILE *stream)
{
    DWORD mode;
    return GetConsoleMode((HANDLE)_get_osfhandle(_fileno(stream)), &mode) != 0;
}

static bool new_name(wchar_t name[MAX_PATH])
{
    wchar_t folder[MAX_PATH + 1];
    if (GetTempPathW(MAX_PATH + 1, folder) != 0 && GetTempFileNameW(folder, L"rwe", 0, name) != 0)
        return true;
    errno = errno_of(GetLastError());
    return false;
}

/* The file goes with the stream. */
static FILE *open_last_time(const wchar_t *name)
{
    const HANDLE file = open_shared(name, GENERIC_READ | GENERIC_WRITE | DELETE, OPEN_EXISTING,
                                    FILE_ATTRIBUTE_TEMPORARY | FILE_FLAG_DELETE_ON_CLOSE);
    if (file == INVALID_HANDLE_VALUE)
        return NULL;
    const int descriptor = _open_osfhandle((intptr_t)file, _O_RDWR | _O_BINARY);
    return descriptor >= 0 ? _fdopen(descriptor, "w+b") : NULL;
}

FILE *stream_temporary(void)
{
    wchar_t name[MAX_PATH];
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
    wchar_t wide[MAX_PATH];
    char *name = new_name(wide) ? utf8_of(wide) : NULL;
    file->stream = NULL;
    file->name[0] = '\0';
    if (name == NULL)
        return false;
    snprintf(file->name, sizeof file->name, "%s", name);
    free(name);
    spooled = file;
    return atexit(end_spooled) == 0;
}

FILE *spool_read(spool *file)
{
    wchar_t *name = wide_of(file->name);
    if (name == NULL)
        return NULL;
    file->stream = open_last_time(name);
    free(name);
    return file->stream;
}

void spool_end(spool *file)
{
    spooled = NULL;
    wchar_t *name = file->stream == NULL ? wide_of(file->name) : NULL;
    if (file->stream != NULL)
        fclose(file->stream);
    if (name != NULL)
        DeleteFileW(name);
    free(name);
}

/* For libxlsxwriter, in place of fopen(): packages/windows/for_xlsxwriter.h. */
FILE *stream_by_name(const char *name, const char *mode);
FILE *stream_by_name(const char *name, const char *mode)
{
    wchar_t *wide_name = wide_of(name), *wide_mode = wide_of(mode);
    FILE *stream = wide_name != NULL && wide_mode != NULL ? _wfopen(wide_name, wide_mode) : NULL;
    free(wide_name);
    free(wide_mode);
    return stream;
}
