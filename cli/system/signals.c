/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "signals.h"

#include "text/message.h"
#include "progress.h"

#include <signal.h>
#include <stddef.h>
#include <string.h>
#include <unistd.h>

static const int ending[] = {SIGINT, SIGTERM, SIGHUP, SIGQUIT};
enum { ENDING_COUNT = sizeof ending / sizeof ending[0] };

/* A library that fails, as libxlsxwriter does where memory is short: the unfinished file goes
 * too. */
static const int crashes[] = {SIGSEGV, SIGBUS, SIGABRT, SIGFPE};
enum { CRASH_COUNT = sizeof crashes / sizeof crashes[0] };

/* Changed only while signals are held back. */
static const char *volatile file_to_remove;
static const char *volatile last_words;

static const char *name_of(int number)
{
    switch (number) {
    case SIGINT:
        return "SIGINT";
    case SIGTERM:
        return "SIGTERM";
    case SIGHUP:
        return "SIGHUP";
    case SIGQUIT:
        return "SIGQUIT";
    case SIGABRT:
        return "SIGABRT";
    case SIGFPE:
        return "SIGFPE";
    case SIGBUS:
        return "SIGBUS";
    default:
        return "SIGSEGV";
    }
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
    for (int i = 0; i < CRASH_COUNT; i++)
        sigaddset(&set, crashes[i]);
    return set;
}

void signals_install(void)
{
    struct sigaction ignore = {.sa_handler = SIG_IGN};
    sigaction(SIGPIPE, &ignore, NULL);
    sigaction(SIGXFSZ, &ignore, NULL);
    struct sigaction end = {.sa_handler = end_by_signal, .sa_mask = handled()};
    for (int i = 0; i < ENDING_COUNT; i++) {
        struct sigaction before;
        if (sigaction(ending[i], NULL, &before) == 0 && before.sa_handler != SIG_IGN)
            sigaction(ending[i], &end, NULL);
    }
    for (int i = 0; i < CRASH_COUNT; i++) {
        struct sigaction before; /* not the default under a sanitizer, which has more to say */
        if (sigaction(crashes[i], NULL, &before) == 0 && before.sa_handler == SIG_DFL)
            sigaction(crashes[i], &end, NULL);
    }
}

void signals_hold(void)
{
    const sigset_t set = handled();
    sigprocmask(SIG_BLOCK, &set, NULL);
}

void signals_release(void)
{
    const sigset_t set = handled();
    sigprocmask(SIG_UNBLOCK, &set, NULL);
}

/* Blocked in a thread, a crash would end the process without the handler. */
static sigset_t before_threads;

void signals_before_threads(void)
{
    sigset_t held;
    sigfillset(&held);
    for (int i = 0; i < CRASH_COUNT; i++)
        sigdelset(&held, crashes[i]);
    pthread_sigmask(SIG_SETMASK, &held, &before_threads);
}

void signals_after_threads(void)
{
    pthread_sigmask(SIG_SETMASK, &before_threads, NULL);
}

void signals_on_end(const char *unfinished_file, const char *message)
{
    file_to_remove = unfinished_file;
    last_words = message;
}
