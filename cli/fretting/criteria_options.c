/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "fretting.h"

#include "document/document.h"

#include <ctype.h>
#include <inttypes.h>
#include <math.h>
#include <string.h>
#include <strings.h>

/* ---- The options ---- */

enum { TEXT_SIZE = 200 };

static const struct poptOption last_options[] = {
    {FLAG("plane-stress", OPTION_PLANE_STRESS),
     "Plane stress, of contact and criteria (default: plane strain)", NULL},
    {VALUE("material", OPTION_MATERIAL), "Constants of body 1 by name, JSON or CSV", "FILE"},
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
    static char text[TEXT_SIZE * 2] = "Columns of these alone: ";
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

static void read_plane_stress(input_texts *texts, criteria *asked)
{
    complaint why;
    if (!input_is_given(texts, INPUT_NU1))
        return; /* it will be missed */
    if (!input_read(texts, INPUT_NU1, &asked->nu, &why))
        usage_error("%s", why.text);
    input_set(texts, INPUT_NU1, 0);
    if (input_is_given(texts, INPUT_NU2))
        input_set(texts, INPUT_NU2, 0);
}

void criteria_read(const arguments *line, const material *constants, input_texts *texts,
                   criteria *asked)
{
    *asked = criteria_usual(&(contact_case){.nu1 = NAN});
    asked->given = *constants;
    for (int i = 0; i < material_count(); i++)
        read_constant(line, i, asked);
    asked->archard = read_archard(line);
    asked->is_plane_stress = line->value[OPTION_PLANE_STRESS] != NULL;
    if (asked->is_plane_stress)
        read_plane_stress(texts, asked);
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

/* ---- A file of constants ---- */

static void set(const char *file, const char *name, double value, material *constants)
{
    const int i = material_constant(name);
    if (i < 0)
        failure("%s: %.60s: no constant that is known here; see rwedge fretting in its manual",
                file, name);
    if (!isnan(constants->value[i]))
        failure("%s: %.60s: there twice; allowed: once", file, name);
    if (!material_is_in_range(i, value))
        failure("%s: %s %g: must be a number, %s", file, name, value, material_allowed(i));
    constants->value[i] = value;
}

static void read_json(const char *path, material *constants)
{
    const node *top = path[0] == '{' ? document_read_text(path, "--material") : document_read(path);
    for (size_t i = 0; i < top->count; i++) {
        const node *value = &top->part[i];
        if (material_is_remark(value->name))
            continue;
        if (value->kind != NODE_NUMBER)
            failure("%s: %.60s: must be a number", path, value->name);
        set(path, value->name, value->number, constants);
    }
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
    for (int i = 0; i < material_count(); i++)
        if (!isnan(constants->value[i]))
            return;
    failure("%s: no constants; needed: names and numbers", path);
}

static void refuse_part(const char *path, const char *missing, const char *there)
{
    if (missing != NULL && there != NULL)
        failure("%s: %s: missing; needed beside %s", path, missing, there);
}

/* Of a curve of life, and of a critical distance, either all constants are there or none. */
static void need_groups(const char *path, const material *constants)
{
    for (int32_t i = 0; i < rwedge_criterion_count(); i++) {
        const char *missing = NULL, *there = NULL;
        for (int32_t j = rwedge_criterion_constants(i); j < rwedge_damage_constants(i); j++)
            if (isnan(rwedge_constant_usual(i, j)))
                *(isnan(material_value(constants, rwedge_constant_name(i, j))) ? &missing
                                                                               : &there) =
                    rwedge_constant_name(i, j);
        refuse_part(path, missing, there);
    }
    const bool has_threshold = !isnan(material_value(constants, "dK_th")),
               has_range = !isnan(material_value(constants, "ds0"));
    if (has_threshold != has_range)
        refuse_part(path, has_threshold ? "ds0" : "dK_th", has_threshold ? "dK_th" : "ds0");
}

/* E is a hundred times such a stress or more in metals: below ten times it is in another unit. */
static void mind_units(const char *path, const material *constants)
{
    static const double TIMES = 10;
    const double E = material_value(constants, "E");
    for (int i = 0; i < material_count(); i++)
        if (strcmp(material_unit(i), "stress") == 0 && strcmp(material_name(i), "E") != 0 &&
            strcmp(material_name(i), "G") != 0 && constants->value[i] * TIMES > E)
            failure("%s: E %g: less than ten times %s %g; is it in GPa? needed: one unit for both",
                    path, E, material_name(i), constants->value[i]);
}

/* What the file has stands for inputs that are not given; E and nu must not differ from them. k
 * stands for a yield stress. */
static void hand_over(const char *path, const material *constants, input_texts *texts)
{
    static const struct {
        const char *name;
        int input;
    } inputs[] = {{"E", INPUT_E1}, {"nu", INPUT_NU1}, {"yield_stress", INPUT_YIELD_STRESS}};
    for (int i = 0; i < 3; i++) {
        const double value = material_value(constants, inputs[i].name);
        const int input = inputs[i].input;
        const bool is_given = input_is_given(texts, input);
        double own;
        complaint why; /* of an input that is wrong: it is said when the contact is read */
        if (is_given && !isnan(value) && i < 2 && input_read(texts, input, &own, &why) &&
            own != value)
            usage_error("--%s1 %s: %s has %s %g; allowed: one of the two", inputs[i].name,
                        texts->text[input], path, inputs[i].name, value);
        if (!isnan(value) && !is_given && !(i == 2 && input_is_given(texts, INPUT_K)))
            input_set(texts, input, value);
    }
}

void material_read(const arguments *line, input_texts *texts, material *constants)
{
    const char *path = line->value[OPTION_MATERIAL];
    *constants = material_unknown();
    if (path == NULL)
        return;
    const char *ending = strrchr(path, '.');
    if (path[0] == '{' || (ending != NULL && strcasecmp(ending, ".json") == 0))
        read_json(path, constants);
    else
        read_csv(path, line->value[OPTION_ENCODING], constants);
    need_any(path, constants);
    need_groups(path, constants);
    mind_units(path, constants);
    hand_over(path, constants, texts);
}
