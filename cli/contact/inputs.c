/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "inputs.h"

#include "text/number.h"

#include <math.h>
#include <string.h>
#include <strings.h>

#define INPUT(option, input) option, '\0', POPT_ARG_STRING, NULL, OPTION_INPUT + (input)

struct poptOption input_option_table[] = {
    {INPUT("E1", INPUT_E1), "Young's modulus of body 1, whose stresses are computed", "STRESS"},
    {INPUT("nu1", INPUT_NU1), "Poisson's ratio of body 1, 0 to 0.5, or --nu", "NUMBER"},
    {INPUT("E2", INPUT_E2), "Young's modulus of body 2, inf if it is rigid (default: as body 1)",
     "STRESS"},
    {INPUT("nu2", INPUT_NU2), "Poisson's ratio of body 2, 0 to 0.5 (default: as body 1)", "NUMBER"},
    {INPUT("theta", INPUT_THETA), "Angle between flank and surface, in radians", "ANGLE"},
    {INPUT("theta-deg", INPUT_THETA_DEG), "The same in degrees", "ANGLE"},
    {INPUT("a", INPUT_A), "Half-width of the rounding; 0 is the sharp wedge", "LENGTH"},
    {INPUT("radius", INPUT_RADIUS), "Radius of the rounding instead, a/theta", "LENGTH"},
    {INPUT("P", INPUT_P), "Normal force per unit length", "FORCE"},
    {INPUT("M", INPUT_M), "Moment per unit length, positive presses the side x > 0 (default 0)",
     "MOMENT"},
    {INPUT("Q", INPUT_Q), "Tangential force per unit length (default 0)", "FORCE"},
    {INPUT("sigma", INPUT_SIGMA), "Bulk tension of body 1 along the surface (default 0)", "STRESS"},
    {INPUT("f", INPUT_F), "Coefficient of friction, or --friction (default 0)", "NUMBER"},
    OTHER_NAME("friction", OPTION_INPUT + INPUT_F),
    OTHER_NAME("nu", OPTION_INPUT + INPUT_NU1),
    POPT_TABLEEND,
};

struct poptOption strength_option_table[] = {
    {INPUT("k", INPUT_K), "Yield stress of body 1 in pure shear", "STRESS"},
    {INPUT("yield-stress", INPUT_YIELD_STRESS), "Yield stress in tension instead, sqrt(3) k",
     "STRESS"},
    POPT_TABLEEND,
};

typedef struct {
    const char *name; /* as the subject of a sentence */
    double lo, hi;
    bool open; /* the ends are not in the domain */
    const char *domain;
} input_domain;

#define ABOVE_0 0, HUGE_VAL, true, "a number above 0"
#define ANY -HUGE_VAL, HUGE_VAL, false, "a number"
#define NOT_BELOW_0 0, HUGE_VAL, false, "a number not below 0"

static const input_domain domains[INPUT_COUNT] = {
    [INPUT_E1] = {"Young's modulus of body 1", ABOVE_0},
    [INPUT_NU1] = {"Poisson's ratio", 0, 0.5, false, "a number from 0 to 0.5"},
    [INPUT_E2] = {"Young's modulus", 0, HUGE_VAL, true, "a number above 0, or inf"},
    [INPUT_NU2] = {"Poisson's ratio", 0, 0.5, false, "a number from 0 to 0.5"},
    [INPUT_THETA] = {"the angle", 0, 1.5707963267948966, true,
                     "a number above 0 and below pi/2, in radians"},
    [INPUT_THETA_DEG] = {"the angle", 0, 90, true, "a number above 0 and below 90, in degrees"},
    [INPUT_A] = {"the half-width of the rounding", NOT_BELOW_0},
    [INPUT_RADIUS] = {"the radius", NOT_BELOW_0},
    [INPUT_P] = {"the normal force", ABOVE_0},
    [INPUT_M] = {"the moment", ANY},
    [INPUT_Q] = {"the tangential force", ANY},
    [INPUT_SIGMA] = {"the bulk tension", ANY},
    [INPUT_F] = {"the coefficient of friction", 0, 1e6, false, "a number from 0 to 1000000"},
    [INPUT_K] = {"the yield stress", ABOVE_0},
    [INPUT_YIELD_STRESS] = {"the yield stress", ABOVE_0},
};

