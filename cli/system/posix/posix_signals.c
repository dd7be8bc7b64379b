/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "system/system.h"

#include <signal.h>

static const struct {
    int number;
    const char *name;
} ending[] = {{SIGINT, "SIGINT"}, {SIGTERM, "SIGTERM"}, {SIGHUP, "SIGHUP"}, {SIGXCPU, "SIGXCPU"}};
enum { ENDING_COUNT = sizeof ending / sizeof ending[0] };

static void end_by_signal(int number)
{
    int i = 0;
    while (ending[i].number != number)
        i++;
    signals_end(ending[i].name);
    struct sigaction action = {.sa_handler = SIG_DFL};
    sigaction(number, &action, NULL);
    raise(number); /* delivered when the handler returns */
}

static sigset_t handled(void)
{
    sigset_t set;
    sigemptyset(&set);
    for (int i = 0; i < ENDING_COUNT; i++)
        sigaddset(&set, ending[i].number);
    return set;
}

void signals_install(void)
{
    const struct sigaction ignore = {.sa_handler = SIG_IGN},
                           end = {.sa_handler = end_by_signal, .sa_mask = handled()};
    struct sigaction before;
    sigaction(SIGPIPE, &ignore, NULL);
    sigaction(SIGXFSZ, &ignore, NULL);
    for (int i = 0; i < ENDING_COUNT; i++)
        if (sigaction(ending[i].number, NULL, &before) == 0 && before.sa_handler != SIG_IGN)
            sigaction(ending[i].number, &end, NULL);
}

void signals_hold(void)
{
    const sigset_t set = handled();
    pthread_sigmask(SIG_BLOCK, &set, NULL);
}

void signals_release(void)
{
    const sigset_t set = handled();
    pthread_sigmask(SIG_UNBLOCK, &set, NULL);
}
