/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "fretting.h"

#include <ctype.h>
#include <math.h>
#include <string.h>

/* ---- The options ---- */

enum { TEXT_SIZE = 200 };

static const struct poptOption last_options[] = {
    {VALUE("archard", OPTION_ARCHARD),
     "Depth worn per energy and area; the profile does not change", "NUMBER"},
};
enum { LAST_OPTIONS = sizeof last_options / sizeof last_options[0] };

/* --criteria, an option for each constant, the last ones, the end. */
struct poptOption criteria_option_table[1 + MATERIAL_MAX + LAST_OPTIONS + 1];

/* "findley-k" */
static const char *option_name(int constant)
{
    static char names[MATERIAL_MAX][MEASURE_NAME_SIZE];
    char *name = names[constant];
    snprintf(name, MEASURE_NAME_SIZE, "%s", material_name(constant));
    for (char *c = name; *c != '\0'; c++)
        *c = *c == '_' ? '-' : (char)tolower((unsigned char)*c);
    return name;
}

static struct poptOption list_option(void)
{
    static char text[TEXT_SIZE * 2] = "Of the columns at the end these alone: ";
    const size_t begins = strlen(text);
    for (int i = 0; i < CRITERION_COUNT; i++)
        if (criterion_exists(i))
            list_add(text + begins, sizeof text - begins, ", ", "%s", criterion_name(i));
    return (struct poptOption){VALUE("criteria", OPTION_CRITERIA), text, "LIST"};
}

void criteria_options_prepare(void)
{
    struct poptOption *next = criteria_option_table;
    *next++ = list_option();
    for (int i = 0; i < material_count(); i++)
        if (material_is_option(i))
            *next++ = (struct poptOption){VALUE(option_name(i), OPTION_CONSTANT + i),
                                          material_meaning(i), "NUMBER"};
    for (int i = 0; i < LAST_OPTIONS; i++)
        *next++ = last_options[i];
}

/* ---- Constants ---- */

static void read_constant(const arguments *line, int i, criteria *asked)
{
    const char *text = line->value[OPTION_CONSTANT + i];
    double *value = &asked->given.value[i];
    if (text != NULL && !(number_read(text, value) && material_is_in_range(i, *value)))
        usage_error("--%s %s: must be a number, %s", option_name(i), text, material_allowed(i));
}

static double read_archard(const arguments *line)
{
    const char *text = line->value[OPTION_ARCHARD];
    double value = NAN;
    if (text != NULL && !(number_read(text, &value) && value >= 1e-60 && number_is_size(value)))
        usage_error("--archard %s: must be a number 1e-60 to 1e60", text);
    return value;
}

/* ---- What is asked for ---- */

/* An option of a criterion asks for it. So do its first constant, and the one that it must not
 * exceed, in a file: a tensile strength does not, as many materials have one. */
static bool is_asked_for(const arguments *line, const material *constants, int criterion)
{
    for (int j = 0; j < rwedge_criterion_constants(criterion); j++) {
        const char *name = rwedge_constant_name(criterion, j);
        const int i = material_constant(name);
        const bool tells = j == 0 || strcmp(name, rwedge_criterion_limit(criterion)) == 0;
        const bool is_given = !isnan(constants->value[i]) && tells;
        if (material_is_option(i) && strcmp(name, "fs_k") != 0 &&
            (line->value[OPTION_CONSTANT + i] != NULL || is_given))
            return true;
    }
    return false;
}

/* A constant that lacks, as the contact or an option or the file gives it. */
NO_RETURN static void refuse_lacking(int criterion, const char *constant)
{
    const int i = material_constant(constant);
    char others[TEXT_SIZE] = "";
    if (strcmp(constant, "yield_stress") == 0)
        usage_error("%s: needs --yield-stress", criterion_name(criterion));
    if (material_is_option(i))
        usage_error("%s: needs --%s, or %s of --material", criterion_name(criterion),
                    option_name(i), constant);
    for (int j = rwedge_criterion_constants(criterion - DAMAGE);
         j < rwedge_damage_constants(criterion - DAMAGE); j++)
        if (isnan(rwedge_constant_usual(criterion - DAMAGE, j)))
            list_add(others, sizeof others, ", ", "%s",
                     rwedge_constant_name(criterion - DAMAGE, j));
    usage_error("%s: needs %s of --material", criterion_name(criterion), others);
}

