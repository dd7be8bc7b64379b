/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "words.h"

#include <math.h>
#include <string.h>

const char case_version_name[] = "rwedge_case";

/* Words beside the inputs. */
static const case_word others[] = {
    {"", "units", "units", WORD_TEXT, INPUT_COUNT},
    {"", "width", "width", WORD_QUANTITY, INPUT_COUNT},
    {"", "section", "section", WORD_QUANTITY, INPUT_COUNT},
    {"", "K_in", "K-in", WORD_TEXT, INPUT_COUNT},
    {"bodies", "plane_stress", "plane-stress", WORD_FLAG, INPUT_COUNT},
    {"bodies", "strength_of", "strength-of", WORD_QUANTITY, INPUT_COUNT},
    {"bodies", "similar", "similar", WORD_FLAG, INPUT_COUNT},
    {"pad", "rotation", "rotation", WORD_TEXT, INPUT_COUNT},
    {"loads", "tilt", NULL, WORD_NUMBERS, INPUT_COUNT}, /* of one load it is the pad's */
    {"loads", "displacement", NULL, WORD_NUMBERS, INPUT_COUNT},
    {"loads", "compliance", "compliance", WORD_QUANTITY, INPUT_COUNT},
    {"pad", "x", NULL, WORD_NUMBERS, INPUT_COUNT},
    {"pad", "slope", NULL, WORD_NUMBERS, INPUT_COUNT},
    {"pad", "height", NULL, WORD_NUMBERS, INPUT_COUNT},
    {"pad", "hull", "hull", WORD_FLAG, INPUT_COUNT},
    {"pad", "fit", "fit", WORD_FLAG, INPUT_COUNT},
    {"pad", "heights", "heights", WORD_TEXT, INPUT_COUNT},
    {"pad", "origin", "origin", WORD_TEXT, INPUT_COUNT},
};
enum { OTHERS = sizeof others / sizeof others[0] };

static const char *group_of(int input)
{
    if (input >= INPUT_P && input <= INPUT_SIGMA)
        return "loads";
    return input >= INPUT_THETA && input < INPUT_P ? "pad" : "bodies";
}

/* A profile is no name of another file: its places stand in the case. */
static const case_word *words(size_t *count)
{
    static case_word all[INPUT_COUNT + OTHERS];
    static size_t made;
    for (int i = 0; made < INPUT_COUNT - 1 && i < INPUT_COUNT; i++)
        if (i != INPUT_PROFILE)
            all[made++] = (case_word){group_of(i), input_kinds[i].column, input_kinds[i].option,
                                      WORD_QUANTITY, i};
    if (made == INPUT_COUNT - 1) {
        memcpy(all + made, others, sizeof others);
        made += OTHERS;
    }
    *count = made;
    return all;
}

size_t case_word_count(void)
{
    size_t count;
    words(&count);
    return count;
}

const case_word *case_word_of(size_t i)
{
    size_t count;
    return &words(&count)[i];
}

bool case_group_exists(const char *name)
{
    return strcmp(name, "bodies") == 0 || strcmp(name, "pad") == 0 || strcmp(name, "loads") == 0;
}

const case_word *case_word_find(const char *group, const char *name, complaint *why)
{
    size_t count;
    const case_word *all = words(&count);
    char allowed[400] = "";
    nearest_name nearest = nearest_to(name);
    for (size_t i = 0; i < count; i++) {
        if (strcmp(all[i].group, group) != 0)
            continue;
        if (strcmp(all[i].name, name) == 0)
            return &all[i];
        nearest_try(&nearest, all[i].name);
        list_add(allowed, sizeof allowed, ", ", "%s", all[i].name);
    }
    if (nearest.name != NULL)
        complain(why, "%s%s%.60s: unknown; the nearest is %s", group, group[0] != '\0' ? ": " : "",
                 name, nearest.name);
    else
        complain(why, "%s%s%.60s: unknown; allowed: %s%s", group, group[0] != '\0' ? ": " : "",
                 name, allowed, group[0] != '\0' ? "" : ", bodies, pad, loads, material, asked");
    return NULL;
}

bool case_version_check(double version, complaint *why)
{
    if (isnan(version))
        return complain(why, "no \"%s\": %d, so it is no case file", case_version_name,
                        CASE_VERSION);
    if (version == CASE_VERSION)
        return true;
    return complain(why, "%s %.6g: a case of another version; this program reads %d",
                    case_version_name, version, CASE_VERSION);
}
