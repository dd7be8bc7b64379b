/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "system/system.h"

#include <errno.h>
#include <fcntl.h>
#include <io.h>
#include <process.h>
#include <stdio.h>
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

/* Runs it with the files in place of our standard streams, which come back afterwards. Returns the
 * status, or -1 with errno. */
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

long processors(void)
{
    const DWORD active = GetActiveProcessorCount(ALL_PROCESSOR_GROUPS);
    return active < 1 ? 1 : (long)active;
}

/* No byte changes on its way: a line ends as it was written. */
static bool fill_closed(void)
{
    for (int stream = 0; stream <= 2; stream++) {
        if (_get_osfhandle(stream) < 0 &&
            _open("NUL", stream == 2 ? _O_WRONLY : _O_RDONLY) != stream)
            return false;
        _setmode(stream, _O_BINARY);
    }
    return true;
}

/* ---- The console ---- */

static UINT users_code_page;

static void give_code_page_back(void)
{
    SetConsoleOutputCP(users_code_page);
}

/* A console shows UTF-8 while the tool runs, and knows how to erase a line. */
static void prepare_console(void)
{
    DWORD mode;
    const HANDLE console = GetStdHandle(STD_ERROR_HANDLE);
    users_code_page = GetConsoleOutputCP();
    if (users_code_page != 0 && users_code_page != CP_UTF8 && SetConsoleOutputCP(CP_UTF8))
        atexit(give_code_page_back);
    if (GetConsoleMode(console, &mode) != 0)
        SetConsoleMode(console, mode | ENABLE_VIRTUAL_TERMINAL_PROCESSING);
}

/* C's start-up does not replace * and ? in arguments by names of files. */
int _dowildcard = 0;

bool start(int *count, const char ***words)
{
    (void)count;
    (void)words;
    if (!fill_closed())
        return false;
    prepare_console();
    _putenv("POSIXLY_CORRECT=");
    _putenv("POSIX_ME_HARDER=");
    return true;
}
