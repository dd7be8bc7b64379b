/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef CLI_TEXT_H
#define CLI_TEXT_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* ---- printf_like ---- */

/* Tells a compiler that knows the format of printf() to check it. */
#ifdef __MINGW32__ /* C's formats, not those of Windows */
#define PRINTF_LIKE(text, first) __attribute__((format(gnu_printf, text, first)))
#elif defined(__GNUC__)
#define PRINTF_LIKE(text, first) __attribute__((format(printf, text, first)))
#else
#define PRINTF_LIKE(text, first)
#endif

/* ---- message ---- */

/* What the tool says on stderr, one line at a time. A mistake ends the command: what must be
 * cleaned up is cleaned up by atexit(), and memory is the system's to take back. */
#ifdef __GNUC__
#define NO_RETURN __attribute__((noreturn))
#else
#define NO_RETURN
#endif

enum { STATUS_DONE = 0, STATUS_FAILED = 1, STATUS_USAGE = 2 };

/* The name with which every message begins from now on, such as "rwedge table". The text is kept,
 * not copied. */
void message_speaker_is(const char *speaker);
const char *message_speaker(void);

/* One line on stderr, and exit() with STATUS_USAGE or STATUS_FAILED. They do not return. The line
 * names the option or the file, its value, and what is allowed or what went wrong. To be called by
 * the first thread alone, and not at exit. */
NO_RETURN int usage_error(const char *format, ...) PRINTF_LIKE(1, 2);
NO_RETURN int failure(const char *format, ...) PRINTF_LIKE(1, 2);

/* A line on stderr that is no failure: something that the user should know about a result. None
 * where it is "". */
void notice(const char *format, ...) PRINTF_LIKE(1, 2);

/* ---- memory ---- Memory, or the end of the command with a message. */

/* They are calloc() and realloc() that never return NULL. The first thread alone may call them. */
void *memory_zeroed(size_t count, size_t size);
void *memory_resized(void *old, size_t size);

/* Makes room for one more element of a list of `count` elements: the list doubles at powers of
 * two. */
void *memory_for_one_more(void *old, size_t count, size_t size);

/* A pointer from another function: ends the command where it is NULL. */
void *memory_checked(void *memory);

/* ---- list ---- Texts that are put together. */

/* What is wrong: the line of a message, or the error of a row. */
typedef struct {
    char text[600];
} complaint;

/* Writes it as by printf; false. */
bool complain(complaint *why, const char *format, ...) PRINTF_LIKE(2, 3);

/* Adds a part, made as by printf, to a text such as "csv, tsv, json"; the separator goes in front
 * of all but the first. What has no room is cut. */
void list_add(char *text, size_t size, const char *separator, const char *format, ...)
    PRINTF_LIKE(4, 5);

/* ---- nearest ---- Which of several names was meant by one that does not exist. */

typedef struct {
    const char *typed, *name; /* NULL where none is near */
    size_t distance;
} nearest_name;

nearest_name nearest_to(const char *typed);

/* Offers one of the names. */
void nearest_try(nearest_name *to, const char *name);

/* ---- utf8 ---- Characters of UTF-8, and which of them a text may have. */

/* The bytes of the character at the start of these, 1 to 4, and its code; 0 where none starts
 * there, or only a part of one is there. */
size_t utf8_length(const char *bytes, size_t count, uint32_t *code);

/* Whether XML, and so every format, can hold the character: not so control characters but tab, line
 * feed and return, nor U+FFFE and U+FFFF. */
bool utf8_is_text(uint32_t code);

/* Whether all of a text is characters of that kind. */
bool utf8_is_whole(const char *text);

/* Whether a terminal would take the character for a command, or reverse the text: control
 * characters, marks of direction. */
bool utf8_is_command(uint32_t code);

/* Copies a text, up to a whole character where the room ends. What `allowed` does not allow, and
 * what is no character, becomes the replacement. Returns whether all of it had room. */
bool utf8_copy(const char *text, bool (*allowed)(uint32_t code), const char *replacement,
               char *copy, size_t size);

/* ---- invocation ---- The command line, for files that say how they were made. */

/* Keeps it: "rwedge" and the words that follow, quoted where a shell needs it. Of an output file
 * only the name is kept, not its folder: the same command writes the same file wherever it is
 * called. It is UTF-8 that every format can hold, and ends with "..." where it is long. */
void invocation_keep(int argc, const char *const argv[]);

const char *invocation(void);

#endif
