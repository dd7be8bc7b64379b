/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What the end by a signal does on every system. */
#include "system.h"

#include <string.h>
#include <unistd.h>

/* Changed only while signals are held back. */
static const char *volatile file_to_remove;
static const char *volatile last_words;

void signals_on_end(const char *unfinished_file, const char *message)
{
    file_to_remove = unfinished_file;
    last_words = message;
}

static void say(const char *text)
{
    if (text != NULL && write(STDERR_FILENO, text, (unsigned)strlen(text)) < 0)
        return; /* nobody to tell */
}

void signals_end(const char *why)
{
    if (file_to_remove != NULL)
        unlink(file_to_remove);
    progress_erase();
    say(message_speaker());
    say(": stopped by ");
    say(why);
    say(last_words);
    say("\n");
}
