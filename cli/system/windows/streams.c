/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "system/system.h"

#include <io.h>
#include <stdlib.h>
#include <windows.h>

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