static void read_names(const char *text, criteria *asked)
{
    char allowed[TEXT_SIZE * 2] = "";
    for (int i = 0; i < CRITERION_COUNT; i++)
        if (criterion_exists(i))
            list_add(allowed, sizeof allowed, ", ", "%s", criterion_name(i));
    for (const char *word = text; word != NULL;) {
        const size_t length = strcspn(word, ",");
        int i = 0;
        while (i < CRITERION_COUNT &&
               !(criterion_exists(i) && strlen(criterion_name(i)) == length &&
                 strncmp(criterion_name(i), word, length) == 0))
            i++;
        if (i == CRITERION_COUNT)
            usage_error("--criteria %s: must be a list of: %s", text, allowed);
        asked->is_wanted[i] = true;
        word = word[length] == ',' ? word + length + 1 : NULL;
    }
}

/* ---- All ---- */

/* In plane stress the contact does not have it, but the strains do. */
static void read_nu(const input_texts *texts, criteria *asked)
{
    complaint why;
    if (!input_is_given(texts, INPUT_NU1))
        return; /* it will be missed */
    if (!input_read(texts, INPUT_NU1, &asked->nu, &why))
        usage_error("%s", why.text);
}

void criteria_read(const arguments *line, const material *constants, const input_texts *texts,
                   criteria *asked)
{
    *asked = criteria_usual(&(contact_case){.nu1 = NAN});
    asked->given = *constants;
    for (int i = 0; i < material_count(); i++)
        read_constant(line, i, asked);
    asked->archard = read_archard(line);
    asked->is_plane_stress = texts->is_plane_stress;
    if (asked->is_plane_stress)
        read_nu(texts, asked);
    asked->is_listed = line->value[OPTION_CRITERIA] != NULL;
    read_names(line->value[OPTION_CRITERIA], asked);
    for (int i = 0; i < DAMAGE && !asked->is_listed; i++)
        asked->is_wanted[i] = is_asked_for(line, constants, i);
}

/* What is wanted must have its constants. SWT is always computed, and Fatemi and Socie's with a
 * yield stress. */
static void take_criterion(const contact_case *setup, int i, criteria *asked)
{
    const bool is_usual = i == RWEDGE_MEASURE_SWT || i == RWEDGE_MEASURE_FATEMI_SOCIE;
    const char *lacks = criteria_take(setup, i, asked);
    if (lacks != NULL && asked->is_wanted[i])
        refuse_lacking(i, lacks);
    asked->is_computed[i] = lacks == NULL && (asked->is_wanted[i] || is_usual);
}

/* Damage is written where its criterion is, or by itself; without a list, where it has a curve. */
static void take_damage(const contact_case *setup, int criterion, criteria *asked)
{
    const int damage = criterion + DAMAGE;
    const char *lacks = criteria_take(setup, damage, asked);
    if (lacks != NULL && asked->is_wanted[damage])
        refuse_lacking(damage, lacks);
    const bool is_asked = asked->is_wanted[damage] || asked->is_wanted[criterion];
    asked->is_wanted[damage] = lacks == NULL && (is_asked || !asked->is_listed);
    asked->is_computed[damage] = asked->is_wanted[damage];
}

void criteria_read_strength(const arguments *line, const contact_case *setup, criteria *asked)
{
    const char *k = line->value[OPTION_CONSTANT + material_constant("fs_k")];
    if (k != NULL && isnan(setup->k))
        usage_error("--fs-k %s: needs --k or --yield-stress", k);
    for (int i = 0; i < DAMAGE; i++)
        if (criterion_exists(i))
            take_criterion(setup, i, asked);
    for (int i = 0; i < DAMAGE; i++)
        if (criterion_exists(i + DAMAGE))
            take_damage(setup, i, asked);
    if (!asked->is_plane_stress)
        asked->nu = setup->nu1;
}