static const char *option_of(int input)
{
    const struct poptOption *option = input < INPUT_K ? input_option_table : strength_option_table;
    while (option->val != OPTION_INPUT + input)
        option++;
    return option->longName;
}

const char *input_column(int input, char name[INPUT_NAME_SIZE])
{
    snprintf(name, INPUT_NAME_SIZE, "%s", option_of(input));
    for (char *dash = strchr(name, '-'); dash != NULL; dash = strchr(dash, '-'))
        *dash = '_';
    return name;
}

int input_alternative(int input)
{
    static const int pairs[][2] = {
        {INPUT_THETA, INPUT_THETA_DEG}, {INPUT_A, INPUT_RADIUS}, {INPUT_K, INPUT_YIELD_STRESS}};
    for (size_t i = 0; i < sizeof pairs / sizeof pairs[0]; i++)
        for (int j = 0; j < 2; j++)
            if (pairs[i][j] == input)
                return pairs[i][1 - j];
    return -1;
}

const char *input_name(const input_texts *given, int input, char name[INPUT_NAME_SIZE])
{
    if (given->is_cell[input])
        return input_column(input, name);
    snprintf(name, INPUT_NAME_SIZE, "--%s", option_of(input));
    return name;
}

void input_texts_from_options(const arguments *given, input_texts *texts)
{
    *texts = (input_texts){.cell_decimal_sign = '.'};
    for (int i = 0; i < INPUT_COUNT; i++)
        texts->text[i] = given->value[OPTION_INPUT + i];
}

bool input_is_given(const input_texts *given, int input)
{
    const char *text = given->text[input];
    return text != NULL && (!given->is_cell[input] || text[strspn(text, " \t")] != '\0');
}

/* The commonest mistake gets a message of its own. */
static const char *hint(const input_texts *given, int input)
{
    const bool cell = given->is_cell[input];
    if (cell && given->cell_decimal_sign == ',' && strchr(given->text[input], '.') != NULL)
        return "; the decimal sign is a comma";
    if (strchr(given->text[input], ',') == NULL || (cell && given->cell_decimal_sign == ','))
        return "";
    return cell ? "; the decimal sign is a point, or a comma with --decimal-comma"
                : "; the decimal sign is a point";
}

static bool is_in(double value, const input_domain *domain)
{
    return domain->open ? value > domain->lo && value < domain->hi
                        : value >= domain->lo && value <= domain->hi;
}

/* The header's first page: whatever has a size is 0 or 1e-60 to 1e60. */
static bool has_possible_size(int input, double value)
{
    const bool without_size = input == INPUT_NU1 || input == INPUT_NU2;
    return without_size || value == 0 || (fabs(value) >= 1e-60 && fabs(value) <= 1e60);
}

bool input_read(const input_texts *given, int input, double *value, char complaint[COMPLAINT_SIZE])
{
    const char *text = given->text[input];
    const char decimal_sign = given->is_cell[input] ? given->cell_decimal_sign : '.';
    const input_domain *domain = &domains[input];
    const bool rigid = strcasecmp(text, "inf") == 0;
    char name[INPUT_NAME_SIZE];
    *value = HUGE_VAL;
    if (rigid ? input == INPUT_E2
              : number_read_cell(text, decimal_sign, value) && is_in(*value, domain)) {
        if (rigid || has_possible_size(input, *value))
            return true;
        snprintf(complaint, COMPLAINT_SIZE, "%s %.60s: %s must be 1e-60 to 1e60 in magnitude%s",
                 input_name(given, input, name), text, domain->name,
                 is_in(0, domain) ? ", or 0" : "");
        return false;
    }
    const char *shown = text[strspn(text, " \t")] != '\0' ? text : "''";
    snprintf(complaint, COMPLAINT_SIZE, "%s %.60s: %s must be %s%s", input_name(given, input, name),
             shown, domain->name, domain->domain,
             rigid && input == INPUT_E1 ? "; a rigid body is body 2, with --E2 inf"
                                        : hint(given, input));
    return false;
}
