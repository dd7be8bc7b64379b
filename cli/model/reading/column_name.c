/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "reading.h"

#include <ctype.h>
#include <string.h>
#include <strings.h>

/* Letters beyond ASCII count, byte by byte. */
static bool is_filler(char c)
{
    return (unsigned char)c < 0x80 && !isalnum((unsigned char)c);
}

/* ---- Characters that look alike ---- */

/* The ASCII character that a code looks like; 0 where it looks like none. */
static char plain_letter(uint32_t code)
{
    if (code > 0xff00 && code < 0xff5f)
        return (char)(code - 0xfee0); /* full-width forms */
    if ((code >= 0x2080 && code <= 0x2089) || (code >= 0x2074 && code <= 0x2079))
        return (char)('0' + code % 16); /* subscripts and powers */
    if (code == 0xb2 || code == 0xb3)
        return (char)('0' + code % 16);
    if (code == 0xb9)
        return '1';
    if (code == 0xb7 || code == 0x22c5)
        return '.'; /* between units */
    if (code == 0x207b || code == 0x2212)
        return '-';
    if (code == 0xa0 || (code >= 0x2000 && code <= 0x200f) || code == 0x202f || code == 0x205f ||
        code == 0x2060 || code == 0x3000 || code == 0xfeff)
        return ' ';
    return '\0';
}

size_t column_name_make_plain(const char *name, char plain[COLUMN_NAME_SIZE])
{
    size_t used = 0, left = strlen(name), length;
    for (; left > 0 && used + 4 < COLUMN_NAME_SIZE; name += length, left -= length) {
        uint32_t code = 0;
        length = utf8_length(name, left, &code);
        length = length > 0 ? length : 1;
        const char letter = plain_letter(code);
        memcpy(plain + used, letter != '\0' ? &letter : name, letter != '\0' ? 1 : length);
        used += letter != '\0' ? 1 : length;
    }
    plain[used] = '\0';
    return used;
}

bool column_name_is_like(const char *a, size_t length, const char *b)
{
    for (const char *end = a + length;; a++, b++) {
        while (a < end && is_filler(*a))
            a++;
        while (*b != '\0' && is_filler(*b))
            b++;
        if (a == end || *b == '\0')
            return a == end && *b == '\0';
        if (tolower((unsigned char)*a) != tolower((unsigned char)*b))
            return false;
    }
}

/* ---- Units ---- */

static size_t word_length(const char *text)
{
    size_t length = 0;
    while (text[length] != '\0' && !is_filler(text[length]))
        length++;
    return length == 0 && text[0] == '%' ? 1 : length;
}

/* Whether a text is a unit alone, as "/ N", " in N/mm^2", "_mm". "in" says that one follows. */
static bool is_unit_text(const char *text)
{
    bool any = false;
    while (*text != '\0') {
        const size_t length = word_length(text);
        if (!any && length == 2 && strncmp(text, "in ", 3) == 0)
            return true;
        const bool power = any && length == strspn(text, "0123456789");
        if (length > 0 && !power && !unit_is_word(text, length))
            return false;
        any = any || length > 0;
        text += length > 0 ? length : 1;
    }
    return any;
}

size_t column_name_stem(const char *plain)
{
    const size_t bracket = strcspn(plain, "[({<");
    if (plain[bracket] != '\0')
        return bracket;
    for (size_t i = 1; i < bracket; i++)
        if (is_filler(plain[i]) && is_unit_text(plain + i))
            return i;
    return bracket;
}

/* ---- The unit of a name ---- */

/* Without what joins a name to its unit. A point or a bracket belongs to the name: "Load(8801:Load)
 * (N)", "u rel. [um]". */
static size_t trimmed(const char *text, size_t length)
{
    while (length > 0 && strchr(" \t_/,;:-=", text[length - 1]) != NULL)
        length--;
    return length;
}

static void copy_unit(const char *from, size_t length, char own[COLUMN_NAME_SIZE])
{
    while (length > 0 && (from[0] == ' ' || from[0] == '_' || from[0] == '/' || from[0] == ','))
        from++, length--;
    if (length > 3 && strncmp(from, "in ", 3) == 0)
        from += 3, length -= 3;
    while (length > 0 && from[length - 1] == ' ')
        length--;
    memcpy(own, from, length);
    own[length] = '\0';
}

/* The group of brackets that ends the text: where it begins; the length where there is none. */
static size_t last_group(const char *plain, size_t length)
{
    static const char open[] = "[({<", close[] = "])}>";
    const char *kind = length > 0 ? strchr(close, plain[length - 1]) : NULL;
    if (kind == NULL || *kind == '\0')
        return length;
    for (size_t i = length - 1; i-- > 0;)
        if (plain[i] == open[kind - close])
            return i;
    return length;
}

size_t column_name_unit(const char *plain, char own[COLUMN_NAME_SIZE])
{
    size_t length = strlen(plain);
    measuring_unit known;
    while (length > 0 && plain[length - 1] == ' ')
        length--;
    const size_t group = last_group(plain, length);
    own[0] = '\0';
    if (group < length) {
        copy_unit(plain + group + 1, length - group - 2, own);
        if (strcmp(own, "-") == 0 || strcmp(own, "1") == 0)
            own[0] = '\0';
        return trimmed(plain, group);
    }
    for (size_t i = 1; i < length; i++)
        if (is_filler(plain[i]) && is_unit_text(plain + i)) {
            copy_unit(plain + i, length - i, own);
            if (unit_read(own, &known))
                return trimmed(plain, i);
        }
    own[0] = '\0';
    return length;
}
