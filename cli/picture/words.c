/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "words.h"

#include <stdbool.h>
#include <stddef.h>
#include <string.h>

static double width_of(const char *letter)
{
    if (letter[0] == '*' || letter[0] == '_' || ((unsigned char)letter[0] & 0xc0) == 0x80)
        return 0; /* marks, and what continues a letter of UTF-8 */
    if (strncmp(letter, "−", strlen("−")) == 0 || strncmp(letter, "←", strlen("←")) == 0 ||
        strncmp(letter, "→", strlen("→")) == 0)
        return 0.84;
    if (strchr(" .,:;/()iljtIf", letter[0]) != NULL)
        return 0.37;
    return strchr("=+<>mwWM", letter[0]) != NULL ? 0.84 : 0.64;
}

static double width_of_part(const char *text, size_t length)
{
    double width = 0;
    for (size_t i = 0; i < length; i++)
        width += width_of(text + i);
    return width;
}

double words_width(const char *text)
{
    return width_of_part(text, strlen(text));
}

int words_wrap(char *text, double width)
{
    int lines = 1;
    char *start = text, *end = NULL; /* of the line, and where it may end */
    for (char *c = text; *c != '\0'; c++) {
        const bool may_end = *c == ' ' && c > text && strchr(",;", c[-1]) != NULL;
        const bool part_ends = may_end || c[1] == '\0';
        const size_t length = (size_t)(c - start) + (c[1] == '\0');
        if (part_ends && end != NULL && width_of_part(start, length) > width) {
            *end = '\n';
            start = end + 1;
            end = NULL;
            lines++;
        }
        if (may_end)
            end = c;
    }
    return lines;
}
