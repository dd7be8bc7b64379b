/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Which columns of a table are inputs, and which are nearly so. */
#include "reading.h"

#include <stdio.h>
#include <string.h>

/* ---- Columns that are probably meant for an input ---- */

/* Other usual names of inputs. Where the input is given by its own name too, they are columns like
 * any other. */
static const struct {
    int input;
    const char *names; /* separated by blanks */
} synonyms[] = {
    /* the Greek letter, and the sign for micro, which keyboards have */
    {INPUT_F, "mu \xce\xbc \xc2\xb5 friction friction_coefficient coefficient_of_friction cof"},
    {INPUT_Q, "tangential_force tangential_load shear_force shear_load"},
    {INPUT_M, "moment"},
    {INPUT_SIGMA, "bulk_tension bulk_stress \xcf\x83"},
    {INPUT_P, "load force normal_force normal_load"},
    {INPUT_YIELD_STRESS, "sigma_y \xcf\x83y Sy Re ReH Rp0.2 yield yield_strength"},
    {INPUT_K, "tau_y \xcf\x84y"},
    {INPUT_E1, "E youngs_modulus"},
    {INPUT_NU1, "nu \xce\xbd \xce\xbd\x31 poissons_ratio poisson"},
    {INPUT_NU2, "\xce\xbd\x32"},
    {INPUT_THETA, "\xce\xb8 angle"},
    {INPUT_RADIUS, "R"},
};

/* Where inputs come from that may stand for a column. */
typedef struct {
    const header *names;
    int first, end; /* of the wanted inputs */
    const input_texts *options;
} sources;

/* Whether the input is given, or its alternative is, as the radius for a. */
static bool is_given_somehow(const sources *from, int input)
{
    const int ways[] = {input, input_alternative(input)};
    for (int i = 0; i < 2; i++)
        if (ways[i] >= 0 && (header_has_input(from->names, ways[i]) ||
                             (from->options != NULL && from->options->text[ways[i]] != NULL)))
            return true;
    return false;
}

/* The input whose name this nearly is: "Yield stress" and "nu_1" are slips. But p beside P, or F
 * beside f, may be another thing; so is what stands beside the input's own column. */
static int slip_for(const sources *from, const char *name, size_t length)
{
    for (int i = from->first; i < from->end; i++) {
        const char *column = input_kinds[i].column;
        if (header_has_input(from->names, i) || !column_name_is_like(name, length, column))
            continue;
        if (column[1] != '\0' || memchr(name, column[0], length) != NULL ||
            !is_given_somehow(from, i))
            return i;
    }
    return INPUT_COUNT;
}

/* Whether one of the names, separated by blanks, is like this one. */
static bool is_among(const char *names, const char *name, size_t length)
{
    for (size_t own; *names != '\0'; names += own + (names[own] == ' ')) {
        char one_name[COLUMN_NAME_SIZE];
        own = strcspn(names, " ");
        snprintf(one_name, sizeof one_name, "%.*s", (int)own, names);
        if (column_name_is_like(name, length, one_name))
            return true;
    }
    return false;
}

static int synonym_for(const sources *from, const char *name, size_t length)
{
    for (size_t i = 0; i < sizeof synonyms / sizeof synonyms[0]; i++) {
        const int input = synonyms[i].input;
        if (input >= from->first && input < from->end && !is_given_somehow(from, input) &&
            is_among(synonyms[i].names, name, length))
            return input;
    }
    return INPUT_COUNT;
}

/* If a column that is meant for an input passed through, nobody would notice: friction, for one, is
 * 0 by default. */
static bool check_other(const sources *from, const char *name, complaint *why)
{
    char plain[COLUMN_NAME_SIZE];
    const size_t length = column_name_make_plain(name, plain), stem = column_name_stem(plain);
    int meant = slip_for(from, plain, length); /* "theta (deg)" is theta_deg */
    const bool has_unit = meant == INPUT_COUNT && stem < length;
    if (has_unit)
        meant = slip_for(from, plain, stem);
    const bool slip = meant < INPUT_COUNT;
    if (!slip)
        meant = synonym_for(from, plain, stem);
    if (meant == INPUT_COUNT)
        return true;
    complain(why, "column '%.60s': allowed: %s%s%s", name, input_kinds[meant].column,
             has_unit && meant == INPUT_THETA ? " in radians or theta_deg" : "",
             slip ? "" : ", or another name if it is something else");
    if (!from->names->how->is_command)
        return false;
    list_add(why->text, sizeof why->text, "; ", "--column %s='%.60s' takes it",
             input_kinds[meant].column, name);
    return false;
}

static const char label_names[] = LABEL_NAMES;

/* A column that says which row it is, not what is computed. A capital T may be a force. */
static bool is_label(const char *name)
{
    char plain[COLUMN_NAME_SIZE];
    column_name_make_plain(name, plain);
    const size_t stem = column_name_stem(plain);
    return is_among(label_names, plain, stem) ||
           (is_among("t", plain, stem) && memchr(plain, 't', stem) != NULL);
}

void header_note_labels(header *names)
{
    for (size_t i = 0; i < names->count; i++)
        names->is_used[i] = names->is_used[i] || is_label(names->name[i]);
}

bool header_find(int first, int end, const input_texts *options, header *names, complaint *why)
{
    const sources from = {names, first, end, options};
    for (int i = first; i < end; i++) {
        const input_kind *kind = &input_kinds[i];
        if (!header_column(names, kind->column, &names->column[i], why))
            return false;
        if (names->column[i] == names->count)
            continue;
        names->is_used[names->column[i]] = true;
        if (i != INPUT_PROFILE && !header_need(names, names->column[i], kind->column, kind->unit,
                                               kind->of, NEED_NUMBER, why))
            return false;
    }
    for (size_t i = 0; i < names->count; i++) {
        const bool is_input = header_is_input(names, i);
        if (!is_input && !header_is_given_name(names, names->name[i]) &&
            !check_other(&from, names->name[i], why))
            return false;
    }
    header_note_labels(names);
    return true;
}

input_texts header_texts(const header *names, const input_texts *constants,
                         const char *const text[INPUT_COUNT])
{
    input_texts texts = *constants;
    for (int i = 0; i < INPUT_COUNT; i++) {
        const bool has_column = header_has_input(names, i);
        const int other = input_alternative(i);
        const bool is_in_row = has_column || (other >= 0 && header_has_input(names, other));
        if (constants->text[i] != NULL || (constants->has_number[i] && !is_in_row))
            continue;
        texts.text[i] = text[i];
        texts.is_cell[i] = true;
        texts.has_number[i] = false;
        if (has_column)
            texts.cell_factor[i] = names->factor[names->column[i]];
    }
    return texts;
}

bool header_texts_agree(const input_texts *texts, const input_texts *constants, complaint *why)
{
    static const int elastic[] = {INPUT_E1, INPUT_NU1};
    for (int i = 0; i < 2; i++) {
        const int input = elastic[i];
        double own;
        if (!constants->has_number[input] || !texts->is_cell[input] ||
            !input_is_given(texts, input))
            continue;
        if (!input_read(texts, input, &own, why))
            return false;
        if (own != constants->number[input])
            return complain(why, "%s %.60s: the material has %g; allowed: one of the two",
                            input_name(texts, input), texts->text[input], constants->number[input]);
    }
    return true;
}
