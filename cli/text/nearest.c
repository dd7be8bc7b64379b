/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "text.h"

#include <ctype.h>
#include <string.h>
#include <strings.h>

enum { LENGTH_MAX = 32 };

/* How many letters are to be put in, left out or changed (Levenshtein), capitals or not. */
static size_t distance(const char *a, const char *b)
{
    size_t row[LENGTH_MAX + 1];
    const size_t width = strlen(b);
    for (size_t j = 0; j <= width; j++)
        row[j] = j;
    for (size_t i = 1; a[i - 1] != '\0'; i++) {
        size_t corner = row[0];
        row[0] = i;
        for (size_t j = 1; j <= width; j++) {
            const int same = tolower((unsigned char)a[i - 1]) == tolower((unsigned char)b[j - 1]);
            const size_t change = corner + (same ? 0 : 1);
            corner = row[j];
            const size_t other = 1 + (row[j - 1] < row[j] ? row[j - 1] : row[j]);
            row[j] = change < other ? change : other;
        }
    }
    return row[width];
}

/* One mistake, and one more for every three letters; in one or two letters there is none to
 * make. */
nearest_name nearest_to(const char *typed)
{
    const size_t length = strlen(typed);
    return (nearest_name){typed, NULL, length < 3 ? 1 : 2 + length / 3};
}

void nearest_try(nearest_name *to, const char *name)
{
    const size_t length = strlen(to->typed);
    if (length == 0 || length > LENGTH_MAX || strlen(name) > LENGTH_MAX)
        return;
    /* the beginning of a name is no mistake */
    const size_t away = strncasecmp(to->typed, name, length) == 0 ? 0 : distance(to->typed, name);
    if (away >= to->distance)
        return;
    to->name = name;
    to->distance = away;
}
