/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Case files: what one has of the form, and what a name in one is. The words are the model's, so
 * that the page and the tool read the same files, and refuse the same. */
#include "page.h"

#include "model/words/words.h"

#include <math.h>
#include <string.h>

/* ---- Written ---- */

/* The number of an input, in the working units; "inf" of a rigid body. */
static void write_input(const case_word *word, const input_texts *texts)
{
    double value;
    complaint why;
    if (!input_is_given(texts, word->input) || !input_read(texts, word->input, &value, &why))
        return;
    if (isinf(value))
        json_add("{'case':{%t:{%t:'inf'}}}", word->group, word->name);
    else
        json_add("{'case':{%t:{%t:%n}}}", word->group, word->name,
                 value * field_share(word->input));
}

/* The places as they were pasted, and how the profile is made of them. */
static void write_profile(void)
{
    const profile_making *making = field_making();
    const pairs *places = field_profile() != NULL ? profiles_places(field_profile()) : NULL;
    if (places == NULL)
        return;
    for (size_t i = 0; i < places->count; i++)
        json_add("{'case':{'pad':{'x':[%n],%t:[%n]}}}", places->first[i], places->column,
                 places->second[i]);
    if (making->takes_hull)
        json_add("{'case':{'pad':{'hull':true}}}");
    if (making->fits)
        json_add("{'case':{'pad':{'fit':true}}}");
    if (making->is_down)
        json_add("{'case':{'pad':{'heights':'down'}}}");
    if (making->is_from_lowest)
        json_add("{'case':{'pad':{'origin':'lowest'}}}");
}

/* Writes the case of the form, all but wrong inputs: its version and its groups, forces of the
 * whole contact where it has a width, or a section; and these. */
EXPORTED const char *page_case(char *fields)
{
    const input_texts texts = field_texts(fields);
    json_begin();
    json_add("{'case':{%t:%n,'bodies':{},'pad':{},'loads':{}}}", case_version_name,
             (double)CASE_VERSION);
    for (size_t i = 0; i < case_word_count(); i++)
        if (case_word_of(i)->input < INPUT_COUNT)
            write_input(case_word_of(i), &texts);
    write_profile();
    json_add("{'width':%n,'section':%n}", field_units()->width, field_units()->section);
    return json_end();
}

/* ---- Read ---- */

/* Whether a file of that version can be read: NAN where it has none. */
EXPORTED const char *page_case_version(double version)
{
    complaint why;
    json_begin();
    if (!case_version_check(version, &why))
        json_fault("", why.text);
    return json_end();
}

EXPORTED int page_case_group(const char *name)
{
    return case_group_exists(name);
}

static void write_kind(const case_word *word)
{
    static const char *const kinds[] = {[WORD_QUANTITY] = "quantity",
                                        [WORD_NUMBERS] = "numbers",
                                        [WORD_TEXT] = "text",
                                        [WORD_FLAG] = "flag"};
    json_add("{'kind':%t}", kinds[word->kind]);
}

/* What a name in a group is, "" for none: its kind; of an input its column, and the number of the
 * text in the working units, of a force of the whole contact as it is. */
EXPORTED const char *page_case_word(const char *group, const char *name, const char *text,
                                    char *fields)
{
    input_texts texts = field_texts(fields);
    double value;
    complaint why;
    const case_word *word = case_word_find(group, name, &why);
    json_begin();
    if (word == NULL) {
        json_fault("", why.text);
        return json_end();
    }
    write_kind(word);
    if (word->input == INPUT_COUNT)
        return json_end();
    texts.text[word->input] = text;
    if (input_read(&texts, word->input, &value, &why))
        json_add("{'input':%t,'value':%n}", input_kinds[word->input].column,
                 value * field_share(word->input));
    else
        json_refuse("", "%s", why.text);
    return json_end();
}
