/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "picture.h"

#include <errno.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* ---- Its script: the data are in here-documents ---- */

/* Writes a drawing in the language of gnuplot 5. The data are in here-documents. */
typedef struct {
    const char *name; /* of the format, and of the file's extension */
    /* what gnuplot is told, with the picture's height over its width as %g */
    const char *terminal;
    double width;              /* in the terminal's unit */
    double line;               /* the height of a line of text over that */
    const char *begins, *ends; /* how a whole file starts, and what is in its last bytes */
    size_t begins_length, ends_length;
    bool needs_spaces; /* its viewers have to be told to keep them */
} picture_format;

/* 85 mm, the width of a journal's column: 241 pt, 1004 dots at 300 to the inch. The SVG is 480
 * pixels wide, as a page on the screen shows it; text and lines are in the same proportion to
 * the width in all three. */
static const picture_format picture_formats[] = {
    {"svg",
     "svg size %.0f,%.0f enhanced font 'sans-serif,15' linewidth 1.6 background '#ffffff' butt",
     480, 0.043, "<?xml", "</svg>", 5, 6, true},
    {"png",
     "pngcairo size %.0f,%.0f enhanced font 'sans-serif,8' fontscale 3.2 linewidth 3.3 pointscale "
     "3.5 dashlength 1.6 background '#ffffff' butt",
     1004, 0.034, "\x89PNG\r\n\x1a\n", "IEND\xae\x42\x60\x82", 8, 8, false},
    {"pdf",
     "pdfcairo size %.3fcm,%.3fcm enhanced font 'sans-serif,8' fontscale 0.8 linewidth 1.6 "
     "pointscale 0.9 background '#ffffff' butt",
     8.5, 0.034, "%PDF-", "%%EOF", 5, 5, false},
};

static const char *const colours[PALETTE_SIZE] = {
    [BLACK] = "#000000",  [BLUE] = "#0072b2",   [VERMILLION] = "#d55e00", [GREEN] = "#009e73",
    [PURPLE] = "#cc79a7", [ORANGE] = "#e69f00", [SKY] = "#56b4e9"};

static const char *const dashes[DASHES] = {"solid", "(9,4)", "(3,3)", "(9,3,2,3)", "(15,4)"};

/* *a* -> {/:Italic a}; an underscore means the same in both. */
static void put_words(FILE *script, const char *text)
{
    bool italic = false;
    for (const char *c = text; *c != '\0'; c++)
        if (*c == '*') {
            fputs(italic ? "}" : "{/:Italic ", script);
            italic = !italic;
        } else {
            if (*c == '"' || *c == '\\')
                fputs("\\", script);
            if (*c == '\n')
                fputs("\\n", script);
            else
                putc(*c, script);
        }
}

static void put_text(FILE *script, const char *text)
{
    fputs("\"", script);
    put_words(script, text);
    fputs("\"", script);
}

static void put_axis(FILE *script, const char *name, const axis *shown)
{
    fprintf(script, "set %slabel ", name);
    put_text(script, shown->text);
    fprintf(script, "\nset %srange [%.9g:%.9g]\nset format %s '%%g'\n", name, shown->from,
            shown->to, name);
    if (shown->tic_end != 0)
        fprintf(script, "set %stics 0,%.9g,%.9g\n", name, shown->tic, shown->tic_end);
    else
        fprintf(script, "set %stics %.9g\n", name, shown->tic);
}

/* What stands below an axis is a line more of its text. */
static void put_caption(FILE *script, const char *axis_text, const char *caption)
{
    if (caption[0] == '\0')
        return;
    fputs("set xlabel \"", script);
    put_words(script, axis_text);
    fputs("\\n", script);
    put_words(script, caption);
    fputs("\\n{/*0.4  }\"\n", script); /* a low line above the names of the curves */
}

/* Of the height of the plot to its width; the scale of both axes is the same where it is free. */
static double proportion(const drawing *plot)
{
    return plot->height > 0 ? plot->height
                            : fabs((plot->y.to - plot->y.from) / (plot->x.to - plot->x.from));
}

static int lines_of(const char *text)
{
    int lines = text[0] != '\0';
    for (const char *c = text; *c != '\0'; c++)
        lines += *c == '\n';
    return lines;
}

/* About how many the names of the curves take: gnuplot arranges them. */
static int lines_of_legend(const drawing *plot)
{
    static const double LETTERS = 36, SAMPLE = 7;
    size_t longest = 0;
    int entries = 0;
    for (int i = 0; i < plot->curve_count; i++) {
        const size_t length = strlen(plot->curve[i].legend);
        longest = length > longest ? length : longest;
        entries += length > 0;
    }
    return (int)ceil(entries * ((double)longest + SAMPLE) / LETTERS);
}

/* Over its width. Paper that is too high or too low costs some white: gnuplot keeps the plot's
 * proportion. */
static double height_of_paper(const drawing *plot, double line)
{
    static const double PLOT = 0.82;
    enum { LINES_OF_AXIS = 6 };
    const int lines =
        LINES_OF_AXIS + lines_of(plot->title) + lines_of(plot->caption) + lines_of_legend(plot);
    return PLOT * proportion(plot) + line * lines;
}

