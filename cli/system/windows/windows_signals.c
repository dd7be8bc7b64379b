/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Windows tells a program in a thread of its own that it is to end. */
#include "system/system.h"

#include <windows.h>

static CRITICAL_SECTION held;

/* What is held stays held: no result appears after the message. Windows' own handler then ends the
 * program, with the status that the shell knows. */
static BOOL WINAPI end_by_console(DWORD event)
{
    EnterCriticalSection(&held);
    signals_end(event == CTRL_C_EVENT       ? "Ctrl-C"
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

void signals_hold(void)
{
    EnterCriticalSection(&held);
}

void signals_release(void)
{
    LeaveCriticalSection(&held);
}
