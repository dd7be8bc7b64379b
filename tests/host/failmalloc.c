/* SPDX-License-Identifier: GPL-3.0-or-later */
/* This library is preloaded into a program. It makes one allocation fail, or all from one on. It
 * needs glibc, whose own functions have a second name.
 *
 *     FAIL_AT=N     the N-th allocation fails; unset or 0: none
 *     FAIL_ALL=1    and all after it
 *     FAIL_COUNT=F  the number of allocations is written to the file F at the end
 *     FAIL_MARK=F   the file F appears when one fails
 *
 * Allocations count from where this library is initialised: after the libraries of the program,
 * before its main(). Programs that it starts are not affected. */
#include <errno.h>
#include <fcntl.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

void *__libc_malloc(size_t size);
void *__libc_calloc(size_t count, size_t size);
void *__libc_realloc(void *block, size_t size);

static bool counting, all_after;
static unsigned long allocations, failing;
static const char *count_file, *mark_file;

__attribute__((constructor)) static void start(void)
{
    const char *at = getenv("FAIL_AT");
    failing = at != NULL ? strtoul(at, NULL, 10) : 0;
    all_after = getenv("FAIL_ALL") != NULL;
    count_file = getenv("FAIL_COUNT");
    mark_file = getenv("FAIL_MARK");
    unsetenv("LD_PRELOAD");
    counting = true;
}

__attribute__((destructor)) static void end(void)
{
    counting = false;
    const int file = count_file != NULL ? open(count_file, O_WRONLY | O_CREAT | O_TRUNC, 0666) : -1;
    if (file < 0)
        return;
    char digits[24] = {0}, *first = digits + sizeof digits - 2;
    *first = '\n';
    for (unsigned long n = allocations; n > 0; n /= 10)
        *--first = (char)('0' + n % 10);
    if (write(file, first, strlen(first)) < 0)
        _exit(99);
    close(file);
}

static bool is_granted(void)
{
    if (!counting)
        return true;
    allocations++;
    if (failing == 0 || (all_after ? allocations < failing : allocations != failing))
        return true;
    if (mark_file != NULL)
        close(open(mark_file, O_WRONLY | O_CREAT, 0666));
    mark_file = NULL;
    errno = ENOMEM;
    return false;
}

void *malloc(size_t size)
{
    return is_granted() ? __libc_malloc(size) : NULL;
}

void *calloc(size_t count, size_t size)
{
    return is_granted() ? __libc_calloc(count, size) : NULL;
}

void *realloc(void *block, size_t size)
{
    return is_granted() ? __libc_realloc(block, size) : NULL;
}
