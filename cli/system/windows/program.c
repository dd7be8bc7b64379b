/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "system/system.h"

#include <errno.h>
#include <io.h>
#include <process.h>
#include <stdlib.h>
#include <windows.h>

const char program_input_name[] = "-";

enum { STREAMS = 3 };

/* Looked for on PATH alone: Windows itself would begin in the current folder. */
static bool find(const char *name, char path[MAX_PATH])
{
    const char *folders = getenv("PATH");
    const DWORD length =
        folders != NULL ? SearchPathA(folders, name, ".exe", MAX_PATH, path, NULL) : 0;
    return length > 0 && length < MAX_PATH;
}

/* With the files in place of our standard streams, which come back afterwards. The status, or -1
 * with errno. */
static intptr_t run(const char *path, const char *const words[], FILE *const streams[STREAMS])
{
    int own[STREAMS];
    for (int i = 0; i < STREAMS; i++) {
        own[i] = _dup(i);
        _dup2(_fileno(streams[i]), i);
    }
    const intptr_t status = _spawnv(_P_WAIT, path, words);
    const int reason = errno;
    for (int i = 0; i < STREAMS; i++) {
        _dup2(own[i], i);
        _close(own[i]);
    }
    errno = reason;
    return status;
}

int program_run(const char *const words[], const char *const variables[], FILE *const streams[3],
                program_end *end)
{
    char path[MAX_PATH];
    for (int i = 0; variables[i] != NULL; i++)
        if (_putenv(variables[i]) != 0)
            return ENOMEM;
    if (!find(words[0], path))
        return ENOENT;
    const intptr_t status = run(path, words, streams);
    *end = (program_end){false, (int)status};
    return status == -1 ? errno : 0;
}
