/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The one table of units: of the tool, of its files, and of the page. */
#include "model.h"

#include <ctype.h>
#include <math.h>
#include <string.h>
#include <strings.h>

/* ---- The table ---- */

/* Powers of newton and of the root of a metre. An angle is a number, but no number is an angle. */
#define FORCE 1, 0, false
#define LENGTH 0, 2, false
#define STRESS 1, -4, false
#define MOMENT 1, 2, false
#define ANGLE 0, 0, true
#define PURE 0, 0, false

typedef struct {
    const char *name;
    double size;
    int force, half_length;
    bool is_angle;
} known_unit;

/* A pound-force is 4.4482216152605 N, an inch 0.0254 m, both by definition. */
static const known_unit known_units[] = {
    {"N", 1, FORCE},
    {"mN", 1e-3, FORCE},
    {"uN", 1e-6, FORCE},
    {"daN", 10, FORCE},
    {"kN", 1e3, FORCE},
    {"MN", 1e6, FORCE},
    {"newton", 1, FORCE},
    {"newtons", 1, FORCE},
    {"kgf", 9.80665, FORCE},
    {"lbf", 4.4482216152605, FORCE},
    {"lb", 4.4482216152605, FORCE},
    {"lbs", 4.4482216152605, FORCE},
    {"kip", 4448.2216152605, FORCE},
    {"Pa", 1, STRESS},
    {"hPa", 1e2, STRESS},
    {"kPa", 1e3, STRESS},
    {"MPa", 1e6, STRESS},
    {"GPa", 1e9, STRESS},
    {"bar", 1e5, STRESS},
    {"psi", 6894.757293168361, STRESS},
    {"ksi", 6894757.293168361, STRESS},
    {"Msi", 6894757293.168361, STRESS},
    {"m", 1, LENGTH},
    {"cm", 1e-2, LENGTH},
    {"mm", 1e-3, LENGTH},
    {"um", 1e-6, LENGTH},
    {"\xc2\xb5m", 1e-6, LENGTH}, /* the sign for micro, and the Greek letter */
    {"\xce\xbcm", 1e-6, LENGTH},
    {"micron", 1e-6, LENGTH},
    {"microns", 1e-6, LENGTH},
    {"nm", 1e-9, LENGTH},
    {"in", 0.0254, LENGTH},
    {"inch", 0.0254, LENGTH},
    {"inches", 0.0254, LENGTH},
    {"ft", 0.3048, LENGTH},
    {"Nm", 1, MOMENT},
    {"Nmm", 1e-3, MOMENT},
    {"kNm", 1e3, MOMENT},
    {"rad", 1, ANGLE},
    {"radians", 1, ANGLE},
    {"mrad", 1e-3, ANGLE},
    {"deg", 0.017453292519943295, ANGLE},
    {"degree", 0.017453292519943295, ANGLE},
    {"degrees", 0.017453292519943295, ANGLE},
    {"grad", 0.015707963267948967, ANGLE},
    {"\xc2\xb0", 0.017453292519943295, ANGLE},
    {"%", 1e-2, PURE},
    {"percent", 1e-2, PURE},
};
enum { UNIT_COUNT = sizeof known_units / sizeof known_units[0] };

static const known_unit *unit_named(const char *name, size_t length)
{
    for (size_t i = 0; i < UNIT_COUNT; i++)
        if (strlen(known_units[i].name) == length &&
            strncmp(known_units[i].name, name, length) == 0)
            return &known_units[i];
    return NULL;
}

bool unit_is_word(const char *word, size_t length)
{
    while (length > 1 && isdigit((unsigned char)word[length - 1]))
        length--; /* mm2 */
    for (size_t i = 0; i < UNIT_COUNT && length > 1; i++)
        if (strlen(known_units[i].name) == length &&
            strncasecmp(word, known_units[i].name, length) == 0)
            return true;
    return unit_named(word, length) != NULL;
}

/* ---- Reading ---- */

/* How many bytes of a sign stand here: 0 for none. */
static size_t sign_length(const char *text, const char *const signs[])
{
    for (; *signs != NULL; signs++)
        if (strncmp(text, *signs, strlen(*signs)) == 0)
            return strlen(*signs);
    return 0;
}

static size_t times_length(const char *text)
{
    static const char *const signs[] = {" ",        "*", "\xc2\xb7", "\xe2\x8b\x85",
                                        "\xc3\x97", ".", NULL};
    return sign_length(text, signs);
}

static size_t root_length(const char *text)
{
    static const char *const signs[] = {"sqrt", "root", "\xe2\x88\x9a", NULL};
    return sign_length(text, signs);
}

