/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "system/program.h"

#include "wide.h"

#include <errno.h>
#include <io.h>
#include <stdlib.h>
#include <string.h>

enum { STREAMS = 3 };

/* ---- The environment: "NAME=value" one after the other, and an empty one at the end ---- */

static bool is_one_of(const wchar_t *variable, wchar_t *const mine[])
{
    const size_t name = wcscspn(variable + 1, L"=") + 2; /* the name of a drive's begins with = */
    for (int i = 0; mine[i] != NULL; i++)
        if (_wcsnicmp(variable, mine[i], name) == 0)
            return true;
    return false;
}

static size_t add(wchar_t *all, size_t used, const wchar_t *variable)
{
    if (all != NULL)
        wcscpy(all + used, variable);
    return used + wcslen(variable) + 1;
}

/* What it needs, and, where all is not NULL, what it is. */
static size_t environment(wchar_t *all, const wchar_t *users, wchar_t *const mine[])
{
    size_t used = 0;
    for (int i = 0; mine[i] != NULL; i++)
        used = add(all, used, mine[i]);
    for (; *users != L'\0'; users += wcslen(users) + 1)
        if (!is_one_of(users, mine))
            used = add(all, used, users);
    return add(all, used, L"");
}

static void free_words(wchar_t **words)
{
    for (int i = 0; words != NULL && words[i] != NULL; i++)
        free(words[i]);
    free(words);
}

static wchar_t **wide_words(const char *const words[])
{
    size_t count = 0;
    while (words[count] != NULL)
        count++;
    wchar_t **wide = calloc(count + 1, sizeof *wide);
    for (size_t i = 0; wide != NULL && i < count; i++) {
        wide[i] = wide_of(words[i]);
        if (wide[i] == NULL) {
            free_words(wide);
            return NULL;
        }
    }
    return wide;
}

static wchar_t *environment_with(const char *const variables[])
{
    wchar_t **mine = wide_words(variables), *all = NULL;
    wchar_t *users = GetEnvironmentStringsW();
    if (mine != NULL && users != NULL)
        all = malloc(environment(NULL, users, mine) * sizeof *all);
    if (all != NULL)
        environment(all, users, mine);
    if (users != NULL)
        FreeEnvironmentStringsW(users);
    free_words(mine);
    return all;
}

/* ---- The program ---- */

/* Looked for on PATH alone: Windows itself would begin in the current folder. */
static bool find(const wchar_t *name, wchar_t path[MAX_PATH])
{
    enum { LONGEST = 32768 };
    wchar_t *folders = malloc(LONGEST * sizeof *folders);
    const DWORD length = folders != NULL ? GetEnvironmentVariableW(L"PATH", folders, LONGEST) : 0;
    const DWORD found = length > 0 && length < LONGEST
                            ? SearchPathW(folders, name, L".exe", MAX_PATH, path, NULL)
                            : 0;
    free(folders);
    errno = ENOENT;
    return found > 0 && found < MAX_PATH;
}

/* The words have no quotation marks. Free it. */
static wchar_t *command_line(wchar_t *const words[])
{
    size_t size = 1, used = 0;
    for (int i = 0; words[i] != NULL; i++)
        size += wcslen(words[i]) + 3;
    wchar_t *line = malloc(size * sizeof *line);
    for (int i = 0; line != NULL && words[i] != NULL; i++)
        used += (size_t)_snwprintf(line + used, size - used, i > 0 ? L" \"%ls\"" : L"\"%ls\"",
                                   words[i]);
    return line;
}

/* A handle that the program inherits. */
static HANDLE inherited(FILE *stream)
{
    HANDLE copy = NULL;
    const HANDLE self = GetCurrentProcess();
    DuplicateHandle(self, (HANDLE)_get_osfhandle(_fileno(stream)), self, &copy, 0, TRUE,
                    DUPLICATE_SAME_ACCESS);
    return copy;
}

static int run(const wchar_t *path, wchar_t *line, wchar_t *variables, FILE *const streams[STREAMS],
               program_end *end)
{
    HANDLE handle[STREAMS];
    PROCESS_INFORMATION process;
    DWORD status = 0;
    for (int i = 0; i < STREAMS; i++)
        handle[i] = inherited(streams[i]);
    STARTUPINFOW how = {.cb = sizeof how,
                        .dwFlags = STARTF_USESTDHANDLES,
                        .hStdInput = handle[0],
                        .hStdOutput = handle[1],
                        .hStdError = handle[2]};
    const bool begun =
        CreateProcessW(path, line, NULL, NULL, TRUE, CREATE_UNICODE_ENVIRONMENT | CREATE_NO_WINDOW,
                       variables, NULL, &how, &process) != 0;
    const int reason = begun ? 0 : errno_of(GetLastError());
    for (int i = 0; i < STREAMS; i++)
        CloseHandle(handle[i]);
    if (!begun)
        return reason;
    WaitForSingleObject(process.hProcess, INFINITE);
    GetExitCodeProcess(process.hProcess, &status);
    CloseHandle(process.hThread);
    CloseHandle(process.hProcess);
    *end = (program_end){false, (int)status};
    return 0;
}

int program_run(const char *const words[], const char *const variables[], FILE *const streams[3],
                program_end *end)
{
    wchar_t path[MAX_PATH];
    wchar_t **wide = wide_words(words);
    wchar_t *line = wide != NULL ? command_line(wide) : NULL;
    wchar_t *all = environment_with(variables);
    int error = ENOMEM;
    if (line != NULL && all != NULL)
        error = find(wide[0], path) ? run(path, line, all, streams, end) : ENOENT;
    free(all);
    free(line);
    free_words(wide);
    return error;
}
