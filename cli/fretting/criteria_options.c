/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "fretting.h"

#include <errno.h>
#include <inttypes.h>
#include <math.h>
#include <string.h>
#include <strings.h>

#include <jansson.h>

struct poptOption criteria_option_table[] = {
    {VALUE("criteria", OPTION_CRITERIA),
     "Columns of these alone: swt, fatemi-socie, findley, modified-wohler, mcdiarmid, crossland, "
     "dang-van, swt-damage, fatemi-socie-damage",
     "LIST"},
    {VALUE("fs-k", OPTION_OF(MATERIAL_FS_K)),
     "Fatemi and Socie's k, beside a yield stress (default 1)", "NUMBER"},
    {VALUE("findley-k", OPTION_OF(MATERIAL_FINDLEY_K)), "Findley's k", "NUMBER"},
    {VALUE("kappa", OPTION_OF(MATERIAL_KAPPA)), "kappa of the modified Woehler curve, a stress",
     "NUMBER"},
    {VALUE("t-a", OPTION_OF(MATERIAL_T_A)), "McDiarmid's fully reversed limit in torsion",
     "NUMBER"},
    {VALUE("su", OPTION_OF(MATERIAL_SU)), "McDiarmid's tensile strength", "NUMBER"},
    {VALUE("crossland-alpha", OPTION_OF(MATERIAL_CROSSLAND_ALPHA)),
     "Crossland's share of the hydrostatic stress", "NUMBER"},
    {VALUE("dang-van-alpha", OPTION_OF(MATERIAL_DANG_VAN_ALPHA)), "Dang Van's", "NUMBER"},
    {FLAG("plane-stress", OPTION_PLANE_STRESS),
     "Plane stress, of contact and criteria (default: plane strain)", NULL},
    {VALUE("material", OPTION_MATERIAL), "Constants of body 1 by name, JSON or CSV", "FILE"},
    {VALUE("archard", OPTION_ARCHARD),
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
    if (text != NULL && !(number_read(text, &value) && value >= least && number_is_size(value)))
        usage_error("--%s %s: must be a number%s 1e-60 to 1e60", name_of(number), text,
                    least > 0 ? "" : ", 0 or");
    return value;
}

static void need(const criteria *asked, int criterion, double constant, const char *option)
{
    if (asked->is_wanted[criterion] && isnan(constant))
        usage_error("%s: needs --%s", criterion_kinds[criterion].name, option);
}

static void read_constants(const arguments *line, criteria *asked)
{
    asked->archard = read_constant(line, OPTION_ARCHARD, 1e-60);
    asked->su = read_constant(line, OPTION_OF(MATERIAL_SU), 1e-60);
    for (int i = 0; i < CRITERION_COUNT; i++) {
        const int constant = criterion_kinds[i].constant;
        if (constant == MATERIAL_COUNT)
            continue;
        asked->constant[i] =
            read_constant(line, OPTION_OF(constant), constant == MATERIAL_T_A ? 1e-60 : 0);
        asked->is_wanted[i] = asked->is_listed ? asked->is_wanted[i] : !isnan(asked->constant[i]);
        need(asked, i, asked->constant[i], name_of(OPTION_OF(constant)));
    }
    if (!asked->is_listed && !isnan(asked->su))
        asked->is_wanted[CRITERION_MCDIARMID] = true;
    need(asked, CRITERION_MCDIARMID, asked->constant[CRITERION_MCDIARMID], "t-a");
    need(asked, CRITERION_MCDIARMID, asked->su, "su");
}

/* ---- --criteria ---- */

static void read_names(const char *text, criteria *asked)
{
    char allowed[200] = "";
    for (int i = 0; i < CRITERION_COUNT; i++)
        list_add(allowed, sizeof allowed, ", ", "%s", criterion_kinds[i].name);
    for (const char *word = text; word != NULL;) {
        const size_t length = strcspn(word, ",");
        int i = 0;
        while (i < CRITERION_COUNT && (strlen(criterion_kinds[i].name) != length ||
                                       strncmp(criterion_kinds[i].name, word, length) != 0))
            i++;
        if (i == CRITERION_COUNT)
            usage_error("--criteria %s: must be a list of: %s", text, allowed);
        asked->is_wanted[i] = true;
        word = word[length] == ',' ? word + length + 1 : NULL;
    }
}

/* ---- All ---- */

static void read_plane_stress(arguments *line, criteria *asked)
{
    static char zero[] = "0";
    input_texts texts;
    complaint why;
    input_texts_from_options(line, &texts);
    if (!input_is_given(&texts, INPUT_NU1))
        return; /* it will be missed */
    if (!input_read(&texts, INPUT_NU1, &asked->nu, &why))
        usage_error("%s", why.text);
    line->value[OPTION_INPUT + INPUT_NU1] = zero;
    if (input_is_given(&texts, INPUT_NU2))
        line->value[OPTION_INPUT + INPUT_NU2] = zero;
}

void criteria_read(arguments *line, const material *constants, criteria *asked)
{
    *asked = criteria_usual(&(contact_case){.nu1 = NAN});
    asked->constants = constants;
    asked->is_plane_stress = line->value[OPTION_PLANE_STRESS] != NULL;
    if (asked->is_plane_stress)
        read_plane_stress(line, asked);
    asked->is_listed = line->value[OPTION_CRITERIA] != NULL;
    read_names(line->value[OPTION_CRITERIA], asked);
    read_constants(line, asked);
}

/* Damage is written where its criterion is, or by itself. */
static void read_damage(int criterion, int damage, const char *needed, criteria *asked)
{
    const int of_life = criterion == CRITERION_SWT ? MATERIAL_SF : MATERIAL_G;
    const bool has_life = !isnan(asked->constants->value[of_life]);
    if (asked->is_wanted[damage] && !has_life)
        usage_error("%s: needs %s of --material", criterion_kinds[damage].name, needed);
    asked->is_wanted[damage] =
        (asked->is_wanted[damage] || asked->is_wanted[criterion] || !asked->is_listed) &&
        has_life && !isnan(asked->constant[criterion]);
    asked->constant[damage] = asked->is_wanted[damage] ? asked->constant[criterion] : NAN;
}

void criteria_read_strength(const arguments *line, const contact_case *setup, criteria *asked)
{
    const char *text = line->value[OPTION_OF(MATERIAL_FS_K)];
    double k = 1;
    if (text != NULL && !(number_read(text, &k) && k >= 0 && k <= 1e6))
        usage_error("--fs-k %s: must be a number from 0 to 1000000", text);
    if (text != NULL && isnan(setup->k))
        usage_error("--fs-k %s: needs --k or --yield-stress", text);
    asked->constant[CRITERION_FATEMI_SOCIE] = criteria_fatemi_socie(setup, k);
    need(asked, CRITERION_FATEMI_SOCIE, setup->k, "yield-stress");
    need(asked, CRITERION_FS_DAMAGE, setup->k, "yield-stress");
    read_damage(CRITERION_SWT, CRITERION_SWT_DAMAGE, "sf, b, ef, c", asked);
    read_damage(CRITERION_FATEMI_SOCIE, CRITERION_FS_DAMAGE, "G, tf, b0, gf, c0", asked);
    if (!asked->is_plane_stress)
        asked->nu = setup->nu1;
}

/* ---- A file of constants ---- */

static void set(const char *file, const char *name, double value, material *constants)
{
    const int i = material_constant(name);
    if (i < 0)
        failure("%s: %.60s: no constant that is known here; see rwedge fretting in its manual",
                file, name);
    if (!isnan(constants->value[i]))
        failure("%s: %.60s: there twice; allowed: once", file, name);
    constants->value[i] = value;
}

/* ---- The file ---- */

/* Without the mark of Unicode, which some editors write first. */
static json_t *load_json(const char *path, json_error_t *error)
{
    FILE *file = fopen(path, "rb");
    if (file == NULL)
        failure("%s: %s", path, strerror(errno));
    int first = fgetc(file);
    if (first == 0xEF && fgetc(file) != EOF && fgetc(file) != EOF)
        first = fgetc(file);
    ungetc(first, file);
    json_t *top = json_loadf(file, JSON_REJECT_DUPLICATES, error);
    fclose(file);
    return top;
}

static void read_json(const char *path, material *constants)
{
    json_error_t error;
    json_t *top = load_json(path, &error), *value;
    const char *name;
    if (top == NULL)
        failure("%s: line %d: %s", path, error.line, error.text);
    if (!json_is_object(top))
        failure("%s: must be an object of names and numbers", path);
    json_object_foreach(top, name, value)
    {
        if (material_is_remark(name))
            continue;
        if (!json_is_number(value))
            failure("%s: %.60s: must be a number", path, name);
        set(path, name, json_number_value(value), constants);
    }
    json_decref(top);
}

static void read_csv(const char *path, const char *encoding, material *constants)
{
    csv_input *in = csv_input_open(path, ',', encoding);
    while (csv_input_next(in)) {
        const char **cells = in->row.cell;
        double value, more;
        if (in->row.count < 2)
            failure("%s: line %" PRId64 ": must be a name and a number, with a comma between", path,
                    in->row.line);
        if (material_is_remark(cells[0]))
            continue;
        if (!number_read_cell(cells[1], '.', &value))
            failure("%s: line %" PRId64 ": %.60s: must be a number", path, in->row.line, cells[0]);
        if (in->row.count > 2 && number_read_cell(cells[2], '.', &more))
            failure("%s: line %" PRId64 ": %.60s: two numbers; a decimal is written 0.1", path,
                    in->row.line, cells[0]);
        set(path, cells[0], value, constants);
    }
    csv_input_check(in);
    csv_input_close(in);
}

/* ---- All ---- */

static void need_any(const char *path, const material *constants)
{
    for (int i = 0; i < MATERIAL_COUNT; i++)
        if (!isnan(constants->value[i]))
            return;
    failure("%s: no constants; needed: names and numbers", path);
}

/* Either all of these or none. */
static void need_group(const char *path, const material *constants, int first, int last)
{
    int missing = -1, there = -1;
    for (int i = first; i <= last; i++)
        *(isnan(constants->value[i]) ? &missing : &there) = i;
    if (missing >= 0 && there >= 0)
        failure("%s: %s: missing; needed beside %s", path, material_names[missing],
                material_names[there]);
}

/* What the file has stands for options that are not given. k without a yield stress, and su without
 * t_A, say nothing. */
static void hand_over(const material *constants, arguments *line)
{
    static char texts[MATERIAL_COUNT][NUMBER_SIZE];
    static const int inputs[] = {INPUT_E1, INPUT_NU1, INPUT_YIELD_STRESS};
    char **value = line->value;
    for (int i = MATERIAL_E; i < MATERIAL_COUNT; i++) {
        const int option = i < MATERIAL_FS_K ? OPTION_INPUT + inputs[i - MATERIAL_E] : OPTION_OF(i);
        const bool is_idle =
            (i == MATERIAL_FS_K && value[OPTION_INPUT + INPUT_YIELD_STRESS] == NULL) ||
            (i == MATERIAL_SU && value[OPTION_OF(MATERIAL_T_A)] == NULL) ||
            (i == MATERIAL_YIELD_STRESS && value[OPTION_INPUT + INPUT_K] != NULL);
        if (isnan(constants->value[i]) || value[option] != NULL || is_idle)
            continue;
        number_write(constants->value[i], NUMBER_DIGITS, '.', texts[i]);
        value[option] = texts[i];
    }
}

void material_read(const char *path, arguments *line, material *constants)
{
    *constants = material_unknown();
    if (path == NULL)
        return;
    const char *ending = strrchr(path, '.');
    if (ending != NULL && strcasecmp(ending, ".json") == 0)
        read_json(path, constants);
    else
        read_csv(path, line->value[OPTION_ENCODING], constants);
    need_any(path, constants);
    need_group(path, constants, MATERIAL_SF, MATERIAL_C);
    need_group(path, constants, MATERIAL_G, MATERIAL_C0);
    need_group(path, constants, MATERIAL_DK_TH, MATERIAL_DS0);
    hand_over(constants, line);
}
