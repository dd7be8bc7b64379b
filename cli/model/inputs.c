/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "model.h"

#include <ctype.h>
#include <math.h>
#include <stdio.h>
#include <string.h>
#include <strings.h>

#define NAMES(name) name, "--" name, name
#define ABOVE_0 0, HUGE_VAL, true, "a number above 0"
#define ANY -HUGE_VAL, HUGE_VAL, false, "a number"
#define NOT_BELOW_0 0, HUGE_VAL, false, "a number not below 0"

const input_kind input_kinds[INPUT_COUNT] = {
    [INPUT_E1] = {NAMES("E1"), "Young's modulus of body 1, whose stresses are computed", "STRESS",
                  "stress", "Young's modulus of body 1", ABOVE_0},
    [INPUT_NU1] = {NAMES("nu1"), "Poisson's ratio of body 1, 0 to 0.5, or --nu", "NUMBER", "none",
                   "Poisson's ratio", 0, 0.5, false, "a number from 0 to 0.5"},
    [INPUT_E2] = {NAMES("E2"), "Young's modulus of body 2, inf if it is rigid (default: as body 1)",
                  "STRESS", "stress", "Young's modulus", 0, HUGE_VAL, true,
                  "a number above 0, or inf"},
    [INPUT_NU2] = {NAMES("nu2"), "Poisson's ratio of body 2, 0 to 0.5 (default: as body 1)",
                   "NUMBER", "none", "Poisson's ratio", 0, 0.5, false, "a number from 0 to 0.5"},
    [INPUT_THETA] = {NAMES("theta"), "Angle between flank and surface, in radians", "ANGLE", "rad",
                     "the angle", 0, 1.5707963267948966, true,
                     "a number above 0 and below pi/2, in radians"},
    [INPUT_THETA_DEG] = {"theta-deg", "--theta-deg", "theta_deg",
                         "Angle between flank and surface in degrees instead", "ANGLE", "deg",
                         "the angle", 0, 90, true, "a number above 0 and below 90, in degrees"},
    [INPUT_A] = {NAMES("a"), "Half-width of the rounding; 0 is the sharp wedge", "LENGTH", "length",
                 "the half-width of the rounding", NOT_BELOW_0},
    [INPUT_RADIUS] = {NAMES("radius"),
                      "Radius of the rounding instead, a/theta; alone, of a cylinder", "LENGTH",
                      "length", "the radius", NOT_BELOW_0},
    [INPUT_RADIUS1] = {NAMES("radius1"), "Radius of body 1 instead, negative where it is concave",
                       "LENGTH", "length", "the radius of body 1", ANY},
    [INPUT_RADIUS2] = {NAMES("radius2"), "Radius of body 2 instead: R = 1/(1/R1 + 1/R2)", "LENGTH",
                       "length", "the radius of body 2", ANY},
    [INPUT_FLAT] = {NAMES("flat"),
                    "Half-width of the flat of a flat pad, whose edges have the radius", "LENGTH",
                    "length", "the half-width of the flat", ABOVE_0},
    [INPUT_PROFILE] = {NAMES("profile"),
                       "Any convex pad: a CSV file with the columns x, and slope or height", "FILE",
                       "name", "the profile", ANY},
    [INPUT_TILT] = {NAMES("tilt"),
                    "Hold the pad at an angle, in radians, in place of --M, which is then a result",
                    "ANGLE", "rad", "the tilt", -1.5707963267948966, 1.5707963267948966, true,
                    "a number below pi/2 in magnitude, in radians"},
    [INPUT_P] = {NAMES("P"), "Normal force per unit length", "FORCE", "force/length",
                 "the normal force", ABOVE_0, SHARE_OF_WIDTH},
    [INPUT_M] = {NAMES("M"), "Moment per unit length, positive presses the side x > 0 (default 0)",
                 "MOMENT", "force", "the moment", ANY, SHARE_OF_WIDTH},
    [INPUT_Q] = {NAMES("Q"), "Tangential force per unit length (default 0)", "FORCE",
                 "force/length", "the tangential force", ANY, SHARE_OF_WIDTH},
    [INPUT_SIGMA] = {NAMES("sigma"), "Bulk tension of body 1 along the surface (default 0)",
                     "STRESS", "stress", "the bulk tension", ANY, SHARE_OF_SECTION},
    [INPUT_F] = {NAMES("f"), "Coefficient of friction, or --friction (default 0)", "NUMBER", "none",
                 "the coefficient of friction", 0, 1e6, false, "a number from 0 to 1000000"},
    [INPUT_K] = {NAMES("k"), "Yield stress of body 1 in pure shear", "STRESS", "stress",
                 "the yield stress", ABOVE_0},
    [INPUT_YIELD_STRESS] = {"yield-stress", "--yield-stress", "yield_stress",
                            "Yield stress in tension instead, sqrt(3) k", "STRESS", "stress",
                            "the yield stress", ABOVE_0},
};

const double usual_tolerance = 1e-4;

int input_alternative(int input)
{
    static const int pairs[][2] = {{INPUT_THETA, INPUT_THETA_DEG},
                                   {INPUT_A, INPUT_RADIUS},
                                   {INPUT_K, INPUT_YIELD_STRESS},
                                   {INPUT_M, INPUT_TILT}};
    for (size_t i = 0; i < sizeof pairs / sizeof pairs[0]; i++)
        for (int j = 0; j < 2; j++)
            if (pairs[i][j] == input)
                return pairs[i][1 - j];
    return -1;
}

