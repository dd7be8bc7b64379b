/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The only file that knows iconv. */
#include "input.h"

#include "system/system.h"

#include <errno.h>
#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

#include <iconv.h>

enum { BLOCK = 1 << 16 };

/* What callers see comes first. */
typedef struct {
    text_input seen;
    const char *encoding; /* NULL for UTF-8 */
    FILE *file;
    iconv_t converter; /* from UTF-8 too: it knows what is none */
    bool has_converter, started, at_end;
    char block[BLOCK];    /* as it is in the file */
    size_t begin, end;    /* what of the block has not been converted */
    int64_t line, column; /* of the character that comes next, from 1 */
    bool after_return;
} source;

/* ---- Opening ---- */

void text_input_check(const char *encoding)
{
    const iconv_t converter = iconv_open("UTF-8", encoding);
    if (converter == (iconv_t)-1 && errno == EINVAL)
        usage_error("--encoding %s: unknown encoding; allowed: utf-8, utf-16, windows-1252, and "
                    "others that iconv knows",
                    encoding);
    if (converter != (iconv_t)-1) /* a lack of memory shows when it is read */
        iconv_close(converter);
}

text_input *text_input_open(const char *path, const char *encoding)
{
    const bool standard = strcmp(path, "-") == 0;
    source *in = memory_zeroed(1, sizeof *in);
    in->seen.name = standard ? "standard input" : path;
    in->encoding = encoding;
    in->line = in->column = 1;
    in->file = standard ? stdin : file_to_read(path);
    if (in->file == NULL)
        complain(&in->seen.problem, "%s: %s", path, file_problem(errno));
    return &in->seen;
}

/* ---- Bytes ---- */

/* Fills the block, unless the file ends before. */
static bool fill(source *in)
{
    memmove(in->block, in->block + in->begin, in->end - in->begin);
    in->end -= in->begin;
    in->begin = 0;
    if (!in->at_end)
        in->end += fread(in->block + in->end, 1, BLOCK - in->end, in->file);
    in->at_end = in->end < BLOCK;
    return !ferror(in->file) ||
           complain(&in->seen.problem, "%s: %s", in->seen.name, file_problem(errno));
}

static bool begins_with(const source *in, const char *mark, size_t length)
{
    return in->end >= length && memcmp(in->block, mark, length) == 0;
}

/* The marks of UTF-8 and UTF-16 say more than nothing, and may contradict what was said. For iconv
 * a mark is a character where the encoding says the order of the bytes. */
static bool take_mark(source *in)
{
    static const char utf8[] = "\xef\xbb\xbf", little[] = "\xff\xfe", big[] = "\xfe\xff";
    const bool is_utf8 = begins_with(in, utf8, 3),
               is_utf16 = begins_with(in, little, 2) || begins_with(in, big, 2);
    in->started = true;
    if (begins_with(in, "PK\x03\x04", 4))
        return complain(&in->seen.problem,
                        "%s: a spreadsheet, or another archive; allowed: text: save it as CSV",
                        in->seen.name);
    in->seen.has_mark = is_utf8 || is_utf16;
    if (is_utf8 && in->encoding != NULL && strcasecmp(in->encoding, "utf-8") != 0)
        return complain(&in->seen.problem,
                        "--encoding %s: %s begins with the mark of UTF-8; allowed: utf-8",
                        in->encoding, in->seen.name);
    if (is_utf16 && in->encoding == NULL)
        in->encoding = "utf-16";
    if (is_utf8)
        in->begin = 3;
    else if (is_utf16 && strcasecmp(in->encoding, "utf-16") != 0)
        in->begin = 2;
    const char *encoding = in->encoding != NULL ? in->encoding : "utf-8";
    in->converter = iconv_open("UTF-8", encoding);
    in->has_converter = in->converter != (iconv_t)-1;
    return in->has_converter || complain(&in->seen.problem, "%s: reading %s: %s", in->seen.name,
                                         encoding, strerror(errno));
}

/* ---- Characters ---- */

static bool stop_here(source *in, const char *why)
{
    return complain(&in->seen.problem, "%s: line %" PRId64 ", column %" PRId64 ": %s",
                    in->seen.name, in->line, in->column, why);
}

static bool refuse_byte(source *in, char byte)
{
    char why[200];
    if (in->encoding != NULL)
        snprintf(why, sizeof why, "the byte %02X is no character of %.40s", (unsigned char)byte,
                 in->encoding);
    else
        snprintf(why, sizeof why,
                 "the byte %02X is not UTF-8; allowed: UTF-8, UTF-16 with its mark, or --encoding, "
                 "such as windows-1252",
                 (unsigned char)byte);
    return stop_here(in, why);
}

/* Looks at every character. Lines end with a return, a line feed, or both. */
static bool check(source *in, const char *bytes, size_t count)
{
    char why[120];
    uint32_t code;
    for (size_t i = 0, length; i < count; i += length) {
        code = (unsigned char)bytes[i];
        length = code < 0x80 ? 1 : utf8_length(bytes + i, count - i, &code);
        if (length == 0)
            return refuse_byte(in, bytes[i]);
        if (!utf8_is_text(code)) {
            snprintf(why, sizeof why,
                     "the character U+%04" PRIX32
                     " belongs to no text; allowed: text, no binary files",
                     code);
            return stop_here(in, why);
        }
        in->line += code == '\r' || (code == '\n' && !in->after_return);
        in->column = code == '\r' || code == '\n' ? 1 : in->column + 1;
        in->after_return = code == '\r';
    }
    return true;
}

/* Converts what has room, and returns its bytes. errno is EILSEQ where a character does not exist
 * in the encoding, or is cut by the end of the file; else 0. */
static size_t convert(source *in, char *bytes, size_t size)
{
    char *from = in->block + in->begin, *to = bytes;
    size_t left = in->end - in->begin, free_bytes = size;
    errno = 0;
    if (iconv(in->converter, &from, &left, &to, &free_bytes) != (size_t)-1)
        errno = 0;
    const bool cut = errno == EINVAL && in->at_end;
    errno = cut || errno == EILSEQ ? EILSEQ : 0;
    in->begin = (size_t)(from - in->block);
    return size - free_bytes;
}

bool text_input_read(text_input *seen, char *bytes, size_t size, size_t *count)
{
    source *in = (source *)seen;
    do {
        if (!fill(in) || (!in->started && !take_mark(in)))
            return false;
        *count = convert(in, bytes, size);
        const bool sound = errno == 0;
        if (!check(in, bytes, *count))
            return false;
        if (!sound)
            return refuse_byte(in, in->block[in->begin]);
    } while (*count == 0 && !(in->at_end && in->begin == in->end));
    return true;
}

void text_input_close(text_input *seen)
{
    source *in = (source *)seen;
    if (in->has_converter)
        iconv_close(in->converter);
    if (in->file != NULL && in->file != stdin)
        fclose(in->file);
    free(in);
}
