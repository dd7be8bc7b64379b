/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "page.h"

#include <math.h>
#include <string.h>

static const char *remark = ""; /* on the profile */

static const char PROFILE_NAME[] = "pasted", BETWEEN[] = "\x1e";

/* What the fields say of all of them. */
static struct {
    unit_system units;
    const char *compliance, *width, *section, *rows; /* of a profile */
    char rows_sign; /* their decimal sign; NUL where it is that of the others */
    profile_making making;
    bool is_of_pad; /* what k and the strength are of */
} said;

/* The rows of a profile become one that is read, by a name. */
static void take_profile(input_texts *texts)
{
    pasted_offer(said.rows);
    const reading how = {.decimal_sign =
                             said.rows_sign != '\0' ? said.rows_sign : texts->cell_decimal_sign,
                         .units = &said.units};
    remark = profiles_read(PROFILE_NAME, &how, &said.making);
    texts->text[INPUT_PROFILE] = PROFILE_NAME;
}

/* What divides forces; a text that is none divides by nothing: its field says so. */
static void take_size(const char *text, const char *dimension, char decimal_sign, double *to)
{
    const char *own;
    double factor, size;
    complaint why;
    if (text != NULL && quantity_read(text, decimal_sign, &size, &own) &&
        units_factor(&said.units, own, dimension, SHARE_NONE, &factor, &why) && size * factor > 0)
        *to = size * factor;
}

double field_share(int input)
{
    const double size = input_kinds[input].of == SHARE_OF_WIDTH     ? said.units.width
                        : input_kinds[input].of == SHARE_OF_SECTION ? said.units.section
                                                                    : NAN;
    return isnan(size) ? 1 : size;
}

const char *field_compliance(void)
{
    return said.compliance;
}

const char *field_remark(void)
{
    return remark;
}

const unit_system *field_units(void)
{
    return &said.units;
}

const char *field_profile(void)
{
    return said.rows != NULL ? PROFILE_NAME : NULL;
}

const profile_making *field_making(void)
{
    return &said.making;
}

bool field_is_of_pad(void)
{
    return said.is_of_pad;
}

/* Fields that are no inputs. */
static bool take_other(const char *name, const char *text, input_texts *texts)
{
    complaint why;
    if (strcmp(name, "decimal_sign") == 0)
        texts->cell_decimal_sign = text[0];
    else if (strcmp(name, "units") == 0) {
        if (!units_read(text, &said.units, &why))
            said.units = units_unknown;
    } else if (strcmp(name, "width") == 0)
        said.width = text;
    else if (strcmp(name, "section") == 0)
        said.section = text;
    else if (strcmp(name, "compliance") == 0)
        said.compliance = text;
    else if (strcmp(name, "profile") == 0)
        said.rows = text;
    else if (strcmp(name, "profile_sign") == 0)
        said.rows_sign = text[0];
    else if (strcmp(name, "plane_stress") == 0)
        texts->is_plane_stress = true;
    else if (strcmp(name, "rotation") == 0)
        texts->rotation = strcmp(text, "held") == 0 ? ROTATION_HELD : ROTATION_FREE;
    else if (strcmp(name, "similar") == 0)
        texts->takes_as_similar = true;
    else if (strcmp(name, "strength_of") == 0)
        said.is_of_pad = strcmp(text, "2") == 0;
    else if (strcmp(name, "hull") == 0)
        said.making.takes_hull = true;
    else if (strcmp(name, "fit") == 0)
        said.making.fits = true;
    else if (strcmp(name, "heights") == 0)
        said.making.is_down = strcmp(text, "down") == 0;
    else if (strcmp(name, "origin") == 0)
        said.making.is_from_lowest = strcmp(text, "lowest") == 0;
    else
        return false;
    return true;
}

static void take(char *field, input_texts *texts)
{
    char *sign = strchr(field, '=');
    if (sign == NULL)
        return;
    *sign = '\0';
    if (take_other(field, sign + 1, texts))
        return;
    for (int i = 0; i < INPUT_COUNT; i++)
        if (strcmp(field, input_kinds[i].column) == 0)
            texts->text[i] = sign + 1;
}

/* Names and blanks are as those of cells. */
input_texts field_texts(char *fields)
{
    input_texts texts = {.cell_decimal_sign = '.',
                         .units = &said.units,
                         .how_units = ": Units above must name those of the numbers",
                         .how_comma = "that separates no thousands",
                         .profile_named = profiles_named,
                         .tolerance = NAN,
                         .how_rotation = "choose it below the friction"};
    profiles_forget(0);
    remark = "";
    memset(&said, 0, sizeof said);
    said.units = units_unknown;
    said.making = (profile_making){.keeps_places = true, .takes_unnamed = true};
    for (int i = 0; i < INPUT_COUNT; i++)
        texts.is_cell[i] = true;
    for (char *field = strtok(fields, BETWEEN); field != NULL; field = strtok(NULL, BETWEEN))
        take(field, &texts);
    take_size(said.width, "length", texts.cell_decimal_sign, &said.units.width);
    take_size(said.section, "area", texts.cell_decimal_sign, &said.units.section);
    if (said.rows != NULL)
        take_profile(&texts);
    return texts;
}
