/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "system/signals.h"

#include "text/message.h"
#include "system/progress.h"

#include <signal.h>
#include <stdbool.h>
#include <stddef.h>
#include <string.h>
#include <unistd.h>

typedef struct {
    int number;
    const char *name;
} kind;

/* Those that end a process, but for SIGKILL and the numbered ones. */
static const kind ending[] = {
    {SIGINT, "SIGINT"},       {SIGTERM, "SIGTERM"}, {SIGHUP, "SIGHUP"},   {SIGQUIT, "SIGQUIT"},
    {SIGALRM, "SIGALRM"},     {SIGUSR1, "SIGUSR1"}, {SIGUSR2, "SIGUSR2"}, {SIGXCPU, "SIGXCPU"},
    {SIGVTALRM, "SIGVTALRM"}, {SIGPROF, "SIGPROF"},
};
enum { ENDING_COUNT = sizeof ending / sizeof ending[0] };

/* A library that fails, as libxlsxwriter does where memory is short: the unfinished file goes
 * too. */
static const kind crashes[] = {
    {SIGSEGV, "SIGSEGV"}, {SIGBUS, "SIGBUS"},   {SIGABRT, "SIGABRT"}, {SIGFPE, "SIGFPE"},
    {SIGILL, "SIGILL"},   {SIGTRAP, "SIGTRAP"}, {SIGSYS, "SIGSYS"},
};
enum { CRASH_COUNT = sizeof crashes / sizeof crashes[0] };

/* Changed only while signals are held back. */
static const char *volatile file_to_remove;
static const char *volatile last_words;

static const char *name_of(int number)
{
    for (int i = 0; i < ENDING_COUNT; i++)
        if (ending[i].number == number)
            return ending[i].name;
    for (int i = 0; i < CRASH_COUNT; i++)
        if (crashes[i].number == number)
            return crashes[i].name;
    return "a signal";
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
        sigaddset(&set, ending[i].number);
    for (int i = 0; i < CRASH_COUNT; i++)
        sigaddset(&set, crashes[i].number);
    return set;
}

/* Not what is ignored already; nor a crash that a sanitizer has more to say about. */
static void install(const kind kinds[], int count, const struct sigaction *end, bool only_default)
{
    for (int i = 0; i < count; i++) {
        struct sigaction before;
        if (sigaction(kinds[i].number, NULL, &before) == 0 &&
            (only_default ? before.sa_handler == SIG_DFL : before.sa_handler != SIG_IGN))
            sigaction(kinds[i].number, end, NULL);
    }
}

void signals_in_thread(char stack[SIGNALS_STACK])
{
    const stack_t other = {.ss_sp = stack, .ss_size = SIGNALS_STACK};
    sigaltstack(&other, NULL);
}

void signals_install(void)
{
    static char stack[SIGNALS_STACK];
    struct sigaction ignore = {.sa_handler = SIG_IGN};
    sigaction(SIGPIPE, &ignore, NULL);
    sigaction(SIGXFSZ, &ignore, NULL);
    struct sigaction end = {
        .sa_handler = end_by_signal, .sa_mask = handled(), .sa_flags = SA_ONSTACK};
    signals_in_thread(stack);
    install(ending, ENDING_COUNT, &end, false);
    install(crashes, CRASH_COUNT, &end, true);
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
        sigdelset(&held, crashes[i].number);
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
