/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "system.h"

#include <errno.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

NO_RETURN static void refuse(const output *out, int reason)
{
    failure("%s: %s", out->name, file_problem(reason));
}

static void open_beside(output *out, const char *path)
{
    out->target = target_of_links(path);
    if (out->target == NULL)
        refuse(out, errno);
    signals_hold();
    out->stream = target_open_beside(out->target, &out->unfinished);
    const int reason = errno;
    if (out->stream != NULL)
        signals_on_end(out->unfinished, "; the output file is as it was before");
    signals_release();
    if (out->stream == NULL)
        refuse(out, reason);
}

/* The one that is open; NULL for none. */
static output *unsettled;

static void give_up(void);

/* What is not known is also a link that the system does not follow. */
void output_open(output *out, const char *path)
{
    static bool is_prepared;
    const bool is_standard = path == NULL || strcmp(path, "-") == 0;
    if (!is_prepared && atexit(give_up) != 0)
        failure("out of memory");
    is_prepared = true;
    out->target = out->unfinished = NULL;
    out->error = 0;
    out->name = is_standard ? "standard output" : path;
    const file_kind kind = is_standard ? FILE_OTHER : file_kind_of(path);
    if (kind == FILE_REGULAR || kind == FILE_ABSENT)
        open_beside(out, path);
    else {
        out->stream = is_standard ? stdout : kind == FILE_OTHER ? file_to_write(path) : NULL;
        if (out->stream == NULL)
            refuse(out, kind == FILE_FOLDER ? EISDIR : errno);
        signals_on_end(NULL, "; the output is not complete");
    }
    unsettled = out;
}

static void remember(output *out, bool done)
{
    if (!done && out->error == 0)
        out->error = errno;
}

void output_try(const char *path)
{
    output out;
    if (path == NULL || strcmp(path, "-") == 0 || file_kind_of(path) == FILE_OTHER)
        return;
    output_open(&out, path);
    give_up();
}

void output_write(output *out, const char *bytes, size_t count)
{
    if (out->error == 0)
        remember(out, fwrite(bytes, 1, count, out->stream) == count);
}

void output_text(output *out, const char *text)
{
    output_write(out, text, strlen(text));
}

void output_print(output *out, const char *format, ...)
{
    va_list values;
    va_start(values, format);
    if (out->error == 0)
        remember(out, vfprintf(out->stream, format, values) >= 0);
    va_end(values);
}

/* The unfinished file replaces the target. After an error it is removed. */
static void settle(output *out)
{
    signals_hold();
    if (out->unfinished != NULL && out->error != 0)
        remove(out->unfinished);
    else if (out->unfinished != NULL)
        out->error = target_replace(out->target, out->unfinished);
    signals_on_end(NULL, NULL);
    signals_release();
    free(out->unfinished);
    free(out->target);
    out->unfinished = out->target = NULL;
}

static void give_up(void)
{
    output *out = unsettled;
    if (out == NULL)
        return;
    unsettled = NULL;
    fclose(out->stream);
    out->error = ECANCELED;
    settle(out);
}

void output_finish(output *out)
{
    remember(out, fflush(out->stream) == 0);
    if (out->unfinished != NULL && out->error == 0)
        out->error = target_sync(out->stream);
    remember(out, fclose(out->stream) == 0); /* a disk may report here what it did not before */
    settle(out);
    unsettled = NULL;
    if (out->error != 0)
        refuse(out, out->error);
}
