/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "system.h"

#include <inttypes.h>
#include <signal.h>
#include <stdio.h>
#include <time.h>
#include <unistd.h>

static const double FIRST_AFTER = 0.5, THEN_EVERY = 0.1; /* seconds */
enum { ROWS_PER_LOOK = 16 };                             /* a row takes up to a millisecond */

static struct {
    bool wanted;
    int64_t done, total;
    const char *unit;
    double next;
} work;

static volatile sig_atomic_t line_shown;

static double seconds(void)
{
    struct timespec now;
    return clock_gettime(CLOCK_MONOTONIC, &now) == 0
               ? (double)now.tv_sec + 1e-9 * (double)now.tv_nsec
               : 0;
}

void progress_start(bool wanted, int64_t total, const char *unit)
{
    work.wanted = wanted;
    work.done = 0;
    work.total = total;
    work.unit = unit;
    work.next = wanted ? seconds() + FIRST_AFTER : 0;
}

void progress_step(void)
{
    work.done++;
    if (!work.wanted || work.done % ROWS_PER_LOOK != 0)
        return;
    const double now = seconds();
    if (now < work.next)
        return;
    work.next = now + THEN_EVERY;
    line_shown = 1;
    fprintf(stderr, "\r%s: %" PRId64, message_speaker(), work.done);
    if (work.total != PROGRESS_NO_TOTAL)
        fprintf(stderr, " of %" PRId64, work.total);
    fprintf(stderr, " %s", work.unit);
}

void progress_erase(void)
{
    static const char erase_line[] = "\r\033[K";
    if (!line_shown)
        return;
    line_shown = 0;
    if (write(STDERR_FILENO, erase_line, sizeof erase_line - 1) < 0)
        return; /* nobody is looking */
}
