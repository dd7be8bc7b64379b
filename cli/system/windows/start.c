/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "system/start.h"

#include "wide.h"

#include <fcntl.h>
#include <io.h>
#include <shellapi.h>
#include <stdio.h>
#include <stdlib.h>

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

/* ---- Arguments ---- */

/* C's start-up gives them in the machine's code page, and replaces * and ? by names of files. */
static bool read_arguments(int *count, const char ***words)
{
    wchar_t **given = CommandLineToArgvW(GetCommandLineW(), count);
    const char **all = given != NULL ? calloc((size_t)*count + 1, sizeof *all) : NULL;
    for (int i = 0; all != NULL && i < *count; i++) {
        all[i] = utf8_of(given[i]);
        if (all[i] == NULL) {
            fputs("rwedge: an argument is no text in Unicode\n", stderr);
            return false;
        }
    }
    LocalFree(given);
    *words = all;
    return all != NULL;
}

bool start(int *count, const char ***words)
{
    if (!fill_closed())
        return false;
    prepare_console();
    _putenv("POSIXLY_CORRECT=");
    _putenv("POSIX_ME_HARDER=");
    return read_arguments(count, words);
}
