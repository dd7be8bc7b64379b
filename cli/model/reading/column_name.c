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
    if (code == 0xb7 || code == 0x22c5 || code == 0x207b || code == 0x2212)
        return '.'; /* between units, and a minus */
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

/* A single letter must have its case: n is a number, N are newtons. */
static bool is_unit(const char *word, size_t length)
{
    static const char *const units[] = {
        "N",    "mN",   "daN",       "kN",        "MN",       "newton", "lb",
        "lbs",  "lbf",  "kip",       "kgf",       "Pa",       "hPa",    "kPa",
        "MPa",  "GPa",  "bar",       "psi",       "ksi",      "m",      "cm",
        "mm",   "um",   "\xc2\xb5m", "in",        "ft",       "inch",   "inches",
        "Nm",   "Nmm",  "kNm",       "\xce\xbcm", "deg",      "rad",    "degree",
        "mrad", "grad", "degrees",   "radians",   "\xc2\xb0", "%",      "percent"};
    while (length > 1 && isdigit((unsigned char)word[length - 1]))
        length--; /* mm2 */
    for (size_t i = 0; i < sizeof units / sizeof units[0]; i++)
        if (strlen(units[i]) == length &&
            (length == 1 ? word[0] == units[i][0] : strncasecmp(word, units[i], length) == 0))
            return true;
    return false;
}

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
        if (length > 0 && !power && !is_unit(text, length))
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
