/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "system/system.h"

#include <errno.h>
#include <fcntl.h>
#include <spawn.h>
#include <stdlib.h>
#include <sys/wait.h>
#include <unistd.h>

extern char **environ;

const char program_input_name[] = "/dev/stdin";

static int spawn(const char *const words[], FILE *const streams[3], pid_t *process)
{
    posix_spawn_file_actions_t actions;
    int error = posix_spawn_file_actions_init(&actions);
    if (error != 0)
        return error;
    for (int i = 0; i < 3 && error == 0; i++)
        error = posix_spawn_file_actions_adddup2(&actions, fileno(streams[i]), i);
    if (error == 0)
        error = posix_spawnp(process, words[0], &actions, NULL, (char **)words, environ);
    posix_spawn_file_actions_destroy(&actions);
    return error;
}

int program_run(const char *const words[], const char *const variables[], FILE *const streams[3],
                program_end *end)
{
    pid_t process;
    int status;
    for (int i = 0; variables[i] != NULL; i++)
        if (putenv((char *)variables[i]) != 0)
            return errno;
    const int error = spawn(words, streams, &process);
    if (error != 0)
        return error;
    while (waitpid(process, &status, 0) < 0)
        if (errno != EINTR)
            return errno;
    *end = WIFEXITED(status) ? (program_end){false, WEXITSTATUS(status)}
                             : (program_end){true, WTERMSIG(status)};
    return 0;
}

long processors(void)
{
    const long online = sysconf(_SC_NPROCESSORS_ONLN);
    return online < 1 ? 1 : online;
}

bool start(int *count, const char ***words)
{
    static const char *no_arguments[] = {"rwedge", NULL};
    if (*count < 1) {
        *count = 1;
        *words = no_arguments;
    }
    unsetenv("POSIXLY_CORRECT");
    unsetenv("POSIX_ME_HARDER");
    for (int stream = STDIN_FILENO; stream <= STDERR_FILENO; stream++)
        if (fcntl(stream, F_GETFD) < 0 &&
            open("/dev/null", stream == STDERR_FILENO ? O_WRONLY : O_RDONLY) != stream)
            return false;
    return true;
}
