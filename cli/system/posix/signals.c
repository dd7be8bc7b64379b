/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "text/text.h"
#include "system/system.h"

#include <signal.h>
#include <string.h>
#include <unistd.h>

static const int ending[] = {SIGINT, SIGTERM, SIGHUP};
enum { ENDING_COUNT = sizeof ending / sizeof ending[0] };

/* Changed only while signals are held back. */
static const char *volatile file_to_remove;
static const char *volatile last_words;

static const char *name_of(int number)
{
    return number == SIGINT ? "SIGINT" : number == SIGTERM ? "SIGTERM" : "SIGHUP";
}

static void say(const char *text)
{
    if (text != NULL && write(STDERR_FILENO, text, strlen(text)) < 0)
        return; /* nobody to tell */
}

/* Only calls that are safe in a signal handler. */
static void end_by_signal(int number)
{
    if (file_to_remove != NULL)
        unlink(file_to_remove);
    progress_erase();
    say(message_speaker());
    say(": stopped by ");
    say(name_of(number));
    say(last_words);
    say("\n");
    struct sigaction action = {.sa_handler = SIG_DFL};
    sigaction(number, &action, NULL);
    raise(number); /* delivered when the handler returns */
}

static sigset_t handled(void)
{
    sigset_t set;
    sigemptyset(&set);
    for (int i = 0; i < ENDING_COUNT; i++)
        sigaddset(&set, ending[i]);
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
        if (sigaction(ending[i], NULL, &before) == 0 && before.sa_handler != SIG_IGN)
            sigaction(ending[i], &end, NULL);
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

void signals_on_end(const char *unfinished_file, const char *message)
{
    file_to_remove = unfinished_file;
    last_words = message;
}
