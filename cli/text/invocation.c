/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "invocation.h"

#include <stdbool.h>
#include <stdio.h>
#include <string.h>

static char line[1024] = "rwedge";

static const char *without_folder(const char *path)
{
    const char *slash = strrchr(path, '/');
    return slash != NULL ? slash + 1 : path;
}

static void add(const char *before, const char *word)
{
    static const char plain[] =
        "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789-_=.,:/+%@";
    const bool quoted = word[strspn(word, plain)] != '\0' || word[0] == '\0';
    const size_t used = strlen(line);
    snprintf(line + used, sizeof line - used, quoted ? "%s'%s'" : "%s%s", before, word);
}

void invocation_keep(int argc, const char *const argv[])
{
    static const char option[] = "--output=";
    bool path = false;
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
}

const char *invocation(void)
{
    return line;
}
