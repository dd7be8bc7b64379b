/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The units of dimensions, in those of the case. */
#include "report.h"

#include <string.h>

/* The i-th of "mm,N,MPa". */
static void add_part(const char *units, int i, char label[UNIT_SIZE])
{
    for (int k = 0; k < i && units != NULL; k++) {
        units = strchr(units, ',');
        units = units != NULL ? units + 1 : NULL;
    }
    if (units == NULL)
        return;
    units += strspn(units, " ");
    list_add(label, UNIT_SIZE, "", "%.*s", (int)strcspn(units, ", "), units);
}

/* A word of a dimension. */
static void add_word(const char *units, const char *word, size_t length, char label[UNIT_SIZE])
{
    static const char *const words[] = {"length", "force", "stress"};
    for (int i = 0; i < 3; i++)
        if (strlen(words[i]) == length && strncmp(words[i], word, length) == 0) {
            add_part(units, i, label);
            return;
        }
    list_add(label, UNIT_SIZE, "", "%.*s", (int)length, word);
}

void report_unit(const report *from, const char *dimension, char label[UNIT_SIZE])
{
    static const char letters[] = "abcdefghijklmnopqrstuvwxyz";
    static const char *const pure[] = {"none", "text", "strain"};
    const char *units = from->line->value[OPTION_UNITS];
    const bool is_angle = strcmp(dimension, "rad") == 0 || strcmp(dimension, "deg") == 0;
    label[0] = '\0';
    for (size_t i = 0; i < sizeof pure / sizeof pure[0]; i++)
        if (strcmp(dimension, pure[i]) == 0)
            return;
    if (units == NULL && !is_angle)
        return;
    while (*dimension != '\0') {
        const size_t length = strspn(dimension, letters),
                     signs = strcspn(dimension + length, letters);
        if (length > 0)
            add_word(units, dimension, length, label);
        for (size_t i = length; i < length + signs; i++)
            list_add(label, UNIT_SIZE, "", dimension[i] == '*' ? "·" : "%c", dimension[i]);
        dimension += length + signs;
    }
}