/* The letters of a name; one of a degree or percent is alone. */
static size_t name_length(const char *text)
{
    size_t length = 0;
    if (text[0] == '%' || strncmp(text, "\xc2\xb0", 2) == 0)
        return text[0] == '%' ? 1 : 2;
    while (isalpha((unsigned char)text[length]) ||
           ((unsigned char)text[length] >= 0x80 && times_length(text + length) == 0 &&
            root_length(text + length) == 0 && strncmp(text + length, "\xc2\xb2", 2) != 0 &&
            strncmp(text + length, "\xc2\xb3", 2) != 0))
        length++;
    return length;
}

/* Twice the power behind a name: "2", "^2", "^-1", "-1", "^0.5", "^1/2", "^(1/2)"; 2 where there is
 * none. */
static const char *take_power(const char *text, int *twice)
{
    static const struct {
        const char *text;
        int twice;
    } powers[] = {{"^(1/2)", 1}, {"^1/2", 1}, {"^0.5", 1}, {"^-1", -2},     {"^-2", -4},
                  {"-1", -2},    {"-2", -4},  {"^2", 4},   {"2", 4},        {"^3", 6},
                  {"3", 6},      {"^1", 2},   {"1/2", 1},  {"\xc2\xb2", 4}, {"\xc2\xb3", 6}};
    *twice = 2;
    for (size_t i = 0; i < sizeof powers / sizeof powers[0]; i++)
        if (strncmp(text, powers[i].text, strlen(powers[i].text)) == 0) {
            *twice = powers[i].twice;
            return text + strlen(powers[i].text);
        }
    return text;
}

/* One factor, as "mm", "mm^2", "sqrt(m)"; NULL where none is there. It multiplies the unit, or
 * divides it. */
static const char *take_factor(const char *text, int sign, measuring_unit *product)
{
    int twice;
    const size_t root = root_length(text);
    text += root;
    const bool in_brackets = root > 0 && text[0] == '(';
    text += in_brackets ? 1 : 0;
    const size_t length = name_length(text);
    const known_unit *one = unit_named(text, length);
    if (one == NULL)
        return NULL;
    text = take_power(text + length, &twice);
    if (in_brackets && *text++ != ')')
        return NULL;
    if (root > 0 && twice % 2 != 0)
        return NULL;
    twice = sign * (root > 0 ? twice / 2 : twice);
    product->size *= pow(one->size, twice / 2.0);
    product->half_force += one->force * twice;
    product->half_length += one->half_length * twice / 2;
    product->is_angle = product->is_angle || one->is_angle;
    return text;
}

bool unit_read(const char *text, measuring_unit *to)
{
    measuring_unit product = {.size = 1};
    int sign = 1;
    text += strspn(text, " \t");
    for (bool first = true; *text != '\0' || first; first = false) {
        if (!first) {
            const size_t blanks = strspn(text, " \t");
            const char *next = text + blanks;
            if (*next == '\0')
                break;
            sign = *next == '/' ? -1 : 1;
            const size_t times = *next == '/' ? 1 : times_length(next);
            if (blanks + times == 0 && root_length(next) == 0)
                return false;
            text = next + times;
            text += strspn(text, " \t");
        }
        text = take_factor(text, sign, &product);
        if (text == NULL)
            return false;
    }
    *to = product;
    return true;
}

/* ---- The working units ---- */

const unit_system units_unknown = {.width = NAN, .section = NAN, .K_length = NAN};

static bool is_length(const measuring_unit *u)
{
    return u->half_force == 0 && u->half_length == 2 && !u->is_angle;
}

static bool is_force(const measuring_unit *u)
{
    return u->half_force == 2 && u->half_length == 0;
}

static bool is_stress(const measuring_unit *u)
{
    return u->half_force == 2 && u->half_length == -4;
}

static bool is_same_size(double a, double b)
{
    return fabs(a - b) <= 1e-9 * fabs(b);
}

bool units_read(const char *text, unit_system *units, complaint *why)
{
    static const char allowed[] =
        "a length, a force and a stress, such as mm,N,MPa or m,N,Pa or in,lbf,psi or um,mN,GPa";
    char word[3][24];
    measuring_unit part[3];
    int at = 0;
    for (const char *from = text; at < 3; at++) {
        const size_t length = strcspn(from, ",");
        if (length == 0 || length >= sizeof word[0] || (from[length] == ',') != (at < 2))
            break;
        memcpy(word[at], from, length);
        word[at][length] = '\0';
        if (!unit_read(word[at], &part[at]))
            return complain(why, "%.60s: %s: no unit that is known; needed: %s", text, word[at],
                            allowed);
        from += length + 1;
    }
    if (at < 3 || !is_length(&part[0]) || !is_force(&part[1]) || !is_stress(&part[2]))
        return complain(why, "%.60s: must be %s", text, allowed);
    const double length = part[0].size, force = part[1].size;
    if (!is_same_size(part[2].size, force / length / length))
        return complain(why,
                        "%.60s: %s per %s^2 is no %s; needed: consistent units, such as "
                        "mm,N,MPa or m,N,Pa or in,lbf,psi or um,mN,GPa",
                        text, word[1], word[0], word[2]);
    units->is_known = true;
    units->length = length;
    units->force = force;
    return true;
}

