/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "text.h"

#include <string.h>

enum { LINE = 1024 };
static char line[LINE] = "rwedge";
static bool whole = true;

/* It stands for a byte that is no character. */
static const char replacement[] = "\xef\xbf\xbd";
static const char cut[] = " ...";

static const char *without_folder(const char *path)
{
    const char *slash = strrchr(path, '/');
    return slash != NULL ? slash + 1 : path;
}

static void append(const char *text)
{
    const size_t used = strlen(line);
    whole =
        whole && utf8_copy(text, utf8_is_text, replacement, line + used, LINE - used - sizeof cut);
}

static void add(const char *before, const char *word)
{
    static const char plain[] =
        "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789-_=.,:/+%@";
    const bool quoted = word[strspn(word, plain)] != '\0' || word[0] == '\0';
    append(before);
    append(quoted ? "'" : "");
    append(word);
    append(quoted ? "'" : "");
}

void invocation_keep(int argc, const char *const argv[])
{
    static const char option[] = "--output=";
    bool path = false;
    whole = true;
    strcpy(line, "rwedge");
    for (int i = 1; i < argc; i++) {
        const char *word = argv[i];
        if (path)
            add(" ", without_folder(word));
        else if (strncmp(word, option, sizeof option - 1) == 0)
            add(" --output=", without_folder(word + sizeof option - 1));
        else if (strncmp(word, "-o", 2) == 0 && word[2] != '\0')
            add(" -o ", without_folder(word + 2));
        else
            add(" ", word);
        path = !path && (strcmp(word, "-o") == 0 || strcmp(word, "--output") == 0);
    }
    if (!whole)
        strcat(line, cut);
}

const char *invocation(void)
{
    return line;
}
