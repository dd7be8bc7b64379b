/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "setup.h"

#include <math.h>
#include <string.h>

enum { OTHER_OPTIONS = 10, CONTACT_INPUTS = INPUT_K };

struct poptOption heights_option_table[] = {
    {FLAG("hull", OPTION_HULL), "Take the convex hull of the heights of a profile", NULL},
    {FLAG("fit", OPTION_FIT),
     "Fit the heights of a profile: the convex profile nearest to them in least squares", NULL},
    {VALUE("heights", OPTION_HEIGHTS), "Which way the heights of a profile point (default up)",
     "up|down"},
    {VALUE("origin", OPTION_ORIGIN),
     "Where x is 0, which P passes through: as in the profile, or at its lowest place", "lowest"},
    POPT_TABLEEND,
};

struct poptOption input_option_table[CONTACT_INPUTS + OTHER_OPTIONS + 1] = {
    [CONTACT_INPUTS] = {INCLUDED(heights_option_table), NULL, NULL},
    {PLANE_STRESS_OPTION},
    {ROTATION_OPTION},
    {SIMILAR_OPTION},
    {MATERIAL_OPTION},
    {VALUE("case", OPTION_CASE), "A case from a JSON file; options replace what it has", "FILE"},
    {VALUE("save-case", OPTION_SAVE_CASE), "Write the case to FILE, for --case", "FILE"},
    OTHER_NAME("friction", OPTION_INPUT + INPUT_F),
    OTHER_NAME("nu", OPTION_INPUT + INPUT_NU1),
    {INCLUDED(reading_option_table), "Units, and columns of files:", NULL},
    POPT_TABLEEND,
};
struct poptOption strength_option_table[INPUT_COUNT - CONTACT_INPUTS + 1] = {
    [INPUT_COUNT - CONTACT_INPUTS] = POPT_TABLEEND,
};

struct poptOption shape_option_table[INPUT_P] = {[INPUT_P - 1] = POPT_TABLEEND};

struct poptOption exactness_option_table[] = {
    {FLAG("exact", OPTION_EXACT),
     "Refuse loads that have no closed form, which are computed otherwise", NULL},
    {VALUE("tolerance", OPTION_TOLERANCE),
     "How exactly these are computed: error of q over f p0, 1e-6 to 1e-2 (default 1e-4)", "NUMBER"},
    POPT_TABLEEND,
};

static struct poptOption option_of(int input)
{
    return (struct poptOption){.longName = input_kinds[input].option,
                               .argInfo = POPT_ARG_STRING,
                               .val = OPTION_INPUT + input,
                               .descrip = input_kinds[input].meaning,
                               .argDescrip = input_kinds[input].argument};
}

void input_options_prepare(void)
{
    int shapes = 0;
    for (int i = 0; i < INPUT_COUNT; i++) {
        if (i < CONTACT_INPUTS)
            input_option_table[i] = option_of(i);
        else
            strength_option_table[i - CONTACT_INPUTS] = option_of(i);
        if (i < INPUT_P && i != INPUT_NU1)
            shape_option_table[shapes++] = option_of(i);
    }
}

static double read_tolerance(const arguments *line)
{
    const char *text = line->value[OPTION_TOLERANCE];
    double tolerance = line->value[OPTION_EXACT] != NULL ? 0 : NAN;
    if (text == NULL)
        return tolerance;
    if (line->value[OPTION_EXACT] != NULL)
        usage_error("--tolerance %s: given together with --exact; allowed: one of the two", text);
    if (!(number_read(text, &tolerance) && tolerance >= 1e-6 && tolerance <= 1e-2))
        usage_error("--tolerance %s: must be a number from 1e-6 to 1e-2", text);
    return tolerance;
}

static rotation read_rotation(const arguments *line)
{
    const char *text = line->value[OPTION_ROTATION];
    if (text != NULL && strcmp(text, "held") != 0 && strcmp(text, "free") != 0)
        usage_error("--rotation %s: must be held or free", text);
    return text == NULL                ? ROTATION_UNSAID
           : strcmp(text, "held") == 0 ? ROTATION_HELD
                                       : ROTATION_FREE;
}

/* How the profile of an option is made of its file. */
profile_making profile_making_of(const arguments *line)
{
    const char *heights = line->value[OPTION_HEIGHTS], *origin = line->value[OPTION_ORIGIN];
    if (heights != NULL && strcmp(heights, "up") != 0 && strcmp(heights, "down") != 0)
        usage_error("--heights %s: must be up or down", heights);
    if (origin != NULL && strcmp(origin, "lowest") != 0)
        usage_error("--origin %s: must be lowest", origin);
    if (line->value[OPTION_FIT] != NULL && line->value[OPTION_HULL] != NULL)
        usage_error("--fit: given together with --hull; allowed: one of the two");
    return (profile_making){.takes_hull = line->value[OPTION_HULL] != NULL,
                            .fits = line->value[OPTION_FIT] != NULL,
                            .is_down = heights != NULL && strcmp(heights, "down") == 0,
                            .is_from_lowest = origin != NULL,
                            .keeps_places = line->value[OPTION_SAVE_CASE] != NULL,
                            .is_command = true};
}

void input_texts_from_options(const arguments *line, input_texts *texts)
{
    complaint why;
    *texts = (input_texts){.cell_decimal_sign = '.',
                           .units = units_of(line),
                           .how_units = ": --units, such as --units mm,N,MPa, converts it",
                           .how_comma = "with --decimal-comma",
                           .where_else = "columns or options",
                           .profile_named = profiles_named,
                           .tolerance = read_tolerance(line),
                           .is_plane_stress = line->value[OPTION_PLANE_STRESS] != NULL,
                           .rotation = read_rotation(line),
                           .takes_as_similar = line->value[OPTION_SIMILAR] != NULL,
                           .how_rotation = "--rotation held or free says it, --similar neglects "
                                           "that friction then moves the contact"};
    for (int i = 0; i < INPUT_COUNT; i++)
        texts->text[i] = line->value[OPTION_INPUT + i];
    material_hand_over(line, texts);
    const char *profile = texts->text[INPUT_PROFILE];
    if (profile == NULL)
        return;
    const reading how = reading_of(line, line->value[OPTION_DECIMAL_COMMA] != NULL ? ',' : '.');
    const profile_making making = profile_making_of(line);
    const char *remark = profiles_read(profile, &how, &making);
    if (profiles_named(profile, &why) == NULL)
        failure("%s", why.text);
    notice("%s", remark);
}

void input_options_check_hull(const arguments *line)
{
    static const struct {
        int number;
        const char *name;
    } options[] = {{OPTION_HULL, "--hull"},
                   {OPTION_FIT, "--fit"},
                   {OPTION_HEIGHTS, "--heights"},
                   {OPTION_ORIGIN, "--origin"}};
    for (size_t i = 0; i < sizeof options / sizeof options[0]; i++)
        if (line->value[options[i].number] != NULL &&
            line->value[OPTION_INPUT + INPUT_PROFILE] == NULL)
            usage_error("%s: needs --profile", options[i].name);
}
