/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A case as it was read: all numbers are in the working units, and forces are per unit length. */
#include "setup.h"

#include "model/words/words.h"
#include "rows/rows.h"
#include "system/system.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

/* ---- JSON ---- */

typedef struct {
    output out;
    bool is_begun;      /* the object at hand */
    bool is_of_command; /* which asked something; else what was read is written */
} writing;

static void begin_name(writing *to, const char *indent, const char *name)
{
    output_print(&to->out, "%s\n%s\"%s\": ", to->is_begun ? "," : "", indent, name);
    to->is_begun = true;
}

static void begin_group(writing *to, const char *name)
{
    begin_name(to, "  ", name);
    output_text(&to->out, "{");
    to->is_begun = false;
}

static void end_group(writing *to)
{
    output_text(&to->out, "\n  }");
    to->is_begun = true;
}

static void put_number(writing *to, double value)
{
    char digits[NUMBER_SIZE];
    number_write(value, NUMBER_DIGITS, '.', digits);
    output_text(&to->out, digits);
}

static void put_text(writing *to, const char *text)
{
    char *quoted = document_quoted(text);
    if (quoted == NULL)
        failure("%s: the text '%.60s' is not UTF-8, which JSON needs", to->out.name, text);
    output_text(&to->out, quoted);
    free(quoted);
}

/* Every fourth number begins a line. */
static void put_list(writing *to, const char *name, size_t count, const double number[])
{
    begin_name(to, "    ", name);
    for (size_t i = 0; i < count; i++) {
        output_text(&to->out, i == 0 ? "[" : i % 4 == 0 ? ",\n      " : ", ");
        put_number(to, number[i]);
    }
    output_text(&to->out, "]");
}

/* ---- Groups ---- */

static const char *text_of(const arguments *line, const case_word *word)
{
    const int number = word->option != NULL ? arguments_number(line, word->option) : 0;
    return number != 0 ? line->value[number] : NULL;
}

static void put_word(writing *to, const case_word *word, const char *text, const input_texts *texts)
{
    complaint why;
    double value;
    begin_name(to, word->group[0] == '\0' ? "  " : "    ", word->name);
    if (word->kind == WORD_FLAG)
        output_text(&to->out, "true");
    else if (word->input == INPUT_COUNT)
        put_text(to, text);
    else if (!input_read(texts, word->input, &value, &why))
        failure("%s: %s", to->out.name, why.text);
    else if (isinf(value))
        put_text(to, "inf");
    else
        put_number(to, value);
}

/* Writes two radii as the one of a cylinder on a plane. */
static void put_two_radii(writing *to, const input_texts *texts)
{
    complaint why;
    double radius1, radius2;
    if (!input_is_given(texts, INPUT_RADIUS1) || !input_is_given(texts, INPUT_RADIUS2))
        return;
    if (!input_read(texts, INPUT_RADIUS1, &radius1, &why) ||
        !input_read(texts, INPUT_RADIUS2, &radius2, &why))
        failure("%s", why.text);
    begin_name(to, "    ", input_kinds[INPUT_RADIUS].column);
    put_number(to, case_radius(radius1, radius2));
}

/* What was read has neither two radii nor how a profile was made; what forces were divided by is
 * not said again. */
static bool is_settled(const writing *to, const case_word *word)
{
    const bool is_of_two = word->input == INPUT_RADIUS1 || word->input == INPUT_RADIUS2,
               is_making = word->input == INPUT_COUNT && strcmp(word->group, "pad") == 0 &&
                           strcmp(word->name, "rotation") != 0;
    if (word->group[0] == '\0' || strcmp(word->name, "compliance") == 0) /* beside the loads */
        return word->kind == WORD_QUANTITY;
    return !to->is_of_command && (is_of_two || is_making);
}

static void put_words(writing *to, const char *group, const arguments *line,
                      const input_texts *texts)
{
    for (size_t i = 0; i < case_word_count(); i++) {
        const case_word *word = case_word_of(i);
        const char *text = text_of(line, word);
        if (strcmp(word->group, group) == 0 && text != NULL && !is_settled(to, word))
            put_word(to, word, text, texts);
    }
}

/* The slopes of what was made of a profile. */
static void put_made(writing *to, const char *profile)
{
    complaint why;
    const pad_profile *made = profile != NULL ? profiles_named(profile, &why) : NULL;
    if (made == NULL)
        return;
    put_list(to, "x", made->count, made->x);
    put_list(to, "slope", made->count, made->slope);
}

static void put_places(writing *to, const char *profile)
{
    const pairs *places = profile != NULL ? profiles_places(profile) : NULL;
    if (places == NULL)
        return;
    put_list(to, "x", places->count, places->first);
    put_list(to, places->column, places->count, places->second);
}

static void put_loads(writing *to, const arguments *line)
{
    static const char *const names[] = {"P", "M", "Q", "sigma", "tilt", "displacement"};
    const bool comma = line->value[OPTION_DECIMAL_COMMA] != NULL;
    load_history loads;
    load_history_read(line, comma ? ',' : '.', &loads);
    double *number = memory_zeroed(loads.count, sizeof *number);
    const bool is_guided = loads_are_guided(loads.load, loads.count),
               is_driven = loads_are_driven(loads.load, loads.count);
    for (int j = 0; j < 6; j++) {
        for (size_t i = 0; i < loads.count; i++) {
            const load *one = &loads.load[i];
            const double part[] = {one->P,     one->M,    one->Q,
                                   one->sigma, one->tilt, one->displacement};
            number[i] = part[j];
        }
        if (j != (is_guided ? 1 : 4) && j != (is_driven ? 2 : 5)) /* one of two each */
            put_list(to, names[j], loads.count, number);
    }
    if (is_driven) {
        begin_name(to, "    ", "compliance");
        put_number(to, loads.load[0].compliance);
    }
    free(number);
}

