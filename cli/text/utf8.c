/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "text.h"

#include <string.h>

/* How many bytes the first one announces; 0 where it cannot be the first. */
static size_t announced(unsigned char first)
{
    if (first < 0x80)
        return 1;
    if (first < 0xc2 || first > 0xf4)
        return 0;
    return first < 0xe0 ? 2 : first < 0xf0 ? 3 : 4;
}

size_t utf8_length(const char *bytes, size_t count, uint32_t *code)
{
    static const uint32_t least[] = {0, 0, 0x80, 0x800, 0x10000};
    const size_t length = count > 0 ? announced((unsigned char)bytes[0]) : 0;
    if (length == 0 || length > count)
        return 0;
    uint32_t value = (unsigned char)bytes[0] & (length == 1 ? 0x7f : 0x7f >> length);
    for (size_t i = 1; i < length; i++) {
        const unsigned char next = (unsigned char)bytes[i];
        if ((next & 0xc0) != 0x80)
            return 0;
        value = value << 6 | (next & 0x3f);
    }
    const bool surrogate = value >= 0xd800 && value < 0xe000;
    if (value < least[length] || value > 0x10ffff || surrogate)
        return 0;
    *code = value;
    return length;
}

bool utf8_is_text(uint32_t code)
{
    const bool control = code < ' ' && code != '\t' && code != '\n' && code != '\r';
    return !control && code != 0xfffe && code != 0xffff;
}

bool utf8_is_whole(const char *text)
{
    uint32_t code;
    size_t left = strlen(text), length = 1;
    for (; left > 0 && length > 0; text += length, left -= length) {
        length = utf8_length(text, left, &code);
        if (length == 0 || !utf8_is_text(code))
            return false;
    }
    return true;
}

bool utf8_is_command(uint32_t code)
{
    const bool control = code < ' ' || (code >= 0x7f && code < 0xa0);
    const bool direction = code == 0x61c || code == 0x200e || code == 0x200f ||
                           (code >= 0x202a && code <= 0x202e) || (code >= 0x2066 && code <= 0x2069);
    return control || direction;
}

bool utf8_copy(const char *text, bool (*allowed)(uint32_t code), const char *replacement,
               char *copy, size_t size)
{
    size_t used = 0, left = strlen(text), length;
    for (; left > 0; text += length, left -= length) {
        uint32_t code;
        length = utf8_length(text, left, &code);
        const bool keep = length > 0 && allowed(code);
        const char *from = keep ? text : replacement;
        const size_t bytes = keep ? length : strlen(replacement);
        length = length > 0 ? length : 1;
        if (used + bytes >= size)
            break;
        memcpy(copy + used, from, bytes);
        used += bytes;
    }
    copy[used] = '\0';
    return left == 0;
}
