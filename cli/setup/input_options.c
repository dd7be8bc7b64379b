/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "setup.h"

enum { OTHER_NAMES = 3, CONTACT_INPUTS = INPUT_K };

struct poptOption input_option_table[CONTACT_INPUTS + OTHER_NAMES + 1] = {
    [CONTACT_INPUTS] = {HULL_OPTION},
    OTHER_NAME("friction", OPTION_INPUT + INPUT_F),
    OTHER_NAME("nu", OPTION_INPUT + INPUT_NU1),
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
    double tolerance = line->value[OPTION_EXACT] != NULL ? 0 : usual_tolerance;
    if (text == NULL)
        return tolerance;
    if (line->value[OPTION_EXACT] != NULL)
        usage_error("--tolerance %s: given together with --exact; allowed: one of the two", text);
    if (!(number_read(text, &tolerance) && tolerance >= 1e-6 && tolerance <= 1e-2))
        usage_error("--tolerance %s: must be a number from 1e-6 to 1e-2", text);
    return tolerance;
}

void input_texts_from_options(const arguments *line, input_texts *texts)
{
    complaint why;
    *texts = (input_texts){.cell_decimal_sign = '.',
                           .how_comma = "with --decimal-comma",
                           .where_else = "columns or options",
                           .profile_named = profiles_named,
                           .tolerance = read_tolerance(line)};
    for (int i = 0; i < INPUT_COUNT; i++)
        texts->text[i] = line->value[OPTION_INPUT + i];
    const char *profile = texts->text[INPUT_PROFILE];
    if (profile == NULL)
        return;
    const char *remark =
        profiles_read(profile, line->value[OPTION_DECIMAL_COMMA] != NULL ? ',' : '.',
                      line->value[OPTION_HULL] != NULL, false);
    if (profiles_named(profile, &why) == NULL)
        failure("%s", why.text);
    notice("%s", remark);
}

void input_options_check_hull(const arguments *line)
{
    if (line->value[OPTION_HULL] != NULL && line->value[OPTION_INPUT + INPUT_PROFILE] == NULL)
        usage_error("--hull: needs --profile");
}
