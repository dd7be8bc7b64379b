/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "fretting.h"

#include <math.h>
#include <string.h>

struct poptOption criteria_option_table[] = {
    {"criteria", '\0', POPT_ARG_STRING, NULL, OPTION_CRITERIA,
     "Columns of these alone: swt, fatemi-socie, findley, modified-wohler, mcdiarmid, crossland, "
     "dang-van, swt-damage, fatemi-socie-damage",
     "LIST"},
    {"fs-k", '\0', POPT_ARG_STRING, NULL, OPTION_OF(MATERIAL_FS_K),
     "Fatemi and Socie's k, beside a yield stress (default 1)", "NUMBER"},
    {"findley-k", '\0', POPT_ARG_STRING, NULL, OPTION_OF(MATERIAL_FINDLEY_K), "Findley's k",
     "NUMBER"},
    {"kappa", '\0', POPT_ARG_STRING, NULL, OPTION_OF(MATERIAL_KAPPA),
     "kappa of the modified Woehler curve, a stress", "NUMBER"},
    {"t-a", '\0', POPT_ARG_STRING, NULL, OPTION_OF(MATERIAL_T_A),
     "McDiarmid's fully reversed limit in torsion", "NUMBER"},
    {"su", '\0', POPT_ARG_STRING, NULL, OPTION_OF(MATERIAL_SU), "McDiarmid's tensile strength",
     "NUMBER"},
    {"crossland-alpha", '\0', POPT_ARG_STRING, NULL, OPTION_OF(MATERIAL_CROSSLAND_ALPHA),
     "Crossland's share of the hydrostatic stress", "NUMBER"},
    {"dang-van-alpha", '\0', POPT_ARG_STRING, NULL, OPTION_OF(MATERIAL_DANG_VAN_ALPHA),
     "Dang Van's", "NUMBER"},
    {"plane-stress", '\0', POPT_ARG_NONE, NULL, OPTION_PLANE_STRESS,
     "Plane stress, of contact and criteria (default: plane strain)", NULL},
    {"material", '\0', POPT_ARG_STRING, NULL, OPTION_MATERIAL,
     "Constants of body 1 by name, JSON or CSV", "FILE"},
    {"archard", '\0', POPT_ARG_STRING, NULL, OPTION_ARCHARD,
     "Depth worn per energy and area; the profile does not change", "NUMBER"},
    POPT_TABLEEND,
};

/* ---- Constants ---- */

static const char *name_of(int number)
{
    const struct poptOption *option = criteria_option_table;
    while (option->val != number)
        option++;
    return option->longName;
}

/* NAN where it is not given. */
static double read_constant(const arguments *line, int number, double least)
{
    const char *text = line->value[number];
    double value = NAN;
    if (text != NULL && !(number_read(text, &value) && value >= least && value <= 1e60 &&
                          (value == 0 || value >= 1e-60)))
        usage_error("--%s %s: must be a number%s 1e-60 to 1e60", name_of(number), text,
                    least > 0 ? "" : ", 0 or");
    return value;
}

static void need(const criteria *all, int criterion, double constant, const char *option)
{
    if (all->is_wanted[criterion] && isnan(constant))
        usage_error("%s: needs --%s", criterion_kinds[criterion].name, option);
}

static void read_constants(const arguments *line, criteria *all)
{
    all->archard = read_constant(line, OPTION_ARCHARD, 1e-60);
    all->su = read_constant(line, OPTION_OF(MATERIAL_SU), 1e-60);
    for (int i = 0; i < CRITERION_COUNT; i++) {
        const int constant = criterion_kinds[i].constant;
        if (constant == MATERIAL_COUNT)
            continue;
        all->constant[i] =
            read_constant(line, OPTION_OF(constant), constant == MATERIAL_T_A ? 1e-60 : 0);
        all->is_wanted[i] = all->is_listed ? all->is_wanted[i] : !isnan(all->constant[i]);
        need(all, i, all->constant[i], name_of(OPTION_OF(constant)));
    }
    if (!all->is_listed && !isnan(all->su))
        all->is_wanted[CRITERION_MCDIARMID] = true;
    need(all, CRITERION_MCDIARMID, all->constant[CRITERION_MCDIARMID], "t-a");
    need(all, CRITERION_MCDIARMID, all->su, "su");
}

