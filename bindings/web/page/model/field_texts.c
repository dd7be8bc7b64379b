/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "field_texts.h"

#include <stddef.h>
#include <string.h>

static void take(char *line, input_texts *texts)
{
    char *sign = strchr(line, '=');
    if (sign == NULL)
        return;
    *sign = '\0';
    for (int i = 0; i < INPUT_COUNT; i++) {
        char name[INPUT_NAME_SIZE];
        if (strcmp(line, input_column(i, name)) == 0)
            texts->text[i] = sign + 1;
    }
}

/* Names and blanks are as those of cells. */
input_texts field_texts(char *lines)
{
    input_texts texts = {.cell_decimal_sign = '.',
                         .how_comma = "that separates no thousands",
                         .tolerance = usual_tolerance};
    for (int i = 0; i < INPUT_COUNT; i++)
        texts.is_cell[i] = true;
    for (char *end = lines; end != NULL; lines = end + 1) {
        end = strchr(lines, '\n');
        if (end != NULL)
            *end = '\0';
        take(lines, &texts);
    }
    return texts;
}