/* ---- What is asked ---- */

/* Names of files, and how they are read; the words of a case. */
int case_option_asked(const arguments *line, const char *name)
{
    static const char *const not_asked[] = {"case", "save-case", "load",   "history", "input",
                                            "drop", "profile",   "points", "material"};
    const int number = arguments_number(line, name);
    for (size_t i = 0; i < sizeof not_asked / sizeof not_asked[0]; i++)
        if (strcmp(not_asked[i], name) == 0)
            return 0;
    for (size_t i = 0; i < case_word_count(); i++)
        if (case_word_of(i)->option != NULL && strcmp(case_word_of(i)->option, name) == 0)
            return 0;
    return number < OPTION_OWN || arguments_other_file(line, number) != NULL ? 0 : number;
}

static void put_asked(writing *to, const char *command_name, const arguments *line)
{
    begin_group(to, "asked");
    begin_name(to, "    ", "command");
    put_text(to, command_name);
    begin_name(to, "    ", "options");
    output_text(&to->out, "{");
    to->is_begun = false;
    for (int i = OPTION_OWN; i < OPTION_LIMIT; i++) {
        const char *name = line->value[i] != NULL ? arguments_name(line, i) : NULL;
        if (name == NULL || case_option_asked(line, name) == 0)
            continue;
        begin_name(to, "      ", name);
        if (line->value[i][0] == '\0')
            output_text(&to->out, "true");
        else
            put_text(to, line->value[i]);
    }
    output_text(&to->out, to->is_begun ? "\n    }" : "}");
    end_group(to);
}

/* ---- All ---- */

/* The words of a file of constants. */
static void put_constants(writing *to, const char *path)
{
    double value;
    csv_input *in = csv_input_open(path, ',', NULL);
    for (const char *before = "{"; csv_input_next(in); before = ", ") {
        const char **cells = in->row.cell;
        output_text(&to->out, before);
        put_text(to, cells[0]);
        output_text(&to->out, ": ");
        if (number_read_cell(cells[1], '.', &value))
            put_number(to, value);
        else
            put_text(to, cells[1]);
    }
    csv_input_check(in);
    csv_input_close(in);
    output_text(&to->out, "}");
}

/* The name of one that is shipped stays; of a file its constants, in its words. */
static void put_material(writing *to, const char *text, const arguments *line)
{
    (void)line;
    const char *ending = strrchr(text, '.');
    const bool is_json = ending != NULL && strcasecmp(ending, ".json") == 0;
    begin_name(to, "  ", "material");
    if (shipped_material_named(text) != NULL) {
        put_text(to, text);
        return;
    }
    if (text[0] != '{' && !is_json) {
        put_constants(to, text);
        return;
    }
    char *object = text[0] == '{' ? NULL : node_written(document_read(text));
    output_text(&to->out, object != NULL ? object : text);
    free(object);
}

/* Its constants in the working units. */
static void put_read_material(writing *to, const char *text, const arguments *line)
{
    (void)text;
    const material *constants = material_of(line);
    begin_group(to, "material");
    for (int i = 0; i < material_count(); i++)
        if (!isnan(constants->value[i])) {
            begin_name(to, "    ", material_name(i));
            put_number(to, constants->value[i]);
        }
    end_group(to);
}

static void put_all(writing *to, const char *command_name, const arguments *line,
                    const input_texts *texts)
{
    const int number = arguments_number(line, "material");
    static const char *const groups[] = {"bodies", "pad", "loads"};
    output_print(&to->out, "{\n  \"%s\": %d", case_version_name, CASE_VERSION);
    to->is_begun = true;
    put_words(to, "", line, texts);
    for (int i = 0; i < 3; i++) {
        begin_group(to, groups[i]);
        put_words(to, groups[i], line, texts);
        if (i == 1)
            (to->is_of_command ? put_places : put_made)(to, texts->text[INPUT_PROFILE]);
        if (i == 1 && !to->is_of_command)
            put_two_radii(to, texts);
        if (i == 2 && history_is_given(line))
            put_loads(to, line);
        end_group(to);
    }
    if (number != 0 && line->value[number] != NULL)
        (to->is_of_command ? put_material : put_read_material)(to, line->value[number], line);
    if (to->is_of_command)
        put_asked(to, command_name, line);
    output_text(&to->out, "\n}\n");
}

void case_file_check(const arguments *line)
{
    const int option = arguments_number(line, "save-case"), input = arguments_number(line, "input");
    const char *path = option != 0 ? line->value[option] : NULL;
    if (path == NULL)
        return;
    if (strcmp(path, "-") == 0)
        usage_error("--save-case -: must be the name of a file");
    if (input != 0 && line->value[input] != NULL)
        usage_error("--save-case %s: is of one contact, not with --input", path);
    if (history_file(line) != NULL && line->value[OPTION_LOAD] != NULL)
        usage_error("--save-case %s: a case has one list of loads; not with --load beside a file",
                    path);
    arguments others = *line;
    others.output = option;
    others.value[OPTION_CASE] = NULL; /* a case may be written anew */
    output_options_spare_files(&others, &(output_options){.option = "save-case", .path = path});
    output_try(path);
}

void case_file_save(const char *command_name, const arguments *line)
{
    const int option = arguments_number(line, "save-case");
    if (option != 0 && line->value[option] != NULL)
        case_file_write(command_name, line, line->value[option]);
}

void case_file_write(const char *command_name, const arguments *line, const char *path)
{
    input_texts texts;
    writing to;
    input_texts_from_options(line, &texts);
    to.is_of_command = command_name != NULL;
    output_open(&to.out, path);
    put_all(&to, command_name, line, &texts);
    output_finish(&to.out);
}
