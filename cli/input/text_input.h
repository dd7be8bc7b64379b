/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A file of text, read as UTF-8 whatever its encoding. What is no text is refused here, so that
 * every format can write what was read. */
#ifndef CLI_TEXT_INPUT_H
#define CLI_TEXT_INPUT_H

#include <stdbool.h>
#include <stddef.h>

typedef struct text_input text_input;

/* Refuses an encoding that iconv does not know, by the name of --encoding. */
void text_input_check(const char *encoding);

/* Opens a file, or standard input where path is "-". The encoding is one that iconv knows; NULL is
 * UTF-8, or UTF-16 where the file begins with its mark. */
text_input *text_input_open(const char *path, const char *encoding);

/* Why it cannot be opened, or read on; an empty text as long as it can. */
const char *text_input_problem(const text_input *in);

/* Reads whole characters into room for at least 4 bytes; *count is 0 at the end. False, with the
 * problem, where it cannot be read, or has what is no text: the problem names the file, the line
 * and the column, which is the number of the character in the line. */
bool text_input_read(text_input *in, char *bytes, size_t room, size_t *count);

/* Whether it began with the mark that some programs put before Unicode; to be asked once it has
 * been read from. */
bool text_input_has_mark(const text_input *in);

/* As messages call it. */
const char *text_input_name(const text_input *in);

void text_input_close(text_input *in);

#endif