const char *input_name(const input_texts *texts, int input)
{
    return texts->is_cell[input] ? input_kinds[input].column : input_kinds[input].flag;
}

const char *input_text(const input_texts *texts, int input, char number[NUMBER_SIZE])
{
    if (!texts->has_number[input])
        return texts->text[input];
    number_write(texts->number[input], NUMBER_DIGITS, '.', number);
    return number;
}

bool input_is_given(const input_texts *texts, int input)
{
    const char *text = texts->text[input];
    if (texts->has_number[input])
        return true;
    return text != NULL && (!texts->is_cell[input] || text[strspn(text, " \t")] != '\0');
}

void input_set(input_texts *texts, int input, double value)
{
    const int other = input_alternative(input);
    texts->text[input] = NULL;
    texts->is_cell[input] = false;
    texts->has_number[input] = true;
    texts->number[input] = value;
    if (other < 0)
        return;
    texts->text[other] = NULL;
    texts->has_number[other] = false;
}

/* What stands behind a number where a unit would; "" where nothing that looks like one does. */
static const char *unit_like(const char *text)
{
    const char *number = text + strspn(text, " \t+-");
    const size_t digits = strspn(number, "0123456789.");
    const char *rest = number + digits + strspn(number + digits, " \t");
    const bool is_word = isalpha((unsigned char)rest[0]) && isalpha((unsigned char)rest[1]);
    return digits > 0 && is_word ? rest : "";
}

/* Adds what the commonest mistakes need. */
static void add_hint(const input_texts *texts, int input, complaint *why)
{
    const char *text = texts->text[input];
    const bool is_cell = texts->is_cell[input], comma = is_cell && texts->cell_decimal_sign == ',';
    if (input == INPUT_E1 && strcasecmp(text, "inf") == 0)
        list_add(why->text, sizeof why->text, "; ", "a rigid body is body 2, with --E2 inf");
    else if (comma && strchr(text, '.') != NULL)
        list_add(why->text, sizeof why->text, "; ", "the decimal sign is a comma");
    else if (!comma && strchr(text, ',') != NULL)
        list_add(why->text, sizeof why->text, "; ", "the decimal sign is a point%s%s",
                 is_cell ? ", or a comma " : "", is_cell ? texts->how_comma : "");
    else if (unit_like(text)[0] != '\0')
        list_add(why->text, sizeof why->text, "; ", "'%.20s' is no unit that is known",
                 unit_like(text));
}

static bool is_in(double value, const input_kind *kind)
{
    return kind->open ? value > kind->lo && value < kind->hi
                      : value >= kind->lo && value <= kind->hi;
}

/* What the number of a text is multiplied by. */
static bool find_factor(const input_texts *texts, int input, const char *own, double *factor,
                        complaint *why)
{
    const unit_system *units = texts->units != NULL ? texts->units : &units_unknown;
    const input_kind *kind = &input_kinds[input];
    complaint reason;
    *factor = texts->cell_factor[input];
    if (own == NULL && texts->is_cell[input] && *factor != 0)
        return true;
    return units_factor(units, own, kind->unit, kind->of, factor, &reason) ||
           complain(why, "%s %.60s: %s%s", input_name(texts, input), texts->text[input],
                    reason.text,
                    units->is_known || texts->how_units == NULL ? "" : texts->how_units);
}

/* Reads a number in the working units; *is_number says whether it is one. */
static bool read_number(const input_texts *texts, int input, double *value, bool *is_number,
                        complaint *why)
{
    const char *own;
    double factor;
    *is_number = quantity_read(texts->text[input],
                               texts->is_cell[input] ? texts->cell_decimal_sign : '.', value, &own);
    if (!*is_number)
        return true;
    if (!find_factor(texts, input, own, &factor, why))
        return false;
    *value *= factor;
    return true;
}

static bool take_number(const input_texts *texts, int input, double *value, complaint *why)
{
    const input_kind *kind = &input_kinds[input];
    *value = texts->number[input];
    return (is_in(*value, kind) && number_is_size(*value)) ||
           complain(why, "%s %.6g: %s must be %s", input_name(texts, input), *value, kind->subject,
                    kind->domain);
}

bool input_read(const input_texts *texts, int input, double *value, complaint *why)
{
    if (texts->has_number[input])
        return take_number(texts, input, value, why);
    const char *text = texts->text[input];
    const input_kind *kind = &input_kinds[input];
    const bool rigid = strcasecmp(text, "inf") == 0;
    if (input == INPUT_PROFILE) {
        const pad_profile *places = texts->profile_named(text, why);
        *value = places != NULL ? (double)places->count : NAN;
        return places != NULL;
    }
    *value = HUGE_VAL;
    bool is_number = false;
    if (!rigid && !read_number(texts, input, value, &is_number, why))
        return false;
    if (rigid ? input == INPUT_E2 : is_number && is_in(*value, kind)) {
        /* the header's first page: whatever has a size is 0 or 1e-60 to 1e60 */
        if (rigid || input == INPUT_NU1 || input == INPUT_NU2 || number_is_size(*value))
            return true;
        return complain(why, "%s %.60s: %s must be 1e-60 to 1e60 in magnitude%s",
                        input_name(texts, input), text, kind->subject,
                        is_in(0, kind) ? ", or 0" : "");
    }
    const char *shown = text[strspn(text, " \t")] != '\0' ? text : "''";
    complain(why, "%s %.60s: %s must be %s", input_name(texts, input), shown, kind->subject,
             kind->domain);
    add_hint(texts, input, why);
    return false;
}
