/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "cycle.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

static const char of_K[] = "stress*sqrt(length)"; /* the dimension of a K */

/* A constant that a criterion has is told by the library; a limit, and what a contact or a critical
 * distance has, is not: number is -1. */
typedef struct {
    const char *name, *meaning;
    int32_t number, j;
    double low, high;
    const char *unit;
} constant;

typedef struct {
    constant list[MATERIAL_MAX];
    int count;
} catalogue;

static bool has(const catalogue *known, const char *name)
{
    for (int i = 0; i < known->count; i++)
        if (strcmp(known->list[i].name, name) == 0)
            return true;
    return false;
}

static void add(catalogue *known, constant next)
{
    if (next.name[0] != '\0' && !has(known, next.name) && known->count < MATERIAL_MAX)
        known->list[known->count++] = next;
}

static void add_those_of_criteria(catalogue *known)
{
    for (int32_t i = 0; i < rwedge_criterion_count(); i++)
        for (int32_t j = 0; rwedge_constant_name(i, j)[0] != '\0'; j++) {
            constant next = {rwedge_constant_name(i, j), rwedge_constant_text(i, j), i, j, 0, 0,
                             rwedge_constant_unit(i, j)};
            rwedge_constant_range(i, j, &next.low, &next.high);
            add(known, next);
        }
    for (int32_t i = 0; i < rwedge_criterion_count(); i++)
        if (strcmp(rwedge_criterion_limit(i), "1") != 0)
            add(known, (constant){rwedge_criterion_limit(i), "what its criterion must not exceed",
                                  -1, 0, 0, 1e60, rwedge_criterion_unit(i)});
}

/* Made once, before any thread. */
static const catalogue *constants_known(void)
{
    static catalogue known;
    if (known.count > 0)
        return &known;
    add_those_of_criteria(&known);
    add(&known, (constant){"nu", "Poisson's ratio", -1, 0, -1, 0.5, "none"});
    add(&known, (constant){"dK_th", "range of the threshold of long cracks", -1, 0, 0, 1e60, of_K});
    add(&known,
        (constant){"ds0", "range of the plain fatigue limit", -1, 0, 1e-60, 1e60, "stress"});
    add(&known, (constant){"paris_C", "factor of the growth of a crack", -1, 0, 1e-60, 1e60, ""});
    add(&known,
        (constant){"paris_m", "exponent of the growth of a crack", -1, 0, 1e-60, 1e60, "none"});
    add(&known, (constant){"K_c", "K at which it breaks", -1, 0, 1e-60, 1e60, of_K});
    return &known;
}

int material_count(void)
{
    return constants_known()->count;
}

const char *material_name(int i)
{
    return constants_known()->list[i].name;
}

const char *material_meaning(int i)
{
    return constants_known()->list[i].meaning;
}

bool material_is_in_range(int i, double value)
{
    const constant *one = &constants_known()->list[i];
    return value >= one->low && value <= one->high && number_is_size(value);
}

const char *material_allowed(int i)
{
    static char text[60];
    const constant *one = &constants_known()->list[i];
    const double low = one->low == 0 ? 1e-60 : one->low;
    const char *zero = one->low == 0 ? "0, or " : "";
    if (one->high == 1e60)
        snprintf(text, sizeof text, "%s%g to 1e60", zero, low);
    else
        snprintf(text, sizeof text, "%s%g to %g", zero, low, one->high);
    return text;
}

const char *material_unit(int i)
{
    return constants_known()->list[i].unit;
}

bool material_is_option(int i)
{
    const constant *one = &constants_known()->list[i];
    return one->number >= 0 && one->j < rwedge_criterion_constants(one->number) &&
           strcmp(one->name, "E") != 0 && strcmp(one->name, "yield_stress") != 0;
}

