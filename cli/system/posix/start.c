/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "system/system.h"

#include <fcntl.h>
#include <stdlib.h>
#include <unistd.h>

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
