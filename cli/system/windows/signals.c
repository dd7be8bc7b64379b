/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Windows tells a program in a thread of its own that it is to end. */
#include "text/text.h"
#include "system/system.h"

#include <io.h>
#include <string.h>
#include <windows.h>

/* Changed only while signals are held back. */
static const char *file_to_remove;
static const char *last_words;
static CRITICAL_SECTION held;

static void say(const char *text)
{
    if (text != NULL && _write(2, text, (unsigned)strlen(text)) < 0)
        return; /* nobody to tell */
}

static void end(const char *why)
{
    if (file_to_remove != NULL)
        DeleteFileA(file_to_remove);
    progress_erase();
    say(message_speaker());
    say(": stopped by ");
    say(why);
    say(last_words);
    say("\n");
}

/* What is held stays held: no result appears after the message. Windows' own handler then ends the
 * program, with the status that the shell knows. */
static BOOL WINAPI end_by_console(DWORD event)
{
    EnterCriticalSection(&held);
    end(event == CTRL_C_EVENT       ? "Ctrl-C"
        : event == CTRL_BREAK_EVENT ? "Ctrl-Break"
        : event == CTRL_CLOSE_EVENT ? "the closed window"
                                    : "the end of the session");
    return FALSE;
}

void signals_install(void)
{
    InitializeCriticalSection(&held);
    SetErrorMode(SEM_FAILCRITICALERRORS); /* no window that asks for a disk */
    SetConsoleCtrlHandler(end_by_console, TRUE);
}

void signals_on_end(const char *unfinished_file, const char *message)
{
    file_to_remove = unfinished_file;
    last_words = message;
}

void signals_hold(void)
{
    EnterCriticalSection(&held);
}

void signals_release(void)
{
    LeaveCriticalSection(&held);
}