/* ---- --criteria ---- */

static int criterion_named(const char *word, size_t length)
{
    for (int i = 0; i < CRITERION_COUNT; i++)
        if (strlen(criterion_kinds[i].name) == length &&
            strncmp(criterion_kinds[i].name, word, length) == 0)
            return i;
    return -1;
}

static void refuse_name(const char *text)
{
    char allowed[200] = "";
    for (int i = 0; i < CRITERION_COUNT; i++)
        list_add(allowed, sizeof allowed, ", ", "%s", criterion_kinds[i].name);
    usage_error("--criteria %s: must be a list of: %s", text, allowed);
}

static void read_names(const char *text, criteria *all)
{
    for (const char *word = text; word != NULL;) {
        const size_t length = strcspn(word, ",");
        const int i = criterion_named(word, length);
        if (i < 0)
            refuse_name(text);
        all->is_wanted[i] = true;
        word = word[length] == ',' ? word + length + 1 : NULL;
    }
}

/* ---- All ---- */

static void read_plane_stress(arguments *line, criteria *all)
{
    static char zero[] = "0";
    input_texts texts;
    char complaint[COMPLAINT_SIZE];
    input_texts_from_options(line, &texts);
    if (!input_is_given(&texts, INPUT_NU1))
        return; /* it will be missed */
    if (!input_read(&texts, INPUT_NU1, &all->nu, complaint))
        usage_error("%s", complaint);
    line->value[OPTION_INPUT + INPUT_NU1] = zero;
    if (input_is_given(&texts, INPUT_NU2))
        line->value[OPTION_INPUT + INPUT_NU2] = zero;
}

void criteria_read(arguments *line, const material *constants, criteria *all)
{
    *all = criteria_usual(&(contact_case){.nu1 = NAN});
    all->constants = constants;
    all->is_plane_stress = line->value[OPTION_PLANE_STRESS] != NULL;
    if (all->is_plane_stress)
        read_plane_stress(line, all);
    all->is_listed = line->value[OPTION_CRITERIA] != NULL;
    read_names(line->value[OPTION_CRITERIA], all);
    read_constants(line, all);
}

/* Damage is written where its criterion is, or by itself. */
static void read_damage(int criterion, int damage, const char *needed, criteria *all)
{
    const bool has_life = material_has_life(all->constants, criterion);
    if (all->is_wanted[damage] && !has_life)
        usage_error("%s: needs %s of --material", criterion_kinds[damage].name, needed);
    all->is_wanted[damage] = all->is_wanted[damage] || all->is_wanted[criterion] || !all->is_listed;
    all->is_wanted[damage] = all->is_wanted[damage] && has_life && !isnan(all->constant[criterion]);
    all->constant[damage] = all->is_wanted[damage] ? all->constant[criterion] : NAN;
}

void criteria_read_strength(const arguments *line, const contact_case *setup, criteria *all)
{
    const char *text = line->value[OPTION_OF(MATERIAL_FS_K)];
    double k = 1;
    if (text != NULL && !(number_read(text, &k) && k >= 0 && k <= 1e6))
        usage_error("--fs-k %s: must be a number from 0 to 1000000", text);
    if (text != NULL && isnan(setup->k))
        usage_error("--fs-k %s: needs --k or --yield-stress", text);
    all->constant[CRITERION_FATEMI_SOCIE] = criteria_fatemi_socie(setup, k);
    need(all, CRITERION_FATEMI_SOCIE, setup->k, "yield-stress");
    need(all, CRITERION_FS_DAMAGE, setup->k, "yield-stress");
    read_damage(CRITERION_SWT, CRITERION_SWT_DAMAGE, "sf, b, ef, c", all);
    read_damage(CRITERION_FATEMI_SOCIE, CRITERION_FS_DAMAGE, "G, tf, b0, gf, c0", all);
    if (!all->is_plane_stress)
        all->nu = setup->nu1;
}