/* ---- Conversion ---- */

/* A dimension by the words of columns: "force/length", "stress", "rad". */
static measuring_unit dimension_of(const char *words)
{
    static const struct {
        const char *words;
        measuring_unit dimension;
    } dimensions[] = {{"length", {1, 0, 2, false}},
                      {"area", {1, 0, 4, false}},
                      {"force", {1, 2, 0, false}},
                      {"force/length", {1, 2, -2, false}},
                      {"length/force", {1, -2, 2, false}},
                      {"area/force", {1, -2, 4, false}},
                      {"stress", {1, 2, -4, false}},
                      {"stress*sqrt(length)", {1, 2, -3, false}},
                      {"rad", {1, 0, 0, true}},
                      {"deg", {0.017453292519943295, 0, 0, true}}};
    for (size_t i = 0; i < sizeof dimensions / sizeof dimensions[0]; i++)
        if (strcmp(dimensions[i].words, words) == 0)
            return dimensions[i].dimension;
    return (measuring_unit){1, 0, 0, false};
}

static bool is_alike(const measuring_unit *a, const measuring_unit *b)
{
    return a->half_force == b->half_force && a->half_length == b->half_length &&
           a->is_angle == b->is_angle;
}

/* What a unit is in the working ones. */
static double working_size(const unit_system *units, const measuring_unit *u)
{
    return u->size /
           (pow(units->force, u->half_force / 2.0) * pow(units->length, u->half_length / 2.0));
}

double units_conversion(const unit_system *from, const unit_system *to, const char *dimension)
{
    const measuring_unit unit = dimension_of(dimension);
    return from->is_known && to->is_known ? working_size(to, &unit) / working_size(from, &unit) : 1;
}

/* What is divided where a quantity is given for the whole contact: its width, or the section. */
typedef struct {
    double size;     /* NAN where not given */
    int half_length; /* by which the whole has more */
    const char *option;
} whole;

static whole whole_of(const unit_system *units, unit_share of)
{
    if (of == SHARE_OF_WIDTH)
        return (whole){units->width, 2,
                       units->has_options ? "--width" : "the width of the contact"};
    if (of == SHARE_OF_SECTION)
        return (whole){units->section, 4, units->has_options ? "--section" : "the section"};
    return (whole){NAN, 0, ""};
}

bool units_factor(const unit_system *units, const char *own, const char *dimension, unit_share of,
                  double *factor, complaint *why)
{
    const measuring_unit needed = dimension_of(dimension);
    const whole divisor = whole_of(units, of);
    measuring_unit given;
    if (own == NULL) {
        *factor = isnan(divisor.size) ? 1 : 1 / divisor.size;
        return true;
    }
    if (!unit_read(own, &given))
        return complain(why,
                        "the unit '%.40s' is not known; known are such as N, kN, lbf, MPa, "
                        "psi, mm, um, in, N/mm, MPa sqrt(m)",
                        own);
    if (!units->is_known)
        return complain(why, "has the unit '%.40s', and no working units are known", own);
    given.is_angle = given.is_angle && strcmp(dimension, "slope") != 0; /* a small angle is one */
    measuring_unit whole_needed = needed;
    whole_needed.half_length += divisor.half_length;
    *factor = working_size(units, &given) / needed.size;
    if (is_alike(&given, &needed))
        return true;
    if (divisor.half_length > 0 && is_alike(&given, &whole_needed)) {
        *factor /= divisor.size;
        return !isnan(divisor.size) ||
               complain(why,
                        "the unit '%.40s' is that of the whole contact; needed: a unit of %s, "
                        "or %s",
                        own, dimension, divisor.option);
    }
    return complain(why, "the unit '%.40s' has the wrong dimension; needed: a unit of %s", own,
                    strcmp(dimension, "none") == 0 ? "a number, % at most" : dimension);
}

/* ---- A number with its unit ---- */

bool quantity_read(const char *text, char decimal_sign, double *value, const char **own)
{
    char number[NUMBER_SIZE * 2];
    *own = NULL;
    if (number_read_cell(text, decimal_sign, value))
        return true;
    text += strspn(text, " \t");
    for (size_t length = strlen(text); length-- > 1;) {
        measuring_unit given;
        if (length >= sizeof number || !isdigit((unsigned char)text[length - 1]))
            continue;
        memcpy(number, text, length);
        number[length] = '\0';
        if (number_read_cell(number, decimal_sign, value) && unit_read(text + length, &given)) {
            *own = text + length + strspn(text + length, " \t");
            return true;
        }
    }
    return false;
}
