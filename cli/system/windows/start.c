/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "system/system.h"

#include <fcntl.h>
#include <io.h>
#include <stdio.h>
#include <stdlib.h>
#include <windows.h>

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