static void put_frame(FILE *script, const drawing *plot)
{
    put_axis(script, "x", &plot->x);
    put_axis(script, "y", &plot->y);
    put_caption(script, plot->x.text, plot->caption);
    fputs("set xtics nomirror\nset ytics nomirror\n", script);
    if (plot->second.text[0] != '\0') {
        put_axis(script, "y2", &plot->second);
        fputs("set border 11\n", script);
    } else
        fputs("set border 3\nset rmargin 2\n", script);
    fputs("set xlabel offset 0,0.4\nset ylabel offset 0.3,0\nset y2label offset -0.5,0\n"
          "set title offset 0,-0.5\nset tics scale 0.6\n"
          "set key below center horizontal reverse Left samplen 2.2 width 1\nset title ",
          script);
    put_text(script, plot->title);
    fprintf(script, "\nset tmargin %d\nset size ratio %.7g\n", 1 + lines_of(plot->title),
            proportion(plot));
}

static void put_label(FILE *script, const label *note)
{
    static const char *const sides[] = {
        [ALIGN_LEFT] = "left", [ALIGN_CENTRE] = "center", [ALIGN_RIGHT] = "right"};
    fputs("set label ", script);
    put_text(script, note->text);
    fprintf(script, " at %s %.7g,%.7g %s front textcolor rgb '%s'%s\n",
            note->second_axis ? "second" : "first", note->x, note->y, sides[note->align],
            colours[note->colour], note->boxed ? " boxed" : "");
}

/* Seven digits: far more than can be seen, and a last bit that differs between math libraries
 * does not show. */
static void put_data(FILE *script, const curve *line, int number)
{
    fprintf(script, "$c%d << EOD\n", number);
    for (size_t i = 0; i < line->count; i++) {
        const double *row = line->from->row[line->first + i].number;
        if (isfinite(row[line->x]) && isfinite(row[line->y]))
            fprintf(script, "%.7g %.7g\n", row[line->x] + 0, row[line->y] + 0);
        else
            fputs("\n", script);
    }
    fputs("EOD\n", script);
}

static void put_line(FILE *script, const curve *line)
{
    fprintf(script, "linewidth %.3g dashtype %s linecolor rgb '%s'", line->width,
            dashes[line->dash], colours[line->colour]);
}

static void put_point(FILE *script, const curve *line)
{
    fprintf(script, "%s linecolor rgb '%s'",
            line->style == STYLE_CROSSES ? "pointtype 2 pointsize 0.35 linewidth 0.7"
                                         : "pointtype 6 pointsize 0.7 linewidth 1.2",
            colours[line->colour]);
}

static void put_style(FILE *script, const curve *line)
{
    const int level = (int)floor(255 * line->grey + 0.5);
    switch (line->style) {
    case STYLE_LINE:
        fputs("lines ", script);
        put_line(script, line);
        break;
    case STYLE_CROSSES:
    case STYLE_CIRCLES:
        fputs("points ", script);
        put_point(script, line);
        break;
    case STYLE_AREA:
        fprintf(script,
                "filledcurves closed fillstyle solid 1 noborder linecolor rgb '#%02x%02x%02x'",
                level, level, level);
        break;
    }
}

static void put_curve(FILE *script, const curve *line, int number, const char *before)
{
    fprintf(script, "%s$c%d using 1:2 axes x1y%d with ", before, number, line->second_axis ? 2 : 1);
    put_style(script, line);
    fputs(" title ", script);
    put_text(script, line->legend);
}

/* gnuplot finds the lines, in a table, which is drawn. What is infinite is high. */
static void put_contours(FILE *script, const contours *field)
{
    fputs("$field << EOD\n", script);
    for (size_t i = 0; i < field->from->count; i++) {
        const double *row = field->from->row[i].number, height = row[field->height];
        fprintf(script, "%s%.7g %.7g %.7g\n", i > 0 && i % (size_t)field->columns == 0 ? "\n" : "",
                row[field->x], row[field->y], isfinite(height) ? height : 2 * field->top);
    }
    fprintf(
        script,
        "EOD\nset contour base\nunset surface\nset cntrparam levels incremental %.7g,%.7g,%.7g\n"
        "set table $lines\nsplot $field using 1:2:3 with lines\nunset table\n"
        "set palette defined (0 '#9ecae1', 0.5 '#2171b5', 1 '#08306b')\nunset colorbox\n",
        field->step, field->step, field->top);
}

/* A level at a time: a line of one colour has no joints. */
static void put_levels(FILE *script, const contours *field)
{
    const int levels = (int)(field->top / field->step);
    fprintf(script,
            "plot for [i=1:%d] $lines using 1:(abs($3 - i*%.7g) < 0.5*%.7g ? $2 : NaN) "
            "with lines linewidth 0.9 linecolor palette frac i/%d. notitle",
            levels, field->step, field->step, levels);
}

static void put_plot(FILE *script, const drawing *plot)
{
    const bool has_field = plot->field.from != NULL;
    if (has_field)
        put_levels(script, &plot->field);
    for (int i = 0; i < plot->curve_count; i++)
        put_curve(script, &plot->curve[i], i, i == 0 && !has_field ? "plot " : ", \\\n    ");
    fputs("\nunset output\n", script);
}

static void gnuplot_script(const drawing *plot, const picture_format *format, FILE *script)
{
    fputs("set terminal ", script);
    fprintf(script, format->terminal, format->width,
            format->width * height_of_paper(plot, format->line));
    fputs("\nset encoding utf8\nset minussign\nset style textbox opaque margins 0.3,0.1 noborder\n",
          script);
    put_frame(script, plot);
    for (int i = 0; i < plot->label_count; i++)
        put_label(script, &plot->label[i]);
    for (int i = 0; i < plot->curve_count; i++)
        put_data(script, &plot->curve[i], i);
    if (plot->field.from != NULL)
        put_contours(script, &plot->field);
    put_plot(script, plot);
}

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
void gnuplot_draw(const drawing *plot, const char *name, output *out)
{
    const picture_format *format = picture_formats;
    while (strcmp(format->name, name) != 0)
        format++;
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
