/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "system.h"

#include "text/text.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

static const char stdout_name[] = "standard output";

NO_RETURN static void refuse(const output *out, int reason)
{
    failure("%s: %s", out->name, file_problem(reason));
}

static void open_directly(output *out, int descriptor)
{
    if (descriptor < 0)
        refuse(out, errno);
    out->descriptor = descriptor;
    signals_on_end(NULL, "; the output is not complete");
}

static void open_beside(output *out, const char *path)
{
    out->target = target_of_links(path);
    if (out->target == NULL)
        refuse(out, errno);
    signals_hold();
    out->descriptor = target_open_beside(out->target, &out->unfinished);
    const int reason = errno;
    if (out->descriptor >= 0)
        signals_on_end(out->unfinished, "; the output file is as it was before");
    signals_release();
    if (out->descriptor < 0)
        refuse(out, reason);
}

static void open_by_name(output *out, const char *path)
{
    switch (file_kind_of(path)) {
    case FILE_REGULAR:
    case FILE_ABSENT:
        open_beside(out, path);
        return;
    case FILE_FOLDER:
        refuse(out, EISDIR);
    case FILE_OTHER:
        open_directly(out, file_to_write(path));
        return;
    case FILE_NOT_KNOWN: /* also a link that the system does not follow */
        break;
    }
    refuse(out, errno);
}

/* The one that is open; NULL for none. */
static output *unsettled;

static void give_up(void);

void output_open(output *out, const char *path)
{
    static bool is_prepared;
    if (!is_prepared && atexit(give_up) != 0)
        failure("out of memory");
    is_prepared = true;
    out->target = out->unfinished = NULL;
    out->error = 0;
    out->used = 0;
    if (path == NULL || strcmp(path, "-") == 0) {
        out->name = stdout_name;
        open_directly(out, STDOUT_FILENO);
    } else {
        out->name = path;
        open_by_name(out, path);
    }
    unsettled = out;
}

bool output_is_stdout(const output *out)
{
    return out->descriptor == STDOUT_FILENO;
}

static void flush(output *out)
{
    const char *bytes = out->buffer;
    while (out->used > 0 && out->error == 0) {
        const ssize_t written = write(out->descriptor, bytes, (unsigned)out->used);
        if (written < 0) {
            if (errno != EINTR)
                out->error = errno;
            continue;
        }
        bytes += written;
        out->used -= (size_t)written;
    }
}

bool output_write(output *out, const char *bytes, size_t count)
{
    while (count > 0 && out->error == 0) {
        const size_t free_bytes = sizeof out->buffer - out->used;
        const size_t now = count < free_bytes ? count : free_bytes;
        memcpy(out->buffer + out->used, bytes, now);
        out->used += now;
        bytes += now;
        count -= now;
        if (out->used == sizeof out->buffer)
            flush(out);
    }
    return out->error == 0;
}

bool output_text(output *out, const char *text)
{
    return output_write(out, text, strlen(text));
}

static void remember(output *out, int reason)
{
    if (out->error == 0)
        out->error = reason;
}

/* A disk may report at close() what it did not at write(). */
static void close_checked(output *out)
{
    if (out->unfinished != NULL && out->error == 0)
        remember(out, target_sync(out->descriptor));
    if (close(out->descriptor) != 0)
        remember(out, errno);
    out->descriptor = -1;
}

/* The unfinished file replaces the target. After an error it is removed. */
static void settle(output *out)
{
    signals_hold();
    if (out->unfinished != NULL && out->error != 0)
        target_remove(out->unfinished);
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
    if (out->unfinished == NULL)
        flush(out);
    close(out->descriptor);
    out->error = ECANCELED;
    settle(out);
}

void output_finish(output *out)
{
    flush(out);
    close_checked(out);
    settle(out);
    unsettled = NULL;
    if (out->error != 0)
        refuse(out, out->error);
}
