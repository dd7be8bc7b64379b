/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Constants of a material: of one that is shipped, of a file, or in the words of the option. */
#include "setup.h"

#include "system/system.h"

#include <inttypes.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

typedef struct {
    const char *source; /* as messages call it */
    constant_words *list;
    size_t count;
    const char *units_text; /* of its numbers; NULL where it does not say */
    unit_system units;      /* those that are worked in */
} material_words;

/* ---- Words ---- */

static void add(material_words *words, const char *name, char *text)
{
    for (size_t i = 0; i < words->count; i++)
        if (strcmp(words->list[i].name, name) == 0)
            failure("%s: %.60s: there twice; allowed: once", words->source, name);
    char *copy = memory_zeroed(strlen(name) + 1, 1);
    words->list = memory_for_one_more(words->list, words->count, sizeof *words->list);
    words->list[words->count++] = (constant_words){strcpy(copy, name), text};
    if (strcmp(name, "units") == 0)
        words->units_text = text;
}

static void read_object(const node *top, material_words *words)
{
    for (size_t i = 0; i < top->count; i++) {
        char *text = node_words(&top->part[i]);
        if (text == NULL)
            failure("%s: %.60s: must be a number, or a text with its unit", words->source,
                    top->part[i].name);
        add(words, top->part[i].name, text);
    }
}

static void read_rows(const char *path, const char *encoding, material_words *words)
{
    csv_input *in = csv_input_open(path, ',', encoding);
    while (csv_input_next(in)) {
        const char **cells = in->row.cell;
        double more;
        if (in->row.count < 2)
            failure("%s: line %" PRId64 ": must be a name and a number, with a comma between", path,
                    in->row.line);
        if (in->row.count > 2 && !material_is_remark(cells[0]) &&
            number_read_cell(cells[2], '.', &more))
            failure("%s: line %" PRId64 ": %.60s: two numbers; a decimal is written 0.1", path,
                    in->row.line, cells[0]);
        char *text = memory_zeroed(strlen(cells[1]) + 1, 1);
        add(words, cells[0], strcpy(text, cells[1]));
    }
    csv_input_check(in);
    csv_input_close(in);
}

static void read_words(const arguments *line, material_words *words)
{
    const char *text = line->value[OPTION_MATERIAL], *ending = strrchr(text, '.');
    const shipped_material *shipped = shipped_material_named(text);
    words->source = text[0] == '{' ? "--material" : text;
    if (shipped != NULL)
        read_object(document_read_text(shipped->text, text), words);
    else if (text[0] == '{')
        read_object(document_read_text(text, words->source), words);
    else if (ending != NULL && strcasecmp(ending, ".json") == 0)
        read_object(document_read(text), words);
    else if (file_kind_of(text) == FILE_ABSENT && ending == NULL)
        failure("%s: neither a file nor a material that is shipped%s", text,
                shipped_material_hint(text));
    else
        read_rows(text, reading_of(line, '.').encoding, words);
}

/* ---- Constants ---- */

/* Units that the material has are the working ones where no others are given. */
static void find_units(const arguments *line, material_words *words)
{
    complaint why;
    words->units = *units_of(line);
    if (words->units_text == NULL)
        return;
    unit_system its = units_unknown;
    if (!units_read(words->units_text, &its, &why))
        failure("%s: units %s", words->source, why.text);
    if (words->units.is_known)
        return;
    units_assume(&its);
    words->units = *units_of(line);
    notice("%s: its numbers are in %s, which are taken as the units of all", words->source,
           words->units_text);
}

static void take_all(const material_words *words, material *constants)
{
    const constant_words *one;
    complaint why;
    if (material_take_all(words->count, words->list, &words->units, constants, &one, &why))
        return;
    if (material_constant(one->name) < 0)
        failure("%s: %.60s: %s; see rwedge fretting in its manual", words->source, one->name,
                why.text);
    const bool has_unit = strstr(why.text, "no working units") != NULL,
               lacks_unit = strncmp(why.text, "needs its unit", 14) == 0;
    failure("%s: %s %.60s: %s%s", words->source, one->name, one->text, why.text,
            has_unit     ? ": --units, such as --units mm,N,MPa, converts it"
            : lacks_unit ? ", beside --units; or --K-in m or mm"
                         : "");
}

/* ---- What it must have ---- */

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

/* A curve of life and a critical distance have either all their constants or none. */
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

const material *material_of(const arguments *line)
{
    static material constants;
    static bool is_read;
    material_words words = {.count = 0};
    if (is_read)
        return &constants;
    is_read = true;
    constants = material_unknown();
    if (line->value[OPTION_MATERIAL] == NULL)
        return &constants;
    read_words(line, &words);
    find_units(line, &words);
    take_all(&words, &constants);
    need_any(words.source, &constants);
    need_groups(words.source, &constants);
    mind_units(words.source, &constants);
    return &constants;
}

void material_hand_over(const arguments *line, input_texts *texts)
{
    const char *text = line->value[OPTION_MATERIAL];
    if (text != NULL)
        hand_over(text[0] == '{' ? "--material" : text, material_of(line), texts);
}
