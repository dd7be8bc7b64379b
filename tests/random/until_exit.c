/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The linker gives calls of f() to __wrap_f(), which calls the usual one as __real_f(). What the C
 * library or libcsv takes for itself is little, and is left. */
#include "until_exit.h"

#include <fcntl.h>
#include <setjmp.h>
#include <stdbool.h>
#include <stdlib.h>
#include <unistd.h>

enum { PIECES = 1 << 16, FILES = 32, ENDINGS = 16 };

static bool is_inside;
static jmp_buf outside;
static int status_of_exit;

static void *memory[PIECES]; /* taken since then, and not given back */
static int pieces;
static void (*ending[ENDINGS])(void); /* since the process began */
static int endings;

static void fail_unless(bool holds)
{
    if (!holds)
        abort();
}

/* ---- Memory ---- */

void *__real_malloc(size_t size);
void *__real_calloc(size_t count, size_t size);
void *__real_realloc(void *old, size_t size);
void __real_free(void *old);
void *__wrap_malloc(size_t size);
void *__wrap_calloc(size_t count, size_t size);
void *__wrap_realloc(void *old, size_t size);
void __wrap_free(void *old);

static void *keep(void *taken)
{
    fail_unless(pieces < PIECES);
    if (is_inside && taken != NULL)
        memory[pieces++] = taken;
    return taken;
}

/* Most pieces are given back soon. */
static void forget(const void *old)
{
    for (int i = pieces - 1; i >= 0; i--)
        if (memory[i] == old) {
            memory[i] = memory[--pieces];
            return;
        }
}

void *__wrap_malloc(size_t size)
{
    return keep(__real_malloc(size));
}

void *__wrap_calloc(size_t count, size_t size)
{
    return keep(__real_calloc(count, size));
}

void *__wrap_realloc(void *old, size_t size)
{
    forget(old);
    return keep(__real_realloc(old, size));
}

void __wrap_free(void *old)
{
    forget(old);
    __real_free(old);
}

/* ---- The end ---- */

int __real_atexit(void (*act)(void));
int __wrap_atexit(void (*act)(void));
void __real_exit(int status) __attribute__((noreturn));
void __wrap_exit(int status) __attribute__((noreturn));

int __wrap_atexit(void (*act)(void))
{
    if (!is_inside)
        return __real_atexit(act);
    for (int i = 0; i < endings; i++)
        if (ending[i] == act)
            return 0;
    fail_unless(endings < ENDINGS);
    ending[endings++] = act;
    return 0;
}

void __wrap_exit(int status)
{
    if (!is_inside)
        __real_exit(status);
    for (int i = endings - 1; i >= 0; i--)
        ending[i]();
    status_of_exit = status;
    longjmp(outside, 1);
}

static bool is_open(int file)
{
    return fcntl(file, F_GETFD) >= 0;
}

static void take_back(const bool was_open[FILES])
{
    for (int i = 0; i < pieces; i++)
        __real_free(memory[i]);
    pieces = 0;
    for (int i = 0; i < FILES; i++)
        if (!was_open[i] && is_open(i))
            close(i);
}

int until_exit(void (*part)(void *context), void *context)
{
    bool was_open[FILES];
    for (int i = 0; i < FILES; i++)
        was_open[i] = is_open(i);
    is_inside = true;
    status_of_exit = NO_EXIT;
    if (setjmp(outside) == 0)
        part(context);
    is_inside = false;
    take_back(was_open);
    return status_of_exit;
}