bool material_take(int i, const char *text, char decimal_sign, const unit_system *units,
                   material *constants, complaint *why)
{
    const constant *one = &constants_known()->list[i];
    const char *own = NULL;
    double value, factor = 1;
    const bool is_read =
        strcmp(one->name, "paris_C") == 0
            ? growth_read(text, decimal_sign, material_value(constants, "paris_m"), units, &value,
                          why)
        : strcmp(one->unit, of_K) == 0
            ? intensity_read(text, decimal_sign, units, &value, why)
            : quantity_read(text, decimal_sign, &value, &own) || complain(why, "must be a number");
    if (!is_read || (own != NULL && !units_factor(units, own, one->unit, SHARE_NONE, &factor, why)))
        return false;
    value *= factor;
    if (!(value >= one->low && value <= one->high && number_is_size(value)))
        return complain(why, "must be a number, %s", material_allowed(i));
    constants->value[i] = value;
    return true;
}

double material_conversion(int i, double m, const unit_system *from, const unit_system *to)
{
    if (strcmp(material_name(i), "paris_C") != 0)
        return units_conversion(from, to, material_unit(i));
    return units_conversion(from, to, "length") * pow(units_conversion(from, to, of_K), -m);
}

material material_unknown(void)
{
    material constants;
    for (int i = 0; i < MATERIAL_MAX; i++)
        constants.value[i] = NAN;
    return constants;
}

int material_constant(const char *name)
{
    int i = material_count() - 1;
    while (i >= 0 && strcmp(name, material_name(i)) != 0)
        i--;
    return i;
}

double material_value(const material *constants, const char *name)
{
    return constants->value[material_constant(name)];
}

bool material_is_remark(const char *name)
{
    return strcmp(name, "name") == 0 || strcmp(name, "source") == 0 || strcmp(name, "units") == 0;
}

/* A bare stress of a material that says the units of its numbers gets its own. */
static const char *with_unit(int i, const char *text, const char *units, char room[200])
{
    double number;
    const char *stress = units != NULL ? strrchr(units, ',') : NULL;
    if (stress == NULL || strcmp(material_unit(i), "stress") != 0 ||
        !number_read_cell(text, '.', &number))
        return text;
    snprintf(room, 200, "%.60s %.60s", text, stress + 1);
    return room;
}

/* The units of the numbers; NULL where none are said. */
static const char *units_of_words(size_t count, const constant_words words[])
{
    for (size_t i = 0; i < count; i++)
        if (strcmp(words[i].name, "units") == 0)
            return words[i].text;
    return NULL;
}

static bool refuse_name(const char *name, complaint *why)
{
    nearest_name near = nearest_to(name);
    for (int i = 0; i < material_count(); i++)
        nearest_try(&near, material_name(i));
    return complain(why, "no constant that is known here%s%s",
                    near.name != NULL ? "; the nearest is " : "",
                    near.name != NULL ? near.name : "");
}

static bool take_words(const constant_words *words, const char *said, const unit_system *units,
                       material *constants, complaint *why)
{
    char room[200];
    const int i = material_constant(words->name);
    return i < 0 ? refuse_name(words->name, why)
                 : material_take(i, with_unit(i, words->text, said, room), '.', units, constants,
                                 why);
}

/* It depends on its exponent. */
static bool is_last(const constant_words *words)
{
    return strcmp(words->name, "paris_C") == 0;
}

bool material_take_all(size_t count, const constant_words words[], const unit_system *units,
                       material *constants, const constant_words **fault, complaint *why)
{
    const char *said = units_of_words(count, words);
    for (int last = 0; last < 2; last++)
        for (size_t i = 0; i < count; i++) {
            *fault = &words[i];
            if (!material_is_remark(words[i].name) && is_last(&words[i]) == (last == 1) &&
                !take_words(&words[i], said, units, constants, why))
                return false;
        }
    return true;
}

double material_allowable(const material *constants, int criterion)
{
    const char *limit = criterion_is_damage(criterion) ? "1" : rwedge_criterion_limit(criterion);
    if (limit[0] == '\0')
        return NAN;
    return strcmp(limit, "1") == 0 ? 1 : material_value(constants, limit);
}
