/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "figure.h"

#include <errno.h>
#include <string.h>

/* ---- The paper ---- */

typedef struct {
    const char *name;          /* of the format, and of the file's extension */
    const char *terminal;      /* what gnuplot is told, with the width and the height */
    double width;              /* in the terminal's unit */
    double line;               /* the height of a line of text over that */
    const char *begins, *ends; /* how a whole file starts, and what is in its last bytes */
} picture_format;

/* 85 mm, the width of a journal's column: 241 pt, 1004 dots at 300 to the inch. The SVG is 480
 * pixels wide, as a page on the screen shows it; text and lines are in the same proportion to
 * the width in all three. */
static const picture_format picture_formats[] = {
    {"svg",
     "svg size %.0f,%.0f enhanced font 'sans-serif,15' linewidth 1.6 background '#ffffff' butt",
     480, 0.043, "<?xml", "</svg>"},
    {"png",
     "pngcairo size %.0f,%.0f enhanced font 'sans-serif,8' fontscale 3.2 linewidth 3.3 pointscale "
     "3.5 dashlength 1.6 background '#ffffff' butt",
     1004, 0.034, "\x89PNG\r\n\x1a\n", "IEND\xae\x42\x60\x82"},
    {"pdf",
     "pdfcairo size %.3fcm,%.3fcm enhanced font 'sans-serif,8' fontscale 0.8 linewidth 1.6 "
     "pointscale 0.9 background '#ffffff' butt",
     8.5, 0.034, "%PDF-", "%%EOF"},
};

/* ---- gnuplot ---- */

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

/* Ends with the last line that says something; gnuplot shows the failing line of the script above
 * it. */
NO_RETURN static void refuse(FILE *complaints, const char *event, int number)
{
    size_t length;
    char *text = read_whole(complaints, &length), *end = text + strlen(text);
    while (end > text && strchr(" \t\r\n", end[-1]) != NULL)
        *--end = '\0';
    const char *line = strrchr(text, '\n'), *said = line != NULL ? line + 1 : text;
    said += strspn(said, " \t\r");
    failure("gnuplot %s %d%s%.400s; needed: gnuplot 5 with its terminals svg, pngcairo, pdfcairo "
            "(package gnuplot-nox)",
            event, number, said[0] != '\0' ? ": " : "", said);
}

/* ---- The picture ---- */

static bool is_whole(const char *picture, size_t length, const picture_format *format)
{
    enum { TAIL = 32 }; /* blanks may follow the end */
    const size_t begins = strlen(format->begins), ends = strlen(format->ends);
    if (length < begins + ends || memcmp(picture, format->begins, begins) != 0)
        return false;
    const size_t last = length - ends;
    for (size_t at = last; at + TAIL > last && at > 0; at--)
        if (memcmp(picture + at, format->ends, ends) == 0)
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

/* Viewers of an SVG drop a space where the font changes, unless told to keep it. */
static void take_picture(FILE *const stream[], const picture_format *format, bool is_part,
                         output *out)
{
    static const char start[] = "<svg";
    size_t length;
    char *picture = read_whole(stream[PICTURE], &length);
    if (!is_whole(picture, length, format))
        refuse(stream[COMPLAINTS], "gave no whole picture, but bytes:", (int)(length % 1000000000));
    remove_date(picture, length);
    const char *root = strcmp(format->name, "svg") == 0 ? strstr(picture, start) : NULL;
    const size_t before = root != NULL ? (size_t)(root - picture) + strlen(start) : 0;
    const size_t skipped = is_part ? before - strlen(start) : 0;
    output_write(out, picture + skipped, before - skipped);
    if (root != NULL)
        output_text(out, " xml:space=\"preserve\"");
    output_write(out, picture + before, length - before);
}

/* ---- gnuplot ---- */

static void run(FILE *const stream[], bool is_part)
{
    /* without the user's own start file; from standard input itself gnuplot reads byte by byte */
    const char *const words[] = {"gnuplot", "--default-settings", program_input_name, NULL};
    program_end end;
    const int error = program_run(words, settings, stream, &end);
    if (error == ENOENT)
        failure("gnuplot: not found on PATH; it draws the figures: install it (on Debian and "
                "Ubuntu the package gnuplot-nox), or use %s",
                is_part ? "--no-pictures" : "--data");
    if (error != 0)
        failure("gnuplot: %s", strerror(error));
    if (end.by_signal || end.number != 0)
        refuse(stream[COMPLAINTS], end.by_signal ? "was ended by signal" : "ended with status",
               end.number);
}

/* Files, not pipes: neither side waits for the other. */
void gnuplot_draw(const figure_case *inputs, const dataset *rows, output *out)
{
    const picture_format *format = picture_formats;
    while (strcmp(format->name, inputs->format) != 0)
        format++;
    FILE *stream[STREAMS];
    for (int i = 0; i < STREAMS; i++) {
        stream[i] = stream_temporary();
        if (stream[i] == NULL)
            failure("gnuplot: a temporary file cannot be made: %s", strerror(errno));
    }
    script_text(stream[SCRIPT], "terminal", format->terminal);
    script_number(stream[SCRIPT], "paper", format->width);
    script_number(stream[SCRIPT], "line", format->line);
    script_write(inputs, rows, stream[SCRIPT]);
    if (fflush(stream[SCRIPT]) != 0 || ferror(stream[SCRIPT]))
        failure("gnuplot: its script cannot be written: %s", strerror(errno));
    rewind(stream[SCRIPT]);
    run(stream, inputs->is_part);
    take_picture(stream, format, inputs->is_part, out);
    for (int i = 0; i < STREAMS; i++)
        fclose(stream[i]);
}
