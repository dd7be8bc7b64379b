/* SPDX-License-Identifier: GPL-3.0-or-later */
/* How files are read, from options: their units, columns and rows. */
#include "setup.h"

#include <string.h>

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
