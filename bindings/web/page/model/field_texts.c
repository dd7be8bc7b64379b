/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "page.h"

#include <string.h>

static const char *remark = ""; /* on the profile */

static const char PROFILE_NAME[] = "pasted", BETWEEN[] = "\x1e";

/* The rows of a profile become one that is read, by a name. */
static void take_profile(const char *rows, bool takes_hull, input_texts *texts)
{
    pasted_offer(rows);
    const reading how = {.decimal_sign = '.'};
    const profile_making making = {.takes_hull = takes_hull, .takes_unnamed = true};
    remark = profiles_read(PROFILE_NAME, &how, &making);
    texts->text[INPUT_PROFILE] = PROFILE_NAME;
}

const char *field_remark(void)
{
    return remark;
}

static void take(char *field, input_texts *texts)
{
    char *sign = strchr(field, '=');
    if (sign == NULL)
        return;
    *sign = '\0';
    if (strcmp(field, "decimal_sign") == 0) {
        texts->cell_decimal_sign = sign[1];
        return;
    }
    if (strcmp(field, "profile") == 0 || strcmp(field, "hull") == 0) {
        take_profile(sign + 1, field[0] == 'h', texts);
        return;
    }
    for (int i = 0; i < INPUT_COUNT; i++)
        if (strcmp(field, input_kinds[i].column) == 0)
            texts->text[i] = sign + 1;
}

/* Names and blanks are as those of cells. */
input_texts field_texts(char *fields)
{
    input_texts texts = {.cell_decimal_sign = '.',
                         .how_comma = "that separates no thousands",
                         .profile_named = profiles_named,
                         .tolerance = usual_tolerance};
    profiles_forget(0);
    remark = "";
    for (int i = 0; i < INPUT_COUNT; i++)
        texts.is_cell[i] = true;
    for (char *field = strtok(fields, BETWEEN); field != NULL; field = strtok(NULL, BETWEEN))
        take(field, &texts);
    return texts;
}
