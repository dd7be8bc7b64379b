/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The linker gives calls of f() to __wrap_f(), which calls the usual one as __real_f(). */
#include "until_exit.h"

#include <setjmp.h>
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include <csv.h>
#include <iconv.h>

enum { PIECES = 1 << 16, FILES = 64, CONVERTERS = 64, ENDINGS = 16 };

static bool is_inside;
static jmp_buf outside;
static int status_of_exit;

static void *memory[PIECES]; /* taken since then, and not given back */
static int pieces;
static int file[FILES]; /* opened since then */
static int files;
static iconv_t converter[CONVERTERS]; /* opened since then, and not closed */
static int converters;
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

char *__wrap_strdup(const char *text);

char *__wrap_strdup(const char *text)
{
    char *copy = __wrap_malloc(strlen(text) + 1);
    return copy != NULL ? strcpy(copy, text) : NULL;
}

/* ---- Memory of libraries ---- */

int __real_csv_init(struct csv_parser *parser, unsigned char options);
int __wrap_csv_init(struct csv_parser *parser, unsigned char options);
iconv_t __real_iconv_open(const char *to, const char *from);
iconv_t __wrap_iconv_open(const char *to, const char *from);
int __real_iconv_close(iconv_t old);
int __wrap_iconv_close(iconv_t old);

int __wrap_csv_init(struct csv_parser *parser, unsigned char options)
{
    const int status = __real_csv_init(parser, options);
    csv_set_realloc_func(parser, __wrap_realloc);
    csv_set_free_func(parser, __wrap_free);
    return status;
}

iconv_t __wrap_iconv_open(const char *to, const char *from)
{
    const iconv_t opened = __real_iconv_open(to, from);
    fail_unless(converters < CONVERTERS);
    if (is_inside && opened != (iconv_t)-1)
        converter[converters++] = opened;
    return opened;
}

int __wrap_iconv_close(iconv_t old)
{
    for (int i = 0; i < converters; i++)
        if (converter[i] == old)
            converter[i] = converter[--converters];
    return __real_iconv_close(old);
}

/* ---- Files ---- */

int __real_file_to_read(const char *path);
int __real_file_to_write(const char *path);
int __wrap_file_to_read(const char *path);
int __wrap_file_to_write(const char *path);

static int keep_file(int descriptor)
{
    fail_unless(files < FILES);
    if (is_inside && descriptor >= 0)
        file[files++] = descriptor;
    return descriptor;
}

int __wrap_file_to_read(const char *path)
{
    return keep_file(__real_file_to_read(path));
}

int __wrap_file_to_write(const char *path)
{
    return keep_file(__real_file_to_write(path));
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

/* A file that the part has closed itself has no descriptor any more. */
static void take_back(void)
{
    for (int i = 0; i < pieces; i++)
        __real_free(memory[i]);
    for (int i = 0; i < files; i++)
        close(file[i]);
    for (int i = 0; i < converters; i++)
        __real_iconv_close(converter[i]);
    pieces = files = converters = 0;
}

int until_exit(void (*part)(void *context), void *context)
{
    is_inside = true;
    status_of_exit = NO_EXIT;
    if (setjmp(outside) == 0)
        part(context);
    is_inside = false;
    take_back();
    return status_of_exit;
}
