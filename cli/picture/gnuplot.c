/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "picture.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>

enum { SCRIPT, PICTURE, COMPLAINTS, STREAMS }; /* numbered as gnuplot's standard streams */

/* What would change the picture: the locale, and the date in a PDF. Cairo 1.18 compresses the date
 * too, where remove_date() cannot see it. CAIRO_DEBUG_PDF tells it to compress nothing. */
static const char *const settings[] = {"LC_ALL=C", "GNUTERM=dumb",      "SOURCE_DATE_EPOCH=0",
                                       "TZ=UTC0",  "CAIRO_DEBUG_PDF=1", NULL};

/* What a file holds, with a 0 after it. */
static char *read_whole(FILE *file, size_t *length)
{
    const long end = fseek(file, 0, SEEK_END) == 0 ? ftell(file) : -1;
    if (end < 0)
        failure("gnuplot: %s", strerror(errno));
    char *text = memory_zeroed((size_t)end + 1, 1);
    rewind(file);
    *length = fread(text, 1, (size_t)end, file);
    return text;
}

/* ---- What gnuplot has to say ---- */

/* The last line that says something; gnuplot shows the failing line of the script above it. */
static const char *last_line(char *text)
{
    char *end = text + strlen(text);
    while (end > text && strchr(" \t\r\n", end[-1]) != NULL)
        *--end = '\0';
    const char *line = strrchr(text, '\n');
    line = line != NULL ? line + 1 : text;
    return line + strspn(line, " \t\r");
}

NO_RETURN static void refuse(FILE *complaints, const char *event, int number)
{
    size_t length;
    const char *said = last_line(read_whole(complaints, &length));
    failure("gnuplot %s %d%s%.400s; needed: gnuplot 5 with its terminals svg, pngcairo, pdfcairo "
            "(package gnuplot-nox)",
            event, number, said[0] != '\0' ? ": " : "", said);
}

/* ---- The picture ---- */

static bool is_whole(const char *picture, size_t length, const picture_format *format)
{
    enum { TAIL = 32 }; /* blanks may follow the end */
    if (length < format->begins_length + format->ends_length ||
        memcmp(picture, format->begins, format->begins_length) != 0)
        return false;
    const size_t last = length - format->ends_length;
    for (size_t at = last; at + TAIL > last && at > 0; at--)
        if (memcmp(picture + at, format->ends, format->ends_length) == 0)
            return true;
    return false;
}

/* The date of a PDF, for the same bytes tomorrow; as many characters as before, since the file
 * counts its bytes. */
static void remove_date(char *picture, size_t length)
{
    static const char key[] = "/CreationDate (D:", usual[] = "20000101000000";
    const size_t before = sizeof key - 1, digits = sizeof usual - 1;
    for (size_t i = 0; i + before + digits <= length; i++)
        if (memcmp(picture + i, key, before) == 0 &&
            strspn(picture + i + before, "0123456789") == digits)
            memcpy(picture + i + before, usual, digits);
}

/* In an SVG, viewers drop a space where the font changes, unless told to keep it. */
static void write_picture(const char *picture, size_t length, bool needs_spaces, output *out)
{
    static const char start[] = "<svg";
    const char *root = needs_spaces ? strstr(picture, start) : NULL;
    const size_t before = root != NULL ? (size_t)(root - picture) + strlen(start) : 0;
    output_write(out, picture, before);
    if (root != NULL)
        output_text(out, " xml:space=\"preserve\"");
    output_write(out, picture + before, length - before);
}

static void take_picture(FILE *const stream[], const picture_format *format, output *out)
{
    size_t length;
    char *picture = read_whole(stream[PICTURE], &length);
    if (!is_whole(picture, length, format))
        refuse(stream[COMPLAINTS], "gave no whole picture, but bytes:", (int)(length % 1000000000));
    remove_date(picture, length);
    write_picture(picture, length, format->needs_spaces, out);
    free(picture);
}

/* ---- gnuplot ---- */

static void put_script(const drawing *plot, const picture_format *format, FILE *script)
{
    gnuplot_script(plot, format, script);
    if (fflush(script) != 0 || ferror(script))
        failure("gnuplot: its script cannot be written: %s", strerror(errno));
    rewind(script);
}

static void run(FILE *const stream[])
{
    /* without the user's own start file; from standard input itself gnuplot reads byte by byte */
    const char *const words[] = {"gnuplot", "--default-settings", program_input_name, NULL};
    program_end end;
    const int error = program_run(words, settings, stream, &end);
    if (error == ENOENT)
        failure("gnuplot: not found on PATH; it draws the figures: install it (on Debian and "
                "Ubuntu the package gnuplot-nox), or use --data");
    if (error != 0)
        failure("gnuplot: %s", strerror(error));
    if (end.by_signal || end.number != 0)
        refuse(stream[COMPLAINTS], end.by_signal ? "was ended by signal" : "ended with status",
               end.number);
}

/* Files, not pipes: neither side waits for the other. */
void gnuplot_draw(const drawing *plot, const picture_format *format, output *out)
{
    FILE *stream[STREAMS];
    for (int i = 0; i < STREAMS; i++) {
        stream[i] = stream_temporary();
        if (stream[i] == NULL)
            failure("gnuplot: a temporary file cannot be made: %s", strerror(errno));
    }
    put_script(plot, format, stream[SCRIPT]);
    run(stream);
    take_picture(stream, format, out);
    for (int i = 0; i < STREAMS; i++)
        fclose(stream[i]);
}
