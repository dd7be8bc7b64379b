/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "system/program.h"

#include <errno.h>
#include <signal.h>
#include <spawn.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>

extern char **environ;

static bool has(const char *const variables[], const char *variable)
{
    for (int i = 0; variables[i] != NULL; i++)
        if (strncmp(variable, variables[i], strcspn(variables[i], "=") + 1) == 0)
            return true;
    return false;
}

/* The user's environment with these variables in it. Free it. */
static char **environment(const char *const variables[])
{
    size_t room = 1, count = 0;
    for (size_t i = 0; variables[i] != NULL; i++)
        room++;
    for (size_t i = 0; environ[i] != NULL; i++)
        room++;
    char **all = malloc(room * sizeof *all);
    if (all == NULL)
        return NULL;
    for (size_t i = 0; variables[i] != NULL; i++)
        all[count++] = (char *)variables[i];
    for (size_t i = 0; environ[i] != NULL; i++)
        if (!has(variables, environ[i]))
            all[count++] = environ[i];
    all[count] = NULL;
    return all;
}

/* Signals that the tool ignores would stay ignored in the program. */
static int usual_signals(posix_spawnattr_t *attributes)
{
    sigset_t usual;
    sigemptyset(&usual);
    sigaddset(&usual, SIGPIPE);
    sigaddset(&usual, SIGXFSZ);
    const int error = posix_spawnattr_setsigdefault(attributes, &usual);
    return error != 0 ? error : posix_spawnattr_setflags(attributes, POSIX_SPAWN_SETSIGDEF);
}

static int start(const char *const words[], char **variables, FILE *const streams[3],
                 pid_t *process)
{
    posix_spawn_file_actions_t actions;
    posix_spawnattr_t attributes;
    int error = posix_spawn_file_actions_init(&actions);
    if (error != 0)
        return error;
    error = posix_spawnattr_init(&attributes);
    if (error == 0) {
        error = usual_signals(&attributes);
        for (int i = 0; i < 3 && error == 0; i++)
            error = posix_spawn_file_actions_adddup2(&actions, fileno(streams[i]), i);
        if (error == 0)
            error =
                posix_spawnp(process, words[0], &actions, &attributes, (char **)words, variables);
        posix_spawnattr_destroy(&attributes);
    }
    posix_spawn_file_actions_destroy(&actions);
    return error;
}

int program_run(const char *const words[], const char *const variables[], FILE *const streams[3],
                program_end *end)
{
    pid_t process;
    int status;
    char **all = environment(variables);
    const int error = all != NULL ? start(words, all, streams, &process) : ENOMEM;
    free(all);
    if (error != 0)
        return error;
    while (waitpid(process, &status, 0) < 0)
        if (errno != EINTR)
            return errno;
    *end = WIFEXITED(status) ? (program_end){false, WEXITSTATUS(status)}
                             : (program_end){true, WTERMSIG(status)};
    return 0;
}
