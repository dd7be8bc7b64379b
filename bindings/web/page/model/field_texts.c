/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "page.h"

#include <string.h>

static const char *remark = ""; /* on the profile */

static const char PROFILE_NAME[] = "pasted", BETWEEN_ROWS = '\x1d';

/* The rows of a profile become one that is read, by a name. */
static void take_profile(char *rows, bool takes_hull, input_texts *texts)
{
    for (char *at = strchr(rows, BETWEEN_ROWS); at != NULL; at = strchr(at, BETWEEN_ROWS))
        *at = '\n';
    pasted_offer(rows);
    profiles_forget(0);
    remark = profiles_read(PROFILE_NAME, '.', takes_hull);
    texts->text[INPUT_PROFILE] = PROFILE_NAME;
}

const char *field_remark(void)
{
    return remark;
}

static void take(char *line, input_texts *texts)
{
    char *sign = strchr(line, '=');
    if (sign == NULL)
        return;
    *sign = '\0';
    if (strcmp(line, "profile") == 0 || strcmp(line, "hull") == 0) {
        take_profile(sign + 1, line[0] == 'h', texts);
        return;
    }
    for (int i = 0; i < INPUT_COUNT; i++)
        if (strcmp(line, input_kinds[i].column) == 0)
            texts->text[i] = sign + 1;
}

/* Names and blanks are as those of cells. */
input_texts field_texts(char *lines)
{
    input_texts texts = {.cell_decimal_sign = '.',
                         .how_comma = "that separates no thousands",
                         .profile_named = profiles_named,
                         .tolerance = usual_tolerance};
    profiles_forget(0);
    remark = "";
    for (int i = 0; i < INPUT_COUNT; i++)
        texts.is_cell[i] = true;
    for (char *line = strtok(lines, "\n"); line != NULL; line = strtok(NULL, "\n"))
        take(line, &texts);
    return texts;
}
