/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Characters of UTF-8, and which of them a text may have. */
#ifndef CLI_UTF8_H
#define CLI_UTF8_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

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
               char *room, size_t size);

#endif
