/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "setup.h"

#include <math.h>
#include <string.h>

enum { OTHER_OPTIONS = 13, CONTACT_INPUTS = INPUT_K };

struct poptOption input_option_table[CONTACT_INPUTS + OTHER_OPTIONS + 1] = {
    [CONTACT_INPUTS] = {HULL_OPTION},
    {FLAG("fit", OPTION_FIT),
     "Fit the heights of a profile: the convex profile nearest to them in least squares", NULL},
    {VALUE("heights", OPTION_HEIGHTS), "Which way the heights of a profile point (default up)",
     "up|down"},
    {VALUE("origin", OPTION_ORIGIN),
     "Where x is 0, which P passes through: as in the profile, or at its lowest place", "lowest"},
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

struct poptOption reading_option_table[] = {
    {VALUE("units", OPTION_UNITS),
     "Working units, to which those behind names and numbers are converted", "mm,N,MPa"},
    {VALUE("width", OPTION_WIDTH),
     "Width of the contact out of the plane: P, M and Q are of the whole, and divided by it",
     "LENGTH"},
    {VALUE("section", OPTION_SECTION), "Area by which sigma is divided where it is a force",
     "AREA"},
    {VALUE("column", OPTION_COLUMN),
     "A column by its name in the file, or its number where there are no names; repeat it",
     "NAME=THEIRS"},
    {K_IN_OPTION},
    {FLAG("drop", OPTION_DROP), "Leave out rows that lack a number: empty, NaN or -9999", NULL},
    POPT_TABLEEND,
};

/* ---- Files ---- */

/* The names that tables have, beside the inputs and the constants of a material. */
static const char *const column_names[] = {"x",
                                           "y",
                                           "slope",
                                           "height",
                                           "p0",
                                           "Q_max",
                                           "Q_min",
                                           "sigma_max",
                                           "sigma_min",
                                           "sigma_before",
                                           "loads",
                                           "life_tested",
                                           displacement_column};

static bool is_column_name(const char *name)
{
    for (size_t i = 0; i < sizeof column_names / sizeof column_names[0]; i++)
        if (strcmp(column_names[i], name) == 0)
            return true;
    for (int i = 0; i < INPUT_COUNT; i++)
        if (strcmp(input_kinds[i].column, name) == 0)
            return true;
    return material_constant(name) >= 0;
}

/* A name that no table has would be passed over. */
static void check_columns(const char *columns)
{
    for (const char *text = columns; text != NULL && *text != '\0';) {
        const size_t length = strcspn(text, "\n"), own = strcspn(text, "=");
        char name[COLUMN_NAME_SIZE];
        snprintf(name, sizeof name, "%.*s", (int)own, text);
        if (own >= length || !is_column_name(name))
            usage_error(
                "--column %.*s: must be NAME=THEIRS, such as P='Normal Force', with a name "
                "that is read here: P, M, Q, sigma, displacement, x, y, slope, height, or an input",
                (int)length, text);
        text += length + (text[length] == '\n');
    }
}

reading reading_of(const arguments *line, char decimal_sign)
{
    const char *encoding = line->value[OPTION_ENCODING];
    check_columns(line->value[OPTION_COLUMN]);
    if (encoding != NULL)
        text_input_check(encoding);
    return (reading){.decimal_sign = decimal_sign,
                     .encoding = encoding,
                     .columns = line->value[OPTION_COLUMN],
                     .units = units_of(line),
                     .drops = line->value[OPTION_DROP] != NULL,
                     .is_driven = line->value[OPTION_COMPLIANCE] != NULL,
                     .is_command = true};
}

/* ---- Inputs ---- */

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
